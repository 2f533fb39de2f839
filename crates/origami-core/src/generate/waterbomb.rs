//! Waterbomb tessellation.

use std::f64::consts::PI;

use super::builder::{SheetBuilder, at_least, between, positive, room};
use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// Rows of waterbomb bases (a square with its diagonals and one midline), each row shifted by half a square, cut to a
/// rectangle. Diagonals are valleys, all else mountains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waterbomb {
    /// Squares in a row. Default 6.
    pub columns: usize,
    /// Rows of squares. Default 6.
    pub rows: usize,
    /// Side of a square. Default 1.
    pub size: f64,
    /// How far every crease folds, above 0 and at most pi. Default pi.
    pub angle: f64,
}

impl Default for Waterbomb {
    fn default() -> Self {
        Self { columns: 6, rows: 6, size: 1.0, angle: PI }
    }
}

impl Waterbomb {
    /// The pattern, in triangles, the midlines along y.
    ///
    /// # Errors
    /// If a count is 0, the size not positive, the angle not above 0 and at most pi, or the sheet too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("columns", self.columns, 1)?;
        at_least("rows", self.rows, 1)?;
        positive("size", self.size)?;
        between("angle", self.angle, 0.0, PI.next_up())?;
        room("columns, rows", [self.columns, self.rows], 4)?;

        let mut sheet = SheetBuilder::default();
        let (half, last) = (self.size / 2.0, 2 * self.columns);
        let line = |sheet: &mut SheetBuilder, j: usize| -> Vec<VertexId> {
            (0..=last).map(|i| sheet.at(half * i as f64, self.size * j as f64)).collect()
        };
        let mut low = line(&mut sheet, 0);
        for j in 0..self.rows {
            let high = line(&mut sheet, j + 1);
            // Odd rows begin and end with half a square.
            for i in ((j + 1) % 2..=last).step_by(2) {
                let middle = sheet.at(half * i as f64, self.size * (j as f64 + 0.5));
                if i > 0 {
                    self.half_square(&mut sheet, middle, [high[i], high[i - 1], low[i - 1], low[i]]);
                }
                if i < last {
                    self.half_square(&mut sheet, middle, [low[i], low[i + 1], high[i + 1], high[i]]);
                }
            }
            for ends in high.windows(2) {
                sheet.crease(ends[0], ends[1], -self.angle);
            }
            low = high;
        }
        Ok(sheet.finish())
    }

    /// Three triangles around `middle`, between the ends `a` and `d` of the midline and the corners `b` and `c`.
    fn half_square(&self, sheet: &mut SheetBuilder, middle: VertexId, [a, b, c, d]: [VertexId; 4]) {
        for (from, to) in [(a, b), (b, c), (c, d)] {
            sheet.face(&[middle, from, to]);
        }
        for (end, corner) in [(a, b), (d, c)] {
            sheet.crease(middle, end, -self.angle);
            sheet.crease(middle, corner, self.angle);
        }
        sheet.crease(b, c, -self.angle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;

    #[test]
    fn every_vertex_folds_flat() {
        for (columns, rows) in [(1, 1), (1, 2), (3, 4), (4, 3)] {
            let pattern = Waterbomb { columns, rows, ..Waterbomb::default() }.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            let shifted = rows / 2;
            let middles = (rows - shifted) * columns + shifted * (columns - 1);
            let between = (rows - 1) * (2 * columns - 1);
            assert_eq!(check::flat_foldable_vertices(&pattern), middles + between);
            check::folds_flat(&pattern);
        }
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |w: Waterbomb| w.pattern().unwrap_err().to_string();
        assert!(message(Waterbomb { rows: 0, ..Waterbomb::default() }).starts_with("parameter rows: is 0;"));
        assert!(message(Waterbomb { angle: 0.0, ..Waterbomb::default() }).starts_with("parameter angle: is 0 degrees"));
        assert!(message(Waterbomb { columns: usize::MAX, ..Waterbomb::default() }).contains("too large"));
    }
}
