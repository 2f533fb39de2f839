//! One model, folded again and again: what is built for it stays.

use std::ops::ControlFlow;

use super::{Folded, Progress, Solver};
use crate::model::Model;
use crate::scene::Scene;
use crate::solve::{Failed, State};

/// A solver with a model, which keeps what it builds for the model from one fold to the next.
pub trait Session {
    /// As [`Solver::fold`].
    ///
    /// # Errors
    /// As [`Solver::fold`].
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed>;
}

/// The session of a solver that keeps nothing.
pub(super) struct Direct<'a, S: ?Sized> {
    pub(super) solver: &'a S,
    pub(super) model: &'a Model,
}

impl<S: Solver + ?Sized> Session for Direct<'_, S> {
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.solver.fold(self.model, start, scene, observe)
    }
}
