//! `origami study`.

use std::path::PathBuf;
#[cfg(feature = "study")]
use std::time::Duration;

use clap::{Args, ValueEnum};

use super::ReadingArgs;
use super::fold::ADAPTER_VARIABLE;
use super::values::positive;

const EXAMPLES: &str = "\
Examples:
  origami study accuracy --quick -o out                    A look in less than a minute
  origami study accuracy crane.fold miura -o out           Of one's own and a generated pattern
  origami study accuracy --backend gpu -o out              On a GPU too
  origami study stability -o out                           What holds on stiff and extreme scenes
  origami study flat *.fold -o out                         Which fold flat, and how near
  origami study contact -o out                             What goes through what, at what cost

Exit codes:
  0  done; what a solver did not hold is a row of the tables, not an error
  1  bad input or usage";

/// Study how far the solvers can be trusted, and what they cost.
///
/// Runs scenes with each solver and writes tables (CSV, JSON), plots (SVG) and a document with them (STUDY.md) into a
/// folder. What was there under the same names is replaced. Files are written whole or not at all.
#[derive(Args)]
#[command(after_help = EXAMPLES, override_usage = "origami study [OPTIONS] <STUDY> [PATTERN]... -o <DIR>")]
pub(crate) struct StudyArgs {
    /// What to study
    #[arg(value_enum, value_name = "STUDY")]
    pub(crate) study: StudyName,

    /// Of accuracy, flat, contact and backwards: patterns in place of the shipped scenes
    ///
    /// Files with crease patterns, `-` for standard input, or names that `origami pattern --list` has; ./NAME is a file in any case.
    #[arg(value_name = "PATTERN")]
    pub(crate) patterns: Vec<PathBuf>,

    /// The folder to write into; made if it is missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,

    /// Fewer and smaller scenes: done in less than a minute
    #[arg(long)]
    pub(crate) quick: bool,

    /// Begin no run after so many seconds; the document names those left out [default: none]
    #[arg(long, value_name = "SECONDS", value_parser = positive)]
    pub(crate) time_limit: Option<f64>,

    /// Where runs take place
    #[arg(long, value_enum, value_name = "BACKEND", default_value_t = StudyBackend::Cpu)]
    pub(crate) backend: StudyBackend,

    /// The GPU adapter to use: part of a name that `origami adapters` lists, in whatever case [default: the first]
    #[arg(long, value_name = "NAME", env = ADAPTER_VARIABLE, hide_env_values = true)]
    pub(crate) adapter: Option<String>,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// How the patterns are read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,
}

/// What to study.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StudyName {
    /// Error against run time and force evaluations
    Accuracy,
    /// What holds on stiff and extreme scenes
    Stability,
    /// Whether patterns that fold flat end in the exact flat-folded state, and at what cost
    Flat,
    /// Where sheets go through themselves, without contact and with it, and what that costs
    Contact,
    /// Which patterns a motion to the flat-folded state is found for, backwards from there
    Backwards,
}

/// Where runs take place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum StudyBackend {
    /// The processor
    Cpu,
    /// The processor, and again a GPU; a software one where there is no other
    Gpu,
}

impl StudyArgs {
    /// Whether a GPU is wanted.
    pub(crate) fn asks_for_gpu(&self) -> bool {
        self.backend == StudyBackend::Gpu
    }
}

#[cfg(feature = "study")]
impl StudyArgs {
    /// None where it is longer than a clock can tell.
    pub(crate) fn time_limit(&self) -> Option<Duration> {
        self.time_limit.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok())
    }
}
