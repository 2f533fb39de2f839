//! Whether it is contact that keeps a sheet from its angles.
//!
//! A sheet whose creases cannot have all of their angles together is off them wherever layers touch or not. So it is let go: where
//! it comes to from there without contact tells what contact did.

use glam::DVec3;

use super::relax::default_ramp;
use super::{Relax, Solver, State, unwatched};
use crate::contact::Layers;
use crate::ids::CreaseId;
use crate::model::Model;
use crate::scene::Scene;

/// A crease that would come nearer to its angle by more than this, in degrees, is held up by contact.
const NEARER: f64 = 10.0;
/// Default ramps for which it is let go.
const RAMPS: u64 = 4;
/// Within so many radii of the equilibrium without contact angles are known well enough.
const TOLERANCE: f64 = 1e-3;

/// Whether layers press, as last measured, and a crease would come nearer to the angle asked of it if they did not.
pub(super) fn is_held_up((model, scene): (&Model, &Scene), layers: &Layers, state: &State) -> bool {
    let far = farthest(&state.fold_angles, &state.targets).is_some_and(|(_, off)| off > NEARER.to_radians());
    if layers.count() == 0 || !far {
        return false;
    }
    let free = Relax {
        tolerance: TOLERANCE,
        ramp: Some(0),
        max_steps: RAMPS * u64::from(default_ramp(model)),
        retry: false,
        perturbation: 0.0,
        saddle_search: 0.0,
        softening: None,
        hand_over: None,
        threads: std::num::NonZeroUsize::new(1),
        ..Relax::default()
    };
    let mut start = state.clone();
    start.velocities.fill(DVec3::ZERO);
    // Who leaves all bounds was held.
    free.fold(model, &start, scene, &mut unwatched).map_or(true, |free| {
        let angles = state.fold_angles.iter().zip(&free.state.fold_angles).zip(&state.targets);
        angles.map(|((held, free), asked)| (held - asked).abs() - (free - asked).abs()).fold(0.0, f64::max)
            > NEARER.to_radians()
    })
}

/// The crease that is farthest from the angle asked of it, and how far.
pub(super) fn farthest(angles: &[f64], asked: &[f64]) -> Option<(CreaseId, f64)> {
    let off = angles.iter().zip(asked).map(|(reached, asked)| (reached - asked).abs());
    let all = off.enumerate().map(|(crease, off)| (CreaseId::new(crease), off));
    all.max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
}
