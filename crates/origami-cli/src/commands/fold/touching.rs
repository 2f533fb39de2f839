//! The solvers that keep paper from going through paper.

use std::ops::ControlFlow;

use origami::contact::Contact;
use origami::model::Model;
use origami::scene::Scene;
#[cfg(feature = "newton")]
use origami::solve::ContactNewton;
use origami::solve::{ContactDynamics, ContactRelax, Failed, Folded, Progress, State, Touch};

use crate::backend::Method;

/// One of them.
pub(super) enum Touching {
    Relax(ContactRelax),
    Dynamics(ContactDynamics),
    #[cfg(feature = "newton")]
    Newton(ContactNewton),
}

impl Touching {
    /// What does under contact as `method` does without it; `None` where nothing does.
    pub(super) fn new(method: &Method, contact: Contact) -> Option<Self> {
        match method {
            Method::Relax(relax) => Some(Self::Relax(ContactRelax { relax: relax.clone(), contact })),
            Method::Dynamics(dynamics) => Some(Self::Dynamics(ContactDynamics { dynamics: dynamics.clone(), contact })),
            #[cfg(feature = "newton")]
            Method::Newton(newton) => {
                let relax = ContactRelax { relax: newton.relax.clone().unwrap_or_default(), contact };
                let (residual, max_factorisations) = (newton.residual, newton.max_factorisations);
                Some(Self::Newton(ContactNewton { relax, residual, max_factorisations }))
            }
            Method::Reflect(_) => None,
        }
    }

    pub(super) fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        match self {
            Self::Relax(relax) => relax.fold_touching(model, start, scene, observe),
            Self::Dynamics(dynamics) => dynamics.fold_touching(model, start, scene, observe),
            #[cfg(feature = "newton")]
            Self::Newton(newton) => newton.fold_touching(model, start, scene, observe),
        }
    }

    /// The sheet is off every symmetry from its first move on: it is not perturbed again.
    pub(super) fn goes_on(&mut self) {
        match self {
            Self::Relax(relax) => relax.relax.perturbation = 0.0,
            Self::Dynamics(_) => {}
            #[cfg(feature = "newton")]
            Self::Newton(newton) => newton.relax.relax.perturbation = 0.0,
        }
    }
}
