//! Ways to a state: which of two is better, and what is made of none.

use glam::DVec3;

use super::crushed::is_crushed;
use super::largest::largest;
use super::{Failed, Folded, State, Stop};
use crate::forces::Forces;
use crate::model::{Model, Softening};
use crate::scene::Scene;

/// One way to a state.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attempt {
    /// 1 for the first.
    pub number: u32,
    /// Evaluations over which the target angles rise; 0 is a jump.
    pub ramp: u32,
    /// Evaluations after which it ends.
    pub limit: u64,
    /// Whether it begins off every symmetry, as [`Relax::perturbation`](super::Relax::perturbation) says.
    pub perturbed: bool,
    /// How soft the sheet is while the target angles rise; as its material where there is none.
    pub softening: Option<Softening>,
}

/// The better of two states that are asked for the same, with the steps of both: one without crushed triangles, else the
/// one of lower energy; `other` came of attempt `number`. A state at hand is finite: another way that diverges does not take
/// it away.
///
/// # Errors
/// The first, where both ways diverge.
#[doc(hidden)]
pub fn better(
    (model, scene): (&Model, &Scene),
    kept: Result<Folded, Failed>,
    other: Result<Folded, Failed>,
    number: u32,
) -> Result<Folded, Failed> {
    let steps = steps_of(&kept);
    match (kept, other) {
        (Ok(kept), Ok(other)) => {
            let steps = steps + other.steps;
            let factorisations = kept.factorisations + other.factorisations;
            let rank = |folded: &Folded| {
                (is_crushed(model, &folded.state.positions), folded.state.energy_in(model, scene).total())
            };
            let other_is_better = rank(&other) < rank(&kept);
            Ok(Folded { steps, factorisations, attempts: number, ..if other_is_better { other } else { kept } })
        }
        (Err(Failed::Diverged(_)), Ok(other)) => Ok(Folded { steps: steps + other.steps, attempts: number, ..other }),
        (kept, _) => kept,
    }
}

/// What a sheet that no way holds came to: where a triangle was crushed before it left all bounds, the last good state, since
/// that is why.
///
/// # Errors
/// As `result`, where nothing was crushed.
#[doc(hidden)]
pub fn or_crushed(
    (model, scene): (&Model, &Scene),
    result: Result<Folded, Failed>,
    attempts: u32,
) -> Result<Folded, Failed> {
    let diverged = match result {
        Err(Failed::Diverged(diverged)) if is_crushed(model, &diverged.last_good.positions) => diverged,
        other => return other,
    };
    let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, &diverged.last_good))?;
    let velocities = vec![DVec3::ZERO; model.node_count()];
    let mut state = State { targets, velocities, ..*diverged.last_good };
    let mut forces = Forces::in_scene(model, scene);
    let residual = largest(forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles));
    Ok(Folded {
        state,
        targets: scene.targets.clone(),
        stop: Stop::Crushed,
        steps: diverged.step,
        time_step: 0.0,
        residual,
        distance: f64::INFINITY,
        attempts,
        saddles: 0,
        factorisations: 0,
        reactions: forces.reactions().to_vec(),
    })
}

/// How many steps the ways took that led here.
#[doc(hidden)]
#[must_use]
pub fn steps_of(result: &Result<Folded, Failed>) -> u64 {
    match result {
        Ok(folded) => folded.steps,
        Err(Failed::Diverged(diverged)) => diverged.step,
        Err(_) => 0,
    }
}
