//! How files are read, for all commands that take a pattern.

use clap::Args;

use super::values::positive;

/// Options that make a [`Reading`](crate::files::Reading).
#[derive(Args, Clone, Debug, Default, PartialEq)]
#[command(next_help_heading = "Input (docs/FORMATS.md has all formats)")]
pub(crate) struct ReadingArgs {
    /// Which colours stand for which letters, such as `#e3170d=M,blue=V,grey=none` [default: black B, red M, blue V,
    /// green C, yellow F, magenta U]
    ///
    /// For SVG, and for lines of DXF and OBJ that have a colour. CSS colours, letters of FOLD; `none` is left out. What the
    /// table does not name follows the default.
    #[arg(long, value_name = "TABLE")]
    pub(crate) colours: Option<String>,

    /// How far straight pieces may be from a curve, in the file's unit [default: a share of the pattern's size]
    #[arg(long, value_name = "LENGTH", value_parser = positive)]
    pub(crate) curve_tolerance: Option<f64>,
}
