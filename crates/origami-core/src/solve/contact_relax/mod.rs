//! Relaxation of a sheet that cannot go through itself.
//!
//! The springs are the kernel's. Contact is added after them, and so the nodes are moved here: its forces and masses change
//! from one evaluation to the next, and moves are shortened before they are made.

mod masses;
mod moves;
mod run;

use std::ops::ControlFlow;

use glam::DVec3;

use super::contact_begin::check_contact;
use super::contact_end::{Touch, Touching};
use super::threads::{count, share};
use super::{Failed, Folded, Progress, Relax, Solver, State, unwatched};
use crate::contact::Contact;
use crate::model::{Inventory, Model};
use crate::scene::Scene;
use run::Run;

/// [`Relax`] of a sheet whose layers push each other away, and through which nothing goes: a state without crossings stays one.
///
/// The settings of `relax` count, but for these: the sheet is as stiff as its material all the way, is folded once, and no
/// saddle is sought. A sheet that contact keeps from its angles ends [`Stop::Blocked`](super::Stop::Blocked), which is a result.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct ContactRelax {
    /// Ramp, tolerance, limits, perturbation and threads.
    pub relax: Relax,
    /// How paper keeps away from paper.
    pub contact: Contact,
}

impl Solver for ContactRelax {
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
        self.relax.inventory(model)
    }
}

impl Touching for ContactRelax {
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        share(count(model, self.relax.threads), observe, |threads, observe| {
            self.run((model, scene, start), threads, observe, &mut |_, _| {})
        })
    }
}

impl ContactRelax {
    /// As [`Touching::fold_touching`] on one thread; `look` is shown the positions after every evaluation's move, with its number.
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
        let refused = |refusal| Failed::refused(refusal, start);
        self.relax.check(model, scene).map_err(refused)?;
        check_contact(self.contact, self.relax.precision, scene).map_err(refused)?;
        let targets = scene.targets.of(model).map_err(refused)?;
        let begin = |relax: &Relax| {
            let positions = relax.first_positions(model, start, scene, &targets);
            Run::new(self, (model, scene, start), (positions, targets.clone()), threads)
        };
        let mut run = match begin(&self.relax) {
            // The perturbation may take the lips of a narrow cut through each other.
            Err(failed) if self.relax.perturbation > 0.0 => {
                begin(&Relax { perturbation: 0.0, ..self.relax.clone() }).map_err(|_| failed)?
            }
            begun => begun?,
        };
        let stop = run.go(observe, look)?;
        Ok(run.into_folded(stop))
    }
}
