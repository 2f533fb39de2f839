//! Areas of triangles, kept from collapse (see [`crate::forces::areas`]).

use super::lane::{GatherScatter, Num};
use super::real::Real;
use crate::forces::areas::THRESHOLD;

/// How strongly triangles pull their corners along the normal times the side opposite to each, where they have the `rest`
/// lengths; `None` where all have enough of their areas.
#[inline(always)]
pub(super) fn pull<L: GatherScatter>(
    k_area: f64,
    [ab, bc, ca]: [Num<L>; 3],
    doubled_area: Num<L>,
    over_area: Num<L>,
) -> Option<Num<L>> {
    let lane = doubled_area.lane;
    let number = |x: f64| Num::splat(lane, x);
    // A triangle has at most half the area of a rectangle on two of its sides: so most are known to have enough.
    if (number(THRESHOLD) * ab * ca).less(doubled_area).all() {
        return None;
    }
    // Heron: the square of twice the area is the product of two squared sides less the square of their dot product. What
    // rounding could add to it is left off, so that nothing pulls at a thin triangle at rest.
    let (ab_squared, ca_squared) = (ab * ab, ca * ca);
    let dot = bc.sub_mul(bc, ab_squared + ca_squared) * number(0.5);
    let certain = number(1.0 - 8.0 * L::Real::EPSILON);
    let at_rest = dot.sub_mul(dot, ab_squared * ca_squared * certain);
    let threshold_squared = number(THRESHOLD * THRESHOLD) * at_rest;
    let squared = doubled_area * doubled_area;
    if threshold_squared.less(squared).all() {
        return None;
    }
    let threshold = threshold_squared.sqrt();
    let stiffness = number(k_area) * (ab + bc + ca) * over_area;
    let pull = stiffness * (threshold * over_area).mul_sub(over_area, number(1.0) / threshold);
    Some(squared.less(threshold_squared).select(pull, number(0.0)))
}
