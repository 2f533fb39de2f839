//! Crease patterns written as other formats than FOLD: CP for the field's editors, SVG for plotters, cutters and drawing
//! programs, DXF for cutters and CAD.
//!
//! All three are lists of lines ([`strokes`]). What they cannot hold (fold angles in CP and DXF, stiffnesses and fixed
//! vertices in all) is left out, and the warnings that each writer returns count it.

mod cp;
mod dxf;
mod lost;
mod page;
mod strokes;
mod svg;

use std::fmt;
use std::io;

use origami_core::{CreasePattern, Error};

pub use cp::cp;
pub use dxf::dxf;
pub use page::{Length, Unit};
pub use strokes::{Kind, Stroke, strokes};
pub use svg::svg;

/// How patterns are written.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// Whether pieces of one line that have one letter and one angle are written as one line. `None`: in SVG and DXF, whose
    /// readers draw and cut; not in CP, whose programs expect lines to end where others meet them.
    pub joined: Option<bool>,
    /// How far the joints of such pieces may be from the one line, as a share of the pattern's size. `None` is
    /// [`STRAIGHT`], which changes nothing but the last bits.
    pub straight: Option<f64>,
    /// How wide the sheet is on paper, from left to right. SVG: 150 mm where there is none, and coordinates stay the file's.
    /// DXF: coordinates are scaled to this many of its unit; where there is none they are the file's.
    pub width: Option<Length>,
}

/// How straight a line is that is written as one, where nothing else is asked for.
pub const STRAIGHT: f64 = 1e-13;

impl Options {
    /// The lines of `pattern` as these options want them; joined or not where they do not say.
    fn strokes(&self, pattern: &CreasePattern, joined: bool) -> Result<Vec<Stroke>, Error> {
        strokes(pattern, self.joined.unwrap_or(joined).then(|| self.straight.unwrap_or(STRAIGHT)))
    }
}

/// A number with all its digits and no exponent, which not every reader of these formats knows; 0 has no sign.
struct Plain(f64);

impl fmt::Display for Plain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&(self.0 + 0.0), f)
    }
}

/// Names the output by `-` until whoever opened it knows better.
fn unwritable(source: io::Error) -> Error {
    Error::Io { path: "-".into(), source }
}
