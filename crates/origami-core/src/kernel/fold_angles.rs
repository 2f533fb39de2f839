//! First pass: the fold angle of every crease and the moment of its spring (paper 2.3).

use super::angle::{angle_of, unwrapped};
use super::lane::{GatherScatter, Num, Vec3};
use super::near::Near;
use super::real::Real;
use crate::model::DEGENERATE;

/// Writes the angles and moments of the creases of a block; the result is the most by which one turned, in radians.
///
/// All sines and cosines are found before the first angle: an angle takes long, and there is other work meanwhile.
#[inline(always)]
pub(super) fn fold_angles<L: GatherScatter>(
    lane: L,
    near: &Near<L::Real>,
    hinges: &[u8],
    (stiffness, targets, wrong_side): (&[L::Real], &[L::Real], f64),
    angles: &mut [L::Real],
    [sines, moments]: [&mut [L::Real]; 2],
) -> Num<L> {
    // The cosines are where the moments will be.
    let places = sines.chunks_exact_mut(L::WIDTH).zip(moments.chunks_exact_mut(L::WIDTH));
    for (nodes, (sines, cosines)) in hinges.chunks_exact(4 * L::WIDTH).zip(places) {
        let [sine, cosine] = sine_and_cosine(lane, near, nodes);
        sine.store(sines);
        cosine.store(cosines);
    }
    let mut most = Num::splat(lane, 0.0);
    let springs = stiffness.chunks_exact(L::WIDTH).zip(targets.chunks_exact(L::WIDTH));
    let places = sines.chunks_exact(L::WIDTH).zip(moments.chunks_exact_mut(L::WIDTH));
    for (((stiffness, target), angles), (sines, moments)) in springs.zip(angles.chunks_exact_mut(L::WIDTH)).zip(places)
    {
        let previous = Num::load(lane, angles);
        let (stiffness, target) = (Num::load(lane, stiffness), Num::load(lane, target));
        let (sine, cosine) = (Num::load(lane, sines), Num::load(lane, moments));
        let (angle, mut moment) = angle_and_moment([sine, cosine], previous, target, stiffness);
        if wrong_side > 0.0 {
            moment = back_to_flat(moment, angle, target, stiffness * Num::splat(lane, wrong_side));
        }
        most = most.max((angle - previous).abs());
        angle.store(angles);
        moment.store(moments);
    }
    most
}

/// Numbers in proportion to the sine and cosine of the fold angle of the hinges on `nodes`; 0 where a hinge is not sound.
#[inline(always)]
fn sine_and_cosine<L: GatherScatter>(lane: L, near: &Near<L::Real>, nodes: &[u8]) -> [Num<L>; 2] {
    let (apexes, ends) = nodes.split_at(2 * L::WIDTH);
    let ((one, two), (end, other_end)) = (apexes.split_at(L::WIDTH), ends.split_at(L::WIDTH));
    let along = Vec3::new(lane, lane.gather_differences(near, end, other_end));
    let to_one = Vec3::new(lane, lane.gather_differences(near, end, one));
    let to_two = Vec3::new(lane, lane.gather_differences(near, end, two));
    let (normal_one, normal_two) = (along.cross(to_one), to_two.cross(along));
    let squared = along.dot(along);
    let [zero, limit] = [0.0, DEGENERATE * DEGENERATE].map(|x| Num::splat(lane, x));
    let least = limit * squared;
    let sound = limit.less(squared) & least.less(normal_one.dot(normal_one)) & least.less(normal_two.dot(normal_two));
    let (y, x) = (squared.sqrt() * normal_two.dot(to_one), normal_one.dot(normal_two));
    [sound.select(y, zero), sound.select(x, zero)]
}

/// The moment with what turns a crease back that is folded to the other side than its target.
#[inline(always)]
fn back_to_flat<L: GatherScatter>(moment: Num<L>, angle: Num<L>, target: Num<L>, stiffness: Num<L>) -> Num<L> {
    let [zero, pulls] = [0.0, L::Real::LEAST].map(|x| Num::splat(moment.lane, x));
    // One that is not sound is without a moment.
    let wrong = (angle * target).less(zero) & pulls.less(moment.abs());
    wrong.select(stiffness.sub_mul(angle, moment), moment)
}

/// Fold angles and moments.
#[inline(always)]
fn angle_and_moment<L: GatherScatter>(
    [sine, cosine]: [Num<L>; 2],
    previous: Num<L>,
    target: Num<L>,
    stiffness: Num<L>,
) -> (Num<L>, Num<L>) {
    let zero = Num::splat(sine.lane, 0.0);
    // A crease that is not sound keeps its angle and pulls at nothing until it opens again.
    let sound = zero.less(sine.abs().max(cosine.abs()));
    let angle = sound.select(unwrapped(angle_of(sine, cosine), previous), previous);
    (angle, sound.select(stiffness * (target - angle), zero))
}
