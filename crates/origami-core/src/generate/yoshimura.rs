//! Yoshimura: diamonds that roll up into a cylinder.

use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::builder::{at_least, between, positive, room};
use super::rolled::Lattice;
use crate::error::Error;
use crate::pattern::CreasePattern;
use crate::rigid::YoshimuraFold;

/// Lines of equal isosceles triangles, each shifted by half a triangle; where two lines meet, triangles are diamonds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yoshimura {
    /// Diamonds around, at least 3. Default 6.
    pub columns: usize,
    /// Lines of triangles, half a diamond high each. Default 6.
    pub rows: usize,
    /// Half the width of a diamond. Default 0.5.
    pub c: f64,
    /// Angle between a diamond's width and its sides, above pi/(2 columns) and below pi/2. Default 30 degrees.
    pub alpha: f64,
}

impl Default for Yoshimura {
    fn default() -> Self {
        Self { columns: 6, rows: 6, c: 0.5, alpha: 30f64.to_radians() }
    }
}

impl Yoshimura {
    /// The flat strip, one cylinder wide; folded by its fold angles it is the cylinder; letters are seen from outside.
    ///
    /// # Errors
    /// If a count is too small, a length not positive, `alpha` out of its range, or the sheet too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        let (lattice, fold) = self.lattice()?;
        let height = self.c * self.alpha.tan();
        let flat = |i: usize, j: usize| DVec3::new(self.c * (2 * i + j % 2) as f64, height * j as f64, 0.0);
        Ok(lattice.strip(flat, |i, j| fold.vertex(i, j)))
    }

    /// The closed cylinder in space. Edges are free hinges, or, if `driven`, fold by the angles that they have at rest.
    ///
    /// # Errors
    /// As [`Yoshimura::pattern`].
    pub fn ring(&self, driven: bool) -> Result<CreasePattern, Error> {
        let (lattice, fold) = self.lattice()?;
        Ok(lattice.ring(|i, j| fold.vertex(i, j), driven))
    }

    fn lattice(&self) -> Result<(Lattice<impl Fn(usize) -> bool>, YoshimuraFold), Error> {
        at_least("columns", self.columns, 3)?;
        at_least("rows", self.rows, 1)?;
        positive("c", self.c)?;
        between("alpha", self.alpha, PI / (2.0 * self.columns as f64), FRAC_PI_2)?;
        room("columns, rows", [self.columns, self.rows], 1)?;
        let lattice = Lattice { columns: self.columns, rows: self.rows, rising: |j| j % 2 == 1 };
        Ok((lattice, YoshimuraFold { n: self.columns, c: self.c, alpha: self.alpha }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;
    use crate::pattern::Assignment;

    #[test]
    fn strip_closes_around_every_vertex() {
        let pattern = Yoshimura { columns: 5, rows: 4, c: 0.7, alpha: 0.5 }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        assert!(check::closure(&pattern) < 1e-12);
    }

    #[test]
    fn strip_and_ring_have_the_same_triangles() {
        let yoshimura = Yoshimura::default();
        let strip = yoshimura.pattern().unwrap();
        let ring = yoshimura.ring(true).unwrap();
        check::sound(&ring, 0);
        assert_eq!(check::side_lengths(&strip), check::side_lengths(&ring));
    }

    #[test]
    fn lines_are_valleys_and_sides_are_mountains_from_outside() {
        let pattern = Yoshimura::default().pattern().unwrap();
        for edge in pattern.edges.iter().filter(|e| e.assignment != Assignment::Boundary) {
            let [a, b] = edge.vertices.map(|v| pattern.vertices[v.index()]);
            let expected = if a.y == b.y { Assignment::Valley } else { Assignment::Mountain };
            assert_eq!(edge.assignment, expected);
        }
    }

    #[test]
    fn free_ring_has_no_angles() {
        let ring = Yoshimura::default().ring(false).unwrap();
        check::sound(&ring, 0);
        assert!(ring.edges.iter().all(|e| e.fold_angle.is_none()));
        assert!(ring.edges.iter().any(|e| e.assignment == Assignment::Unassigned));
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |y: Yoshimura| y.pattern().unwrap_err().to_string();
        let good = Yoshimura::default();
        assert!(message(Yoshimura { columns: 2, ..good }).starts_with("parameter columns: is 2;"));
        assert_eq!(
            message(Yoshimura { alpha: 15f64.to_radians(), ..good }),
            "parameter alpha: is 15 degrees; expected an angle above 15 degrees and below 90 degrees"
        );
        assert!(message(Yoshimura { rows: usize::MAX, ..good }).contains("too large"));
    }
}
