//! What contact did on the way to a state.

use super::State;
use crate::contact::{Layers, Pressing, pressing};
use crate::ids::CreaseId;
use crate::model::Model;

/// A sheet at rest under contact that is farther than this from an angle asked of it is blocked, in degrees.
const OFF: f64 = 10.0;

/// What contact did on a way to a state.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Touch {
    /// The faces that press at the end, the hardest first.
    pub pressing: Vec<Pressing>,
    /// The share of the way to the targets, 0 to 1, at which a move was first shortened; `None`: nothing was ever in the way.
    pub first_limited: Option<f64>,
    /// Evaluations in which some move was shortened.
    pub limited: u64,
    /// The least gap at the end, in radii; infinite where nothing touches.
    pub least_gap: f64,
    /// The energy of all gaps at the end, in the model's unit.
    pub energy: f64,
    /// The crease that is farthest from the angle asked of it, and how far, in radians.
    pub farthest: Option<(CreaseId, f64)>,
    /// Most pairs that were listed at one time.
    pub most_pairs: usize,
}

impl Touch {
    /// The same at the end of the way, at a state that `layers` were last measured at.
    pub(super) fn at_end(self, model: &Model, layers: &Layers, state: &State) -> Self {
        Self {
            pressing: pressing(&model.mesh, layers, &state.positions),
            least_gap: layers.least_gap(),
            energy: layers.energy(&state.positions),
            farthest: farthest(&state.fold_angles, &state.targets),
            ..self
        }
    }
}

/// Whether layers press, and a crease is far from the angle asked of it.
pub(super) fn is_held_up(layers: &Layers, angles: &[f64], asked: &[f64]) -> bool {
    layers.count() > 0 && farthest(angles, asked).is_some_and(|(_, off)| off > OFF.to_radians())
}

/// The crease that is farthest from the angle asked of it, the first of several, and how far.
fn farthest(angles: &[f64], asked: &[f64]) -> Option<(CreaseId, f64)> {
    let off = angles.iter().zip(asked).map(|(reached, asked)| (reached - asked).abs());
    let all = off.enumerate().map(|(crease, off)| (CreaseId::new(crease), off));
    all.max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
}
