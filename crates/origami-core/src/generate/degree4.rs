//! The flat-foldable vertex of degree 4.

use std::f64::consts::{FRAC_PI_2, PI};

use super::builder::{SheetBuilder, between, positive, within};
use crate::error::Error;
use crate::pattern::CreasePattern;
use crate::rigid::{Degree4Mode, degree4};

/// A kite around one flat-foldable vertex: vertex 0 is the middle, vertex k the end of crease k; sectors
/// (a, b, pi - a, pi - b) counterclockwise, the first one after crease 1, which points along x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degree4 {
    /// First sector. Default 60 degrees.
    pub a: f64,
    /// Second sector. Default 80 degrees.
    pub b: f64,
    /// Which way it folds. Default [`Degree4Mode::A`].
    pub mode: Degree4Mode,
    /// How far the driven creases fold (1 and 3 in mode A, 2 and 4, the other way, in mode B). Default pi/2.
    pub angle: f64,
    /// Drive one crease alone (1 in mode A, 2 in mode B) and leave the others free: then the rigid folding is an exact
    /// equilibrium of no energy. Default false.
    pub driven_only: bool,
    /// Length of the creases. Default 1.
    pub radius: f64,
}

impl Default for Degree4 {
    fn default() -> Self {
        let [a, b] = [60.0f64, 80.0].map(f64::to_radians);
        Self { a, b, mode: Degree4Mode::A, angle: FRAC_PI_2, driven_only: false, radius: 1.0 }
    }
}

impl Degree4 {
    /// The pattern; all its fold angles, where not free, close exactly.
    ///
    /// # Errors
    /// If a sector is not above 0 and below pi, the angle not in -pi..=pi, or the radius not positive.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        between("a", self.a, 0.0, PI)?;
        between("b", self.b, 0.0, PI)?;
        within("angle", self.angle, -PI, PI)?;
        positive("radius", self.radius)?;
        let mut sheet = SheetBuilder::default();
        let middle = sheet.at(0.0, 0.0);
        let ends = [0.0, self.a, self.a + self.b, PI + self.b].map(|azimuth| {
            let (sin, cos) = azimuth.sin_cos();
            sheet.at(self.radius * cos, self.radius * sin)
        });
        let folds = degree4(self.a, self.b, self.mode, self.angle);
        let driven = match self.mode {
            Degree4Mode::A => 0,
            Degree4Mode::B => 1,
        };
        for (crease, (end, fold)) in ends.into_iter().zip(folds).enumerate() {
            if self.driven_only && crease != driven {
                sheet.free(middle, end);
            } else {
                sheet.crease(middle, end, fold);
            }
        }
        let [e1, e2, e3, e4] = ends;
        for (from, to) in [(e1, e2), (e2, e3), (e3, e4), (e4, e1)] {
            sheet.face(&[middle, from, to]);
        }
        Ok(sheet.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;
    use crate::pattern::Assignment;

    #[test]
    fn folds_flat_in_both_modes() {
        for mode in [Degree4Mode::A, Degree4Mode::B] {
            let pattern = Degree4 { mode, angle: PI, ..Degree4::default() }.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            assert_eq!(check::flat_foldable_vertices(&pattern), 1);
            check::folds_flat(&pattern);
        }
    }

    #[test]
    fn only_the_driven_crease_has_an_angle() {
        for (mode, driven, angle) in [(Degree4Mode::A, 0, 1.0), (Degree4Mode::B, 1, -1.0)] {
            let vertex = Degree4 { mode, angle: 1.0, driven_only: true, ..Degree4::default() };
            let pattern = vertex.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            for (i, edge) in pattern.edges.iter().take(4).enumerate() {
                assert_eq!(edge.fold_angle, (i == driven).then_some(angle));
                assert_eq!(edge.assignment == Assignment::Unassigned, i != driven);
            }
        }
    }

    #[test]
    fn bad_parameters_are_named() {
        let error = Degree4 { b: PI, ..Degree4::default() }.pattern().unwrap_err().to_string();
        assert!(error.starts_with("parameter b: is 180 degrees"), "{error}");
        assert!(Degree4 { angle: f64::INFINITY, ..Degree4::default() }.pattern().is_err());
    }
}
