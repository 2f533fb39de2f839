//! What `relax` makes of many patterns, before and after a change of it.
//!
//! `cargo run --release -p origami-tools --bin folds -- [KEY=NUMBER,... ...] [FILE.fold ...] > after.csv` folds the files, or what
//! the generators make where there are none, to each `percent` (60 and 100 by default) with each material: `ea`, `k_fold`,
//! `k_facet`, `k_face` and `collapse` have its numbers. `relax=JSON` changes settings of the solver, `most=700` leaves larger
//! sheets out.
//!
//! `... --bin folds -- compare before.csv after.csv` prints a Markdown table of the runs that both have.
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

mod compare;
#[path = "../tuning/patterns.rs"]
mod patterns;
mod run;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match &words[..] {
        [compare, before, after] if compare == "compare" => compare::print(before, after),
        words => run::print(words),
    }
}
