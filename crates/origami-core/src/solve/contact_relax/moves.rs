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
            row_sums(self.model, &self.positions, &mut self.springs);
        }
        for (force, [_, springs]) in self.forces.iter_mut().zip(self.kernel.positions_and_forces()) {
            *force = springs;
        }
        self.masses.copy_from_slice(&self.springs);
        let felt = self.layers.felt(&self.positions);
        for ((force, mass), [x, y, z, sum]) in self.forces.iter_mut().zip(&mut self.masses).zip(felt) {
            *force += DVec3::new(*x, *y, *z);
            *mass += sum;
        }
        if !felt.is_empty() {
            self.surroundings.held().clear(&mut self.forces);
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
        let mut sums = Sums::default();
        for ((force, velocity), mass) in self.forces.iter().zip(&self.velocities).zip(&self.masses) {
            sums.power += force.dot(*velocity);
            sums.speed += mass * velocity.length_squared();
            sums.pull += force.length_squared() / mass;
        }
        let Decision { step, keep, towards_force, back } = fire_update(&mut self.fire, sums);
        let longest = self.layers.longest_move();
        let mut largest = 0.0_f64;
        for (((by, velocity), force), mass) in
            self.moves.iter_mut().zip(&mut self.velocities).zip(&self.forces).zip(&self.masses)
        {
            let old = *velocity;
            *velocity = keep * old + (towards_force / mass) * *force;
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
