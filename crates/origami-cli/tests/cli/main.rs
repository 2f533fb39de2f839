//! The program from outside: what it reads, writes, says and exits with.
#![expect(clippy::unwrap_used, reason = "a test may")]

mod batch;
mod dangers;
mod faults;
mod fold;
mod gpu;
mod help;
mod info;
mod mutations;
mod newton;
mod pattern;
mod picture;
mod place;
mod report;
mod streams;
mod study;
mod sweep;
mod usage;
