//! The paper's motion of a sheet that cannot go through itself.
//!
//! Nodes have mass 1 and are moved by springs, damping and contact. Contact is far stiffer than the springs once layers press,
//! and begins at once where they meet, so that steps become as short as it asks for, all of the sheet's.

mod run;

use std::ops::ControlFlow;

use glam::DVec3;

use super::contact_begin::check_contact;
use super::contact_end::{Touch, Touching};
use super::threads::{count, share};
use super::{Dynamics, Failed, Folded, Progress, Solver, State, unwatched};
use crate::contact::Contact;
use crate::model::{Inventory, Model};
use crate::scene::Scene;
use run::Run;

/// [`Dynamics`] of a sheet whose layers push each other away, and through which nothing goes: a state without crossings stays
/// one.
///
/// The settings of `dynamics` count; a step is as long as its rule says where nothing touches, and where layers press or come
/// near to each other so short that energy is kept. A sheet that comes to rest while contact keeps it from its angles ends
/// [`Stop::Blocked`](super::Stop::Blocked).
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct ContactDynamics {
    /// Time step, integrator, ramp, tolerance, limits and threads.
    pub dynamics: Dynamics,
    /// How paper keeps away from paper.
    pub contact: Contact,
}

impl Solver for ContactDynamics {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(model, start, scene, observe).map(|(folded, _)| folded)
    }

    fn inventory(&self, model: &Model) -> Inventory {
        self.dynamics.inventory(model)
    }
}

/// [`Touch::limited`] counts the steps in which something was stopped that met other layers too hard for contact to brake it:
/// energy is lost in them, and in no others.
impl Touching for ContactDynamics {
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        share(count(model, self.dynamics.threads), observe, |threads, observe| {
            self.run((model, scene, start), threads, observe, &mut |_, _| {})
        })
    }
}

impl ContactDynamics {
    /// As [`Touching::fold_touching`] on one thread; `look` is shown the positions after every step, with its number.
    ///
    /// # Errors
    /// As that.
    #[doc(hidden)]
    pub fn fold_looking(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<(Folded, Touch), Failed> {
        self.run((model, scene, start), 1, &mut unwatched, look)
    }

    fn run(
        &self,
        (model, scene, start): (&Model, &Scene, &State),
        threads: usize,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        look: &mut dyn FnMut(u64, &[DVec3]),
    ) -> Result<(Folded, Touch), Failed> {
        let dynamics = &self.dynamics;
        let refused = |refusal| Failed::refused(refusal, start);
        let balanced = || if dynamics.steps.is_none() { scene.check_balance(model) } else { Ok(()) };
        let checked = dynamics.check(model, scene).and_then(|()| balanced());
        checked.and_then(|()| check_contact(self.contact, dynamics.precision, scene)).map_err(refused)?;
        let targets = scene.targets.of(model).map_err(refused)?;
        let mut run = Run::new(self, (model, scene, start), targets, threads)?;
        let stop = run.go(observe, look)?;
        Ok(run.into_folded(stop))
    }
}
