//! A million steps: what the motion should keep, and whether it does.

use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use std::sync::atomic::{AtomicBool, Ordering};

use origami_core::generate::miura;
use origami_core::glam::DVec3;
use origami_core::solve::{Integrator, TimeStep, time_step};
use origami_core::{Dynamics, Material, Model, Newton, Relax, Solver, State};
use rayon::prelude::*;

use super::motion::{self, Outcome};
use crate::options::Deadline;

/// How often the drift of a run is sampled.
const SAMPLES: u64 = 100;
/// Those whose mean is taken at the beginning and at the end.
const ENDS: usize = 10;
/// A sheet that vibrates and turns: percentage that the target jumps to, and turns per unit of time in radians.
const JUMP: f64 = 20.0;
const SPIN: DVec3 = DVec3::new(0.01, 0.02, 0.03);

/// What is run for a million steps.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Start {
    /// Undamped: the target jumps, and the sheet spins.
    Spinning,
    /// A damped sheet, which comes to rest.
    AtRest,
    /// Damped: in the equilibrium at 60 %.
    Folded,
}

const CASES: [(&str, Start, Integrator, Step); 6] = [
    ("undamped, Euler, paper's step", Start::Spinning, Integrator::Euler, Step::Paper),
    ("undamped, Euler, safe step at rest, kept", Start::Spinning, Integrator::Euler, Step::Kept),
    ("undamped, Euler, safe step, renewed", Start::Spinning, Integrator::Euler, Step::Safe),
    ("undamped, Verlet, safe step at rest, kept", Start::Spinning, Integrator::Verlet, Step::Kept),
    ("damped, Euler, at rest", Start::AtRest, Integrator::Euler, Step::Safe),
    ("damped, Euler, folded equilibrium", Start::Folded, Integrator::Euler, Step::Safe),
];

/// Which time step a run takes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step {
    Paper,
    /// The safe one, never renewed.
    Kept,
    Safe,
}

/// A run with what came of it.
#[derive(Clone, Debug)]
pub(super) struct Drift {
    /// What was run, for tables.
    pub(super) name: &'static str,
    /// Whether the step was renewed on the way.
    pub(super) renewed: bool,
    /// How many steps the run has.
    pub(super) steps: u64,
    /// How the run ended.
    pub(super) outcome: Outcome,
    /// Of an undamped run: steps, and the energy that these steps keep, in shares of the energy at the start.
    pub(super) energies: Vec<(u64, f64)>,
    /// Largest distance of the centroid from where it was, in radii.
    pub(super) centroid: f64,
    /// Largest momentum: it should be 0. In masses of a node times radii per unit of time.
    pub(super) momentum: f64,
    /// Of an undamped run: largest change of the angular momentum, as a share of it.
    pub(super) angular_momentum: Option<f64>,
    /// Of a run that starts in an equilibrium: largest way of a vertex, in radii.
    pub(super) moved: Option<f64>,
}

impl Drift {
    /// Change of the mean energy from the first tenth of the run to the last, as a share.
    pub(super) fn of_energy(&self) -> Option<f64> {
        let mean = |part: &[(u64, f64)]| part.iter().map(|(_, e)| e).sum::<f64>() / part.len() as f64;
        let (first, last) = (self.energies.get(..ENDS)?, self.energies.get(self.energies.len().checked_sub(ENDS)?..)?);
        Some(mean(last) / mean(first) - 1.0)
    }
}

/// All cases, of `steps` each; those for which there was no time are left out.
pub(super) fn all(steps: u64, deadline: Deadline) -> (Vec<Drift>, bool) {
    let left_out = AtomicBool::new(false);
    let run = |case: &(&'static str, Start, Integrator, Step)| {
        if deadline.passed() {
            left_out.store(true, Ordering::Relaxed);
            return None;
        }
        run(*case, steps)
    };
    let drifts: Vec<Option<Drift>> = CASES.par_iter().map(run).collect();
    (drifts.into_iter().flatten().collect(), left_out.into_inner())
}

fn run((name, start, integrator, step): (&'static str, Start, Integrator, Step), steps: u64) -> Option<Drift> {
    let zeta = if start == Start::Spinning { 0.0 } else { Material::default().zeta };
    let model = Model::new(&miura(2, 2).ok()?, &Material { zeta, ..Material::default() }).ok()?;
    let (mut state, percent) = begin(&model, start)?;
    let time_step = match step {
        Step::Paper => TimeStep::Paper,
        Step::Kept => TimeStep::Fixed(time_step::safe(&model, &model.rest, integrator)),
        Step::Safe => TimeStep::Safe,
    };
    let each = (steps / SAMPLES).max(1);
    let solver = Dynamics { time_step, integrator, steps: Some(each), ..Dynamics::default() };
    let first = state.clone();
    let (energy, spin) = (motion::energy(&model, &first), angular_momentum(&first));
    let undamped = start == Start::Spinning;
    let mut drift = Drift {
        name,
        renewed: step == Step::Safe,
        steps: each * SAMPLES,
        outcome: Outcome::Holds,
        energies: Vec::new(),
        centroid: 0.0,
        momentum: 0.0,
        angular_momentum: undamped.then_some(0.0),
        moved: (!undamped).then_some(0.0),
    };
    for sample in 1..=SAMPLES {
        let dt;
        state = match solver.fold(&model, &state, &Scene::percent(percent), &mut unwatched) {
            Ok(folded) => {
                dt = folded.time_step;
                folded.state
            }
            Err(failed) => {
                drift.outcome = Outcome::of_failed(&model, &failed);
                return Some(drift);
            }
        };
        drift.centroid = drift.centroid.max(centroid(&state.positions).distance(centroid(&first.positions)));
        drift.momentum = drift.momentum.max(state.velocities.iter().sum::<DVec3>().length());
        if undamped {
            let now = motion::kept_energy(&model, &state, dt, integrator);
            drift.energies.push((sample * each, now / energy));
            let change = angular_momentum(&state).distance(spin) / spin.length();
            drift.angular_momentum = drift.angular_momentum.map(|most| most.max(change));
        } else {
            let ways = state.positions.iter().zip(&first.positions).map(|(p, q)| p.distance(*q));
            drift.moved = drift.moved.map(|most| ways.fold(most, f64::max));
        }
    }
    Some(drift)
}

/// The state to start from and the percentage asked for; `None` where no equilibrium is found.
fn begin(model: &Model, start: Start) -> Option<(State, f64)> {
    let at_rest = State::at_rest(model);
    match start {
        Start::AtRest => Some((at_rest, 0.0)),
        Start::Folded => {
            let near = Relax::default().fold_from_rest(model, 60.0).ok()?;
            let equilibrium = Newton::default().refine(model, &near.state).ok()?;
            equilibrium.converged.then_some((equilibrium.state, 60.0))
        }
        Start::Spinning => {
            // Off every symmetry, and with no momentum.
            let mut state = State::perturbed(model, 1e-2, 1);
            let middle = centroid(&state.positions);
            let arms = state.positions.iter().map(|p| SPIN.cross(*p - middle));
            state.velocities = arms.collect();
            state.targets = model.targets(JUMP);
            Some((state, JUMP))
        }
    }
}

fn centroid(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

fn angular_momentum(state: &State) -> DVec3 {
    state.positions.iter().zip(&state.velocities).map(|(p, v)| p.cross(*v)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn some_thousand_steps_keep_what_they_should() {
        let (drifts, left_out) = all(5000, Deadline::after(None));
        assert!(drifts.len() == CASES.len() && !left_out);
        for drift in &drifts {
            assert_eq!(drift.outcome, Outcome::Holds, "{}", drift.name);
            assert!(drift.centroid < 1e-10 && drift.momentum < 1e-10, "{}: {drift:?}", drift.name);
            assert!(drift.angular_momentum.unwrap_or(0.0) < 1e-9, "{}: {drift:?}", drift.name);
            assert!(drift.moved.unwrap_or(0.0) < 1e-9, "{}: {drift:?}", drift.name);
            assert!(drift.of_energy().unwrap_or(0.0).abs() < 0.1, "{}: {:?}", drift.name, drift.of_energy());
        }
    }

    #[test]
    fn a_change_of_energy_is_seen() {
        let model = Model::new(&miura(2, 2).expect("a sheet"), &Material::default()).expect("valid");
        let (state, percent) = begin(&model, Start::Spinning).expect("no equilibrium is needed");
        let solver = Dynamics { steps: Some(500), ..Dynamics::default() };
        let end = solver.fold(&model, &state, &Scene::percent(percent), &mut unwatched).expect("holds").state;
        assert!(motion::energy(&model, &end) < 0.5 * motion::energy(&model, &state), "damping takes energy");
        assert!(angular_momentum(&end).distance(angular_momentum(&state)) > 1e-3, "and stops the spin");
    }
}
