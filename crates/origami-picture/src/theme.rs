//! Colours and line styles of a picture, as data.

use crate::colour::Rgb;
use crate::figure::LineKind;

/// Dashes of a line, in pixels: lengths drawn and left out in turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dash {
    /// Length of a dash.
    pub on: f32,
    /// Length of the gap between two dashes.
    pub off: f32,
    /// Length of a shorter dash in the middle of the gap; 0 is none.
    pub dot: f32,
}

/// How lines of one kind are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineStyle {
    /// The colour of the line.
    pub colour: Rgb,
    /// Its width in pixels of a picture 1000 pixels high; see [`Theme::line_scale`].
    pub width: f32,
    /// Dashes; `None`: drawn through.
    pub dash: Option<Dash>,
}

impl LineStyle {
    const fn solid(colour: Rgb, width: f32) -> Self {
        Self { colour, width, dash: None }
    }
}

/// Colours of paper, ground and lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Theme {
    /// Colour of the side that the pattern's letters are meant for.
    pub front: Rgb,
    /// Colour of the other side.
    pub back: Rgb,
    /// Colour behind the sheet; `None` is transparent.
    pub background: Option<Rgb>,
    /// Colour of the caption and of the numbers beside a map.
    pub text: Rgb,
    /// How lines of each [`LineKind`] are drawn, in its order.
    pub lines: [LineStyle; LineKind::ALL.len()],
    /// Colour of creases over a map, where their own colours would be mistaken for values; drawn thinner too.
    pub over_map: Rgb,
    /// How much light and shade differ: 0 is none, 1 that of paper by a window.
    pub shading: f32,
}

impl Default for Theme {
    fn default() -> Self {
        Self::paper()
    }
}

impl Theme {
    /// Names of all themes.
    pub const NAMES: [&str; 4] = ["paper", "mono", "dark", "white"];

    /// The theme of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "paper" => Self::paper(),
            "mono" => Self::mono(),
            "dark" => Self::dark(),
            "white" => Self::white(),
            _ => return None,
        })
    }

    /// Warm paper, dyed on its front, on white; lines in the field's colours.
    #[must_use]
    pub const fn paper() -> Self {
        Self {
            front: Rgb(138, 190, 222),
            back: Rgb(250, 245, 232),
            background: Some(Rgb::WHITE),
            text: Rgb(34, 34, 34),
            lines: field_lines(Rgb(30, 34, 40), Rgb(255, 255, 255)),
            over_map: Rgb(150, 150, 150),
            shading: 1.0,
        }
    }

    /// White paper on white, for patterns and for prints that shall show the folds alone.
    #[must_use]
    pub const fn white() -> Self {
        Self { front: Rgb(252, 252, 250), back: Rgb(232, 232, 228), ..Self::paper() }
    }

    /// Greys; dashes tell mountain (dash and dot) from valley (dashes), as in diagrams since Yoshizawa.
    #[must_use]
    pub const fn mono() -> Self {
        const INK: Rgb = Rgb(20, 20, 20);
        const fn dashed(on: f32, off: f32, dot: f32) -> LineStyle {
            LineStyle { colour: INK, width: 1.8, dash: Some(Dash { on, off, dot }) }
        }
        Self {
            front: Rgb(205, 205, 205),
            back: Rgb(248, 248, 248),
            lines: [
                dashed(12.0, 9.0, 2.0),
                dashed(8.0, 6.0, 0.0),
                LineStyle::solid(INK, 2.4),
                LineStyle::solid(Rgb(150, 150, 150), 1.0),
                LineStyle::solid(INK, 3.2),
                dashed(2.0, 5.0, 0.0),
            ],
            ..Self::paper()
        }
    }

    /// Light lines on dark ground, for slides.
    #[must_use]
    pub const fn dark() -> Self {
        Self {
            front: Rgb(84, 132, 168),
            back: Rgb(214, 206, 190),
            background: Some(Rgb(24, 26, 30)),
            text: Rgb(232, 232, 232),
            lines: field_lines(Rgb(232, 232, 232), Rgb(150, 150, 150)),
            over_map: Rgb(150, 150, 150),
            shading: 1.0,
        }
    }

    /// How lines of a kind are drawn.
    #[must_use]
    pub const fn line(&self, kind: LineKind) -> &LineStyle {
        &self.lines[kind as usize]
    }

    /// By how much widths are multiplied in a picture of this size, so that a large print looks like a small one, and
    /// lines in a small one stay whole.
    #[must_use]
    pub fn line_scale(width: u32, height: u32) -> f32 {
        (width.min(height) as f32 / 800.0).max(0.55)
    }
}

/// Mountain red, valley blue, boundary black, facets light, cuts green, undriven creases magenta.
const fn field_lines(boundary: Rgb, facet: Rgb) -> [LineStyle; LineKind::ALL.len()] {
    [
        LineStyle::solid(Rgb(208, 32, 36), 2.2),
        LineStyle::solid(Rgb(22, 78, 190), 2.2),
        LineStyle::solid(boundary, 2.2),
        LineStyle::solid(facet, 1.1),
        LineStyle::solid(Rgb(20, 150, 60), 2.4),
        LineStyle::solid(Rgb(200, 30, 180), 2.2),
    ]
}
