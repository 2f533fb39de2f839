//! Miura-ori.

use std::f64::consts::FRAC_PI_2;

use super::builder::{SheetBuilder, at_least, between, positive, room};
use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;
use crate::rigid::MiuraFold;

/// A sheet of parallelograms in zigzag columns: vertex `j * (columns + 1) + i` is vertex i of zigzag crease j.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Miura {
    /// Panels along the zigzag creases (x). Default 10.
    pub columns: usize,
    /// Panels along the straight creases (y). Default 10.
    pub rows: usize,
    /// Side of a panel along the straight creases. Default 1.
    pub a: f64,
    /// Side of a panel along the zigzag creases. Default 1.
    pub b: f64,
    /// Acute corner of a panel. Default 60 degrees.
    pub gamma: f64,
    /// Inclination of the panels when folded, from 0 (exclusive) to pi/2: [`MiuraFold`] has the fold angles.
    /// Default pi/2, folded flat: all creases fold by pi.
    pub theta: f64,
}

impl Default for Miura {
    fn default() -> Self {
        Self { columns: 10, rows: 10, a: 1.0, b: 1.0, gamma: 60f64.to_radians(), theta: FRAC_PI_2 }
    }
}

/// The common benchmark: rhombic panels with corners of 60 degrees, folded flat.
///
/// # Errors
/// If a count is 0 or the sheet is too large.
pub fn miura(columns: usize, rows: usize) -> Result<CreasePattern, Error> {
    Miura { columns, rows, ..Miura::default() }.pattern()
}

impl Miura {
    /// The pattern, with parallelograms as faces.
    ///
    /// # Errors
    /// If a count is 0, a length not positive, `gamma` not above 0 and below pi/2, `theta` not above 0 and at most
    /// pi/2, or the sheet too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("columns", self.columns, 1)?;
        at_least("rows", self.rows, 1)?;
        positive("a", self.a)?;
        positive("b", self.b)?;
        between("gamma", self.gamma, 0.0, FRAC_PI_2)?;
        between("theta", self.theta, 0.0, FRAC_PI_2.next_up())?;
        room("columns, rows", [self.columns, self.rows], 1)?;

        let mut sheet = SheetBuilder::default();
        let folded = self.folded();
        let flat = MiuraFold { theta: 0.0, ..folded };
        let grid: Vec<Vec<VertexId>> =
            (0..=self.rows).map(|j| (0..=self.columns).map(|i| sheet.vertex(flat.vertex(i, j))).collect()).collect();
        for (j, zigzag) in grid.iter().enumerate() {
            // Odd zigzags are the ridges.
            let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
            for ends in zigzag.windows(2) {
                sheet.crease(ends[0], ends[1], sign * folded.zigzag_fold());
            }
            let Some(next) = grid.get(j + 1) else { break };
            for (i, (&low, &high)) in zigzag.iter().zip(next).enumerate() {
                // Between two acute corners a straight crease folds against the zigzag: that is above an even vertex.
                let sign = if i % 2 == 0 { -sign } else { sign };
                sheet.crease(low, high, sign * folded.straight_fold());
            }
            for (low, high) in zigzag.windows(2).zip(next.windows(2)) {
                sheet.face(&[low[0], low[1], high[1], high[0]]);
            }
        }
        Ok(sheet.finish())
    }

    /// The folded state that the fold angles lead to.
    #[must_use]
    pub fn folded(&self) -> MiuraFold {
        MiuraFold { a: self.a, b: self.b, gamma: self.gamma, theta: self.theta }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use glam::DVec3;

    use super::*;
    use crate::generate::check;

    #[test]
    fn folds_flat() {
        let pattern = miura(5, 4).unwrap();
        check::sound_and_flat(&pattern, 1);
        assert_eq!(check::flat_foldable_vertices(&pattern), 12);
        check::folds_flat(&pattern);
        assert!(pattern.edges.iter().filter_map(|e| e.fold_angle).all(|angle| (angle.abs() - PI).abs() < 1e-12));
    }

    #[test]
    fn angles_are_those_of_the_folded_positions() {
        let miura = Miura { columns: 4, rows: 5, a: 1.2, b: 0.7, gamma: 1.1, theta: 0.8 };
        let pattern = miura.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        let folded: Vec<DVec3> =
            (0..=5).flat_map(|j| (0..=4).map(move |i| (i, j))).map(|(i, j)| miura.folded().vertex(i, j)).collect();
        let measured = check::measured(&pattern, &folded);
        assert_eq!(measured.len(), 4 * 4 + 5 * 3);
        assert!(check::closure(&pattern) < 1e-12);
        for (asked, reached) in measured {
            assert!((asked - reached).abs() < 1e-12, "{asked} {reached}");
        }
    }

    #[test]
    fn numbering_is_as_documented() {
        let pattern = Miura { columns: 3, rows: 2, ..Miura::default() }.pattern().unwrap();
        let flat = MiuraFold { theta: 0.0, ..Miura::default().folded() };
        assert_eq!(pattern.vertices[2 * 4 + 3], flat.vertex(3, 2));
    }

    #[test]
    fn a_large_sheet_has_the_counts_of_a_grid() {
        let pattern = miura(316, 316).unwrap();
        assert_eq!((pattern.vertices.len(), pattern.faces.len()), (317 * 317, 316 * 316));
        assert_eq!(pattern.edges.len(), 2 * 316 * 317);
        assert!(pattern.edges.iter().all(|edge| edge.vertices.iter().all(|v| v.index() < 317 * 317)));
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |m: Miura| m.pattern().unwrap_err().to_string();
        let good = Miura::default();
        assert!(message(Miura { columns: 0, ..good }).starts_with("parameter columns: is 0;"));
        assert!(message(Miura { rows: usize::MAX, ..good }).contains("too large"));
        assert!(message(Miura { rows: 1 << 20, columns: 1 << 20, ..good }).starts_with("parameter columns, rows: are"));
        assert!(message(Miura { gamma: FRAC_PI_2, ..good }).starts_with("parameter gamma: is 90 degrees"));
        assert!(message(Miura { theta: -0.1, ..good }).starts_with("parameter theta"));
    }
}
