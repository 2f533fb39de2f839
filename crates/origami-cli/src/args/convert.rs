//! `origami convert`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::ReadingArgs;
use super::values::share;

const EXAMPLES: &str = "\
Examples:
  origami convert crane.cp -o crane.fold                   From any format that is read to FOLD
  origami convert crane.fold -o crane.svg -o crane.cp      As two files
  origami convert crane.fold -o crane.svg --width 200mm    For a plotter: a sheet 200 mm wide
  origami convert crane.fold -o crane.dxf --width 200mm    For a cutter, in mm
  origami fold crane.svg -o folded.svg                     Not this: a picture, with line styles and paper

Exit codes: 0 done, 1 bad input or usage.";

/// Write a crease pattern in another format.
///
/// Reads a pattern in any format and writes it as FOLD, CP, SVG or DXF, cleaned of what files get wrong: lines split where they
/// cross, doubles dropped, faces found. Nothing is folded. Coordinates keep all their digits. What a format cannot hold, such
/// as fold angles in CP, is counted in a warning. docs/FORMATS.md has the conventions of each.
#[derive(Args)]
#[command(after_help = EXAMPLES, override_usage = "origami convert [OPTIONS] <INPUT> -o <OUT>")]
pub(crate) struct ConvertArgs {
    /// A file with a crease pattern; `-` is standard input
    #[arg(value_name = "INPUT")]
    pub(crate) input: PathBuf,

    /// Where to write; can be given more than once
    ///
    /// The extension tells the format: .fold, .cp, .svg or .dxf. `-` is FOLD on standard output.
    #[arg(short, long = "output", value_name = "OUT", required = true)]
    pub(crate) outputs: Vec<PathBuf>,

    /// Which frame of the input holds the pattern: 0 is the key frame [default: the first with vertex positions]
    #[arg(long, value_name = "N")]
    pub(crate) frame: Option<usize>,

    /// How wide the sheet is on paper, such as 150mm, 15cm or 6in [default: 150mm in SVG; DXF keeps the input's numbers]
    ///
    /// Coordinates in SVG stay the input's, its width and height say how long they are. In DXF coordinates are scaled and
    /// count this unit.
    #[arg(long, value_name = "LENGTH")]
    pub(crate) width: Option<String>,

    /// Whether a line that others meet is one line or its pieces [default: joined in SVG and DXF, pieces in CP]
    ///
    /// A plotter or a cutter draws one line at once; editors of crease patterns expect lines to end where others meet them.
    /// Pieces are joined if they are of one letter and one angle.
    #[arg(long, value_enum, value_name = "HOW")]
    pub(crate) lines: Option<LinesName>,

    /// How far from a straight line its pieces may be joined, as a share of the sheet's size [default: 1e-13]
    ///
    /// More, such as 1e-6, joins what was written with few digits; creases that end there then end beside the line by as much.
    #[arg(long, value_name = "X", value_parser = share)]
    pub(crate) straight: Option<f64>,

    /// Say nothing but errors
    #[arg(short, long)]
    pub(crate) quiet: bool,

    /// How the file is read.
    #[command(flatten)]
    pub(crate) reading: ReadingArgs,
}

/// How lines are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LinesName {
    /// As long as they go on straight
    Joined,
    /// As they lie between vertices
    Pieces,
}
