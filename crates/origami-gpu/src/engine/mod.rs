//! A sheet on the GPU: its buffers, and the passes of a step in their order.

mod buffers;
mod contact;
mod passes;

use origami_core::Model;
use origami_core::ids::NodeId;
use origami_core::model::Material;

use crate::blocks::Copies;
use crate::device::Gpu;
use crate::error::GpuError;
use crate::outside::Outside;
use crate::pipeline::{Buffers, Pass};
use crate::plan::{CHECK_INTERVAL, batch};
use crate::purpose::{Dispatch, Purpose};
use crate::route::{Route, small_variant};
use crate::sheet_arrays::SheetArrays;
use crate::variant::Variant;
use buffers::buffers;
pub(crate) use buffers::{check_counts, most_instances, sizes};
use passes::Passes;

/// The buffers and passes of a sheet, for up to `instances` instances.
#[derive(Debug)]
pub(crate) struct Engine {
    pub(crate) gpu: Gpu,
    pub(crate) variant: Variant,
    pub(crate) buffers: Buffers,
    pub(crate) instances: usize,
    /// The nodes that may be loaded, in order, and the slot of each for its load.
    pub(crate) load_slots: Vec<(NodeId, u32)>,
    /// Of a sheet that goes by blocks: the creases as they have them.
    pub(crate) copies: Option<Copies>,
    passes: Passes,
}

impl Engine {
    /// For one sheet of `model`, with room for what acts on it from outside.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] where a buffer is larger than the adapter allows, or what the device says.
    pub(crate) fn new(gpu: &Gpu, model: &Model, outside: &Outside, purpose: Purpose) -> Result<Self, GpuError> {
        Self::of_arrays(gpu, &SheetArrays::with_outside(model, outside), Some(model.material), purpose, 1)
    }

    /// For `instances` sheets of these arrays, and the material of all of them, or `None` where they differ.
    ///
    /// # Errors
    /// As [`Engine::new`].
    pub(crate) fn of_arrays(
        gpu: &Gpu,
        arrays: &SheetArrays,
        material: Option<Material>,
        purpose: Purpose,
        instances: usize,
    ) -> Result<Self, GpuError> {
        let plain = purpose.variant(arrays, material);
        let route = Route::new(arrays, purpose, gpu.abilities());
        let variant = route.variant(&plain);
        check_counts(&variant)?;
        gpu.scoped(|| {
            let buffers = buffers(gpu, arrays, &variant, &route, instances)?;
            let small = route.blocks().filter(|_| route.dispatch() == Dispatch::Workgroup);
            let most = batch(arrays.nodes);
            let small = small.map(|blocks| small_variant(arrays, blocks, &variant, purpose.safe, most));
            let passes = Passes::new(gpu, &variant, small.as_ref(), &buffers, purpose.safe);
            let engine = Self::plain(gpu, variant, buffers, Vec::new());
            let copies = route.blocks().map(|blocks| blocks.copies.clone());
            Ok(Self { load_slots: arrays.load_slots.clone(), copies, passes, instances, ..engine })
        })?
    }

    /// The buffers of one sheet that goes by passes, or by blocks, without any pass.
    #[cfg(test)]
    pub(crate) fn bare(gpu: &Gpu, model: &Model, purpose: Purpose) -> Result<Self, GpuError> {
        let arrays = SheetArrays::new(model);
        let plain = purpose.variant(&arrays, Some(model.material));
        let route = Route::new(&arrays, purpose, gpu.abilities());
        let variant = route.variant(&plain);
        let buffers = gpu.scoped(|| buffers(gpu, &arrays, &variant, &route, 1))??;
        let copies = route.blocks().map(|blocks| blocks.copies.clone());
        Ok(Self { copies, ..Self::plain(gpu, variant, buffers, Vec::new()) })
    }

    /// One sheet of which a step is `passes` one after the other: no stopping rule, nothing to be renewed.
    pub(crate) fn plain(gpu: &Gpu, variant: Variant, buffers: Buffers, integration: Vec<Pass>) -> Self {
        Self {
            gpu: gpu.clone(),
            variant,
            buffers,
            instances: 1,
            load_slots: Vec::new(),
            copies: None,
            passes: Passes { integration, stride: 1, ..Passes::default() },
        }
    }

    /// Whether dynamics renews its time step, which no sheet does at its first step.
    pub(crate) fn renews_time_step(&self) -> bool {
        !self.variant.relaxing() && self.passes.renewal > 0
    }

    /// So many steps as whole dispatches that are no fewer.
    pub(crate) fn whole_dispatches(&self, steps: u64) -> u64 {
        if self.passes.stride > 1 { steps.next_multiple_of(CHECK_INTERVAL) } else { steps }
    }

    /// What may act on its sheets from outside.
    pub(crate) fn outside(&self) -> Outside {
        Outside { holds: self.variant.fixed, loaded: self.load_slots.iter().map(|(node, _)| *node).collect() }
    }

    /// Records the steps `from..to`, counted since the start.
    pub(crate) fn record(&self, pass: &mut wgpu::ComputePass<'_>, instances: u32, from: u64, to: u64) {
        let mut record = |passes: &[Pass]| passes.iter().for_each(|p| p.record(pass, instances));
        let (passes, dynamics) = (&self.passes, !self.variant.relaxing());
        // Dynamics begins with a time step, a relaxation without masses.
        let renews = |step: u64| passes.renewal > 0 && step.is_multiple_of(passes.renewal) && (step > 0 || !dynamics);
        let mut step = from;
        while step < to {
            if let Some((steps, pass)) = passes.long.as_ref().filter(|(steps, _)| to - step >= *steps) {
                record(std::slice::from_ref(pass));
                step += steps;
                continue;
            }
            let (is_check, renews) = (step.is_multiple_of(CHECK_INTERVAL), renews(step));
            if !passes.alone || is_check || renews {
                record(&passes.fold_angles);
            }
            if is_check || if passes.alone { renews } else { !dynamics } {
                record(&passes.spring_forces);
            }
            if is_check {
                record(&passes.settling);
            }
            if renews {
                record(&passes.row_sums);
            }
            record(&passes.damped_forces);
            record(&passes.integration);
            step += passes.stride;
        }
        record(&passes.home);
    }

    /// Records a copy of the state, where it is good.
    pub(crate) fn record_checkpoint(&self, pass: &mut wgpu::ComputePass<'_>, instances: u32) {
        self.passes.checkpoint.iter().for_each(|p| p.record(pass, instances));
    }
}

/// The material that all models share.
pub(crate) fn uniform(models: &[&Model]) -> Option<Material> {
    let material = models[0].material;
    models.iter().all(|m| m.material == material).then_some(material)
}
