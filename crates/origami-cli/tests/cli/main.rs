//! The program from outside: what it reads, writes, says and exits with.
#![expect(clippy::unwrap_used, reason = "a test may")]

mod analyse;
mod attitude;
mod batch;
mod contact;
mod convert;
mod dangers;
mod design;
mod faults;
mod flat;
mod fold;
mod formats;
mod gpu;
mod help;
mod info;
mod manners;
mod mutations;
mod newton;
mod outputs;
mod pattern;
mod picture;
mod place;
mod report;
mod resume;
mod shards;
mod streams;
mod study;
mod sweep;
mod tutorial;
mod usage;
