//! `origami render`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::values::index;
use super::{ADAPTER_VARIABLE, BackendName, PictureArgs, ReadingArgs};

const EXAMPLES: &str = "\
Examples:
  origami render crane.fold -o crane.png                   The crease pattern
  origami render crane.fold -o crane.svg                   The same as SVG
  origami render folded.fold -o a.png --camera front       A folded form, from the side
  origami render film.fold --frame 5 -o a.png --strain     The strain in one frame of an animation
  origami fold crane.fold -o crane.png                     Fold and draw in one go

Exit codes: 0 done, 1 bad input or usage.";

/// Draw a crease pattern or a folded form as it lies.
///
/// Nothing is folded: vertices are where the file has them. On a crease pattern vertices that break a rule of flat folding
/// and creases that end inside a face are ringed, with a legend; lines of which no sheet can be made are drawn as they are,
/// with the reason below. Pictures are the same on every machine, need no display and
/// no GPU, and are written whole or not at all.
#[derive(Args)]
#[command(after_help = EXAMPLES, override_usage = "origami render [OPTIONS] <INPUT> -o <OUT>")]
pub(crate) struct RenderArgs {
    /// A crease pattern or folded form: FOLD, CP, OPX, ORI, SVG, OBJ or another; `-` is standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: PathBuf,

    /// Where to write; can be given more than once
    ///
    /// The extension tells the format: .png, .svg (flat patterns) or .glb (binary glTF). `-` is PNG on standard output.
    #[arg(short, long = "output", value_name = "OUT", required = true)]
    pub(crate) outputs: Vec<PathBuf>,

    /// Which frame of the input to draw: 0 is the key frame [default: the first with vertex positions]
    #[arg(long, value_name = "N", value_parser = index)]
    pub(crate) frame: Option<usize>,

    /// As what [default: pattern for what is flat and no folded form, else sheet]
    #[arg(long, value_enum, value_name = "VIEW")]
    pub(crate) view: Option<ViewName>,

    /// Mark nothing on a crease pattern: neither vertices that cannot fold flat nor creases that end inside a face
    #[arg(long)]
    pub(crate) no_marks: bool,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// What draws: cpu or gpu; auto is the processor
    #[arg(long, value_enum, value_name = "BACKEND", default_value_t = BackendName::Auto, hide_possible_values = true)]
    pub(crate) backend: BackendName,

    /// The GPU adapter to use with --backend gpu: part of a name that `origami adapters` lists [default: the first]
    #[arg(long, value_name = "NAME", env = ADAPTER_VARIABLE, hide_env_values = true)]
    pub(crate) adapter: Option<String>,

    /// How the input is read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,

    /// How it looks.
    #[command(flatten)]
    pub(crate) picture: PictureArgs,
}

/// As what a frame is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ViewName {
    /// Paper in space
    Sheet,
    /// A flat crease pattern, from above
    Pattern,
}
