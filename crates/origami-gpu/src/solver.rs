//! The solvers of the core, computed on a GPU.

use std::sync::Arc;

use glam::DVec3;
use origami_core::forces::{Forces, damping};
use origami_core::ids::NodeId;
use origami_core::model::{Inventory, Model};
use origami_core::solve::{Diverged, Failed, Folded, Instance, Progress, Session, Solver, State, Stop};

use crate::device::Gpu;
use crate::engine::{Dispatch, Engine, Purpose};
use crate::error::GpuError;
use crate::layout::{Control, NONE, Node, SETTLED, vector};
use crate::run::Ending;
use crate::variant::Scheme;
use crate::{ensemble, inventory};

/// A solver of the core that computes on a GPU. The settings are those of the core's solver, and mean the same.
#[derive(Clone, Debug)]
pub struct OnGpu<S> {
    pub(crate) gpu: Gpu,
    pub(crate) method: S,
    pub(crate) dispatch: Dispatch,
}

impl<S> OnGpu<S> {
    /// The solver's settings.
    pub fn method(&self) -> &S {
        &self.method
    }

    /// Another way for the passes of a step to reach the GPU. Results differ by rounding only. Default:
    /// [`Dispatch::Auto`].
    #[must_use]
    pub fn dispatch(self, dispatch: Dispatch) -> Self {
        Self { dispatch, ..self }
    }
}

/// What the core's solvers say of themselves, so that a GPU can do as they do.
pub(crate) trait Method: Solver {
    /// What an engine for it has to do. `damped`: whether some of the models have damping.
    fn purpose(&self, damped: bool, dispatch: Dispatch) -> Purpose;

    /// Runs instances, no more than the engine was built for, to their ends; results in their order.
    fn run(
        &self,
        engine: &mut Engine,
        instances: &[Instance<'_>],
        observe: &mut dyn FnMut(usize, Progress),
    ) -> Vec<Result<Folded, Failed>>;
}

impl<S: Method> Solver for OnGpu<S> {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        percent: f64,
        observe: &mut dyn FnMut(Progress),
    ) -> Result<Folded, Failed> {
        self.session(model).fold(start, percent, observe)
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(self.on(model))
    }

    fn fold_all(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) + Sync),
    ) -> Vec<Result<Folded, Failed>> {
        let purpose = purpose(self, instances.iter().map(|i| i.model));
        ensemble::fold_all(&self.gpu, &self.method, purpose, instances, observe)
    }

    fn inventory(&self, model: &Model) -> Inventory {
        inventory::of(model, self.method.inventory(model), purpose(self, [model].into_iter()))
    }
}

/// What an engine for `models` has to do.
fn purpose<'m, S: Method>(solver: &OnGpu<S>, mut models: impl Iterator<Item = &'m Model>) -> Purpose {
    solver.method.purpose(models.any(|m| m.material.zeta > 0.0), solver.dispatch)
}

#[expect(private_bounds, reason = "which of the core's methods a GPU can compute is no matter of choice")]
impl<S: Method> OnGpu<S> {
    /// What [`Solver::session`] gives, by its own name.
    pub fn on<'a>(&'a self, model: &'a Model) -> OnModel<'a, S> {
        let engine = Engine::new(&self.gpu, &[model], purpose(self, [model].into_iter()), 1);
        OnModel { method: &self.method, model, engine }
    }
}

/// A [`Session`] on a GPU: the buffers and pipelines of one model stay from one percentage to the next. With the feature
/// `render` a `Renderer` can draw the sheet where the session has left it.
#[derive(Debug)]
pub struct OnModel<'a, S> {
    method: &'a S,
    model: &'a Model,
    engine: Result<Engine, GpuError>,
}

#[cfg(feature = "render")]
impl<S> OnModel<'_, S> {
    /// # Errors
    /// Why it could not be built.
    pub(crate) fn engine(&self) -> Result<&Engine, GpuError> {
        self.engine.as_ref().map_err(Clone::clone)
    }
}

impl<S: Method> Session for OnModel<'_, S> {
    fn fold(&mut self, start: &State, percent: f64, observe: &mut dyn FnMut(Progress)) -> Result<Folded, Failed> {
        let engine = self.engine.as_mut().map_err(|error| backend(error.clone(), start, 0))?;
        let instance = Instance { model: self.model, start: start.clone(), percent };
        let mut results = self.method.run(engine, &[instance], &mut |_, progress| observe(progress));
        results.pop().expect("one result for one instance")
    }
}

/// A device that gave up, with the last state that is known.
pub(crate) fn backend(error: GpuError, last: &State, step: u64) -> Failed {
    Failed::Backend { source: Arc::new(error), last_read: Box::new(last.clone()), last_read_step: step }
}

/// How far an instance has come.
pub(crate) fn progress(control: &Control) -> Progress {
    let ramp = match control.ramp_length {
        0 => 1.0,
        length => f64::from(control.ramp_step) / f64::from(length),
    };
    Progress { step: u64::from(control.step), ramp, distance: distance(control) }
}

fn distance(control: &Control) -> f64 {
    match f64::from(control.distance) {
        // The shaders write so where they have no estimate.
        none if none >= 1e30 => f64::INFINITY,
        distance => distance,
    }
}

/// What an instance came to. `steps_asked`: it was to run so many steps, and not to stop before.
pub(crate) fn folded(
    model: &Model,
    percent: f64,
    targets: Vec<f64>,
    steps_asked: bool,
    ending: &Ending,
    scheme: Scheme,
) -> Result<Folded, Failed> {
    let control = &ending.control;
    let time_step = f64::from(match scheme {
        Scheme::Relax => control.fire_step,
        Scheme::Dynamics { .. } => control.time_step,
    });
    let angles = ending.creases.iter().map(|c| f64::from(c.angle)).collect();
    let mut state = State {
        positions: ending.nodes.iter().map(Node::position).collect(),
        velocities: ending.nodes.iter().map(|n| vector(n.velocity)).collect(),
        fold_angles: angles,
        targets,
    };
    if control.bad_node != NONE {
        return Err(diverged(
            model,
            ending,
            &state,
            time_step,
            matches!(scheme, Scheme::Dynamics { verlet: true, .. }),
        )
        .into());
    }
    // Measured in double precision, at the state as it was read.
    let mut forces = Forces::new(model);
    let values = forces.evaluate(&state.positions, &state.targets, &mut state.fold_angles);
    let residual = values.iter().map(|f| f.length()).fold(0.0, f64::max);
    match scheme {
        Scheme::Relax => state.velocities.fill(DVec3::ZERO),
        Scheme::Dynamics { verlet, .. } if !verlet || control.step == 0 => {}
        Scheme::Dynamics { .. } => {
            // The velocity that was stored is the one extrapolated by the acceleration before.
            damping::add(model, &state.velocities, values);
            for ((v, f), node) in state.velocities.iter_mut().zip(values).zip(&ending.nodes) {
                *v += (*f - vector(node.force)) * (0.5 * time_step);
            }
        }
    }
    let stop = match control.stop {
        SETTLED => Stop::Converged,
        _ if steps_asked => Stop::StepsDone,
        _ => Stop::StepLimit,
    };
    let steps = u64::from(control.step);
    Ok(Folded { state, percent, stop, steps, time_step, residual, distance: distance(control), attempts: 1 })
}

fn diverged(model: &Model, ending: &Ending, state: &State, time_step: f64, verlet: bool) -> Diverged {
    let control = &ending.control;
    let node = control.bad_node as usize;
    let last_good = match &ending.checkpoint {
        Some((nodes, angles)) => State {
            positions: nodes.iter().map(Node::position).collect(),
            velocities: nodes.iter().map(|n| vector(n.velocity)).collect(),
            fold_angles: angles.iter().map(|a| f64::from(*a)).collect(),
            targets: state.targets.clone(),
        },
        None => State::at_rest(model),
    };
    // Velocity Verlet moves by the velocity in the middle of a step, and keeps the one at its end.
    let half_a_step = if verlet { vector(ending.nodes[node].force) * (0.5 * time_step) } else { DVec3::ZERO };
    let moved = (state.velocities[node] - half_a_step) * time_step;
    let place = (NodeId::new(node), state.positions[node], moved);
    Diverged::new(model, place, u64::from(control.step), Box::new(last_good), u64::from(control.checkpoint_step))
}

#[cfg(test)]
mod tests {
    use origami_core::{Dynamics, Relax};

    use super::*;
    use crate::AdapterChoice;
    use crate::paper::testing::miura;
    use crate::testing::gpu;

    /// An adapter of its own: it is going to be lost.
    fn fresh() -> Option<Gpu> {
        let choice = AdapterChoice::Named(gpu()?.adapter().to_string());
        Some(Gpu::open(&choice).expect("opened before"))
    }

    /// A fold on an adapter that is lost after so many reports of progress; how many there were.
    fn lost_after<S: Method + Clone>(method: &S, reports: usize) -> Option<(Failed, usize)> {
        let gpu = fresh()?;
        let (solver, model) = (gpu.with(method.clone()), miura());
        let start = State::perturbed(&model, 1e-3, 7);
        if reports == 0 {
            gpu.device().destroy();
        }
        let mut reported = 0;
        let failed = solver.fold(&model, &start, 60.0, &mut |_| {
            reported += 1;
            if reported == reports {
                gpu.device().destroy();
            }
        });
        let failed = failed.expect_err("it was lost");
        assert_eq!(failed.last_state(), &start, "what it began with is all that is known");
        let all = solver.fold_all(&[Instance { model: &model, start: start.clone(), percent: 60.0 }], &|_, _| {});
        assert!(matches!(all[0], Err(Failed::Backend { .. })), "it stays lost");
        Some((failed, reported))
    }

    #[test]
    fn a_lost_device_is_an_error_with_the_last_state() {
        let methods =
            (Relax { steps: Some(5000), ..Relax::default() }, Dynamics { steps: Some(5000), ..Default::default() });
        for reports in [0, 1, 3] {
            for failed in [lost_after(&methods.0, reports), lost_after(&methods.1, reports)] {
                let Some((failed, reported)) = failed else { return };
                assert!(matches!(failed, Failed::Backend { last_read_step: 0, .. }), "{failed}");
                assert!(failed.to_string().starts_with("the GPU was lost"), "{failed}");
                assert!(reported < 40, "it did not run on: {reported} reports");
            }
        }
    }
}
