//! The command `origami`: folds crease patterns from the command line.
#![forbid(unsafe_code)]

mod args;
mod backend;
mod commands;
mod console;
mod draw;
mod exit;
mod files;
mod numbers;
mod progress;
mod report;
mod settings;
mod stopwatch;

use std::process::ExitCode;

use clap::Parser;

use args::Cli;
use exit::{Exit, Failure};

fn main() -> ExitCode {
    let done = match Cli::try_parse() {
        Ok(cli) => commands::run(cli),
        Err(told) => return told_by_clap(&told),
    };
    match done {
        Ok(exit) => exit.into(),
        // Whoever read the output has seen enough.
        Err(Failure::BrokenPipe) => Exit::Done.into(),
        Err(Failure::Message(message)) => {
            console::error(&message);
            Exit::BadInput.into()
        }
    }
}

/// Help and version end well; what clap refuses is bad usage, which is 1 here, not clap's 2.
fn told_by_clap(told: &clap::Error) -> ExitCode {
    // Nobody is left to be told where this fails.
    let _ = told.print();
    if told.use_stderr() { Exit::BadInput.into() } else { Exit::Done.into() }
}
