//! Points that fill a picture.

use origami_core::glam::DVec3;

/// Room in depth before and behind the sheet, in sizes of it: for what is moved nearer to be seen.
const SLACK: f64 = 0.25;

/// Where the camera stands, in its own axes.
pub(super) struct Fit {
    /// The point in the middle of the picture.
    pub(super) centre: [f64; 2],
    /// Pixels per radius; with perspective, at distance 1.
    pub(super) scale: f64,
    /// Along the line of sight, larger is nearer to the viewer: the eye, the nearest and the farthest point.
    pub(super) eye: f64,
    pub(super) near: f64,
    pub(super) far: f64,
    pub(super) perspective: bool,
}

impl Fit {
    pub(super) fn orthographic(seen: &[DVec3], room: [f64; 2]) -> Self {
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

    pub(super) fn perspective(seen: &[DVec3], room: [f64; 2], angle: f64) -> Self {
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
