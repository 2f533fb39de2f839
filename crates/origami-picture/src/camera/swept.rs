//! Turntables.

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
