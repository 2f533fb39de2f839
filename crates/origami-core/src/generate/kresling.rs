//! Kresling: a twisted cylinder with two stable states.

use std::f64::consts::PI;

use glam::DVec3;

use super::builder::{at_least, between, positive, room};
use super::rolled::Lattice;
use crate::error::Error;
use crate::pattern::CreasePattern;
use crate::rigid::KreslingFold;

/// Storeys of equal triangles between n-gons, each turned against the one below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kresling {
    /// Sides of the polygons, at least 3. Default 6.
    pub n: usize,
    /// Storeys. Default 3.
    pub rows: usize,
    /// Circumradius of the polygons when folded. Default 1.
    pub radius: f64,
    /// Height of a storey when folded. Default 1.8.
    pub height: f64,
    /// Turn of a storey when folded, counterclockwise from above, in -pi..pi. Default 20 degrees.
    pub twist: f64,
}

impl Default for Kresling {
    fn default() -> Self {
        Self { n: 6, rows: 3, radius: 1.0, height: 1.8, twist: 20f64.to_radians() }
    }
}

impl Kresling {
    /// The flat strip, one cylinder wide; folded by its fold angles it is the cylinder; letters are seen from outside.
    ///
    /// # Errors
    /// If a count is too small, a length not positive, the twist not within -pi..pi, or the sheet too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        let (lattice, fold) = self.lattice()?;
        let [l, b, c] = fold.bars();
        // The corner (0, 1) at b from (0, 0) and at c from (-1, 0).
        let x = (c * c - b * b - l * l) / (2.0 * l);
        let y = (b * b - x * x).sqrt();
        let flat = |i: usize, j: usize| DVec3::new(l * i as f64 + x * j as f64, y * j as f64, 0.0);
        Ok(lattice.strip(flat, |i, j| fold.vertex(i, j)))
    }

    /// The closed cylinder in space. Edges are free hinges, or, if `driven`, fold by the angles that they have at rest.
    ///
    /// # Errors
    /// As [`Kresling::pattern`].
    pub fn ring(&self, driven: bool) -> Result<CreasePattern, Error> {
        let (lattice, fold) = self.lattice()?;
        Ok(lattice.ring(|i, j| fold.vertex(i, j), driven))
    }

    fn lattice(&self) -> Result<(Lattice<impl Fn(usize) -> bool>, KreslingFold), Error> {
        at_least("n", self.n, 3)?;
        at_least("rows", self.rows, 1)?;
        positive("radius", self.radius)?;
        positive("height", self.height)?;
        between("twist", self.twist, -PI, PI)?;
        room("n, rows", [self.n, self.rows], 1)?;
        let lattice = Lattice { columns: self.n, rows: self.rows, rising: |_| true };
        Ok((lattice, self.folded()))
    }

    /// The folded storey that the fold angles lead to.
    #[must_use]
    pub fn folded(&self) -> KreslingFold {
        KreslingFold { n: self.n, radius: self.radius, height: self.height, twist: self.twist }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;

    #[test]
    fn strip_closes_around_every_vertex() {
        let kresling = Kresling { n: 7, rows: 3, radius: 1.3, height: 0.8, twist: 0.9 };
        for twist in [0.9, -0.4] {
            let pattern = Kresling { twist, ..kresling }.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            assert!(check::closure(&pattern) < 1e-12);
        }
    }

    #[test]
    fn both_stable_states_have_the_same_strip() {
        let tall = Kresling::default();
        let second = tall.folded().second_state().unwrap();
        let short = Kresling { height: second.height, twist: second.twist, ..tall };
        let (tall, short) = (tall.pattern().unwrap(), short.pattern().unwrap());
        assert_eq!(check::side_lengths(&tall), check::side_lengths(&short));
        let ring = Kresling::default().ring(false).unwrap();
        check::sound(&ring, 0);
        assert_eq!(check::side_lengths(&tall), check::side_lengths(&ring));
        // ... and other fold angles.
        let folds = |p: &CreasePattern| p.edges.iter().filter_map(|e| e.fold_angle).collect::<Vec<_>>();
        assert!(folds(&tall).iter().zip(folds(&short)).any(|(one, other)| (one - other).abs() > 0.1));
    }

    #[test]
    fn driven_ring_has_the_angles_of_the_strip() {
        let kresling = Kresling { rows: 2, ..Kresling::default() };
        let mut around: Vec<f64> = kresling.ring(true).unwrap().edges.iter().filter_map(|e| e.fold_angle).collect();
        let mut strip: Vec<f64> = kresling.pattern().unwrap().edges.iter().filter_map(|e| e.fold_angle).collect();
        // Two storeys of the six sides that close the ring are the strip's border.
        assert_eq!(around.len(), strip.len() + 2);
        around.sort_by(f64::total_cmp);
        strip.sort_by(f64::total_cmp);
        assert!((around[0] - strip[0]).abs() < 1e-12);
        assert!((around[around.len() - 1] - strip[strip.len() - 1]).abs() < 1e-12);
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |k: Kresling| k.pattern().unwrap_err().to_string();
        assert!(message(Kresling { n: 2, ..Kresling::default() }).starts_with("parameter n: is 2;"));
        assert!(message(Kresling { twist: f64::NAN, ..Kresling::default() }).starts_with("parameter twist: is NaN"));
    }
}
