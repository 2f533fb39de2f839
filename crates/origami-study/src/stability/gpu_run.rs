//! The same cases on a GPU, which computes in 32 bits: one after the other, since there is one GPU.

use origami_core::measure::align;
use origami_core::solve::{Integrator, TimeStep};
use origami_core::{Dynamics, State};

use super::cases::Case;
use super::found::{Budget, Found, follow, unpanicked};
use super::motion::{self, Motion, Outcome};
use crate::GpuChoice;
use crate::gpu_choice::OnEither;

/// Rounding of a position in 32 bits, in radii, with what summing makes of it.
const ROUNDING: f64 = 1e-6;

/// What a GPU made of a case.
#[derive(Clone, Debug)]
pub(super) struct GpuRun {
    /// How the motion in safe steps ended.
    pub(super) safe: Outcome,
    /// Largest distance from the state in 64 bits after the same steps, in radii.
    pub(super) after_steps: Option<f64>,
    /// How the relaxation ended: whether it converged, or how it failed.
    pub(super) relaxed: Result<bool, Outcome>,
    /// Largest distance from the equilibrium in 64 bits, or, where that is not known, from where the relaxation ended.
    pub(super) at_equilibrium: Option<f64>,
}

/// Runs a case once more; `None` without a GPU.
pub(super) fn run(case: &Case, found: &Found, budget: Budget, gpu: &GpuChoice) -> Option<GpuRun> {
    if !gpu.is_there() {
        return None;
    }
    let (safe, end) = unpanicked(|| motion(case, found, budget, gpu))
        .unwrap_or_else(|panic| (Outcome::Wrong(format!("panicked: {panic}")), None));
    let after_steps = found.end.as_ref().zip(end).map(|(in_64, in_32)| distance(in_64, &in_32));
    let relaxed = unpanicked(|| relax(case, found, budget, gpu))
        .unwrap_or_else(|panic| Err(Outcome::Wrong(format!("panicked: {panic}"))));
    let known = found.equilibrium.as_ref().or_else(|| found.relaxed.folded().map(|folded| &folded.state));
    let at_equilibrium = known.zip(relaxed.as_ref().ok()).map(|(in_64, (_, in_32))| distance(in_64, in_32));
    Some(GpuRun { safe, after_steps, relaxed: relaxed.map(|(converged, _)| converged), at_equilibrium })
}

fn distance(one: &State, other: &State) -> f64 {
    align(&one.positions, &other.positions).max
}

fn motion(case: &Case, found: &Found, budget: Budget, gpu: &GpuChoice) -> (Outcome, Option<State>) {
    let (steps, _) = budget.of(case.size);
    let solver = motion::piece(Dynamics { time_step: TimeStep::Safe, ..Dynamics::default() }, steps);
    let solver = gpu.with(OnEither::Dynamics(solver));
    // The bound is 2 / sqrt of the largest stiffness that a node feels.
    let stiffness = 4.0 / found.at_rest.bound.powi(2);
    let rounding = found.model.node_count() as f64 * stiffness * ROUNDING * ROUNDING;
    let each = steps / motion::PIECES;
    Motion { solver: solver.as_ref(), integrator: Integrator::Euler, each, rounding }.run(&found.model, &case.path)
}

fn relax(case: &Case, found: &Found, budget: Budget, gpu: &GpuChoice) -> Result<(bool, State), Outcome> {
    let folded = follow(case, &found.model, budget, |relax| gpu.with(OnEither::Relax(relax.clone())));
    match folded {
        Ok(folded) if motion::is_finite(&folded.state) => Ok((folded.converged(), folded.state)),
        Ok(_) => Err(Outcome::Wrong("not finite".into())),
        Err(failed) => Err(Outcome::of_failed(&found.model, &failed)),
    }
}
