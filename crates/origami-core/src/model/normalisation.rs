//! The scale at which the paper's constants mean what they say.

use glam::DVec3;

use crate::error::{Error, ErrorCode, Place};

/// Maps file coordinates to a sheet whose farthest node lies at distance 1 from the centre of its bounding box.
///
/// Axial stiffness goes with 1 / length, crease stiffness with length and corner stiffness with neither: without this
/// the same material numbers would mean another material for every size of paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normalisation {
    /// Centre of the bounding box, in file units.
    pub centre: DVec3,
    /// Distance of the farthest node from the centre, in file units.
    pub radius: f64,
}

impl Normalisation {
    /// That of the sheet with nodes at `points`.
    ///
    /// # Errors
    /// [`Error::Invalid`] where all points coincide or lie too far apart for a finite radius.
    pub fn of(points: impl Iterator<Item = DVec3> + Clone) -> Result<Self, Error> {
        let (low, high) =
            points.clone().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
        let centre = 0.5 * low + 0.5 * high;
        let radius = points.map(|p| (p - centre).length()).fold(0.0, f64::max);
        if radius.is_finite() && radius > 0.0 && centre.is_finite() {
            Ok(Self { centre, radius })
        } else {
            let (place, problem) = (Place::key("vertices_coords"), format!("the sheet has radius {radius}"));
            Err(Error::new(ErrorCode::SheetSize, place, problem, "a finite radius above 0"))
        }
    }

    /// From file units to those of the model.
    #[must_use]
    pub fn to_model(&self, p: DVec3) -> DVec3 {
        (p - self.centre) / self.radius
    }

    /// From the model's units to those of the file.
    #[must_use]
    pub fn to_file(&self, p: DVec3) -> DVec3 {
        p * self.radius + self.centre
    }
}
