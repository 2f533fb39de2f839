//! Where a picture lies on the paper.

use glam::DVec3;

/// The place of each of `flat` on the flat sheet that they make, in the unit square: scaled so that its longer side is 1 long,
/// the aspect kept, its lower left corner at 0. So a picture put on the paper is not stretched. `None` if they do not all
/// lie at one height z.
#[must_use]
pub fn texture_coordinates(flat: &[DVec3]) -> Option<Vec<[f64; 2]>> {
    let low = flat.iter().copied().reduce(DVec3::min)?;
    let high = flat.iter().copied().reduce(DVec3::max)?;
    let size = (high - low).truncate().max_element();
    (high.z == low.z && size > 0.0 && size.is_finite())
        .then(|| flat.iter().map(|place| ((place - low).truncate() / size).to_array()).collect())
}
