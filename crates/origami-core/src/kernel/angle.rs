//! Angles: arc tangents of one's own, so that all lanes have the same.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use super::lane::{Lane, Num};
use super::real::Real;

/// The angle with sine and cosine proportional to `y` and `x`; 0 where both are 0.
#[inline(always)]
pub(super) fn angle_of<L: Lane>(y: Num<L>, x: Num<L>) -> Num<L> {
    let lane = y.lane;
    let zero = Num::splat(lane, 0.0);
    let (along, across) = (x.abs(), y.abs());
    let (far, near) = (along.max(across), along.min(across));
    // From pi/8 on turned back by pi/4: the series then sees at most tan(pi/8).
    let turned = (far * Num::splat(lane, 0.414_213_562_373_095_05)).less(near);
    let t = turned.select(near - far, near) / turned.select(near + far, far);
    let t = zero.less(far).select(t, zero);
    let angle = series(L::Real::ARCTANGENT, t) + turned.select(Num::splat(lane, FRAC_PI_4), zero);
    let angle = along.less(across).select(Num::splat(lane, FRAC_PI_2) - angle, angle);
    let angle = x.less(zero).select(Num::splat(lane, PI) - angle, angle);
    y.less(zero).select(-angle, angle)
}

/// The same of angles that are mostly small.
#[inline(always)]
pub(super) fn small_angle_of<L: Lane>(y: Num<L>, x: Num<L>) -> Num<L> {
    let small = y.abs().less(x * Num::splat(y.lane, 0.1));
    let angle = series(L::Real::SHORT_ARCTANGENT, y / x);
    if small.all() { angle } else { small.select(angle, angle_of(y, x)) }
}

/// `t + t^3 (...)`, by Horner's rule in two halves, of which neither waits for the other.
#[inline(always)]
fn series<L: Lane>(coefficients: &[f64], t: Num<L>) -> Num<L> {
    let q = t * t;
    let q2 = q * q;
    let last = coefficients.len() - 1;
    let [mut even, mut odd] = [Num::splat(t.lane, 0.0); 2];
    for (i, coefficient) in coefficients.iter().enumerate() {
        let coefficient = Num::splat(t.lane, *coefficient);
        let half = if (last - i).is_multiple_of(2) { &mut even } else { &mut odd };
        *half = if i < 2 { coefficient } else { half.mul_add(q2, coefficient) };
    }
    (t * q).mul_add(odd.mul_add(q, even), t)
}

/// The angle equal to `angle` up to whole turns that lies nearest to `previous`.
#[inline(always)]
pub(super) fn unwrapped<L: Lane>(angle: Num<L>, previous: Num<L>) -> Num<L> {
    let turns = ((previous - angle) * Num::splat(angle.lane, 1.0 / TAU)).round();
    turns.mul_add(Num::splat(angle.lane, TAU), angle)
}
