//! Where instances have ended, on its way to the processor.

use crate::engine::Engine;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{Control, CreaseState, NONE, Node};
use crate::mapped::Reading;
use crate::run::Ending;

/// Creases as an engine has them.
#[derive(Debug)]
enum Creases {
    States(Reading<CreaseState>),
    /// Blocks know the fold angles alone.
    Angles(Reading<f32>),
}

impl Creases {
    /// The states of the creases of each instance.
    fn wait(self, engine: &Engine) -> Result<Vec<Vec<CreaseState>>, GpuError> {
        let each = engine.variant.creases.max(1);
        Ok(match self {
            Self::States(states) => states.wait(&engine.gpu)?.chunks(each).map(<[_]>::to_vec).collect(),
            Self::Angles(angles) => {
                let state = |angle| CreaseState { angle, ..CreaseState::default() };
                let own = |own: &[f32]| by_crease(engine, own).into_iter().map(state).collect();
                angles.wait(&engine.gpu)?.chunks(each).map(own).collect()
            }
        })
    }
}

/// The angles of an instance, one for each crease.
fn by_crease(engine: &Engine, angles: &[f32]) -> Vec<f32> {
    engine.copies.as_ref().map_or_else(|| angles.to_vec(), |copies| copies.collect(angles))
}

/// Copies of what some instances of an engine have come to. The instances can be used for others at once.
#[derive(Debug)]
pub(crate) struct Leaving {
    controls: Reading<Control>,
    /// The control block of each, where the one that is copied has been changed since.
    known: Vec<Option<Control>>,
    nodes: Reading<Node>,
    creases: Creases,
    /// The last good state of all, where one of them may have diverged.
    good: Option<(Reading<Node>, Reading<f32>)>,
    cancelled: bool,
}

impl Leaving {
    /// Copies what lies in these instances, with the control blocks of those for which they are known. `cancelled`: whether
    /// they were broken off; `diverged`: whether one of them may have.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn new(
        engine: &Engine,
        instances: &[(usize, Option<Control>)],
        cancelled: bool,
        diverged: bool,
    ) -> Result<Self, GpuError> {
        let (all, known): (Vec<usize>, Vec<_>) = instances.iter().copied().unzip();
        let (nodes, creases) = (engine.variant.nodes, engine.variant.creases);
        engine.gpu.scoped(|| Self {
            controls: engine.start_reading(Binding::Control, &all, 1),
            known,
            nodes: engine.start_reading(Binding::Nodes, &all, nodes),
            creases: match engine.copies {
                None => Creases::States(engine.start_reading(Binding::CreaseStates, &all, creases)),
                Some(_) => Creases::Angles(engine.start_reading(Binding::Angles, &all, creases)),
            },
            good: diverged.then(|| {
                let good_nodes = engine.start_reading(Binding::CheckpointNodes, &all, nodes);
                (good_nodes, engine.start_reading(Binding::CheckpointAngles, &all, creases))
            }),
            cancelled,
        })
    }

    /// Where they ended, in their order.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn wait(self, engine: &Engine) -> Result<Vec<Ending>, GpuError> {
        let (gpu, node_count, crease_count) = (&engine.gpu, engine.variant.nodes, engine.variant.creases);
        let controls = self.controls.wait(gpu)?;
        let (nodes, creases) = (self.nodes.wait(gpu)?, self.creases.wait(engine)?);
        let good = match self.good {
            Some((nodes, angles)) => Some((nodes.wait(gpu)?, angles.wait(gpu)?)),
            None => None,
        };
        let mut creases = creases.into_iter();
        let ending = |(i, (control, known)): (usize, (Control, Option<Control>))| {
            let control = known.unwrap_or(control);
            let own_nodes = i * node_count..(i + 1) * node_count;
            let own_creases = i * crease_count..(i + 1) * crease_count;
            let good = good.as_ref().filter(|_| control.bad_node != NONE);
            let good = good.map(|(n, angles)| (n[own_nodes.clone()].to_vec(), by_crease(engine, &angles[own_creases])));
            Ending {
                cancelled: self.cancelled,
                control,
                checkpoint: good,
                nodes: nodes[own_nodes].to_vec(),
                creases: creases.next().unwrap_or_default(),
            }
        };
        Ok(controls.into_iter().zip(self.known).enumerate().map(ending).collect())
    }
}
