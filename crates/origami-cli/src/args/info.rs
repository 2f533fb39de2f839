//! `origami info`.

use std::path::PathBuf;

use clap::Args;

use super::values::index;
use super::{MaterialArgs, ReadingArgs};

const EXAMPLES: &str = "\
Examples:
  origami info crane.fold
  origami info crane.fold --json | jq .model.time_step.paper
  origami fold crane.fold -o - --quiet | origami info -
  origami info film.fold --check

Exit codes: 0 the pattern can be folded, 1 it cannot.";

/// Tell what is in a file and what a model of it would hold.
///
/// Frames, vertices, edges by letter, faces, what is odd about them, what a model would build and leave out, and its
/// time steps. Nothing is folded.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct InfoArgs {
    /// A crease pattern: FOLD, CP, OPX, ORI, SVG, OBJ or another; `-` is standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: PathBuf,

    /// Which frame holds the pattern: 0 is the key frame [default: the first with vertex positions]
    #[arg(long, value_name = "N", value_parser = index)]
    pub(crate) frame: Option<usize>,

    /// Tell which frames have paper that goes through paper, and which faces cross
    ///
    /// The test is exact, on the coordinates as the file has them. What touches does not cross: frames that lie flat in one
    /// plane have no crossing.
    #[arg(long)]
    pub(crate) check: bool,

    /// As JSON; docs/REPORT.md has the keys
    #[arg(long)]
    pub(crate) json: bool,

    /// How the input is read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,

    /// The paper.
    #[command(flatten)]
    pub(crate) material: MaterialArgs,
}
