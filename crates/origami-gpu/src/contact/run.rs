//! One fold under contact: the shaders go on until their list of pairs is spent, and the processor makes another.

use std::ops::ControlFlow;

use glam::DVec3;
use origami_core::contact::{Crossings, PairList};
use origami_core::mesh::Mesh;
use origami_core::solve::{Came, Ended, Failed, Instance, Progress, State};

use crate::engine::Engine;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{self, Control, CreaseState, HELD_UP, NONE, Node, SETTLED, SPENT};
use crate::leaving::Leaving;
use crate::outcome::{distance, diverged, progress, state};
use crate::pair_arrays::PairArrays;
use crate::run::Beginning;
use crate::variant::Scheme;

/// Evaluations that are submitted at once: twice as many as the last list has lasted for, between these.
const BATCH: [u64; 2] = [4, 100];

/// Where a run has come to.
pub(super) enum End {
    Came(Box<Came>),
    Diverged(Box<Failed>),
}

/// One fold.
pub(super) struct Run<'i, 'm> {
    instance: &'i Instance<'m>,
    targets: Vec<f64>,
    list: PairList,
    limit: u64,
    most_pairs: usize,
    /// The last state that was read and has no crossings, and the evaluations up to it.
    pub(super) last: State,
    pub(super) at: u64,
}

impl<'i, 'm> Run<'i, 'm> {
    /// One that begins there.
    pub(super) fn new(instance: &'i Instance<'m>, beginning: &Beginning<'m>, list: PairList) -> Self {
        Self {
            instance,
            targets: beginning.targets.clone(),
            list,
            limit: beginning.limit.min(u64::from(u32::MAX)),
            most_pairs: 0,
            last: beginning.state.clone(),
            at: 0,
        }
    }

    /// Goes until the sheet stands still; tells where, and whether it was broken off.
    pub(super) fn go(
        &mut self,
        engine: &mut Engine,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<(Control, bool), GpuError> {
        self.hand_over_list(engine)?;
        let (mut control, mut listed_at, mut batch) = (Control { bad_node: NONE, ..Control::default() }, 0, BATCH[1]);
        loop {
            let from = u64::from(control.step);
            if from >= self.limit {
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
    pub(super) fn end(
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
        let arrived = control.ramp_step >= control.ramp_length;
        let first = || f64::from(touch.first_limited) / f64::from(control.ramp_length.max(1));
        Ok(End::Came(Box::new(Came {
            state,
            ended: match control.stop {
                SETTLED => Ended::Settled,
                _ if cancelled => Ended::Cancelled,
                _ if steps_asked => Ended::StepsDone,
                HELD_UP => Ended::HeldUp,
                _ => Ended::Limit(arrived),
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
mod tests {
    use std::error::Error;

    use origami_core::ids::FaceId;
    use origami_core::{Relax, Solver};

    use super::*;
    use crate::outcome::backend;
    use crate::testing::layers::model;

    #[test]
    fn a_state_that_is_crossed_is_an_error_that_is_told() {
        let model = model("square-twist");
        assert_eq!(check_crossings(&model.mesh, &model.rest, 7), Ok(()));
        // Folded as far as it goes without contact.
        let free = Relax::default().fold_from_rest(&model, 100.0).expect("it folds");
        let error = check_crossings(&model.mesh, &free.state.positions, 70).expect_err("it is crossed");
        let GpuError::Crossed { step: 70, faces: [one, other] } = error else { panic!("{error}") };
        assert!(FaceId(one) < FaceId(other));
        let failed = backend(error, &free.state, 40);
        assert!(failed.to_string().contains("after 70 evaluations under contact faces"), "{failed}");
        assert!(failed.source().is_some() || matches!(failed, Failed::Backend { last_read_step: 40, .. }));
    }
}
