//! The waterbomb vertex: 2n equal sectors, alternately mountain and valley.

use std::f64::consts::PI;

use super::builder::{SheetBuilder, at_least, between, positive, room};
use crate::error::Error;
use crate::pattern::CreasePattern;
use crate::rigid::{waterbomb_folds, waterbomb_polar};

/// A regular 2n-gon with a crease to each corner, at the fold angles of one symmetric rigid state: vertex 0 is the
/// middle, vertex k the end of crease k.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WaterbombVertex {
    /// Half the number of creases, at least 3. Default 4.
    pub n: usize,
    /// Angle between the valley creases (1, 3, ..) and the axis of symmetry on the side of +z, above pi/n and below pi.
    /// Below pi/2 the rim pops up, above it pops down: the two branches that meet in the flat state. Default 70 degrees.
    pub polar: f64,
    /// Length of the creases. Default 1.
    pub radius: f64,
}

impl Default for WaterbombVertex {
    fn default() -> Self {
        Self { n: 4, polar: 70f64.to_radians(), radius: 1.0 }
    }
}

impl WaterbombVertex {
    /// The pattern; its fold angles close exactly.
    ///
    /// # Errors
    /// If n is too small, the radius not positive, or the polar angle out of its range.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("n", self.n, 3)?;
        between("polar", self.polar, PI / self.n as f64, PI)?;
        positive("radius", self.radius)?;
        room("n", [self.n, 0], 1)?;
        let mountains = waterbomb_polar(self.n, self.polar, false);
        let folds = waterbomb_folds(self.n, self.polar, mountains);
        let mut sheet = SheetBuilder::default();
        let middle = sheet.at(0.0, 0.0);
        let ends: Vec<_> = (0..2 * self.n)
            .map(|k| {
                let (sin, cos) = (PI * k as f64 / self.n as f64).sin_cos();
                sheet.at(self.radius * cos, self.radius * sin)
            })
            .collect();
        for (&end, &fold) in ends.iter().zip(folds.iter().cycle()) {
            sheet.crease(middle, end, fold);
        }
        for (&end, &next) in ends.iter().zip(ends.iter().cycle().skip(1)) {
            sheet.face(&[middle, end, next]);
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
    fn closes_with_alternating_letters() {
        for n in [3, 4, 7] {
            for polar in [70f64, 100.0, 120.0] {
                let vertex = WaterbombVertex { n, polar: polar.to_radians(), radius: 2.0 };
                let pattern = vertex.pattern().unwrap();
                check::sound_and_flat(&pattern, 1);
                assert!(check::closure(&pattern) < 1e-12);
                let letters: Vec<_> = pattern.edges.iter().map(|e| e.assignment).take(2 * n).collect();
                assert_eq!(letters, [Assignment::Valley, Assignment::Mountain].repeat(n));
            }
        }
    }

    #[test]
    fn both_branches_meet_in_the_flat_state() {
        let fold = |degrees: f64| {
            let vertex = WaterbombVertex { polar: degrees.to_radians(), ..WaterbombVertex::default() };
            vertex.pattern().unwrap().edges[0].fold_angle.unwrap()
        };
        assert!(fold(89.99) < 0.01 && fold(90.01) < 0.01);
        assert!(fold(80.0) > 0.5 && fold(100.0) > 0.1);
    }

    #[test]
    fn bad_parameters_are_named() {
        let vertex = WaterbombVertex { polar: 0.1, ..WaterbombVertex::default() };
        assert!(vertex.pattern().unwrap_err().to_string().starts_with("parameter polar: is"));
        assert!(WaterbombVertex { n: 2, ..vertex }.pattern().is_err());
    }
}
