//! Where a flat crease pattern lies, and where its points lie in a figure of it.

use origami_core::CreasePattern;
use origami_core::glam::DVec3;

/// The middle of the pattern's box and half of its diagonal; 1 where it has none.
pub(crate) fn extent(pattern: &CreasePattern) -> (DVec3, f64) {
    let low = pattern.vertices.iter().copied().reduce(DVec3::min).unwrap_or_default();
    let high = pattern.vertices.iter().copied().reduce(DVec3::max).unwrap_or_default();
    let radius = 0.5 * (high - low).length();
    (0.5 * low + 0.5 * high, if radius > 0.0 && radius.is_finite() { radius } else { 1.0 })
}

/// Where a point of the pattern lies in its [figure](crate::Figure::of_pattern).
pub(crate) fn in_figure(pattern: &CreasePattern, point: DVec3) -> [f32; 3] {
    let (centre, radius) = extent(pattern);
    ((point - centre) / radius).to_array().map(|x| x as f32)
}
