//! Panels in a row.

use std::f64::consts::PI;

use super::builder::{SheetBuilder, at_least, positive, room, within};
use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// An accordion of rectangles along x; flat creases make it the strip of which buckling is tested.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strip {
    /// Panels. Default 10.
    pub panels: usize,
    /// Length of a panel. Default 1.
    pub length: f64,
    /// Width of the strip. Default 1.
    pub width: f64,
    /// Fold angle of the first crease, the next one has its opposite and so on; 0 for flat creases. Default pi.
    pub angle: f64,
}

impl Default for Strip {
    fn default() -> Self {
        Self { panels: 10, length: 1.0, width: 1.0, angle: PI }
    }
}

impl Strip {
    /// The pattern; vertices 2k and 2k + 1 are the ends of line k.
    ///
    /// # Errors
    /// If there is no panel, a length is not positive, the angle not in -pi..=pi, or the strip too long.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("panels", self.panels, 1)?;
        positive("length", self.length)?;
        positive("width", self.width)?;
        within("angle", self.angle, -PI, PI)?;
        room("panels", [self.panels, 0], 1)?;
        let mut sheet = SheetBuilder::default();
        let lines: Vec<[VertexId; 2]> =
            (0..=self.panels).map(|k| [0.0, self.width].map(|y| sheet.at(self.length * k as f64, y))).collect();
        for (k, pair) in lines.windows(2).enumerate() {
            let [[a, d], [b, c]] = [pair[0], pair[1]];
            sheet.face(&[a, b, c, d]);
            sheet.crease(b, c, if k % 2 == 0 { self.angle } else { -self.angle });
        }
        Ok(sheet.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;

    #[test]
    fn folds_flat_onto_one_panel() {
        let pattern = Strip { panels: 5, ..Strip::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        for place in check::folds_flat(&pattern) {
            assert!((place.x.abs() < 1e-12 || (place.x - 1.0).abs() < 1e-12) && place.y >= 0.0 && place.y <= 1.0);
        }
    }

    #[test]
    fn flat_strip_has_flat_creases() {
        let pattern = Strip { angle: 0.0, ..Strip::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        assert_eq!(pattern.edges.iter().filter(|e| e.fold_angle == Some(0.0)).count(), 9);
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |s: Strip| s.pattern().unwrap_err().to_string();
        assert!(message(Strip { panels: 0, ..Strip::default() }).starts_with("parameter panels: is 0;"));
        assert!(message(Strip { panels: usize::MAX, ..Strip::default() }).starts_with("parameter panels:"));
        assert!(message(Strip { width: -1.0, ..Strip::default() }).starts_with("parameter width: is -1;"));
    }
}
