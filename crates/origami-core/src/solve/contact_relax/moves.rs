//! One evaluation under contact, and one move.

use glam::DVec3;

use super::super::row_sums::row_sums;
use super::run::Run;
use crate::twins::fire_update::{Decision, RENEWAL, Sums, fire_update};

impl Run<'_> {
    /// Forces and masses at the present positions; the result is the most by which a crease turned, in radians.
    pub(super) fn evaluate(&mut self) -> f64 {
        self.kernel.set_positions(&self.positions);
        let turned = self.kernel.springs(false);
        if self.steps.is_multiple_of(RENEWAL) {
            let mut sums = vec![0.0; self.springs.len()];
            row_sums(self.model, &self.positions, &mut sums);
            self.springs.iter_mut().zip(sums).for_each(|(own, sum)| *own = [sum, 1.0 / sum]);
        }
        self.kernel.reduce_forces(&self.springs);
        self.kernel.read_forces(&mut self.forces);
        let felt = self.layers.felt(&self.positions);
        self.felt = !felt.is_empty();
        if self.felt {
            for (force, [x, y, z, _]) in self.forces.iter_mut().zip(felt) {
                *force += DVec3::new(*x, *y, *z);
            }
            self.masses.weigh(self.springs.iter().zip(felt).map(|([springs, _], [.., sum])| springs + sum));
            self.surroundings.held().clear(&mut self.forces);
            self.masses.hold(self.layers.stiff(), &self.forces);
        }
        self.touch.most_pairs = self.touch.most_pairs.max(self.layers.listed());
        turned
    }

    /// Takes note of an evaluation; true when the state has settled. What contact has just held up has not.
    pub(super) fn settled(&mut self) -> bool {
        if self.touch.limited > 0 && self.last_limited + 1 == self.steps {
            self.settling.disturb();
        }
        self.settling.observe(self.positions.iter().zip(&self.forces).map(|(p, f)| [*p, *f]))
    }

    /// One move by FIRE, shortened where something is in the way.
    pub(super) fn advance(&mut self) {
        let forces = self.forces.as_slice();
        let (masses, left, speed) = if self.felt {
            (&self.masses.nodes, self.masses.left(forces), self.masses.speed(&self.velocities))
        } else {
            (&self.springs, forces, 0.0)
        };
        let mut sums = Sums { speed, ..Sums::default() };
        for (((force, left), velocity), [mass, inverse]) in forces.iter().zip(left).zip(&self.velocities).zip(masses) {
            sums.power += force.dot(*velocity);
            sums.speed += mass * velocity.length_squared();
            sums.pull += force.dot(*left) * inverse;
        }
        let Decision { step, keep, towards_force, back } = fire_update(&mut self.fire, sums);
        let longest = self.layers.longest_move();
        let mut largest = 0.0_f64;
        for (((by, velocity), left), [_, inverse]) in
            self.moves.iter_mut().zip(&mut self.velocities).zip(left).zip(masses)
        {
            let old = *velocity;
            *velocity = keep * old + (towards_force * inverse) * *left;
            *by = step * *velocity + back * old;
            let square = by.length_squared();
            if square > longest * longest {
                let share = longest / square.sqrt();
                *by *= share;
                *velocity *= share;
            }
            largest = largest.max(square);
        }
        let mut largest = largest.sqrt().min(longest);
        let mut limited = false;
        if self.layers.in_the_way(&self.positions, largest) {
            let shares = self.layers.limit(&self.positions, &self.moves);
            let mut made = 0.0_f64;
            for ((by, velocity), share) in self.moves.iter_mut().zip(&mut self.velocities).zip(shares) {
                if *share < 1.0 {
                    limited = true;
                    *by *= *share;
                    *velocity *= *share;
                }
                made = made.max(by.length_squared());
            }
            largest = made.sqrt();
        }
        for (p, by) in self.positions.iter_mut().zip(&self.moves) {
            *p += *by;
        }
        self.layers.moved(largest);
        if limited {
            self.touch.limited += 1;
            self.last_limited = self.steps;
            self.touch.first_limited.get_or_insert(self.ramp.share());
        }
    }
}
