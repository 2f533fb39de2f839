//! First pass: the fold angle of every crease and the moment of its spring (paper 2.3).

use super::angle::{angle_of, unwrapped};
use super::isa::{Compute, Pass};
use super::lane::{GatherScatter, Num, Vec3};
use super::real::{Quad64, Real};
use super::share::Cut;
use crate::model::DEGENERATE;

/// Writes angles and moments; the result is the most by which a crease turned, in radians.
pub(super) struct FoldAngles<'a, R: Real> {
    pub(super) positions: &'a [Quad64],
    /// By chunk of creases: apexes one and two, ends one and two.
    pub(super) hinges: &'a [u32],
    pub(super) stiffness: &'a [R],
    pub(super) targets: &'a [R],
    /// What pulls a crease back to flat from the side that its target is not on, in units of its stiffness.
    pub(super) wrong_side: f64,
    pub(super) angles: &'a mut [R],
    pub(super) moments: &'a mut [R],
}

impl<R: Real> Pass<R> for FoldAngles<'_, R> {
    type Output = f64;

    #[inline(always)]
    fn run<L: GatherScatter<Real = R>>(self, lane: L) -> f64 {
        let mut most = Num::splat(lane, 0.0);
        let springs = self.stiffness.chunks_exact(L::WIDTH).zip(self.targets.chunks_exact(L::WIDTH));
        let states = self.angles.chunks_exact_mut(L::WIDTH).zip(self.moments.chunks_exact_mut(L::WIDTH));
        let hinges = self.hinges.chunks_exact(4 * L::WIDTH);
        for ((nodes, (stiffness, target)), (angles, moments)) in hinges.zip(springs).zip(states) {
            let previous = Num::load(lane, angles);
            let (stiffness, target) = (Num::load(lane, stiffness), Num::load(lane, target));
            let (angle, mut moment) = angle_and_moment(lane, self.positions, nodes, previous, target, stiffness);
            if self.wrong_side > 0.0 {
                moment = back_to_flat(moment, angle, target, stiffness * Num::splat(lane, self.wrong_side));
            }
            most = most.max((angle - previous).abs());
            angle.store(angles);
            moment.store(moments);
        }
        let mut each = [R::default(); 16];
        most.store(&mut each);
        each.iter().map(|turn| turn.to_f64()).fold(0.0, f64::max)
    }
}

impl<R: Compute> Cut<R> for FoldAngles<'_, R> {
    fn elements(&self) -> usize {
        self.stiffness.len()
    }

    fn cut(self, at: usize) -> (Self, Self) {
        let (hinges, other_hinges) = self.hinges.split_at(4 * at);
        let (stiffness, other_stiffness) = self.stiffness.split_at(at);
        let (targets, other_targets) = self.targets.split_at(at);
        let (angles, other_angles) = self.angles.split_at_mut(at);
        let (moments, other_moments) = self.moments.split_at_mut(at);
        let other = Self {
            positions: self.positions,
            hinges: other_hinges,
            stiffness: other_stiffness,
            targets: other_targets,
            wrong_side: self.wrong_side,
            angles: other_angles,
            moments: other_moments,
        };
        (
            Self {
                positions: self.positions,
                hinges,
                stiffness,
                targets,
                wrong_side: self.wrong_side,
                angles,
                moments,
            },
            other,
        )
    }

    fn both(one: f64, other: f64) -> f64 {
        one.max(other)
    }
}

/// The moment with what turns a crease back that is folded to the other side than its target.
#[inline(always)]
fn back_to_flat<L: GatherScatter>(moment: Num<L>, angle: Num<L>, target: Num<L>, stiffness: Num<L>) -> Num<L> {
    let [zero, pulls] = [0.0, L::Real::LEAST].map(|x| Num::splat(moment.lane, x));
    // A triangle beside it that is too thin leaves it without a moment.
    let wrong = (angle * target).less(zero) & pulls.less(moment.abs());
    wrong.select(stiffness.sub_mul(angle, moment), moment)
}

/// Fold angles and moments of the hinges on `nodes`.
#[inline(always)]
fn angle_and_moment<L: GatherScatter>(
    lane: L,
    positions: &[Quad64],
    nodes: &[u32],
    previous: Num<L>,
    target: Num<L>,
    stiffness: Num<L>,
) -> (Num<L>, Num<L>) {
    let (apexes, ends) = nodes.split_at(2 * L::WIDTH);
    let ((one, two), (end, other_end)) = (apexes.split_at(L::WIDTH), ends.split_at(L::WIDTH));
    let along = Vec3::new(lane, lane.gather_differences(positions, end, other_end));
    let to_one = Vec3::new(lane, lane.gather_differences(positions, end, one));
    let to_two = Vec3::new(lane, lane.gather_differences(positions, end, two));
    let (normal_one, normal_two) = (along.cross(to_one), to_two.cross(along));
    let squared = along.dot(along);
    let limit = Num::splat(lane, DEGENERATE * DEGENERATE);
    let least = limit * squared;
    // A crease that is not sound keeps its angle and pulls at nothing until it opens again.
    let sound = limit.less(squared) & least.less(normal_one.dot(normal_one)) & least.less(normal_two.dot(normal_two));
    let (y, x) = (squared.sqrt() * normal_two.dot(to_one), normal_one.dot(normal_two));
    let angle = sound.select(unwrapped(angle_of(y, x), previous), previous);
    (angle, sound.select(stiffness * (target - angle), Num::splat(lane, 0.0)))
}
