//! FIRE, the fast inertial relaxation engine (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006), on masses equal to the
//! row sums of the stiffness: every node then moves at its own local step, and a step of 2 would be the stability limit.

/// The first step, in units of each node's own; 2 would be the limit of stability.
pub const FIRST_STEP: f64 = 0.42;
/// The longest step.
pub const LONGEST_STEP: f64 = 1.5;
/// The shortest step.
pub const SHORTEST_STEP: f64 = 0.028;
/// Factor of the step while it goes downhill.
pub const LONGER: f64 = 1.1;
/// Factor of the step where it went uphill.
pub const SHORTER: f64 = 0.5;
/// How much the velocity is turned towards the force.
pub const MIXING: f64 = 0.15;
/// How that share decays while it goes downhill.
pub const LESS_MIXING: f64 = 0.99;
/// Downhill steps before the step may grow.
pub const PATIENCE: u32 = 5;
/// Evaluations between two renewals of the masses: heights shrink as the sheet folds.
pub const RENEWAL: u64 = 50;
/// The ramp waits while a crease turns by more than this in one evaluation, in radians.
pub const HOLD: f64 = 0.1;

/// What FIRE remembers from one evaluation to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fire {
    /// The present step, in units of each node's own.
    pub step: f64,
    /// The share by which the velocity is turned towards the force.
    pub mixing: f64,
    /// Downhill evaluations since the last uphill one.
    pub downhill: u32,
}

impl Default for Fire {
    fn default() -> Self {
        Self { step: FIRST_STEP, mixing: MIXING, downhill: 0 }
    }
}

/// Sums over all nodes, in the norm of the masses.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sums {
    /// Force times velocity.
    pub power: f64,
    /// Mass times squared velocity.
    pub speed: f64,
    /// Squared force over mass.
    pub pull: f64,
}

/// How the velocities change and the nodes move: `v = keep v + towards_force F / m`, `x += step v + back v_old`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// In units of each node's own.
    pub step: f64,
    /// The share of the velocity that stays.
    pub keep: f64,
    /// Times force over mass is added to it.
    pub towards_force: f64,
    /// Times the old velocity is added to the displacement.
    pub back: f64,
}

/// One evaluation's decision: longer steps while the sheet goes downhill, a step back and a stop where it goes uphill.
pub fn fire_update(fire: &mut Fire, Sums { power, speed, pull }: Sums) -> Decision {
    let uphill = power < 0.0;
    if uphill {
        *fire = Fire { step: (SHORTER * fire.step).max(SHORTEST_STEP), mixing: MIXING, downhill: 0 };
    } else {
        fire.downhill += 1;
        if fire.downhill > PATIENCE {
            fire.step = (LONGER * fire.step).min(LONGEST_STEP);
            fire.mixing *= LESS_MIXING;
        }
    }
    let step = fire.step;
    if uphill {
        return Decision { step, keep: 0.0, towards_force: step, back: -0.5 * step };
    }
    let turn = if pull > 0.0 { fire.mixing * (speed / pull).sqrt() } else { 0.0 };
    Decision { step, keep: 1.0 - fire.mixing, towards_force: turn + step, back: 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A parabola of stiffness 1 on a mass of 1, where one step of length 1 of gradient descent would end.
    #[test]
    fn it_comes_to_rest_at_the_bottom_of_a_parabola() {
        let (mut fire, mut x, mut v) = (Fire::default(), 1.0_f64, 0.0_f64);
        for _ in 0..400 {
            let force = -x;
            let sums = Sums { power: force * v, speed: v * v, pull: force * force };
            let Decision { step, keep, towards_force, back } = fire_update(&mut fire, sums);
            let old = v;
            v = keep * v + towards_force * force;
            x += step * v + back * old;
        }
        assert!(x.abs() < 1e-10, "{x}");
    }

    #[test]
    fn uphill_it_stops_and_steps_back_half_a_step() {
        let mut fire = Fire { step: 1.0, mixing: 0.05, downhill: 30 };
        let decision = fire_update(&mut fire, Sums { power: -1e-9, speed: 1.0, pull: 1.0 });
        assert_eq!(fire, Fire { step: 0.5, mixing: MIXING, downhill: 0 });
        assert_eq!(decision, Decision { step: 0.5, keep: 0.0, towards_force: 0.5, back: -0.25 });
    }
}
