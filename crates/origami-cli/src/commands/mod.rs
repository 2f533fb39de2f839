//! What each command does.

mod adapters;
mod analyse;
mod convert;
mod fold;
mod info;
mod pattern;
mod render;
mod study;
mod sweep;
mod texts;
mod view;

use crate::args::{Cli, Command};
use crate::exit::{Exit, Failure};

/// Does what the command line says.
///
/// # Errors
/// Why it ends before its work is done.
pub(crate) fn run(cli: Cli) -> Result<Exit, Failure> {
    match cli.command {
        Command::Fold(args) => fold::run(&args),
        Command::Sweep(args) => sweep::run(&args),
        Command::Merge(args) => sweep::merge(&args),
        Command::Convert(args) => convert::run(&args),
        Command::Render(args) => render::run(&args),
        Command::Study(args) => study::run(&args),
        Command::Analyse(args) => analyse::run(&args),
        Command::Design(args) => analyse::design(&args),
        Command::Info(args) => info::run(&args),
        Command::Pattern(args) => pattern::run(&args),
        Command::View(args) => view::run(&args),
        Command::Adapters(args) => adapters::run(&args),
        Command::Completions { shell } => texts::completions(shell),
        Command::Man => texts::man(),
        Command::Version => texts::version(),
    }
}
