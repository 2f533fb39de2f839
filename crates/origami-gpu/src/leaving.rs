//! Where instances have ended, on its way to the processor.

use crate::engine::Engine;
use crate::error::GpuError;
use crate::kernels::Binding;
use crate::layout::{Control, CreaseState, NONE, Node};
use crate::mapped::Reading;
use crate::run::Ending;

/// Copies of what some instances of an engine have come to. The instances can be used for others at once.
#[derive(Debug)]
pub(crate) struct Leaving {
    controls: Reading<Control>,
    /// The control block of each, where the one that is copied has been changed since.
    known: Vec<Option<Control>>,
    nodes: Reading<Node>,
    creases: Reading<CreaseState>,
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
            creases: engine.start_reading(Binding::CreaseStates, &all, creases),
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
        let (nodes, creases) = (self.nodes.wait(gpu)?, self.creases.wait(gpu)?);
        let good = match self.good {
            Some((nodes, angles)) => Some((nodes.wait(gpu)?, angles.wait(gpu)?)),
            None => None,
        };
        let ending = |(i, (control, known)): (usize, (Control, Option<Control>))| {
            let control = known.unwrap_or(control);
            let own_nodes = i * node_count..(i + 1) * node_count;
            let own_creases = i * crease_count..(i + 1) * crease_count;
            let good = good.as_ref().filter(|_| control.bad_node != NONE);
            let good = good.map(|(n, c)| (n[own_nodes.clone()].to_vec(), c[own_creases.clone()].to_vec()));
            Ending {
                cancelled: self.cancelled,
                control,
                checkpoint: good,
                nodes: nodes[own_nodes].to_vec(),
                creases: creases[own_creases].to_vec(),
            }
        };
        Ok(controls.into_iter().zip(self.known).enumerate().map(ending).collect())
    }
}
