//! A hub with many creases.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::builder::{SheetBuilder, at_least, positive, room, within};
use crate::error::Error;
use crate::pattern::CreasePattern;

/// A regular polygon with a crease from the middle to each corner, alternately valley and mountain. Vertices of high
/// valence are what breaks a time step that looks at one beam at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fan {
    /// Creases, an even number from 4. Default 16.
    pub valence: usize,
    /// Length of the creases. Default 1.
    pub radius: f64,
    /// Fold angle of the first crease, the next one has its opposite and so on. Default pi/2.
    pub angle: f64,
}

impl Default for Fan {
    fn default() -> Self {
        Self { valence: 16, radius: 1.0, angle: FRAC_PI_2 }
    }
}

impl Fan {
    /// The pattern; vertex 0 is the hub.
    ///
    /// # Errors
    /// If the valence is odd or too small, the radius not positive, or the angle not in -pi..=pi.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("valence", self.valence, 4)?;
        if self.valence % 2 == 1 {
            return Err(Error::invalid("parameter valence", format!("is {}", self.valence), "an even number"));
        }
        positive("radius", self.radius)?;
        within("angle", self.angle, -PI, PI)?;
        room("valence", [self.valence, 0], 1)?;
        let mut sheet = SheetBuilder::default();
        let hub = sheet.at(0.0, 0.0);
        let rim: Vec<_> = (0..self.valence)
            .map(|k| {
                let (sin, cos) = (TAU * k as f64 / self.valence as f64).sin_cos();
                sheet.at(self.radius * cos, self.radius * sin)
            })
            .collect();
        for (&end, sign) in rim.iter().zip([1.0, -1.0].into_iter().cycle()) {
            sheet.crease(hub, end, sign * self.angle);
        }
        for (&end, &next) in rim.iter().zip(rim.iter().cycle().skip(1)) {
            sheet.face(&[hub, end, next]);
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
    fn letters_alternate() {
        let pattern = Fan { valence: 6, ..Fan::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 1);
        assert_eq!((pattern.vertices.len(), pattern.faces.len()), (7, 6));
        let letters: Vec<_> = pattern.edges.iter().map(|e| e.assignment).take(6).collect();
        assert_eq!(letters, [Assignment::Valley, Assignment::Mountain].repeat(3));
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |f: Fan| f.pattern().unwrap_err().to_string();
        assert_eq!(message(Fan { valence: 7, ..Fan::default() }), "parameter valence: is 7; expected an even number");
        assert!(message(Fan { radius: 0.0, ..Fan::default() }).starts_with("parameter radius"));
    }
}
