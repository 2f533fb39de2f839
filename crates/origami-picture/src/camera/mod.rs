//! From where a sheet is seen. The camera finds its place by itself: the points it is given fill the picture.

mod facing;
mod fit;
mod swept;

pub use swept::swept;

use origami_core::Error;
use origami_core::glam::DVec3;

use fit::Fit;

/// How depth shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Parallel lines stay parallel.
    Orthographic,
    /// What is far looks smaller; the angle of view across the shorter side of the picture, in degrees (5 to 120).
    Perspective(f64),
}

/// A direction of view. Angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Where the viewer stands, counterclockwise from the x axis seen from above. Default -60.
    pub azimuth: f64,
    /// How high the viewer stands over the sheet's plane; 90 looks straight down. Default 35.
    pub elevation: f64,
    /// The camera's turn about its line of sight, clockwise: the picture turns counterclockwise. Default 0.
    pub roll: f64,
    /// Magnification after fitting; 1 shows everything. Default 1.
    pub zoom: f64,
    /// Default [`Projection::Orthographic`].
    pub projection: Projection,
}

impl Default for Camera {
    fn default() -> Self {
        Self { azimuth: -60.0, elevation: 35.0, roll: 0.0, zoom: 1.0, projection: Projection::Orthographic }
    }
}

/// The part of a picture that the sheet is fitted into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The picture's width in pixels.
    pub width: u32,
    /// The picture's height in pixels.
    pub height: u32,
    /// Pixels left free: left, top, right, bottom.
    pub margins: [f64; 4],
}

/// A camera in its place: what a renderer needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// From positions to clip space, by column: x to the right, y up, z from 0 (near) to 1 (far), as WebGPU has it.
    pub matrix: [[f32; 4]; 4],
    /// The unit vector to the viewer from the middle of the sheet.
    pub towards: [f32; 3],
    /// The unit vector that points up in the picture.
    pub up: [f32; 3],
    /// The unit vector to the light: over the viewer's left shoulder, whatever the direction of view.
    pub light: [f32; 3],
    /// The length that a pixel covers at the middle of the sheet, in radii.
    pub pixel: f32,
    /// How much clip depth (z over w) changes over the length of a pixel at the middle of the sheet.
    pub depth: f32,
}

impl View {
    /// How much clip depth changes over a radius at the middle of the sheet.
    #[must_use]
    pub fn depth_of_radius(&self) -> f64 {
        f64::from(self.depth) / f64::from(self.pixel)
    }
}

impl Camera {
    /// Names of the directions that have one.
    pub const NAMES: [&str; 4] = ["default", "top", "front", "isometric"];

    /// The direction of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Some(match name {
            "default" => Self::default(),
            "top" => Self::top(),
            "front" => Self::front(),
            "isometric" => Self::isometric(),
            _ => return None,
        })
    }

    /// Straight down, x to the right: as crease patterns are drawn.
    #[must_use]
    pub fn top() -> Self {
        Self { azimuth: -90.0, elevation: 90.0, ..Self::default() }
    }

    /// Along the sheet's plane, x to the right.
    #[must_use]
    pub fn front() -> Self {
        Self { azimuth: -90.0, elevation: 0.0, ..Self::default() }
    }

    /// All three axes equally long.
    #[must_use]
    pub fn isometric() -> Self {
        Self { azimuth: -45.0, elevation: (1.0 / 3.0_f64.sqrt()).asin().to_degrees(), ..Self::default() }
    }

    /// Right, up and towards the viewer.
    fn axes(&self) -> [DVec3; 3] {
        let ((sa, ca), (se, ce)) = (self.azimuth.to_radians().sin_cos(), self.elevation.to_radians().sin_cos());
        let towards = DVec3::new(ca * ce, sa * ce, se);
        let right = DVec3::new(-sa, ca, 0.0);
        let up = towards.cross(right);
        let (sr, cr) = self.roll.to_radians().sin_cos();
        [right * cr - up * sr, up * cr + right * sr, towards]
    }

    /// The camera in its place before `points`, all of which fill the frame.
    ///
    /// # Errors
    /// [`Error::Invalid`] for an angle, a zoom or a field of view that is out of range, and for a frame without room.
    pub fn view(&self, points: impl Iterator<Item = [f32; 3]>, frame: &Frame) -> Result<View, Error> {
        self.check()?;
        let [left, top, right, bottom] = frame.margins;
        let (width, height) = (f64::from(frame.width), f64::from(frame.height));
        let room = [width - left - right, height - top - bottom];
        if !room.iter().all(|side| *side >= 1.0) {
            let problem = format!("{} x {} pixels leave no room for the sheet", frame.width, frame.height);
            return Err(Error::invalid("size", problem, "a larger picture"));
        }
        let axes = self.axes();
        let seen: Vec<DVec3> = points
            .map(|p| DVec3::from_array(p.map(f64::from)))
            .map(|p| DVec3::new(p.dot(axes[0]), p.dot(axes[1]), p.dot(axes[2])))
            .collect();
        let fit = match self.projection {
            Projection::Orthographic => Fit::orthographic(&seen, room),
            Projection::Perspective(angle) => Fit::perspective(&seen, room, angle),
        };
        // The middle of the room, in clip space.
        let middle = [(left - right) / width, (bottom - top) / height];
        let scale = [2.0 * self.zoom * fit.scale / width, 2.0 * self.zoom * fit.scale / height];
        // Rows of the matrix over (right, up, towards, 1).
        let w = if fit.perspective { [0.0, 0.0, -1.0, fit.eye] } else { [0.0, 0.0, 0.0, 1.0] };
        let row = |axis: usize| -> [f64; 4] {
            let mut row = w.map(|x| x * middle[axis]);
            row[axis] += scale[axis];
            row[3] -= scale[axis] * fit.centre[axis];
            row
        };
        let (near, far) = (fit.eye - fit.near, fit.eye - fit.far);
        let z = if fit.perspective {
            let slope = far / (far - near);
            [0.0, 0.0, -slope, slope * (fit.eye - near)]
        } else {
            [0.0, 0.0, -1.0 / (fit.near - fit.far), fit.near / (fit.near - fit.far)]
        };
        let rows = [row(0), row(1), z, w];
        let mut matrix = [[0.0; 4]; 4];
        for (r, row) in rows.iter().enumerate() {
            let vector = axes[0] * row[0] + axes[1] * row[1] + axes[2] * row[2];
            for (column, value) in vector.to_array().into_iter().chain([row[3]]).enumerate() {
                matrix[column][r] = value as f32;
            }
        }
        let distance = if fit.perspective { fit.eye - 0.5 * (fit.near + fit.far) } else { 1.0 };
        let pixel = distance / (fit.scale * self.zoom);
        let depth = if fit.perspective {
            far * near / (far - near) / (distance * distance)
        } else {
            1.0 / (fit.near - fit.far)
        };
        let unit = |v: DVec3| v.to_array().map(|x| x as f32);
        let light = (axes[0] * -0.5 + axes[1] * 0.62 + axes[2] * 0.6).normalize();
        Ok(View {
            matrix,
            towards: unit(axes[2]),
            up: unit(axes[1]),
            light: unit(light),
            pixel: pixel as f32,
            depth: (depth * pixel) as f32,
        })
    }

    fn check(&self) -> Result<(), Error> {
        let angles = [("azimuth", self.azimuth), ("elevation", self.elevation), ("roll", self.roll)];
        for (name, angle) in angles {
            if !(-1e6..=1e6).contains(&angle) {
                return Err(Error::invalid(name, angle.to_string(), "an angle in degrees"));
            }
        }
        if !(1e-3..=1e3).contains(&self.zoom) {
            return Err(Error::invalid("zoom", self.zoom.to_string(), "0.001 to 1000"));
        }
        match self.projection {
            Projection::Perspective(angle) if !(5.0..=120.0).contains(&angle) => {
                Err(Error::invalid("field of view", angle.to_string(), "5 to 120 degrees"))
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests;
