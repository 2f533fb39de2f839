//! Stiffnesses of bars and hinges from a sheet of isotropic material.
//!
//! - Bars: a triangle of area S gives each of its sides the area `2 t S / ((1 - nu) (sum of its sides))`, which stores what
//!   the sheet does when it is stretched alike in all directions, and only then: in one direction the modulus and Poisson's
//!   ratio depend on the triangles' shape. The rule of MERLIN2 (K. Liu and G. H. Paulino, 7OSME 2018) for triangles.
//! - Facets: `D (l / t)^(1/3)` for a hinge of length l, with `D = E t^3 / (12 (1 - nu^2))`; E. T. Filipov, K. Liu, T. Tachi,
//!   M. Schenk, G. H. Paulino, Bar and hinge models for scalable analysis of origami, Int. J. Solids Structures 124 (2017).
//! - Creases: what a crease has of its own, `D l / L*`, in series with the facets beside it, `0.55 D (l / t)^(1/3)`; the same
//!   paper. L*, the length scale of F. Lechenault, B. Thiria, M. Adda-Bedia, Mechanical response of a creased sheet, Phys. Rev.
//!   Lett. 112 (2014), is a length: some 20 to 100 times the thickness of paper, and to be measured.

use serde::{Deserialize, Serialize};

use crate::error::{Error, ErrorCode, Place};

/// An isotropic sheet, in the job's units.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct SheetMaterial {
    /// Young's modulus, a force per length squared. Larger: everything is stiffer. Above 0.
    #[serde(rename = "E")]
    pub modulus: f64,
    /// Poisson's ratio, without unit. Larger: stiffer when stretched in all directions. At least 0 and below 0.5.
    pub nu: f64,
    /// Thickness, a length. Thicker: bars stiffer in proportion, hinges by its cube. Above 0.
    pub t: f64,
    /// Density, a mass per length cubed; only vibrations need it. Above 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<f64>,
}

impl SheetMaterial {
    pub(super) fn check(&self) -> Result<(), Error> {
        let wrong = |key, x: f64, expected| {
            Err(Error::new(ErrorCode::WrongValue, Place::key(key), format!("is {x}"), expected))
        };
        if !(self.modulus.is_finite() && self.modulus > 0.0) {
            return wrong("sheet.E", self.modulus, "a number above 0");
        }
        if !(0.0..0.5).contains(&self.nu) {
            return wrong("sheet.nu", self.nu, "a number of at least 0 and below 0.5");
        }
        if !(self.t.is_finite() && self.t > 0.0) {
            return wrong("sheet.t", self.t, "a number above 0");
        }
        match self.density {
            Some(density) if !(density.is_finite() && density > 0.0) => {
                wrong("sheet.density", density, "a number above 0")
            }
            _ => Ok(()),
        }
    }

    /// What a triangle adds to the rigidity EA of each of its sides.
    pub(super) fn rigidity(&self, area: f64, sides: f64) -> f64 {
        self.modulus * 2.0 * self.t * area / ((1.0 - self.nu) * sides)
    }

    /// Bending stiffness of a plate, a moment per length and curvature.
    fn bending(&self) -> f64 {
        self.modulus * self.t.powi(3) / (12.0 * (1.0 - self.nu * self.nu))
    }

    /// Stiffness of a whole facet hinge, a moment per radian.
    pub(super) fn facet(&self, length: f64) -> f64 {
        self.bending() * (length / self.t).cbrt()
    }

    /// Stiffness of a whole crease, a moment per radian; `scale` is L*.
    pub(super) fn crease(&self, length: f64, scale: f64) -> f64 {
        let (own, beside) = (self.bending() * length / scale, 0.55 * self.facet(length));
        own * beside / (own + beside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merlin2s_waterbomb_has_its_areas_and_stiffnesses() {
        // Its example: E 10, nu 0.33, thickness 1, L* 50; one triangle between (0, 0, 20), (70, 0, 0) and (100, 100, 0).
        let sheet = SheetMaterial { modulus: 10.0, nu: 0.33, t: 1.0, density: None };
        let sides = [5300_f64.sqrt(), 20_400_f64.sqrt(), 10_900_f64.sqrt()];
        let area = 0.5 * (2000.0_f64.powi(2) + 600.0_f64.powi(2) + 7000.0_f64.powi(2)).sqrt();
        let rigidity = sheet.rigidity(area, sides.iter().sum());
        assert!((rigidity / 10.0 - 34.06737790063368).abs() < 1e-12, "{rigidity}");
        // It takes L* for a ratio to the crease's length.
        for (length, wanted) in [(sides[0], 0.00025469392901349906), (sides[1], 0.00013004584450080454)] {
            let per_length = sheet.crease(length, 50.0 * length) / length;
            assert!((per_length / wanted - 1.0).abs() < 1e-12, "{per_length}");
        }
    }

    #[test]
    fn stretched_alike_in_all_directions_bars_store_what_the_sheet_does() {
        let sheet = SheetMaterial { modulus: 7.0, nu: 0.2, t: 0.1, density: None };
        let (area, sides) = (1.7, [2.0, 1.9, 2.5]);
        let (strain, total) = (1e-3, sides.iter().sum::<f64>());
        let bars: f64 = sides.iter().map(|l| 0.5 * sheet.rigidity(area, total) * l * strain * strain).sum();
        // E t e^2 / (1 - nu) for each area.
        let plate = 7.0 * 0.1 * strain * strain / 0.8 * area;
        assert!((bars / plate - 1.0).abs() < 1e-12);
    }
}
