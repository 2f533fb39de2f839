//! How files are read, for all commands that take a pattern.

use clap::Args;

use super::values::{at_least_zero, positive};

/// Options that make a [`Reading`](crate::files::Reading).
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(next_help_heading = "Input (docs/FORMATS.md has all formats)")]
pub(crate) struct ReadingArgs {
    /// Join ends of lines that are nearer than this, in the file's unit [default: found from the file]
    ///
    /// Ends to ends, and ends to lines. 0 joins only what is off by rounding. Each join is told.
    #[arg(long, value_name = "LENGTH", value_parser = at_least_zero)]
    pub(crate) join: Option<f64>,

    /// Which colours stand for which letters, such as `#e3170d=M,blue=V,grey=none` [default: black B, red M, blue V,
    /// green C, yellow F, magenta U]
    ///
    /// For SVG, and for lines of DXF and OBJ that have a colour. CSS colours, letters of FOLD; `none` is left out. What the
    /// table does not name follows the default.
    #[arg(long, value_name = "TABLE")]
    pub(crate) letters: Option<String>,

    /// How far straight pieces may be from a curve, in the file's unit [default: 1/2000 of the drawing's size]
    #[arg(long, value_name = "LENGTH", value_parser = positive)]
    pub(crate) curve_tolerance: Option<f64>,
}
