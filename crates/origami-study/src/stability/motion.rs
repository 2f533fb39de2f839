//! Whether a step holds: the paper's motion for some thousand steps, its energy watched.

use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use std::fmt;

use origami_core::forces::Forces;
use origami_core::solve::{Diverged, Failed, Integrator};
use origami_core::{Dynamics, Model, Solver, State};

/// Pieces of a run; the energy is taken at the end of each.
pub(super) const PIECES: u64 = 10;
/// Of a damped run these pieces may gain energy: a thin triangle at which a target jumps takes large turns in few steps. At
/// their end no more may be left than the jump gave.
const EARLY: u64 = 5;
/// After that it may only lose energy; so much of what the jump gave it is forgiven, since the energy of a state of the
/// discrete motion swings a little where springs do not answer linearly.
const FORGIVEN: f64 = 0.01;
/// An undamped one keeps its energy; explicit steps make it swing, and with this factor it has grown.
const GROWN: f64 = 2.0;
/// Energies below it are rounding, in 64 bits.
pub(super) const ROUNDING: f64 = 1e-12;

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outcome {
    /// The run held to its end.
    Holds,
    /// Its energy grew, in this piece of the run (1 to 10) of the percentage.
    Grows {
        /// Which tenth of the run, from 1.
        piece: u64,
    },
    /// It left all bounds, and said where.
    Diverged {
        /// The step in which it did.
        step: u64,
        /// The vertex that it named.
        vertex: u32,
    },
    /// It failed otherwise than it should, or gave what is not finite as a result.
    Wrong(String),
}

impl Outcome {
    pub(super) fn holds(&self) -> bool {
        *self == Self::Holds
    }

    /// The same, `steps` later.
    fn after(self, steps: u64) -> Self {
        match self {
            Self::Diverged { step, vertex } => Self::Diverged { step: steps + step, vertex },
            other => other,
        }
    }

    /// What a solver's failure says of the run, as it should: where it diverged, with a finite state to go back to.
    pub(super) fn of_failed(model: &Model, failed: &Failed) -> Self {
        match failed {
            Failed::Diverged(diverged) if is_sensible(model, diverged) => {
                Self::Diverged { step: diverged.step, vertex: diverged.vertex.0 }
            }
            Failed::Diverged(diverged) => Self::Wrong(format!("senseless: {diverged}")),
            other => Self::Wrong(other.to_string()),
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Holds => f.write_str("holds"),
            Self::Grows { piece } => write!(f, "energy grows, tenth {piece}"),
            Self::Diverged { step, vertex } => write!(f, "diverged at step {step}, vertex {vertex}"),
            Self::Wrong(what) => write!(f, "wrong: {what}"),
        }
    }
}

fn is_sensible(model: &Model, diverged: &Diverged) -> bool {
    let named = model.mesh.node_of_vertex.get(diverged.vertex.index()).is_some_and(Option::is_some);
    named && diverged.step > diverged.last_good_step && is_finite(&diverged.last_good)
}

/// Whether every number of a state is finite.
pub(super) fn is_finite(state: &State) -> bool {
    let vectors = state.positions.iter().chain(&state.velocities);
    vectors.map(|v| v.is_finite()).chain(state.fold_angles.iter().map(|a| a.is_finite())).all(|finite| finite)
}

/// The energy of springs and motion.
pub(super) fn energy(model: &Model, state: &State) -> f64 {
    state.energy(model).total() + 0.5 * state.velocities.iter().map(|v| v.length_squared()).sum::<f64>()
}

/// The energy that steps of `dt` keep where springs answer linearly: near the longest step that holds, the energy itself
/// swings by a multiple of it.
///
/// With forces F it is `E + dt/2 v.F` for the semi-implicit Euler and `E - dt^2/8 F.F` for Verlet.
pub(super) fn kept_energy(model: &Model, state: &State, dt: f64, integrator: Integrator) -> f64 {
    let mut fold_angles = state.fold_angles.clone();
    let mut forces = Forces::new(model);
    let forces = forces.evaluate(&state.positions, &state.targets, &mut fold_angles).iter();
    let correction = if integrator == Integrator::Verlet {
        -0.125 * dt * dt * forces.map(|f| f.length_squared()).sum::<f64>()
    } else {
        0.5 * dt * forces.zip(&state.velocities).map(|(f, v)| f.dot(*v)).sum::<f64>()
    };
    energy(model, state) + correction
}

/// `solver` for one piece of a run of `steps`.
pub(super) fn piece(solver: Dynamics, steps: u64) -> Dynamics {
    Dynamics { steps: Some(steps / PIECES), ..solver }
}

/// A motion to be run: on whatever backend, [`PIECES`] for each percentage.
pub(super) struct Motion<'a> {
    /// Runs one piece.
    pub(super) solver: &'a dyn Solver,
    /// The scheme with which the solver integrates.
    pub(super) integrator: Integrator,
    /// How many steps a piece has.
    pub(super) each: u64,
    /// Energies below it say nothing.
    pub(super) rounding: f64,
}

impl Motion<'_> {
    /// Runs `model` from rest along `path`; where it held, with the state at the end.
    pub(super) fn run(&self, model: &Model, path: &[f64]) -> (Outcome, Option<State>) {
        let damped = model.material.zeta > 0.0;
        let mut session = self.solver.session(model);
        let mut done = 0;
        let mut state = State::at_rest(model);
        for percent in path {
            state.targets = model.targets(*percent);
            let at_first = energy(model, &state);
            let mut before = at_first;
            for piece in 1..=PIECES {
                let folded = match session.fold(&state, &Scene::percent(*percent), &mut unwatched) {
                    Ok(folded) if is_finite(&folded.state) => folded,
                    Ok(_) => return (Outcome::Wrong("not finite".into()), None),
                    Err(failed) => return (Outcome::of_failed(model, &failed).after(done), None),
                };
                state = folded.state;
                done += self.each;
                let now = kept_energy(model, &state, folded.time_step, self.integrator);
                let allowed = match (damped, piece) {
                    (false, _) => GROWN * at_first,
                    (true, ..EARLY) => f64::INFINITY,
                    (true, EARLY) => at_first,
                    (true, _) => before + FORGIVEN * at_first,
                };
                if now > allowed + self.rounding {
                    return (Outcome::Grows { piece }, None);
                }
                before = now;
            }
        }
        (Outcome::Holds, Some(state))
    }
}

#[cfg(test)]
mod tests {
    use origami_core::Material;
    use origami_core::generate::miura;
    use origami_core::solve::{TimeStep, time_step};

    use super::super::cases::patterns::hinge;
    use super::*;

    fn held(zeta: f64, factor: f64) -> Outcome {
        let model =
            Model::new(&miura(3, 3).expect("a sheet"), &Material { zeta, ..Material::default() }).expect("valid");
        let dt = factor * time_step::safe(&model, &model.rest, Integrator::Euler);
        let solver = Dynamics { time_step: TimeStep::Fixed(dt), ..Dynamics::default() };
        let solver = piece(solver, 1000);
        Motion { solver: &solver, integrator: Integrator::Euler, each: 100, rounding: ROUNDING }.run(&model, &[60.0]).0
    }

    #[test]
    fn short_steps_hold_and_long_ones_do_not() {
        for zeta in [0.0, 0.45, 1.0] {
            assert_eq!(held(zeta, 0.5), Outcome::Holds, "zeta {zeta}");
            assert!(matches!(held(zeta, 5.0), Outcome::Diverged { .. }), "zeta {zeta}");
        }
    }

    #[test]
    fn near_the_limit_a_crease_keeps_its_energy_to_a_little() {
        let material = Material { k_fold: 100.0, k_face: 0.0, zeta: 0.0, ..Material::default() };
        let model = Model::new(&hinge(1.0, 1e-4), &material).expect("valid");
        for integrator in [Integrator::Euler, Integrator::Verlet] {
            let dt = 0.99 * 2.0 / (4.0 * 100.0 * 2.0_f64).sqrt();
            let mut start = State::at_rest(&model);
            start.targets = model.targets(100.0);
            let first = kept_energy(&model, &start, dt, integrator);
            let mut plain = Vec::new();
            for steps in 1..40 {
                let time_step = TimeStep::Fixed(dt);
                let solver = Dynamics { time_step, integrator, steps: Some(steps), ..Dynamics::default() };
                let state = solver.fold(&model, &start, &Scene::percent(100.0), &mut unwatched).expect("holds").state;
                let kept = kept_energy(&model, &state, dt, integrator);
                assert!((kept / first - 1.0).abs() < 0.05, "{integrator:?}, {steps}: {kept} of {first}");
                plain.push(energy(&model, &state));
            }
            let (least, most) = plain.iter().fold((f64::MAX, 0.0_f64), |(a, b), e| (a.min(*e), b.max(*e)));
            assert!(most > 3.0 * least, "{integrator:?}: the plain energy swings from {least} to {most}");
        }
    }

    #[test]
    fn a_step_a_little_too_long_shakes_the_sheet() {
        let grown = [2.0, 2.5, 3.0].map(|factor| held(1.0, factor));
        assert!(grown.iter().any(|held| !held.holds()), "{grown:?}");
    }
}
