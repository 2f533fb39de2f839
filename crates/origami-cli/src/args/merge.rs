//! `origami merge`.

use std::path::PathBuf;

use clap::Args;

const EXAMPLES: &str = "\
Examples:
  origami merge out -o out                     Of all parts in a folder
  origami merge a/sweep.1-of-2.json b -o whole  Of tables and folders

Exit codes:
  1  a table is missing, is not of the same sweep, or cannot be written
  else those of the whole sweep";

/// Put the parts of a sweep together.
///
/// Parts that `origami sweep --shard` made become sweep.csv and sweep.json of the whole sweep: byte for byte those of one
/// run, whatever the number of parts and their order, but for the times, which are summed. Nothing is written unless
/// every row is there, once.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct MergeArgs {
    /// The tables of parts (JSON), or folders with such
    #[arg(value_name = "PART", required = true)]
    pub(crate) parts: Vec<PathBuf>,

    /// The folder for sweep.csv and sweep.json, made where it is missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,
}
