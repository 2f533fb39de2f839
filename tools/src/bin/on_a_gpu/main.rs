//! What `./on-a-gpu` runs where there is a GPU, and what makes tables and plots of what it wrote:
//!
//! ```text
//! on_a_gpu measure FOLDER [--seconds N] [--rehearse] [--commit TEXT] [--tests FILE]... [--command FILE]
//! on_a_gpu tables DOCUMENT PLOTS [FOLDER]...
//! ```
//!
//! `measure` writes into FOLDER, which it makes: `results.csv` (a row for each figure, as soon as there is one), `machine.json`
//! and `run.json`, pictures, and what the tests said. Each section is a process of its own: one that crashes, or hangs until
//! its time is over, takes no other along. `tables` puts tables of such folders into DOCUMENT, between the two lines that say
//! so, and plots into the folder PLOTS.
#![expect(clippy::print_stdout, reason = "it tells how far it has come")]

mod contact;
mod document;
mod ensembles;
mod figures;
mod folded;
mod kept;
mod looks;
mod machine;
mod memory;
mod parity;
mod pictures;
mod place;
mod results;
mod run;
mod section;
mod sheets;
mod speed;
mod suites;
mod tables;

use std::error::Error;
use std::path::PathBuf;

const USAGE: &str = "expected: on_a_gpu measure FOLDER [--seconds N] [--rehearse] [--commit TEXT] [--tests FILE]... \
                     [--command FILE], or on_a_gpu tables DOCUMENT PLOTS [FOLDER]...";

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["measure", folder, ref options @ ..] => run::measure(&asked(folder, options)?),
        // What `measure` starts.
        ["section", name, folder, seconds, ref options @ ..] => {
            section::work(name, &asked(folder, options)?, seconds.parse()?)
        }
        ["tables", document, plots, ref folders @ ..] => document::write(document.as_ref(), plots.as_ref(), folders),
        _ => Err(USAGE.into()),
    }
}

fn asked(folder: &str, options: &[&str]) -> Result<run::Asked, Box<dyn Error>> {
    let mut asked = run::Asked { folder: PathBuf::from(folder), ..run::Asked::default() };
    let mut options = options.iter();
    while let Some(option) = options.next() {
        let mut value = || options.next().copied().ok_or_else(|| format!("{option}: has no value; {USAGE}"));
        match *option {
            "--seconds" => {
                asked.seconds = value()?.parse().map_err(|why| format!("--seconds: {why}; expected seconds"))?;
            }
            "--rehearse" => asked.rehearse = true,
            "--commit" => value()?.clone_into(&mut asked.commit),
            "--tests" => asked.tests.push(value()?.into()),
            "--command" => asked.command = Some(value()?.into()),
            other => return Err(format!("{other}: is no option; {USAGE}").into()),
        }
    }
    Ok(asked)
}
