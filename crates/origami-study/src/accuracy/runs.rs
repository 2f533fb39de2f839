//! Every solver on every case.

use origami_core::solve::{Integrator, Precision, TimeStep, time_step};
use origami_core::{Dynamics, Material, Model, Relax};

use super::cases::{Case, LARGE};
use super::reference::{self, Branch, Equilibrium, Error};
use super::trail::{self, From, On, Trail};
use crate::crossings::crossings;
use crate::gpu_choice::GpuChoice;
use crate::options::Deadline;

/// Steps after which the paper's scheme is left on its way.
const MOST_STEPS: u64 = 60_000;
/// The same for a jump, on which it is compared step by step.
const MOST_STEPS_IN_FULL: u64 = 250_000;

/// A solver with its settings.
#[derive(Clone, Debug)]
pub(super) struct Method {
    pub(super) name: String,
    pub(super) kind: Kind,
}

#[derive(Clone, Debug)]
pub(super) enum Kind {
    /// The paper's scheme, and the damping ratio that it runs with.
    Dynamics(Dynamics, f64),
    Relax(Relax),
    Newton(From),
}

/// A run: what it was, what came of it.
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub(super) case: String,
    pub(super) percent: f64,
    pub(super) jump: bool,
    pub(super) nodes: usize,
    pub(super) method: String,
    pub(super) backend: &'static str,
    pub(super) trail: Trail,
    /// The error at each look of the trail.
    pub(super) errors: Vec<Error>,
    pub(super) branch: Branch,
    /// The energy of the state in which the run ended.
    pub(super) energy: Option<f64>,
    /// How often its paper goes through itself; none of a very large sheet.
    pub(super) crossings: Option<usize>,
    /// The tolerance that it claims to have met, where it claims so.
    pub(super) claim: Option<f64>,
}

/// The paper's scheme as its program runs it: what all else is compared with.
pub(super) const PAPER: &str = "paper";
/// The name of the default solver.
pub(super) const RELAX: &str = "relax";

/// What is run on a case, that of the paper first.
pub(super) fn methods(case: &Case, quick: bool) -> Vec<Method> {
    let zeta = Material::default().zeta;
    let dynamics =
        |name: &str, dynamics: Dynamics, zeta: f64| Method { name: name.into(), kind: Kind::Dynamics(dynamics, zeta) };
    let paper = Dynamics::default();
    let mut methods = vec![dynamics(PAPER, paper.clone(), zeta)];
    if case.in_full {
        let own = time_step::paper(&case.model);
        let fixed = |share: f64| Dynamics { time_step: TimeStep::Fixed(share * own), ..paper.clone() };
        if !quick {
            methods.push(dynamics("paper, half the step", fixed(0.5), zeta));
            methods.push(dynamics("paper, twice the step", fixed(2.0), zeta));
            methods.push(dynamics("paper, zeta 0.02", paper.clone(), 0.02));
            let verlet = Dynamics { time_step: TimeStep::Safe, integrator: Integrator::Verlet, ..paper.clone() };
            methods.push(dynamics("verlet, safe step", verlet, zeta));
        }
        methods.push(dynamics("paper, zeta 0.1", paper.clone(), 0.1));
        methods.push(dynamics("safe step", Dynamics { time_step: TimeStep::Safe, ..paper.clone() }, zeta));
    }
    methods.push(Method { name: RELAX.into(), kind: Kind::Relax(Relax::default()) });
    if case.in_full {
        let mixed = Relax { precision: Precision::Mixed, ..Relax::default() };
        methods.push(Method { name: "relax, mixed".into(), kind: Kind::Relax(mixed) });
    }
    if case.model.node_count() <= LARGE {
        methods.push(Method { name: "newton after relax".into(), kind: Kind::Newton(From::Relax) });
        if case.in_full {
            methods.push(Method { name: "newton in a jump".into(), kind: Kind::Newton(From::Jump) });
        }
        if !quick {
            methods.push(Method { name: "newton in increments".into(), kind: Kind::Newton(From::Rest) });
        }
    }
    methods
}

/// Runs one method and measures its way.
pub(super) fn run(case: &Case, method: &Method, on: On<'_>, reference: &Equilibrium, deadline: Deadline) -> Run {
    let limit = if case.in_full { MOST_STEPS_IN_FULL } else { MOST_STEPS };
    let mut claim = None;
    let trail = match &method.kind {
        Kind::Dynamics(dynamics, zeta) => {
            let material = Material { zeta: *zeta, ..case.model.material };
            let model = Model { material, ..case.model.clone() };
            let arrived = |look: &trail::Look| reference::error(&look.positions, reference).max < 1e-7;
            trail::of_dynamics(case, &model, dynamics, on, limit, arrived, deadline)
        }
        Kind::Relax(relax) => {
            let trail = trail::of_relax(case, relax, on, deadline);
            claim = trail.last.as_ref().filter(|last| last.converged()).map(|_| relax.tolerance);
            trail
        }
        Kind::Newton(from) => trail::of_newton(case, *from, deadline),
    };
    let state = trail.last.as_ref().map(|last| &last.state);
    let (branch, own) = state.map_or((Branch::Underway, None), |s| reference::branch(&case.model, s, reference));
    let against = own.as_ref().unwrap_or(reference);
    Run {
        case: case.name.clone(),
        percent: case.percent,
        jump: case.ramp == 0,
        nodes: case.model.node_count(),
        method: method.name.clone(),
        backend: match on {
            On::Cpu => "cpu",
            On::Gpu(_) => "gpu",
        },
        errors: trail.looks.iter().map(|look| reference::error(&look.positions, against)).collect(),
        energy: state.map(|state| state.energy(&case.model).total()),
        crossings: state.and_then(|state| crossings(&case.model, &state.positions)),
        branch,
        claim,
        trail,
    }
}

/// Whether a method is run on a GPU beside the processor: the two that are compared with each other.
pub(super) fn is_for_gpu(method: &Method, gpu: &GpuChoice) -> bool {
    gpu.is_there() && [PAPER, RELAX].contains(&method.name.as_str())
}

impl Run {
    /// The first look from which on the error stays within `level`, as (evaluations, seconds).
    pub(super) fn arrival(&self, level: f64) -> Option<(u64, f64)> {
        let outside = self.errors.iter().rposition(|error| error.max > level || error.max.is_nan());
        let look = self.trail.looks.get(outside.map_or(0, |i| i + 1))?;
        Some((look.evaluations, look.seconds))
    }

    /// The error of the state in which the run ended.
    pub(super) fn error(&self) -> Option<Error> {
        self.errors.last().copied()
    }

    /// Whether it holds what it claims; `None` where it claims nothing.
    pub(super) fn keeps_claim(&self) -> Option<bool> {
        self.claim.map(|tolerance| self.error().is_some_and(|error| error.max <= tolerance))
    }
}
