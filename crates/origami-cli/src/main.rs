//! The command `origami`: folds crease patterns from the command line.
#![forbid(unsafe_code)]

mod args;
mod backend;
mod commands;
mod console;
mod draw;
mod drivers;
mod exit;
mod files;
mod nearest;
mod numbers;
mod oddities;
mod progress;
mod report;
mod settings;
mod stopwatch;
mod text;
mod threads;

use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

use args::Cli;
use exit::{Exit, Failure};

fn main() -> ExitCode {
    let done = match Cli::try_parse() {
        Ok(cli) => {
            drivers::hush(&cli);
            commands::run(cli)
        }
        Err(told) => return told_by_clap(&told),
    };
    ended(done)
}

fn ended(done: Result<Exit, Failure>) -> ExitCode {
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

/// Help and version end well where they can be written; what clap refuses is bad usage, which is 1 here, not clap's 2.
fn told_by_clap(told: &clap::Error) -> ExitCode {
    match told.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            ended(told.print().map(|()| Exit::Done).map_err(Failure::from))
        }
        ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            // Nobody is left to be told where this fails.
            let _ = told.print();
            Exit::BadInput.into()
        }
        _ => ended(Err(Failure::Message(args::message(told)))),
    }
}
