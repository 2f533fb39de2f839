//! What tells one series from another: colours, shapes, dashes.

use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::Mark;

/// The palette of Okabe and Ito (2008), which the colour-blind can tell apart, without its yellow: it is lost on white.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];

/// Width of lines, in pixels.
const STROKE: u32 = 2;
/// Pixels of a dash and of the gap behind it.
const DASH: (i32, i32) = (7, 5);

/// How one series looks.
#[derive(Clone, Copy)]
pub(super) struct Look {
    colour: RGBColor,
    shape: usize,
    mark: Mark,
}

impl Look {
    /// Of the series of this index. Six shapes and seven colours repeat after 42.
    pub(super) fn new(index: usize, mark: Mark) -> Self {
        Self { colour: COLOURS[index % COLOURS.len()], shape: index % 6, mark }
    }

    /// Draws it through pixels.
    pub(super) fn draw<DB: DrawingBackend>(self, area: &Area<DB>, pixels: &[(i32, i32)]) -> Drawn<DB> {
        let line = self.colour.stroke_width(STROKE);
        match self.mark {
            // A line through one point is none.
            _ if pixels.len() < 2 => {}
            Mark::Line => area.draw(&PathElement::new(pixels, line))?,
            Mark::Dashed => area.draw(&DashedPathElement::new(pixels.iter().copied(), DASH.0, DASH.1, line))?,
            Mark::Points => {}
        }
        pixels.iter().try_for_each(|pixel| self.draw_shape(area, *pixel))
    }

    /// Its sample in the legend: `width` pixels from `left`.
    pub(super) fn draw_sample<DB: DrawingBackend>(
        self,
        area: &Area<DB>,
        (left, y): (i32, i32),
        width: i32,
    ) -> Drawn<DB> {
        let ends = [(left, y), (left + width, y)];
        let line = self.colour.stroke_width(STROKE);
        match self.mark {
            Mark::Line => area.draw(&PathElement::new(ends, line))?,
            Mark::Dashed => area.draw(&DashedPathElement::new(ends, DASH.0, DASH.1, line))?,
            Mark::Points => {}
        }
        self.draw_shape(area, (left + width / 2, y))
    }

    fn draw_shape<DB: DrawingBackend>(self, area: &Area<DB>, (x, y): (i32, i32)) -> Drawn<DB> {
        let fill = self.colour.filled();
        let at = |offsets: &[(i32, i32)]| offsets.iter().map(|(dx, dy)| (x + dx, y + dy)).collect::<Vec<_>>();
        match self.shape {
            0 => area.draw(&Circle::new((x, y), 4, fill)),
            1 => area.draw(&Polygon::new(at(&[(-4, -4), (4, -4), (4, 4), (-4, 4)]), fill)),
            2 => area.draw(&Polygon::new(at(&[(0, -5), (5, 4), (-5, 4)]), fill)),
            3 => area.draw(&Polygon::new(at(&[(0, -6), (6, 0), (0, 6), (-6, 0)]), fill)),
            4 => area.draw(&Polygon::new(at(&[(0, 5), (5, -4), (-5, -4)]), fill)),
            _ => area.draw(&Cross::new((x, y), 4, self.colour.stroke_width(STROKE))),
        }
    }
}

/// The whole picture, in pixels.
pub(super) type Area<DB> = DrawingArea<DB, plotters::coord::Shift>;
/// What comes of drawing.
pub(super) type Drawn<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;
