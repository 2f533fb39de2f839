//! How long layers may move on as they do before they have come much nearer.

use glam::DVec3;

use super::Layers;

/// Pairs are listed up to so many times the skin beyond the gap where moves are long, ...
const WIDEST: f64 = 20.0;
/// ... and so many times farther than they ask for, so that a list lasts.
const WIDER: f64 = 1.5;
/// A pair with less than so many times the gap that is never used up is left to [`Layers::limit`].
const CLOSED: f64 = 2.0;

/// A step through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    pub(crate) time: f64,
    /// Whether some layers meet so hard that they all but touch: moves are to be shortened by [`Layers::limit`].
    pub(crate) limited: bool,
}

impl Layers {
    /// The longest time step, at most `longest`, in which no pair loses more than `share` of its gap as the nodes move on from
    /// the positions last measured; one that does not push yet may come as far into its width. What moves together with
    /// another thing does not come nearer to it.
    ///
    /// Along the normal of a pair every node of one thing stays ahead of every node of the other, so that a plane that moves on
    /// with them divides them all the time: with a share below 1 nothing goes through anything.
    pub(crate) fn longest_step(
        &mut self,
        (positions, velocities): (&[DVec3], &[DVec3]),
        share: f64,
        longest: f64,
    ) -> Step {
        self.ungroup();
        let swiftest = velocities.iter().map(|v| v.length_squared()).fold(0.0, f64::max).sqrt();
        self.widen(positions, swiftest * longest);
        // Pairs that are not listed are out of reach.
        let within = 0.25 * self.room;
        let mut step =
            Step { time: if swiftest * longest > within { within / swiftest } else { longest }, limited: false };
        let bound = self.look_for_near_within(positions, self.contact.gap + 2.0 * step.time * swiftest);
        let farthest = self.reach();
        let Self { pairs, soon, way, floor, .. } = self;
        for (brief, due) in soon.iter_mut() {
            if *due >= bound {
                continue;
            }
            let pair = &pairs[brief.number as usize];
            let near = pair.near(brief.number, positions);
            *due = near.gap.min(farthest) + 2.0 * *way;
            let closed = near.gap < CLOSED * *floor * pair.width;
            let may_lose = match near.gap - pair.width {
                beyond if beyond > 0.0 => beyond + share * pair.width,
                _ => share * (near.gap - *floor * pair.width).max(0.0),
            };
            let distance = near.gap + pair.closed;
            let (first, second) = pair.nodes.split_at(pair.split);
            for (one, other) in first.iter().flat_map(|one| second.iter().map(move |other| (*one, *other))) {
                let between = |of: &[DVec3]| (of[one.index()] - of[other.index()]).dot(near.normal);
                // As short where things part: a motion and the same backwards take the same steps, and energy does not drift.
                let (apart, closing) = (between(positions), between(velocities).abs());
                let may = may_lose + (apart - distance).max(0.0);
                if closing * step.time > may {
                    step.limited |= closed;
                    step.time = if closed { step.time } else { may / closing };
                }
            }
        }
        step
    }

    /// Lists pairs as far away as moves of that length ask for, in radii, as far as that goes.
    fn widen(&mut self, positions: &[DVec3], longest: f64) {
        let wanted = (4.0 * longest).clamp(self.skin, WIDEST * self.skin);
        if self.room < wanted || wanted < 0.5 * self.least_room {
            self.least_room = (WIDER * wanted).min(WIDEST * self.skin);
            self.room = self.least_room;
            self.listed_at.clear();
            self.measure(positions);
        }
    }
}
