//! The solvers that keep paper from going through paper.

use origami::contact::Contact;
#[cfg(feature = "newton")]
use origami::solve::ContactNewton;
use origami::solve::{ContactDynamics, ContactRelax, Relax, Touching};

use crate::backend::Method;
use crate::settings::Settings;

/// Makes a solver, which is told whether the sheet goes on: then it is off every symmetry, and is not perturbed again.
pub(super) type Make<'a> = Box<dyn Fn(bool) -> Box<dyn Touching> + 'a>;

/// What does under contact as the method of the settings does without it; `None` where nothing does.
pub(super) fn in_contact(settings: &Settings, contact: Contact) -> Option<Make<'_>> {
    let relaxing = move |relax: &Relax, goes_on| {
        let perturbation = if goes_on { 0.0 } else { relax.perturbation };
        ContactRelax { relax: Relax { perturbation, ..relax.clone() }, contact }
    };
    match &settings.method {
        Method::Relax(relax) => Some(Box::new(move |goes_on| settings.backend.in_contact(relaxing(relax, goes_on)))),
        Method::Dynamics(dynamics) => {
            Some(Box::new(move |_| Box::new(ContactDynamics { dynamics: dynamics.clone(), contact })))
        }
        #[cfg(feature = "newton")]
        Method::Newton(newton) => Some(Box::new(move |goes_on| {
            let relax = relaxing(&newton.relax.clone().unwrap_or_default(), goes_on);
            let (residual, max_factorisations) = (newton.residual, newton.max_factorisations);
            Box::new(ContactNewton { relax, residual, max_factorisations })
        })),
        Method::Reflect(_) => None,
    }
}
