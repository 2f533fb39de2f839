//! A sheet in motion on a GPU: what a `Simulation` of the core runs on there.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;
use origami_core::forces::Forces;
use origami_core::ids::NodeId;
use origami_core::model::Model;
use origami_core::scene::{Axes, Held, Load, Reaction, Refusal, Scene, Support, Targets};
use origami_core::solve::{self, Failed, Folded, Instance, Positions, Report, Saved, State};

use crate::engine::Engine;
use crate::error::{GPU, GpuError};
use crate::kernels::Binding;
use crate::layout::{Control, CreaseState, NONE, Node, SETTLED};
use crate::leaving::Leaving;
use crate::method::{GpuMethod, Settings};
use crate::outcome::{backend, checked, distance, diverged, folded, ramp_share, state};
use crate::outside::Outside;
use crate::positions_buffer::PositionsBuffer;
use crate::purpose::{Dispatch, Purpose};
use crate::run::{Ending, softened};
use crate::single;
use crate::solver::OnGpu;

/// A sheet in motion on a GPU. [`Simulation`](origami_core::solve::Simulation) is its interface for programs.
///
/// Positions, velocities and all that moves them stay on the device: a call that takes steps reads where it stands, no more.
/// [`GpuEngine::positions_buffer`] is where others can draw from.
#[derive(Debug)]
pub struct GpuEngine {
    model: Arc<Model>,
    settings: Settings,
    /// With the loads of now.
    scene: Scene,
    held: Held,
    engine: Engine,
    /// As on the device, or as it is to be there before the next step.
    control: Control,
    /// Whether it has yet to be written.
    changed: bool,
    /// Target angles at both ends of the ramp, by crease.
    from: Vec<f64>,
    to: Vec<f64>,
    /// Whether nodes are moved off every symmetry before they are first folded.
    perturbs: bool,
    /// What was read last, and at which step.
    state: State,
    read_at: u64,
    /// Whether nodes may have moved since.
    stale: bool,
}

impl<S: GpuMethod> solve::Method for OnGpu<S> {
    type Engine = GpuEngine;

    /// By passes over all elements, whatever the dispatch: a workgroup that takes many steps at once cannot take just one.
    fn engine(&self, model: &Arc<Model>, scene: &Scene, start: &State) -> Result<GpuEngine, Failed> {
        let instance = Instance { model, start: start.clone(), scene: scene.clone() };
        let checked = self.method.method().check_settings().and_then(|()| checked(&instance));
        let targets = checked.map_err(|refusal| Failed::refused(refusal, start))?;
        // Any node may be pinned later.
        let outside = Outside { holds: true, ..Outside::of([scene]) };
        let purpose = Purpose { dispatch: Dispatch::Passes, ..self.purpose([&**model].into_iter()) };
        let gave_up = |error| backend(error, start, 0);
        let engine = Engine::new(&self.gpu, model, &outside, purpose).map_err(gave_up)?;
        let settings = Settings::of(self.method.method());
        let mut beginning = settings.method().beginning(&instance, targets.clone());
        (beginning.limit, beginning.stops_when_settled) = (u64::from(u32::MAX), false);
        let (state, held) = (beginning.state.clone(), beginning.held.clone());
        engine.load(0, &[beginning]).map_err(gave_up)?;
        let control = engine.read(Binding::Control, 1).map_err(gave_up)?;
        let folds = targets != start.targets || !scene.has_springs_only();
        Ok(GpuEngine {
            model: Arc::clone(model),
            settings,
            scene: scene.clone(),
            held,
            engine,
            control: control.first().copied().unwrap_or_default(),
            changed: false,
            from: start.targets.clone(),
            to: targets,
            perturbs: !folds,
            state,
            read_at: 0,
            stale: true,
        })
    }
}

impl GpuEngine {
    /// Where the positions lie on the device.
    #[must_use]
    pub fn positions_buffer(&self) -> PositionsBuffer<'_> {
        PositionsBuffer::of(&self.engine.buffers[&Binding::Nodes], self.model.node_count())
    }

    #[cfg(feature = "render")]
    pub(crate) fn engine(&self) -> &Engine {
        &self.engine
    }

    /// Changes the control block before the next step.
    fn change(&mut self, change: impl FnOnce(&mut Control)) {
        let before = self.control;
        change(&mut self.control);
        self.changed |= self.control != before;
    }

    /// Something has changed that the sheet has yet to follow.
    fn disturb(&mut self) {
        self.change(Control::disturb);
        self.stale = true;
    }

    /// The targets of the last evaluation.
    fn targets_now(&self) -> Vec<f64> {
        let share = ramp_share(&self.control);
        let now = |(from, to): (&f64, &f64)| if share >= 1.0 { *to } else { from + share * (to - from) };
        self.from.iter().zip(&self.to).map(now).collect()
    }

    fn run(&mut self, steps: u64, until_settled: bool) -> Result<(), GpuError> {
        self.change(|c| (c.stop, c.stops_when_settled) = (0, u32::from(until_settled)));
        if std::mem::take(&mut self.changed) {
            self.engine.gpu.scoped(|| self.engine.write(Binding::Control, &[self.control]))?;
        }
        let from = u64::from(self.control.step);
        let to = from.saturating_add(steps).min(u64::from(u32::MAX));
        let (controls, _) = self.engine.advance(1, from, to, &mut |_, _| ControlFlow::Continue(()))?;
        self.control = controls.last().copied().unwrap_or(self.control);
        self.stale = true;
        Ok(())
    }

    /// Where it is, with the last good state if it has diverged.
    fn ending(&self) -> Result<Vec<Ending>, GpuError> {
        let diverged = self.control.bad_node != NONE;
        Leaving::new(&self.engine, &[(0, None)], false, diverged)?.wait(&self.engine)
    }

    fn read_nodes(&self) -> Result<Vec<Node>, GpuError> {
        self.engine.read(Binding::Nodes, self.model.node_count())
    }

    fn read_creases(&self) -> Result<Vec<CreaseState>, GpuError> {
        self.engine.read(Binding::CreaseStates, self.model.creases.len())
    }

    /// Reads the nodes into `state`, where they may have moved.
    fn refresh(&mut self) -> Result<(), GpuError> {
        if self.stale {
            let nodes = self.read_nodes()?;
            let read = state(&nodes, &[], Vec::new());
            (self.state.positions, self.state.velocities) = (read.positions, read.velocities);
            self.read_at = u64::from(self.control.step);
            self.stale = false;
        }
        Ok(())
    }

    /// Reads all that moves into `state`.
    fn refresh_all(&mut self) -> Result<(), GpuError> {
        self.refresh()?;
        self.state.fold_angles = self.read_creases()?.iter().map(|crease| f64::from(crease.angle)).collect();
        self.state.targets = self.targets_now();
        Ok(())
    }

    /// Moves the nodes off every symmetry, once, before they are first folded.
    fn perturb(&mut self, targets: &[f64]) -> Result<(), GpuError> {
        let Settings::Relax(relax) = &self.settings else { return Ok(()) };
        if !std::mem::take(&mut self.perturbs) || relax.perturbation == 0.0 {
            return Ok(());
        }
        let held = self.held.iter().map(|(node, axes)| Support::along(node, axes));
        let scene = held.fold(Scene::default(), Scene::with_support);
        let mut nodes = self.read_nodes()?;
        let before = State { targets: self.targets_now(), ..state(&nodes, &[], Vec::new()) };
        let after = relax.beginning(&self.model, &before, &scene, targets);
        nodes.iter_mut().zip(&after.positions).for_each(|(node, position)| node.set_position(*position));
        self.stale = true;
        self.engine.gpu.scoped(|| self.engine.write(Binding::Nodes, &nodes))
    }

    fn aim(&mut self, targets: Vec<f64>) -> Result<(), GpuError> {
        self.perturb(&targets)?;
        let now = self.targets_now();
        let start = State { targets: now, ..State::default() };
        let (mut length, softening) = self.settings.method().ramp((&self.model, &self.scene), &start, &targets);
        if start.targets == targets {
            length = 0;
        }
        let (is_soft, softening) = (self.control.is_soft(), softening.map(|soft| softened(&self.model, soft)));
        if is_soft {
            // It arrives where its masses are renewed, and not at once.
            length = length.max(2);
        }
        let mut creases = self.read_creases()?;
        for ((crease, from), to) in creases.iter_mut().zip(&start.targets).zip(&targets) {
            crease.aim(*from, *to);
        }
        self.engine.gpu.scoped(|| self.engine.write(Binding::CreaseStates, &creases))?;
        (self.from, self.to) = (start.targets, targets);
        self.change(|c| {
            (c.ramp_step, c.ramp_before, c.ramp_length) = (length.min(1_u32.saturating_sub(c.ramp_waits)), 0, length);
            if softening.is_some() || !is_soft {
                (c.soft_ea, c.soft_corners, c.wrong_side) = softening.unwrap_or_default();
            }
        });
        self.disturb();
        Ok(())
    }

    fn gave_up(&self, error: GpuError) -> Failed {
        backend(error, &self.state, self.read_at)
    }

    fn refused(&self, what: &'static str, expected: &'static str) -> Failed {
        self.refused_for(Refusal::Unsupported { what, backend: GPU, expected })
    }

    fn refused_for(&self, refusal: Refusal) -> Failed {
        Failed::refused(refusal, &self.state)
    }
}

impl solve::Engine for GpuEngine {
    fn advance(&mut self, steps: u64, until_settled: bool) -> Result<Report, Failed> {
        let stands = self.control.bad_node != NONE || until_settled && self.control.has_settled();
        if steps > 0 && !stands {
            self.run(steps, until_settled).map_err(|error| self.gave_up(error))?;
        }
        if self.control.bad_node == NONE {
            return Ok(self.report());
        }
        let mut endings = self.ending().map_err(|error| self.gave_up(error))?;
        match endings.pop() {
            Some(ending) => Err(diverged(&self.model, &ending, self.to.clone(), self.engine.variant.scheme).into()),
            None => Ok(self.report()),
        }
    }

    fn report(&self) -> Report {
        Report {
            steps: u64::from(self.control.step),
            settled: self.control.has_settled(),
            distance: distance(&self.control),
            ramp: ramp_share(&self.control),
        }
    }

    fn set_targets(&mut self, targets: Vec<f64>) -> Result<(), Failed> {
        single::check_targets(&targets).map_err(|refusal| self.refused_for(refusal))?;
        if targets == self.to { Ok(()) } else { self.aim(targets).map_err(|error| self.gave_up(error)) }
    }

    fn set_surroundings(&mut self, held: Held, loads: Vec<Load>) -> Result<(), Failed> {
        single::check_loads(&loads).map_err(|refusal| self.refused_for(refusal))?;
        let loaded = self.engine.outside().loaded;
        if loads.iter().any(|load| !loaded.contains(&load.node)) {
            return Err(
                self.refused("loads on other nodes", "those that it began with (a load of 0 keeps room for another)")
            );
        }
        let written = self.engine.gpu.scoped(|| {
            self.engine.hold(&self.held, &held);
            if self.scene.loads != loads {
                self.engine.write_loads(0, std::iter::once(&loads[..]));
            }
        });
        written.map_err(|error| self.gave_up(error))?;
        (self.held, self.scene.loads) = (held, loads);
        self.disturb();
        Ok(())
    }

    fn place(&mut self, node: NodeId, axes: Axes, position: DVec3) -> Result<(), Failed> {
        single::check_position(position).map_err(|refusal| self.refused_for(refusal))?;
        let written = self.engine.gpu.scoped(|| self.engine.place(node, axes, position));
        written.map_err(|error| self.gave_up(error))?;
        self.disturb();
        Ok(())
    }

    fn positions(&mut self) -> Result<Positions<'_>, Failed> {
        self.refresh().map_err(|error| self.gave_up(error))?;
        Ok(Positions::new(&self.state.positions, &self.model.normalisation))
    }

    fn state(&mut self) -> Result<State, Failed> {
        self.refresh_all().map_err(|error| self.gave_up(error))?;
        Ok(self.state.clone())
    }

    fn reactions(&mut self) -> Result<Vec<Reaction>, Failed> {
        self.refresh_all().map_err(|error| self.gave_up(error))?;
        let mut forces = Forces::holding(&self.model, &self.scene, self.held.clone());
        let State { positions, targets, fold_angles, .. } = &self.state;
        forces.evaluate(positions, targets, &mut fold_angles.clone());
        Ok(forces.reactions().to_vec())
    }

    fn save(&mut self) -> Result<Saved, Failed> {
        Err(self.refused("saved simulations", "the CPU; `state` tells where the nodes are"))
    }

    fn restore(&mut self, _: &Saved) -> Result<(), Failed> {
        Err(self.refused("saved simulations", "the CPU; a simulation can begin in any state"))
    }

    fn finish(self, targets: Targets) -> Result<Folded, Failed> {
        let mut endings = self.ending().map_err(|error| self.gave_up(error))?;
        let Some(mut ending) = endings.pop() else {
            return Err(self.gave_up(GpuError::Refused("the state could not be read".to_owned())));
        };
        ending.control = Control { stop: if self.control.has_settled() { SETTLED } else { 0 }, ..self.control };
        let scene = self.scene.with_targets(targets);
        let instance = Instance { model: &self.model, start: State::default(), scene };
        folded(&instance, self.held, self.to, true, &ending, self.engine.variant.scheme)
    }
}
