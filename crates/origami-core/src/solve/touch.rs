//! What the solvers under contact have in common: what they refuse, how they begin, and what contact did on the way.

use std::ops::ControlFlow;

use glam::DVec3;

use super::largest::largest;
use super::relax::default_ramp;
use super::{Failed, Folded, Precision, Progress, Solver, State};
use crate::contact::{Contact, Crossings, Layers, Pressing, pressing};
use crate::forces::Forces;
use crate::ids::CreaseId;
use crate::model::Model;
use crate::scene::{Held, Reaction, Refusal, Scene};

/// A sheet at rest under contact that is farther than this from an angle asked of it is blocked, in degrees.
const OFF: f64 = 10.0;
/// Ramps for which it goes on at the final targets while contact holds it up.
const PATIENCE: u64 = 10;

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

/// A solver that keeps paper from going through paper, and tells what that did.
pub trait Touching: Solver {
    /// As [`Solver::fold`], and what contact did.
    ///
    /// # Errors
    /// As [`Solver::fold`]; [`Failed::Refused`] too where the sheet begins crossed or closed, and for settings that are no
    /// lengths or stiffnesses above 0.
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed>;
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

/// Whether a sheet can be folded so in a scene, in numbers of that precision.
pub(super) fn check_contact(contact: Contact, precision: Precision, scene: &Scene) -> Result<(), Refusal> {
    let Contact { gap, stiffness, thickness } = contact;
    for (what, value) in [("gap", gap), ("stiffness", stiffness)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(Refusal::Contact { what, value });
        }
    }
    if !(thickness.is_finite() && thickness >= 0.0) {
        return Err(Refusal::Contact { what: "thickness", value: thickness });
    }
    let unsupported = |what, expected| Err(Refusal::Unsupported { what, backend: "contact", expected });
    match precision {
        Precision::Mixed => unsupported("numbers of mixed precision", "f64"),
        Precision::F64 if !scene.forces.is_empty() => unsupported("forces", "a scene without forces of one's own"),
        Precision::F64 => Ok(()),
    }
}

/// The layers of a sheet that begins at `positions`, measured there; `shared` as for [`Layers::new`]. Refused where it begins
/// crossed or closed.
pub(super) fn first_layers(
    model: &Model,
    positions: &[DVec3],
    contact: Contact,
    shared: bool,
) -> Result<Layers, Refusal> {
    let crossings = Crossings::of(&model.mesh, positions);
    if let Some([one, other]) = crossings.faces.first() {
        return Err(Refusal::Crossed { faces: [*one, *other] });
    }
    let mut layers = Layers::new(&model.mesh, &model.rest, contact, shared);
    layers.measure(positions);
    if layers.least_gap() > 0.0 { Ok(layers) } else { Err(Refusal::Closed { gap: layers.least_gap() }) }
}

/// Evaluations at the final targets for which a sheet goes on that contact holds up.
#[doc(hidden)]
#[must_use]
pub fn patience(model: &Model) -> u64 {
    PATIENCE * u64::from(default_ramp(model))
}

/// The largest force of springs and contact, and what the supports do. The fold angles are measured anew.
pub(super) fn residual(
    (model, scene): (&Model, &Scene),
    held: &Held,
    layers: &Layers,
    state: &mut State,
) -> (f64, Vec<Reaction>) {
    let mut forces = Forces::holding(model, scene, held.clone());
    let mut all = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles).to_vec();
    let (mut of_contact, mut sums) = (vec![DVec3::ZERO; all.len()], vec![0.0; all.len()]);
    layers.add(&state.positions, &mut of_contact, &mut sums);
    held.clear(&mut of_contact);
    all.iter_mut().zip(&of_contact).for_each(|(all, own)| *all += *own);
    (largest(&all), forces.reactions().to_vec())
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
