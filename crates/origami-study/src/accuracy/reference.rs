//! What errors are measured against: the equilibrium itself, on the branch that a run is on.

use origami_core::glam::DVec3;
use origami_core::measure::align;
use origami_core::scene::Scene;
use origami_core::solve::{Reflect, unwatched};
use origami_core::{Model, Newton, Relax, Solver, State};

use super::cases::Case;

/// Equilibria nearer to each other than this many radii are one.
const SAME: f64 = 1e-5;
/// Energies that differ by no more than this share are equal: directions without stiffness lead from one to the other.
const SAME_ENERGY: f64 = 1e-7;
/// A run that ends farther than this many radii from every equilibrium has not arrived anywhere.
const ARRIVED: f64 = 0.02;
/// A sheet that misses itself by no more, in radii, is folded flat exactly.
const EXACT: f64 = 1e-10;
/// Factorisations after which the equilibrium of a run's own branch is given up.
const PATIENCE: u32 = 300;

/// An equilibrium of a case, against which runs are measured.
#[derive(Clone, Debug)]
pub(super) struct Equilibrium {
    pub(super) positions: Vec<DVec3>,
    pub(super) energy: f64,
    pub(super) residual: f64,
    /// Directions that cost nothing, beyond rigid motion.
    pub(super) neutral: usize,
}

/// Largest and root mean square distance of a vertex, in radii, after the best rigid motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Error {
    pub(super) max: f64,
    pub(super) rms: f64,
}

pub(super) fn error(positions: &[DVec3], equilibrium: &Equilibrium) -> Error {
    let alignment = align(positions, &equilibrium.positions);
    Error { max: alignment.max, rms: alignment.rms }
}

/// Where a run ended up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Branch {
    /// The run ended at the reference.
    Same,
    /// The run ended in another equilibrium of the same energy.
    SameEnergy,
    /// In another equilibrium, whose energy is so many times that of the reference.
    Other(f64),
    /// The run has not come to an equilibrium.
    Underway,
}

impl Branch {
    pub(super) fn name(self) -> String {
        match self {
            Self::Same => "same".into(),
            Self::SameEnergy => "same energy, elsewhere".into(),
            Self::Other(ratio) if ratio < 1e4 => format!("another, {ratio:.3} times the energy"),
            Self::Other(_) => "another, higher".into(),
            Self::Underway => "not arrived".into(),
        }
    }
}

/// The flat-folded state itself where the case asks for it, else the equilibrium on the branch that the case's own ramp leads
/// to. `None` where Newton's method does not settle.
pub(super) fn of(case: &Case) -> Option<Equilibrium> {
    if let Some(flat) = flat(case) {
        return Some(flat);
    }
    let relax = Relax { ramp: Some(case.ramp), ..Relax::default() };
    let near =
        relax.fold(&case.model, &State::at_rest(&case.model), &Scene::percent(case.percent), &mut unwatched).ok()?;
    nearest(&case.model, &near.state, Newton::default().max_factorisations)
}

/// The state that the case folds flat to, where it is one to rounding.
fn flat(case: &Case) -> Option<Equilibrium> {
    let folded = Reflect { tolerance: EXACT }.fold_from_rest(&case.model, case.percent).ok()?;
    let stability = Newton::stability(&case.model, &folded.state)?;
    Some(Equilibrium {
        energy: folded.state.energy(&case.model).total(),
        residual: folded.residual,
        neutral: stability.neutral.saturating_sub(6),
        positions: folded.state.positions,
    })
}

/// The equilibrium downhill from `state`.
pub(super) fn nearest(model: &Model, state: &State, max_factorisations: u32) -> Option<Equilibrium> {
    let reached = Newton { max_factorisations, ..Newton::default() }.refine(model, state).ok()?;
    reached.converged.then(|| Equilibrium {
        energy: reached.state.energy(model).total(),
        residual: reached.residual,
        neutral: reached.stability.map_or(0, |s| s.neutral.saturating_sub(6)),
        positions: reached.state.positions,
    })
}

/// The branch of a run that ended in `last`, and the equilibrium there if it is not the reference.
pub(super) fn branch(model: &Model, last: &State, reference: &Equilibrium) -> (Branch, Option<Equilibrium>) {
    let to_reference = error(&last.positions, reference).max;
    if to_reference < SAME {
        return (Branch::Same, None);
    }
    let Some(own) = nearest(model, last, PATIENCE) else { return (Branch::Underway, None) };
    if error(&own.positions, reference).max < SAME {
        return (if to_reference < ARRIVED { Branch::Same } else { Branch::Underway }, None);
    }
    if error(&last.positions, &own).max > ARRIVED {
        return (Branch::Underway, None);
    }
    let difference = (own.energy - reference.energy).abs();
    if difference <= SAME_ENERGY * reference.energy.abs() + 1e-12 {
        return (Branch::SameEnergy, Some(own));
    }
    (Branch::Other(own.energy / reference.energy.max(1e-300)), Some(own))
}
