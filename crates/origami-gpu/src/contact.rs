//! Relaxation under contact on a GPU: the shaders go on until their list of pairs is spent, and the processor makes another.

use std::ops::ControlFlow;

use glam::DVec3;
use origami_core::contact::{Contact, Crossings, PairList};
use origami_core::mesh::Mesh;
use origami_core::model::{Inventory, Model};
use origami_core::scene::{Refusal, Scene};
use origami_core::solve::attempt::Attempt;
use origami_core::solve::contact_end::{Came, Ended, patience};
use origami_core::solve::{ContactRelax, Failed, Folded, Instance, Progress, Session, Solver, State, Touch, Touching};
use origami_core::twins::checkpoint::COPY_EVERY;

use crate::device::Gpu;
use crate::engine::Engine;
use crate::error::{GPU, GpuError};
use crate::kernels::Binding;
use crate::layout::{self, Control, CreaseState, HELD_UP, NONE, Node, SETTLED, SPENT};
use crate::leaving::Leaving;
use crate::outcome::{backend, distance, diverged, progress, state};
use crate::outside::Outside;
use crate::pair_arrays::PairArrays;
use crate::run::Beginning;
use crate::variant::{InContact, Scheme};
use crate::{inventory, relax, single};

/// The least gap that f32 bears, in radii. Distances come with an error of some 5e-8 where edges are as long as the sheet.
const LEAST_GAP: f64 = 1e-4;
/// Evaluations that are submitted at once: twice as many as the last list has lasted for, between these.
const BATCH: [u64; 2] = [4, 100];

impl Gpu {
    /// `method` computed here instead of on the processor.
    pub fn with_contact(&self, method: ContactRelax) -> ContactOnGpu {
        ContactOnGpu { gpu: self.clone(), method }
    }
}

/// [`ContactRelax`] on a GPU, with the same settings and the same result up to f32: a sheet that cannot go through itself.
///
/// It goes by passes over all elements, one sheet at a time. The processor lists the pairs that may touch, anew as often as it
/// would for itself; forces, moves and how they are shortened are the GPU's. Every state that is read, also for a list, goes
/// through the exact test for crossings in double precision, and one that is crossed is an error, [`GpuError::Crossed`].
///
/// [`Relax::precision`](origami_core::Relax::precision) and `threads` have no meaning here.
#[derive(Clone, Debug)]
pub struct ContactOnGpu {
    gpu: Gpu,
    method: ContactRelax,
}

impl ContactOnGpu {
    /// The solver's settings.
    pub fn method(&self) -> &ContactRelax {
        &self.method
    }

    /// The same with one model's buffers and pipelines kept, for more than one fold.
    pub fn on<'a>(&'a self, model: &'a Model) -> ContactOnModel<'a> {
        ContactOnModel { gpu: &self.gpu, method: self.method.clone(), model, engine: None }
    }
}

impl Solver for ContactOnGpu {
    fn fold(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(model, start, scene, observe).map(|(folded, _)| folded)
    }

    fn session<'a>(&'a self, model: &'a Model) -> Box<dyn Session + 'a> {
        Box::new(self.on(model))
    }

    /// One after the other.
    fn fold_each(
        &self,
        instances: &[Instance<'_>],
        observe: &(dyn Fn(usize, Progress) -> ControlFlow<()> + Sync),
        take: &(dyn Fn(usize, Result<Folded, Failed>) -> ControlFlow<()> + Sync),
    ) {
        let _ = instances.iter().enumerate().try_for_each(|(i, instance)| {
            take(i, self.fold(instance.model, &instance.start, &instance.scene, &mut |progress| observe(i, progress)))
        });
    }

    fn inventory(&self, model: &Model) -> Inventory {
        inventory::in_contact(model, self.method.inventory(model), self.method.contact)
    }
}

impl Touching for ContactOnGpu {
    fn fold_touching(
        &self,
        model: &Model,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        self.on(model).fold_touching(start, scene, observe)
    }
}

/// A [`Session`] under contact on a GPU. The sheet is moved off every symmetry once, not at each fold.
#[derive(Debug)]
pub struct ContactOnModel<'a> {
    gpu: &'a Gpu,
    method: ContactRelax,
    model: &'a Model,
    engine: Option<Engine>,
}

impl Session for ContactOnModel<'_> {
    fn fold(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Folded, Failed> {
        self.fold_touching(start, scene, observe).map(|(folded, _)| folded)
    }
}

impl ContactOnModel<'_> {
    /// As [`Session::fold`], and what contact did.
    ///
    /// # Errors
    /// As [`Touching::fold_touching`].
    pub fn fold_touching(
        &mut self,
        start: &State,
        scene: &Scene,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Folded, Touch), Failed> {
        let instance = Instance { model: self.model, start: start.clone(), scene: scene.clone() };
        let refused = |refusal| Failed::refused(refusal, start);
        let beginning = self.beginning(&instance).map_err(refused)?;
        let mut list = PairList::new(&self.model.mesh, &self.model.rest, self.method.contact);
        list.list(&beginning.state.positions);
        if list.least_gap() <= 0.0 {
            return Err(refused(Refusal::Closed { gap: list.least_gap() }));
        }
        let mut run = Run {
            instance: &instance,
            targets: beginning.targets.clone(),
            limit: beginning.limit.min(u64::from(u32::MAX)),
            most_pairs: 0,
            last: beginning.state.clone(),
            at: 0,
            list,
        };
        let steps_asked = self.method.relax.steps.is_some();
        let gone = self.engine(scene, &run.list).and_then(|engine| {
            engine.load(0, &[beginning])?;
            engine.forget_contact()?;
            let stands = run.go(engine, observe)?;
            run.end(engine, stands, steps_asked)
        });
        match gone {
            Ok(End::Came(came)) => {
                if start.targets != came.state.targets {
                    self.method.relax.perturbation = 0.0;
                }
                Ok(came.measured((self.model, scene), self.method.contact))
            }
            Ok(End::Diverged(failed)) => Err(*failed),
            Err(error) => Err(backend(error, &run.last, run.at)),
        }
    }

    /// Where the sheet begins, if this can fold it.
    fn beginning<'m>(&self, instance: &Instance<'m>) -> Result<Beginning<'m>, Refusal> {
        check(&self.method)?;
        let targets = relax::targets(instance)?;
        let relax = &self.method.relax;
        let attempt = relax.first_attempt((instance.model, &instance.scene), &instance.start, &targets);
        let beginning = relax::beginning(relax, instance, &targets, Attempt { softening: None, ..attempt });
        let crossings = Crossings::of(&instance.model.mesh, &beginning.state.positions);
        match crossings.faces.first() {
            Some([one, other]) => Err(Refusal::Crossed { faces: [*one, *other] }),
            None => Ok(beginning),
        }
    }

    /// The engine, built once more where a scene brings supports or loads for which it has no room.
    fn engine(&mut self, scene: &Scene, list: &PairList) -> Result<&mut Engine, GpuError> {
        let before = self.engine.take();
        let engine = match before {
            Some(engine) if engine.outside().covers(scene) => engine,
            before => {
                let outside = before.map_or_else(Outside::default, |engine| engine.outside()).with(scene);
                let contact = InContact {
                    stiffness: self.method.contact.stiffness,
                    thick: self.method.contact.thickness > 0.0,
                    longest_move: list.longest_move(),
                    patience: patience(self.model),
                };
                Engine::in_contact(self.gpu, self.model, &outside, contact)?
            }
        };
        Ok(self.engine.insert(engine))
    }
}

/// Whether f32 can compute with the settings.
fn check(method: &ContactRelax) -> Result<(), Refusal> {
    let Contact { gap, stiffness, thickness } = method.contact;
    for (what, value) in [("gap", gap), ("stiffness", stiffness)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(Refusal::Contact { what, value });
        }
    }
    if !(thickness.is_finite() && thickness >= 0.0) {
        return Err(Refusal::Contact { what: "thickness", value: thickness });
    }
    if gap < LEAST_GAP {
        let what = "contact gap in radii".to_owned();
        return Err(Refusal::TooWide { what, value: gap, backend: GPU, least: LEAST_GAP, most: 1e30 });
    }
    single::check("contact stiffness", stiffness)?;
    single::check("contact thickness", thickness)?;
    single::check("tolerance", method.relax.tolerance)
}

/// Where a run has come to.
enum End {
    Came(Box<Came>),
    Diverged(Box<Failed>),
}

/// One fold.
struct Run<'i, 'm> {
    instance: &'i Instance<'m>,
    targets: Vec<f64>,
    list: PairList,
    limit: u64,
    most_pairs: usize,
    /// The last state that was read and has no crossings, and the evaluations up to it.
    last: State,
    at: u64,
}

impl Run<'_, '_> {
    /// Goes until the sheet stands still; tells where, and whether it was broken off.
    fn go(
        &mut self,
        engine: &mut Engine,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Control, bool), GpuError> {
        self.hand_over_list(engine)?;
        let (mut control, mut listed_at, mut batch) = (Control { bad_node: NONE, ..Control::default() }, 0, BATCH[1]);
        loop {
            let from = u64::from(control.step);
            if from >= self.limit && control.step > 0 || self.limit == 0 {
                return Ok((control, false));
            }
            let to = (from + batch).min(self.limit);
            let controls = engine.submit(1, from, to)?.wait(&engine.gpu)?;
            engine.check_steps(&controls, to)?;
            control = controls.first().copied().unwrap_or(control);
            let is_cancelled = observe(progress(&control)).is_break();
            if is_cancelled || control.bad_node != NONE || ![0, SPENT].contains(&control.stop) {
                return Ok((control, is_cancelled));
            }
            if control.stop == SPENT {
                let nodes: Vec<Node> = engine.read(Binding::Nodes, engine.variant.nodes)?;
                self.take(state(&nodes, &[], Vec::new()).positions, u64::from(control.step))?;
                self.list.list_on(&self.last.positions);
                self.hand_over_list(engine)?;
                engine.go_on()?;
                control.stop = 0;
                batch = (2 * (self.at - listed_at)).clamp(BATCH[0], BATCH[1]);
                listed_at = self.at;
            }
        }
    }

    fn hand_over_list(&mut self, engine: &mut Engine) -> Result<(), GpuError> {
        self.most_pairs = self.most_pairs.max(self.list.pairs().len());
        engine.list(&PairArrays::new(engine.variant.nodes, &self.list))
    }

    /// Takes note of positions that were read, where they have no crossings.
    fn take(&mut self, positions: Vec<DVec3>, step: u64) -> Result<(), GpuError> {
        check_crossings(&self.instance.model.mesh, &positions, step)?;
        (self.last.positions, self.at) = (positions, step);
        Ok(())
    }

    /// Where it has come to; `steps_asked`: it was to run so many evaluations, and not to stop before.
    fn end(
        &mut self,
        engine: &Engine,
        (control, cancelled): (Control, bool),
        steps_asked: bool,
    ) -> Result<End, GpuError> {
        let model = self.instance.model;
        if control.bad_node != NONE {
            let endings = Leaving::new(engine, &[(0, None)], cancelled, true)?.wait(engine)?;
            if let Some(ending) = endings.first() {
                let diverged = diverged(model, ending, std::mem::take(&mut self.targets), Scheme::Relax);
                return Ok(End::Diverged(Box::new(diverged.into())));
            }
        }
        let nodes: Vec<Node> = engine.read(Binding::Nodes, model.node_count())?;
        let creases: Vec<CreaseState> = engine.read(Binding::CreaseStates, model.creases.len())?;
        let touch: Vec<layout::Touch> = engine.read(Binding::Touch, 1)?;
        let touch = touch.first().copied().unwrap_or_default();
        let state = state(&nodes, &creases, std::mem::take(&mut self.targets));
        self.take(state.positions.clone(), u64::from(control.step))?;
        let is_recent = touch.limited > 0 && u64::from(control.step - touch.last_limited) <= COPY_EVERY;
        let arrived = control.ramp_step >= control.ramp_length;
        let first = || f64::from(touch.first_limited) / f64::from(control.ramp_length.max(1));
        Ok(End::Came(Box::new(Came {
            state,
            ended: match control.stop {
                SETTLED => Ended::Settled,
                _ if cancelled => Ended::Cancelled,
                _ if steps_asked => Ended::StepsDone,
                HELD_UP => Ended::HeldUp,
                _ => Ended::Limit(arrived, is_recent),
            },
            steps: u64::from(control.step),
            time_step: f64::from(control.fire_step),
            distance: distance(&control),
            first_limited: (touch.limited > 0).then(|| if control.ramp_length == 0 { 1.0 } else { first() }),
            limited: u64::from(touch.limited),
            most_pairs: self.most_pairs,
        })))
    }
}

/// Whether a state that was read goes through itself.
///
/// # Errors
/// [`GpuError::Crossed`].
fn check_crossings(mesh: &Mesh, positions: &[DVec3], step: u64) -> Result<(), GpuError> {
    match Crossings::of(mesh, positions).faces.first() {
        Some([one, other]) => Err(GpuError::Crossed { step, faces: [one.0, other.0] }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests;
