//! Two triangles.

use std::f64::consts::PI;

use super::builder::{SheetBuilder, positive, within};
use crate::error::Error;
use crate::pattern::CreasePattern;

/// Two triangles that share one crease: vertices 0 and 1 are the apexes, 2 and 3 the ends of the crease.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingleCrease {
    /// Length of the crease. Default 1.
    pub length: f64,
    /// Height of each apex over the middle of the crease. Default 1.
    pub height: f64,
    /// Fold angle, valley positive, 0 for a flat crease. Default pi.
    pub angle: f64,
}

impl Default for SingleCrease {
    fn default() -> Self {
        Self { length: 1.0, height: 1.0, angle: PI }
    }
}

impl SingleCrease {
    /// The pattern, the crease along y.
    ///
    /// # Errors
    /// If a length is not positive, or the angle is not in -pi..=pi.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        positive("length", self.length)?;
        positive("height", self.height)?;
        within("angle", self.angle, -PI, PI)?;
        let mut sheet = SheetBuilder::default();
        let left = sheet.at(-self.height, 0.0);
        let right = sheet.at(self.height, 0.0);
        let low = sheet.at(0.0, -self.length / 2.0);
        let high = sheet.at(0.0, self.length / 2.0);
        sheet.crease(low, high, self.angle);
        sheet.face(&[low, high, left]);
        sheet.face(&[high, low, right]);
        Ok(sheet.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;
    use crate::pattern::Assignment;

    #[test]
    fn letters_follow_the_sign() {
        for (angle, letter) in [(1.0, Assignment::Valley), (-1.0, Assignment::Mountain), (0.0, Assignment::Flat)] {
            let pattern = SingleCrease { angle, ..SingleCrease::default() }.pattern().unwrap();
            check::sound_and_flat(&pattern, 1);
            assert_eq!((pattern.edges[0].assignment, pattern.edges[0].fold_angle), (letter, Some(angle)));
        }
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |p: SingleCrease| p.pattern().unwrap_err().to_string();
        let good = SingleCrease::default();
        assert!(message(SingleCrease { length: 0.0, ..good }).starts_with("parameter length: is 0;"));
        assert!(message(SingleCrease { height: f64::NAN, ..good }).starts_with("parameter height: is NaN;"));
        assert_eq!(
            message(SingleCrease { angle: 200f64.to_radians(), ..good }),
            "parameter angle: is 200 degrees; expected an angle from -180 degrees to 180 degrees"
        );
    }
}
