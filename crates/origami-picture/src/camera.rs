//! From where a sheet is seen. The camera finds its place by itself: the points it is given fill the picture.

use origami_core::Error;
use origami_core::glam::DVec3;

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
            if !(angle.abs() <= 1e6) {
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

/// Room in depth before and behind the sheet, in sizes of it: for what is moved nearer to be seen.
const SLACK: f64 = 0.25;

/// Points that stand for these turned about the vertical through their middle: a camera that is fitted to them sees a
/// turntable neither grow nor sway.
#[must_use]
pub fn swept(points: impl Iterator<Item = [f32; 3]> + Clone) -> Vec<[f32; 3]> {
    const BANDS: usize = 32;
    const TURNS: usize = 64;
    let bounds = |axis: usize| {
        let all = points.clone().map(|p| p[axis]);
        all.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let ((x0, x1), (y0, y1), (low, high)) = (bounds(0), bounds(1), bounds(2));
    let middle = [0.5 * (x0 + x1), 0.5 * (y0 + y1)];
    // The farthest from the axis, and the lowest and highest, of each band of heights.
    let mut bands = [(0.0_f32, f32::INFINITY, f32::NEG_INFINITY); BANDS];
    for [x, y, z] in points {
        let band = &mut bands[((z - low) / (high - low).max(1e-9) * (BANDS - 1) as f32) as usize % BANDS];
        *band = (band.0.max((x - middle[0]).hypot(y - middle[1])), band.1.min(z), band.2.max(z));
    }
    let turns = (0..TURNS).map(|i| (std::f32::consts::TAU * i as f32 / TURNS as f32).sin_cos());
    let rings = bands.iter().filter(|band| band.1 <= band.2).flat_map(|band| [(band.0, band.1), (band.0, band.2)]);
    let ring = |(radius, z): (f32, f32)| {
        turns.clone().map(move |(sin, cos)| [middle[0] + radius * cos, middle[1] + radius * sin, z])
    };
    rings.flat_map(ring).collect()
}

/// Where the camera stands, in its own axes.
struct Fit {
    /// The point in the middle of the picture.
    centre: [f64; 2],
    /// Pixels per radius; with perspective, at distance 1.
    scale: f64,
    /// Along the line of sight, larger is nearer to the viewer: the eye, the nearest and the farthest point.
    eye: f64,
    near: f64,
    far: f64,
    perspective: bool,
}

impl Fit {
    fn orthographic(seen: &[DVec3], room: [f64; 2]) -> Self {
        let (low, high) = bounds(seen);
        let size = high - low;
        // A sheet seen edge-on, or a single point, has a scale too.
        let least = size.max_element().max(1e-9) * 1e-3;
        let scale = (room[0] / size.x.max(least)).min(room[1] / size.y.max(least));
        let centre = (low + high) * 0.5;
        let slack = SLACK * size.max_element().max(1e-9);
        Self {
            centre: [centre.x, centre.y],
            scale,
            eye: high.z + slack,
            near: high.z + slack,
            far: low.z - slack,
            perspective: false,
        }
    }

    fn perspective(seen: &[DVec3], room: [f64; 2], angle: f64) -> Self {
        let (low, high) = bounds(seen);
        let size = (high - low).max_element().max(1e-9);
        let scale = 0.5 * room[0].min(room[1]) / (0.5 * angle.to_radians()).tan();
        let half = [0, 1].map(|axis| 0.5 * room[axis] / scale);
        let mut centre = [0.5 * (low.x + high.x), 0.5 * (low.y + high.y)];
        let eye = |centre: [f64; 2]| {
            let need = |p: &DVec3| p.z + ((p.x - centre[0]).abs() / half[0]).max((p.y - centre[1]).abs() / half[1]);
            seen.iter().map(need).fold(high.z + 0.1 * size, f64::max)
        };
        // What is near spreads over more of the picture: move the centre to where both sides are equally far out.
        for _ in 0..8 {
            let from = eye(centre);
            for axis in 0..2 {
                let out = |p: &DVec3| (p[axis] - centre[axis]) / (from - p.z);
                let (least, most) = seen
                    .iter()
                    .map(out)
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
                if least.is_finite() && most.is_finite() {
                    centre[axis] += 0.5 * (least + most) * (from - high.z);
                }
            }
        }
        let eye = eye(centre);
        let slack = (SLACK * size).min(0.9 * (eye - high.z));
        Self { centre, scale, eye, near: high.z + slack, far: low.z - slack, perspective: true }
    }
}

fn bounds(seen: &[DVec3]) -> (DVec3, DVec3) {
    let low = seen.iter().copied().reduce(DVec3::min).unwrap_or_default();
    let high = seen.iter().copied().reduce(DVec3::max).unwrap_or_default();
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points() -> Vec<[f32; 3]> {
        (0..60)
            .map(|i| i as f32)
            .map(|i| [(2.1 * i).sin(), (1.3 * i).cos() * 0.7, (0.7 * i).sin() * 0.4 + 3.0])
            .collect()
    }

    /// Clip coordinates over w.
    fn project(view: &View, p: [f32; 3]) -> [f64; 3] {
        let row = |r: usize| {
            (0..3).map(|c| f64::from(view.matrix[c][r]) * f64::from(p[c])).sum::<f64>() + f64::from(view.matrix[3][r])
        };
        [0, 1, 2].map(|r| row(r) / row(3))
    }

    #[test]
    fn everything_fills_the_frame_from_everywhere() {
        let frame = Frame { width: 300, height: 200, margins: [10.0, 20.0, 60.0, 4.0] };
        for projection in [Projection::Orthographic, Projection::Perspective(30.0), Projection::Perspective(100.0)] {
            for (azimuth, elevation, roll) in
                [(0.0, 0.0, 0.0), (-60.0, 35.0, 0.0), (200.0, -80.0, 33.0), (0.0, 90.0, 0.0)]
            {
                let camera = Camera { azimuth, elevation, roll, projection, ..Camera::default() };
                let view = camera.view(points().into_iter(), &frame).unwrap();
                let seen: Vec<[f64; 3]> = points().into_iter().map(|p| project(&view, p)).collect();
                let pixels = |p: &[f64; 3]| [(p[0] + 1.0) * 150.0, (1.0 - p[1]) * 100.0];
                let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
                for p in &seen {
                    assert!(p[2] > 0.0 && p[2] < 1.0, "depth {}", p[2]);
                    for (axis, x) in pixels(p).into_iter().enumerate() {
                        low[axis] = low[axis].min(x);
                        high[axis] = high[axis].max(x);
                    }
                }
                assert!(low[0] > 9.9 && high[0] < 240.1 && low[1] > 19.9 && high[1] < 196.1, "{low:?} {high:?}");
                let filled = ((high[0] - low[0]) / 230.0).max((high[1] - low[1]) / 176.0);
                // A wide angle would have the eye between the points.
                let least = if projection == Projection::Perspective(100.0) { 0.7 } else { 0.99 };
                assert!(filled > least, "{camera:?}: {filled}");
            }
        }
    }

    #[test]
    fn directions_are_what_their_names_say() {
        let frame = Frame { width: 200, height: 200, margins: [0.0; 4] };
        let cube = || (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 }));
        let top = Camera::top().view(cube(), &frame).unwrap();
        let [x, y, _] = project(&top, [1.0, 0.5, 0.0]);
        assert!((x - 1.0).abs() < 1e-6 && (y - 0.5).abs() < 1e-6, "{x} {y}");
        assert!(project(&top, [0.0, 0.0, 1.0])[2] < project(&top, [0.0, 0.0, -1.0])[2], "up is near");
        let front = Camera::front().view(cube(), &frame).unwrap();
        let [x, y, _] = project(&front, [1.0, 0.0, 0.5]);
        assert!((x - 1.0).abs() < 1e-6 && (y - 0.5).abs() < 1e-6, "{x} {y}");
        let isometric = Camera::isometric().view(cube(), &frame).unwrap();
        let origin = project(&isometric, [0.0; 3]);
        let length = |p: [f32; 3]| {
            let [x, y, _] = project(&isometric, p);
            (x - origin[0]).hypot(y - origin[1])
        };
        let lengths = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(length);
        assert!((lengths[0] - lengths[1]).abs() < 1e-6 && (lengths[0] - lengths[2]).abs() < 1e-6, "{lengths:?}");
        let turned = Camera { roll: 90.0, ..Camera::top() }.view(cube(), &frame).unwrap();
        let [x, y, _] = project(&turned, [1.0, 0.0, 0.0]);
        assert!(x.abs() < 1e-6 && (y - 1.0).abs() < 1e-6, "the x axis has turned counterclockwise: {x} {y}");
    }

    #[test]
    fn a_turntable_neither_grows_nor_sways_and_shows_everything() {
        let frame = Frame { width: 300, height: 200, margins: [10.0; 4] };
        let swept = swept(points().into_iter());
        let at = |azimuth| Camera { azimuth, ..Camera::default() }.view(swept.iter().copied(), &frame).unwrap();
        for azimuth in [0.0, 17.0, 45.0, 200.0] {
            assert!((at(azimuth).pixel / at(90.0).pixel - 1.0).abs() < 5e-3, "{azimuth}");
            for p in points() {
                let [x, y, z] = project(&at(azimuth), p);
                assert!(x.abs() < 1.0 && y.abs() < 1.0 && z > 0.0 && z < 1.0, "{azimuth} {p:?}");
            }
        }
    }

    #[test]
    fn a_pixel_is_as_long_and_as_deep_as_said() {
        let frame = Frame { width: 400, height: 400, margins: [0.0; 4] };
        let cube = || (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 1 { 1.0 } else { -1.0 }));
        for projection in [Projection::Orthographic, Projection::Perspective(40.0)] {
            let view = Camera { projection, ..Camera::top() }.view(cube(), &frame).unwrap();
            let middle = project(&view, [0.0; 3]);
            let [x, ..] = project(&view, [view.pixel, 0.0, 0.0]);
            assert!(((x - middle[0]) * 200.0 - 1.0).abs() < 1e-3);
            let [.., z] = project(&view, [0.0, 0.0, 10.0 * view.pixel]);
            assert!(((middle[2] - z) / (10.0 * f64::from(view.depth)) - 1.0).abs() < 0.05, "{projection:?}");
        }
    }

    #[test]
    fn strange_cameras_and_frames_are_refused() {
        let frame = Frame { width: 100, height: 100, margins: [0.0; 4] };
        let refused = |camera: Camera, frame: Frame| camera.view(points().into_iter(), &frame).is_err();
        assert!(refused(Camera { azimuth: f64::NAN, ..Camera::default() }, frame));
        assert!(refused(Camera { zoom: 0.0, ..Camera::default() }, frame));
        assert!(refused(Camera { projection: Projection::Perspective(180.0), ..Camera::default() }, frame));
        assert!(refused(Camera::default(), Frame { margins: [50.0; 4], ..frame }));
        // A point and nothing at all are seen all the same.
        for points in [vec![[1.0; 3]], vec![]] {
            let view = Camera::default().view(points.into_iter(), &frame).unwrap();
            assert!(view.matrix.iter().flatten().all(|x| x.is_finite()));
        }
    }
}
