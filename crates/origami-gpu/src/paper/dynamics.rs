//! The stepping loop.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;
use origami_core::forces::Forces;
use origami_core::ids::NodeId;
use origami_core::model::{Built, Inventory, Model};
use origami_core::scene::{Refusal, Scene};
use origami_core::solve::{Diverged, Failed, Folded, Progress, Stop, TimeStep, time_step};
use origami_core::twins::checkpoint::{COPY_EVERY, is_good};
use origami_core::{Solver, State};

use super::sheet::Sheet;
use crate::device::Gpu;
use crate::error::GpuError;
use crate::layout::{Control, NONE};

/// The paper's scheme in the paper's five passes: the plainest way to do on a GPU what [`origami_core::Dynamics`] does with
/// [`Integrator::Euler`](origami_core::solve::Integrator::Euler), no ramp and a number of steps.
///
/// It is the baseline of comparisons. Positions are rest plus a displacement in f32, nothing is left out that a scene does
/// not need, and the state is read now and then, to see whether it is good.
#[derive(Clone, Debug)]
pub struct PaperDynamics {
    /// Where it computes.
    pub gpu: Gpu,
    /// Length of a step: [`TimeStep::Paper`] or [`TimeStep::Fixed`].
    pub time_step: TimeStep,
    /// How many steps it takes.
    pub steps: u64,
    /// Steps between two reads of the state, with which whoever watches is told how far it has come; at least 1. More: faster,
    /// while a state that comes back where it diverges is older. [`READ_EVERY`](Self::READ_EVERY) is usual.
    pub read_every: u64,
}

impl PaperDynamics {
    /// As often as `Dynamics` keeps a state that is good.
    pub const READ_EVERY: u64 = COPY_EVERY;
}

/// The one time step that this baseline does not have.
#[derive(Clone, Copy, Debug, thiserror::Error)]
#[error("the paper's five passes have no safe time step (expected the paper's or a fixed one)")]
struct NoSafeStep;

impl Solver for PaperDynamics {
    /// Takes exactly [`PaperDynamics::steps`] steps; the target angles jump. The residual is that of the state read, in
    /// f64, and the fold angles are its own.
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        let targets = scene.targets.of(model).map_err(|refusal| Failed::refused(refusal, start))?;
        if !(scene.supports.is_empty() && scene.has_springs_only()) {
            let (what, backend, expected) = ("supports, loads and forces", "the paper's five passes", "another solver");
            return Err(Failed::refused(Refusal::Unsupported { what, backend, expected }, start));
        }
        let mut read = Read { state: start.clone(), step: 0 };
        let dt = match self.time_step {
            TimeStep::Paper => time_step::paper(model),
            TimeStep::Fixed(dt) => dt,
            _ => return Err(read.failed(NoSafeStep)),
        };
        let mut good = read.clone();
        read.state.targets = targets;
        let sheet = Sheet::new(&self.gpu, model, dt).map_err(|error| read.failed(error))?;
        sheet.write(model, &read.state).map_err(|error| read.failed(error))?;
        let mut stop = Stop::StepsDone;
        while read.step < self.steps {
            let step = read.step.saturating_add(self.read_every.max(1)).min(self.steps);
            let control = advance(&sheet, read.step, step).map_err(|error| read.failed(error))?;
            let state = sheet.read(model, &read.state.targets).map_err(|error| read.failed(error))?;
            if control.bad_node != NONE {
                return Err(diverged(model, &state, control, dt, good).into());
            }
            read = Read { state, step };
            if read.is_good(dt) {
                good.clone_from(&read);
            }
            if observe(Progress { step: read.step, ramp: 1.0, distance: f64::INFINITY }).is_break() {
                stop = Stop::Cancelled;
                break;
            }
        }

        let mut state = read.state;
        let mut forces = Forces::new(model);
        let residual = forces
            .evaluate(&state.positions, &state.targets, &mut state.fold_angles)
            .iter()
            .map(|f| f.length())
            .fold(0.0, f64::max);
        let reactions = forces.reactions().to_vec();
        let (targets, steps, distance) = (scene.targets.clone(), read.step, f64::INFINITY);
        Ok(Folded {
            state,
            targets,
            stop,
            steps,
            time_step: dt,
            residual,
            distance,
            attempts: 1,
            saddles: 0,
            factorisations: 0,
            reactions,
        })
    }

    fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        inventory.built.push(Built { what: "damping", count: model.beams.len() });
        inventory
    }
}

/// Takes the steps `from..to`, in submissions of a length that no driver takes for a hanging one.
fn advance(sheet: &Sheet, from: u64, to: u64) -> Result<Control, GpuError> {
    let mut step = from;
    loop {
        let next = (step + COPY_EVERY).min(to);
        let control = sheet.advance(step, next)?;
        if next == to || control.bad_node != NONE {
            return Ok(control);
        }
        step = next;
    }
}

/// A state that was read, and its step.
#[derive(Clone)]
struct Read {
    state: State,
    step: u64,
}

impl Read {
    fn failed(&self, error: impl std::error::Error + Send + Sync + 'static) -> Failed {
        let last_read = Box::new(self.state.clone());
        Failed::Backend { source: Arc::new(error), last_read, last_read_step: self.step }
    }

    /// Whether it is one to go back to.
    fn is_good(&self, dt: f64) -> bool {
        let mut nodes = self.state.positions.iter().zip(&self.state.velocities);
        nodes.all(|(p, v)| is_good(*p, *v * dt))
    }
}

/// `state` is that after the step which led out of bounds: no later step has moved it.
fn diverged(model: &Model, state: &State, control: Control, dt: f64, good: Read) -> Diverged {
    let node = NodeId(control.bad_node);
    let at = |of: &[DVec3]| of.get(node.index()).copied().unwrap_or(DVec3::NAN);
    let (position, moved) = (at(&state.positions), at(&state.velocities) * dt);
    Diverged::new(model, (node, position, moved), u64::from(control.step), Box::new(good.state), good.step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::cases;
    use crate::testing::gpu;
    use origami_core::Dynamics;
    use origami_core::solve::unwatched;

    /// How far apart trajectories may be, in radii, after 300 steps. Each step rounds a displacement of up to 1 by 6e-8, and
    /// were all of these errors of one sign, they would add up to 2e-5.
    const TRAJECTORY: f64 = 2e-5;
    const STEPS: u64 = 300;

    fn cpu(time_step: TimeStep, steps: u64) -> Dynamics {
        Dynamics { time_step, steps: Some(steps), ..Dynamics::default() }
    }

    fn solved(solver: &dyn Solver, model: &Model, percent: f64) -> Folded {
        solver.fold(model, &State::at_rest(model), &Scene::percent(percent), &mut unwatched).expect("it holds")
    }

    #[test]
    fn trajectories_agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        let solver =
            PaperDynamics { gpu, time_step: TimeStep::Paper, steps: STEPS, read_every: PaperDynamics::READ_EVERY };
        for (name, model) in cases::patterns() {
            let (ours, theirs) = (solved(&solver, &model, 60.0), solved(&cpu(TimeStep::Paper, STEPS), &model, 60.0));
            let far = cases::farthest(&ours.state.positions, &theirs.state.positions);
            let moved = cases::farthest(&theirs.state.positions, &model.rest);
            println!("{name}: {far:.1e} radii apart after moving {moved:.2}");
            assert!(moved > 0.05, "{name} moves");
            assert!(far < TRAJECTORY, "{name}: {far} radii apart");
            let other = solved(&cpu(TimeStep::Paper, STEPS), &model, 59.9);
            assert!(cases::farthest(&ours.state.positions, &other.state.positions) > TRAJECTORY, "0.1 % is seen");
            for node in &model.fixed {
                assert_eq!(ours.state.positions[node.index()], model.rest[node.index()], "{name}: it is fixed");
            }
            assert!((ours.residual - theirs.residual).abs() < 1e-2 * theirs.residual, "{name}: residual");
            assert_eq!((ours.stop, ours.steps, ours.time_step), (Stop::StepsDone, STEPS, theirs.time_step));
        }
    }

    #[test]
    fn two_runs_give_the_same_bits() {
        let Some(gpu) = gpu() else { return };
        let solver =
            PaperDynamics { gpu, time_step: TimeStep::Paper, steps: 150, read_every: PaperDynamics::READ_EVERY };
        let model = cases::miura();
        assert_eq!(solved(&solver, &model, 60.0).state, solved(&solver, &model, 60.0).state);
    }

    #[test]
    fn steps_that_are_too_long_diverge_as_on_the_processor() {
        let Some(gpu) = gpu() else { return };
        let model = cases::miura();
        let (time_step, start) = (TimeStep::Fixed(0.35), State::at_rest(&model));
        let fold = |solver: &dyn Solver| {
            solver.fold(&model, &start, &Scene::percent(60.0), &mut unwatched).expect_err("too long")
        };
        let ours =
            fold(&PaperDynamics { gpu: gpu.clone(), time_step, steps: 1000, read_every: PaperDynamics::READ_EVERY });
        let theirs = fold(&cpu(time_step, 1000));
        let (Failed::Diverged(ours), Failed::Diverged(theirs)) = (ours, theirs) else { panic!("not a divergence") };
        assert_eq!((ours.vertex, ours.step, ours.quantity), (theirs.vertex, theirs.step, theirs.quantity));
        assert!((ours.value - theirs.value).abs() < 1e-2 * theirs.value, "{} is not {}", ours.value, theirs.value);
        assert_eq!(ours.last_good_step, theirs.last_good_step);

        let nan = fold(&PaperDynamics {
            gpu,
            time_step: TimeStep::Fixed(f64::NAN),
            steps: 3,
            read_every: PaperDynamics::READ_EVERY,
        });
        assert!(matches!(nan, Failed::Diverged(ref d) if d.step == 1 && d.value.is_nan()), "{nan}");
    }

    #[test]
    fn no_steps_leave_the_start_and_a_safe_step_is_refused() {
        let Some(gpu) = gpu() else { return };
        let model = cases::miura();
        let none = PaperDynamics {
            gpu: gpu.clone(),
            time_step: TimeStep::Paper,
            steps: 0,
            read_every: PaperDynamics::READ_EVERY,
        };
        let folded = solved(&none, &model, 60.0);
        assert_eq!(folded.state.positions, model.rest);
        assert_eq!(folded.state.targets, model.targets(60.0));
        assert!(folded.residual > 0.0);
        let safe = PaperDynamics { gpu, time_step: TimeStep::Safe, steps: 1, read_every: PaperDynamics::READ_EVERY };
        let refused = safe
            .fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut unwatched)
            .expect_err("no such step");
        assert!(matches!(refused, Failed::Backend { last_read_step: 0, .. }), "{refused}");
    }
}
