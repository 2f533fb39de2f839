//! Concentric curved creases.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::builder::{SheetBuilder, at_least, between, positive, room};
use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::CreasePattern;

/// A ring, or a sector of one, pleated along concentric arcs with alternating letters; each arc is a polyline, and flat
/// rulings run along the radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvedPleat {
    /// Creases. Default 3.
    pub creases: usize,
    /// Straight pieces of each arc. Default 48.
    pub segments: usize,
    /// Radius of the inner border. Default 0.5.
    pub inner: f64,
    /// Distance between arcs. Default 0.25.
    pub width: f64,
    /// Angle that the arcs span, above 0; a whole turn closes the ring. Default a whole turn, 2 pi.
    pub sweep: f64,
    /// How far the creases fold, the first one as a mountain; above 0 and at most pi. Default pi/2.
    pub angle: f64,
}

impl Default for CurvedPleat {
    fn default() -> Self {
        Self { creases: 3, segments: 48, inner: 0.5, width: 0.25, sweep: TAU, angle: FRAC_PI_2 }
    }
}

impl CurvedPleat {
    /// The pattern, in trapezoids.
    ///
    /// # Errors
    /// If a count is 0, a length not positive, an angle out of its range, a segment spans half a turn, or the sheet is
    /// too large.
    pub fn pattern(&self) -> Result<CreasePattern, Error> {
        at_least("creases", self.creases, 1)?;
        at_least("segments", self.segments, 1)?;
        positive("inner", self.inner)?;
        positive("width", self.width)?;
        between("angle", self.angle, 0.0, PI.next_up())?;
        // A closed ring is met to rounding, so that 360 degrees close it however they were converted.
        between("sweep", self.sweep, 0.0, TAU + 1e-12)?;
        let closed = TAU - self.sweep < 1e-9;
        at_least("segments", self.segments, if closed { 3 } else { 1 + (self.sweep / PI) as usize })?;
        room("creases, segments", [self.creases, self.segments], 1)?;

        let mut sheet = SheetBuilder::default();
        let points = if closed { self.segments } else { self.segments + 1 };
        let arc = |sheet: &mut SheetBuilder, k: usize| -> Vec<VertexId> {
            let radius = self.inner + self.width * k as f64;
            let azimuth = |i: usize| self.sweep * i as f64 / self.segments as f64;
            (0..points).map(|i| sheet.at(radius * azimuth(i).cos(), radius * azimuth(i).sin())).collect()
        };
        let mut inner = arc(&mut sheet, 0);
        for k in 1..=self.creases + 1 {
            let outer = arc(&mut sheet, k);
            let angle = if k % 2 == 1 { -self.angle } else { self.angle };
            for i in 0..self.segments {
                let next = (i + 1) % points;
                sheet.face(&[inner[i], outer[i], outer[next], inner[next]]);
                sheet.crease(outer[i], outer[next], angle);
            }
            inner = outer;
        }
        Ok(sheet.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::check;

    #[test]
    fn ring_and_sector_are_sound() {
        let ring = CurvedPleat { creases: 2, segments: 5, ..CurvedPleat::default() };
        let pattern = ring.pattern().unwrap();
        check::sound_and_flat(&pattern, 0);
        assert_eq!(pattern.edges.iter().filter(|e| e.fold_angle.is_some_and(|angle| angle != 0.0)).count(), 10);
        let sector = CurvedPleat { sweep: 1.5, segments: 1, ..ring }.pattern().unwrap();
        check::sound_and_flat(&sector, 1);
        assert_eq!(sector.vertices.len(), 8);
    }

    #[test]
    fn a_turn_in_degrees_closes() {
        let pattern = CurvedPleat { sweep: 360f64.to_radians(), ..CurvedPleat::default() }.pattern().unwrap();
        check::sound_and_flat(&pattern, 0);
    }

    #[test]
    fn bad_parameters_are_named() {
        let message = |c: CurvedPleat| c.pattern().unwrap_err().to_string();
        let good = CurvedPleat::default();
        assert!(message(CurvedPleat { segments: 2, ..good }).starts_with("parameter segments: is 2;"));
        assert!(message(CurvedPleat { segments: 1, sweep: PI, ..good }).starts_with("parameter segments"));
        assert!(message(CurvedPleat { sweep: 7.0, ..good }).starts_with("parameter sweep"));
        assert!(message(CurvedPleat { creases: usize::MAX, ..good }).contains("too large"));
    }
}
