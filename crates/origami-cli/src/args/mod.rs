//! The command line, one file a command. Defaults of the simulation come from the library.

mod adapters;
mod analyse;
mod contact;
mod convert;
mod design;
mod fold;
mod hold;
mod info;
mod list;
mod look;
mod material;
mod merge;
mod pattern;
mod picture;
mod reading;
mod render;
mod shard;
mod study;
mod sweep;
mod usage;
mod values;
mod view;

pub(crate) use adapters::AdaptersArgs;
pub(crate) use analyse::AnalyseArgs;
#[cfg(feature = "analysis")]
pub(crate) use analyse::{Analysis, BucklingArgs, EquilibriaArgs, ModesArgs, PathArgs, StiffnessArgs, SubjectArgs};
pub(crate) use contact::{ContactArgs, SequenceSource};
pub(crate) use convert::ConvertArgs;
#[cfg(feature = "formats")]
pub(crate) use convert::LinesName;
pub(crate) use design::DesignArgs;
pub(crate) use fold::{
    ADAPTER_VARIABLE, BackendName, FoldArgs, IntegratorName, PrecisionName, SolverName, SolvingArgs, is_named,
};
pub(crate) use info::InfoArgs;
#[cfg(feature = "render")]
pub(crate) use look::{Ground, check_size};
pub(crate) use material::MaterialArgs;
pub(crate) use merge::MergeArgs;
pub(crate) use pattern::PatternArgs;
#[cfg(feature = "render")]
pub(crate) use picture::{CameraName, ColoursName, ShadingName, ThemeName};
pub(crate) use picture::{MapName, PictureArgs};
pub(crate) use reading::ReadingArgs;
pub(crate) use render::{RenderArgs, ViewName};
pub(crate) use shard::Shard;
pub(crate) use study::StudyArgs;
#[cfg(feature = "study")]
pub(crate) use study::{StudyBackend, StudyName};
pub(crate) use sweep::SweepArgs;
pub(crate) use usage::message;
pub(crate) use view::ViewArgs;

use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;

/// Folds origami crease patterns: the bar-and-hinge method of Ghassaei, Demaine and Gershenfeld (2018), with the truth
/// about convergence and error.
#[derive(Parser)]
#[command(
    name = "origami",
    bin_name = "origami",
    version,
    max_term_width = 100,
    after_help = EXAMPLES
)]
pub(crate) struct Cli {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXAMPLES: &str = "\
Examples:
  origami pattern miura --set columns=6 -o miura.fold      Make a crease pattern
  origami info miura.fold                                  See what is in a file
  origami fold miura.fold --percent 60 -o folded.fold      Fold it
  origami fold miura.fold --percent 60 -o folded.png       Fold it and draw it
  origami fold --help                                      More of these, and all settings
  origami view miura.fold                                  Fold it by hand, in a browser
  origami sweep miura.fold --percent 0:100:5 -o out        Fold it in many ways
  origami study accuracy miura.fold -o out                 See how far to trust the solvers
  origami analyse path kresling.fold press.json -o out     Press it until it snaps, and further
  origami design kresling.fold height.json -o out          Find the tube that snaps to a height

Exit codes: 0 done, 1 bad input or usage, 2 the state diverged, 3 not converged.";

/// The commands. What those with arguments do is told there.
#[derive(Subcommand)]
pub(crate) enum Command {
    Fold(Box<FoldArgs>),
    Sweep(Box<SweepArgs>),
    Merge(MergeArgs),
    Convert(ConvertArgs),
    Render(Box<RenderArgs>),
    Study(StudyArgs),
    Analyse(Box<AnalyseArgs>),
    Design(Box<DesignArgs>),
    Info(InfoArgs),
    Pattern(PatternArgs),
    View(ViewArgs),
    Adapters(AdaptersArgs),
    /// Write a completion script for a shell to standard output.
    #[command(after_help = "Example:\n  origami completions bash > ~/.local/share/bash-completion/completions/origami")]
    Completions {
        /// The shell.
        shell: Shell,
    },
    /// Write the manual page to standard output.
    #[command(after_help = "Example:\n  origami man > origami.1 && man ./origami.1")]
    Man,
    /// Tell the version.
    Version,
}

/// The definition of the whole command line.
pub(crate) fn definition() -> clap::Command {
    Cli::command()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_definition_holds_together() {
        definition().debug_assert();
    }
}
