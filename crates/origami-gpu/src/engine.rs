//! A sheet on the GPU: its buffers, and the passes of a step in their order.

use std::mem::offset_of;

use origami_core::Model;
use origami_core::ids::NodeId;
use origami_core::model::Material;

use crate::blocks::Copies;
use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::{Binding, Kernel, triangle_forces, workgroup_dynamics, workgroup_relax};
use crate::layout::{Before, Control, CreaseState, Node, Touch};
use crate::outside::Outside;
use crate::pair_arrays::{self, PairArrays};
use crate::pipeline::{Buffers, Pass, buffer};
use crate::plan::{CHECK_INTERVAL, Plan, batch};
use crate::purpose::{Dispatch, Purpose};
use crate::route::{Route, small_variant};
use crate::sheet_arrays::SheetArrays;
use crate::variant::{InContact, Scheme, Small, Variant};

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

/// The passes of a sheet, by when they run.
#[derive(Debug, Default)]
struct Passes {
    fold_angles: Vec<Pass>,
    /// The forces of the springs alone: those of a relaxation, and what the stopping rule of dynamics takes.
    spring_forces: Vec<Pass>,
    damped_forces: Vec<Pass>,
    settling: Vec<Pass>,
    row_sums: Vec<Pass>,
    /// From forces to new positions; where these passes compute the forces too, all of a step.
    integration: Vec<Pass>,
    checkpoint: Vec<Pass>,
    /// After the last step of a submission.
    home: Vec<Pass>,
    /// Whether `integration` needs no forces.
    alone: bool,
    /// Steps that it takes at once.
    stride: u64,
    /// A pass that takes more steps at once, and how many.
    long: Option<(u64, Pass)>,
    /// Steps between two renewals of masses or of the time step; 0 where there are none.
    renewal: u64,
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

    /// For one sheet of `model` whose layers push each other away; by passes over all elements. It needs a list of pairs before
    /// its first step.
    ///
    /// # Errors
    /// As [`Engine::new`].
    pub(crate) fn in_contact(
        gpu: &Gpu,
        model: &Model,
        outside: &Outside,
        contact: InContact,
    ) -> Result<Self, GpuError> {
        let arrays = SheetArrays::with_outside(model, outside);
        let plain = Variant::new(&arrays, Scheme::Relax, Some(model.material));
        let variant = Variant { contact: Some(contact), ..plain };
        check_counts(&variant)?;
        gpu.scoped(|| {
            let mut buffers = buffers(gpu, &arrays, &variant, &Route::Passes, 1)?;
            for (binding, size) in pair_arrays::sizes(variant.nodes, FIRST_PAIRS) {
                buffers.insert(binding, buffer(gpu, binding, size, &[])?);
            }
            let passes = Passes::new(gpu, &variant, None, &buffers, false);
            let engine = Self::plain(gpu, variant, buffers, Vec::new());
            Ok(Self { load_slots: arrays.load_slots.clone(), passes, ..engine })
        })?
    }

    /// Takes another list of pairs; every node is where it is listed.
    ///
    /// # Errors
    /// [`GpuError::TooManyElements`] where a dispatch does not count so many pairs, and as [`Engine::new`].
    pub(crate) fn list(&mut self, PairArrays { pairs, rows, lasts }: &PairArrays) -> Result<(), GpuError> {
        let allowed = 65_535 * u64::from(self.variant.workgroup);
        let count = u32::try_from(pairs.len()).ok().filter(|count| u64::from(*count) <= allowed);
        let count = count.ok_or(GpuError::TooManyElements { count: pairs.len() as u64, allowed })?;
        let gpu = self.gpu.clone();
        gpu.scoped(|| {
            let needed = size_of_val(&pairs[..]) as u64;
            if needed > self.buffers[&Binding::Pairs].size() {
                // Lists grow as the sheet folds.
                let room = 2 * pairs.len();
                let of_pairs = [Binding::Pairs, Binding::Nears, Binding::Pushes, Binding::Shares];
                let sizes = pair_arrays::sizes(self.variant.nodes, room).into_iter();
                for (binding, size) in sizes.filter(|(binding, _)| of_pairs.contains(binding)) {
                    self.buffers.insert(binding, buffer(&gpu, binding, size, &[])?);
                }
                let buffers = &self.buffers;
                self.passes.all_mut().for_each(|pass| pass.rebind(&gpu, buffers));
            }
            self.passes.all_mut().for_each(|pass| pass.set_pairs(count));
            self.write(Binding::Pairs, pairs);
            self.write(Binding::PairRows, rows);
            let at = offset_of!(Touch, lasts) as u64;
            gpu.queue().write_buffer(&self.buffers[&Binding::Touch], at, bytemuck::bytes_of(lasts));
            self.write(Binding::Ways, &vec![[0.0_f32; 4]; self.variant.nodes]);
            Ok(())
        })?
    }

    /// Before a fold nothing has been in the way.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn forget_contact(&self) -> Result<(), GpuError> {
        self.gpu.scoped(|| self.write(Binding::Touch, &[Touch::default()]))
    }

    /// Lets the first instance go on that waited for a list, after all that has been submitted.
    ///
    /// # Errors
    /// What the device says.
    pub(crate) fn go_on(&self) -> Result<(), GpuError> {
        // The first word of its control block.
        self.gpu.scoped(|| self.write(Binding::Control, &[0_u32]))
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

/// Pairs for which there is room before the first list.
const FIRST_PAIRS: usize = 1024;

impl Passes {
    fn all_mut(&mut self) -> impl Iterator<Item = &mut Pass> {
        let Self {
            fold_angles, spring_forces, damped_forces, settling, row_sums, integration, checkpoint, home, ..
        } = self;
        let all = [fold_angles, spring_forces, damped_forces, settling, row_sums, integration, checkpoint, home];
        all.into_iter().flatten()
    }

    /// `small`: the variant of a workgroup that has the whole sheet.
    fn new(gpu: &Gpu, variant: &Variant, small: Option<&Variant>, buffers: &Buffers, safe: bool) -> Self {
        let pass = |kernel, variant: &Variant, clock| Pass::new(gpu, kernel, variant, clock, buffers);
        let plan = Plan::new(variant, safe);
        let passes = |kernels: &[&'static Kernel]| kernels.iter().map(|k| pass(k, variant, false)).collect();
        if let Some(small) = small {
            let kernel = if variant.relaxing() { &workgroup_relax::KERNEL } else { &workgroup_dynamics::KERNEL };
            let of = |steps: u64| {
                let steps = steps.min(u64::from(small.small.steps));
                #[expect(clippy::cast_possible_truncation, reason = "no more than there were")]
                let own = Small { steps: steps as u32, ..small.small };
                (steps, pass(kernel, &Variant { small: own, ..small.clone() }, false))
            };
            // Sheets that take turns stop at whole intervals.
            let (stride, short) = of(CHECK_INTERVAL);
            return Self {
                integration: vec![short],
                checkpoint: passes(plan.checkpoint),
                alone: true,
                stride,
                long: (u64::from(small.small.steps) > stride).then(|| of(u64::MAX)),
                ..Self::default()
            };
        }
        let undamped =
            |kernels: &[&'static Kernel]| kernels.iter().map(|k| pass(k, &variant.undamped(), false)).collect();
        let alone = variant.blocks.is_some();
        // The pass over the triangles advances the clock.
        let clock = |k: &Kernel| k.name == triangle_forces::KERNEL.name;
        let damped: &[&Kernel] = if alone || variant.relaxing() { &[] } else { &plan.forces };
        Self {
            fold_angles: undamped(plan.angles),
            spring_forces: undamped(&plan.forces),
            damped_forces: damped.iter().map(|k| pass(k, variant, clock(k))).collect(),
            settling: passes(plan.settling),
            row_sums: passes(plan.row_sums),
            integration: passes(plan.integration),
            checkpoint: passes(plan.checkpoint),
            home: passes(plan.home),
            alone,
            stride: 1,
            long: None,
            renewal: plan.renewal,
        }
    }
}

/// The material that all models share.
pub(crate) fn uniform(models: &[&Model]) -> Option<Material> {
    let material = models[0].material;
    models.iter().all(|m| m.material == material).then_some(material)
}

/// Dispatches count workgroups in 16 bits.
pub(crate) fn check_counts(variant: &Variant) -> Result<(), GpuError> {
    // A block has several creases for each invocation.
    let creases = if variant.blocks.is_some() { 0 } else { variant.creases };
    let most = creases.max(variant.faces).max(variant.nodes);
    let allowed = 65_535;
    match variant.groups(most) {
        groups if groups > allowed => Err(GpuError::TooManyElements {
            count: most as u64,
            allowed: (allowed * variant.workgroup as usize) as u64,
        }),
        _ => Ok(()),
    }
}

/// Bytes that each buffer takes for one instance, and once for all: what a sheet needs.
pub(crate) fn sizes(arrays: &SheetArrays, variant: &Variant, route: &Route) -> Vec<(Binding, u64, u64)> {
    let size = |count: usize, of: usize| (count * of) as u64;
    let nodes = arrays.nodes;
    // By blocks dynamics keeps the nodes twice: where they are, and where they come to.
    let halves = if matches!(route, Route::Blocks(_)) && !variant.relaxing() { 2 } else { 1 };
    let mut sizes = vec![
        (Binding::Control, size(1, size_of::<Control>()), 0),
        (Binding::Nodes, size(halves * nodes, size_of::<Node>()), 0),
        (Binding::Windows, size(nodes, size_of::<Before>()), 0),
        (Binding::CheckpointNodes, size(nodes, size_of::<Node>()), 0),
        (Binding::CheckpointAngles, size(variant.creases, 4), 0),
    ];
    let partials = (Binding::Partials, size(variant.groups(nodes).max(variant.sums()), 16), 0);
    if let Some(blocks) = route.blocks() {
        sizes.extend([
            (Binding::Blocks, 0, size(blocks.words.len(), 4)),
            (Binding::Angles, size(variant.creases, 4), 0),
            (Binding::Targets, size(variant.creases, 8), 0),
        ]);
        if variant.loads {
            sizes.push((Binding::Loads, size(nodes, 16), 0));
        }
        if matches!(route, Route::Blocks(_)) {
            sizes.extend([partials, (Binding::Slots, size(nodes, 16), 0)]);
        }
        return sizes;
    }
    sizes.extend([
        partials,
        (Binding::CreaseStates, size(arrays.hinges.len(), size_of::<CreaseState>()), 0),
        (Binding::Hinges, 0, size_of_val(&arrays.hinges[..]) as u64),
        (Binding::Faces, 0, size_of_val(&arrays.faces[..]) as u64),
        (Binding::Slots, size(arrays.slot_count(), 16), 0),
        (Binding::Rows, 0, size(nodes + 1, 4)),
    ]);
    if variant.corners {
        sizes.push((Binding::Corners, 0, size(arrays.corners.len(), 16)));
    }
    if variant.rigidities {
        sizes.push((Binding::Rigidities, 0, size(arrays.rigidities.len(), 4)));
    }
    if variant.loose_beams > 0 {
        sizes.push((Binding::LooseBeams, 0, size_of_val(&arrays.loose_beams[..]) as u64));
    }
    sizes
}

fn buffers(
    gpu: &Gpu,
    arrays: &SheetArrays,
    variant: &Variant,
    route: &Route,
    instances: usize,
) -> Result<Buffers, GpuError> {
    let mut buffers = Buffers::new();
    for (binding, each, once) in sizes(arrays, variant, route) {
        let contents: &[u8] = match (binding, route) {
            (Binding::Hinges, _) => bytemuck::cast_slice(&arrays.hinges),
            (Binding::Faces, _) => bytemuck::cast_slice(&arrays.faces),
            (Binding::Rows, _) => bytemuck::cast_slice(&arrays.rows),
            (Binding::Corners, _) => bytemuck::cast_slice(&arrays.corners),
            (Binding::Rigidities, _) => bytemuck::cast_slice(&arrays.rigidities),
            (Binding::LooseBeams, _) => bytemuck::cast_slice(&arrays.loose_beams),
            (Binding::Blocks, Route::Blocks(blocks) | Route::Workgroup(blocks)) => bytemuck::cast_slice(&blocks.words),
            _ => &[],
        };
        buffers.insert(binding, buffer(gpu, binding, each * instances as u64 + once, contents)?);
    }
    Ok(buffers)
}

/// How many instances of a sheet fit into the adapter's buffers.
pub(crate) fn most_instances(gpu: &Gpu, arrays: &SheetArrays, purpose: Purpose) -> usize {
    // Buffers are as large with one material as with many.
    let plain = purpose.variant(arrays, None);
    let route = Route::new(arrays, purpose, gpu.abilities());
    let variant = route.variant(&plain);
    let allowed = gpu.largest_buffer();
    let fits = sizes(arrays, &variant, &route).into_iter().filter(|(_, each, _)| *each > 0);
    let most = fits.map(|(_, each, once)| allowed.saturating_sub(once) / each).min().unwrap_or(1);
    usize::try_from(most.clamp(1, 65_535)).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::{gpu, sheets};

    fn arrays_and_variant(model: &Model) -> (SheetArrays, Variant) {
        let arrays = SheetArrays::new(model);
        let variant = Variant::new(&arrays, EULER, Some(model.material));
        (arrays, variant)
    }

    #[test]
    fn more_elements_than_a_dispatch_counts_are_refused() {
        let (_, mut variant) = arrays_and_variant(&miura());
        variant.faces = 65_535 * variant.workgroup as usize;
        assert_eq!(check_counts(&variant), Ok(()));
        variant.faces += 1;
        let count = variant.faces as u64;
        assert_eq!(check_counts(&variant), Err(GpuError::TooManyElements { count, allowed: count - 1 }));
    }

    #[test]
    fn buffers_that_the_adapter_does_not_allow_are_refused() {
        let Some(gpu) = gpu() else { return };
        let model = miura();
        let (mut arrays, variant) = arrays_and_variant(&model);
        let allowed = gpu.largest_buffer();
        // As if it had so many nodes: only what is allowed is ever made.
        arrays.nodes = usize::try_from(allowed).expect("64 bits") / size_of::<Node>() + 1;
        let refused = buffers(&gpu, &arrays, &variant, &Route::Passes, 1).expect_err("too large");
        let needed = (arrays.nodes * size_of::<Node>()) as u64;
        assert_eq!(refused, GpuError::TooLarge { what: "the nodes", needed, allowed });
    }

    #[test]
    fn as_many_instances_as_fit_and_no_more() {
        let Some(gpu) = gpu() else { return };
        let allowed = gpu.largest_buffer();
        for model in [miura(), sheets::loose_beams()] {
            let (arrays, variant) = arrays_and_variant(&model);
            let purpose = Purpose { scheme: EULER, safe: false, softens: false, dispatch: Dispatch::Passes };
            let most = most_instances(&gpu, &arrays, purpose) as u64;
            let largest = |count: u64| sizes(&arrays, &variant, &Route::Passes).iter().map(|s| s.1 * count + s.2).max();
            assert!(largest(most) <= Some(allowed));
            assert!(most == 65_535 || largest(most + 1) > Some(allowed));
            assert!(most >= 1);
        }
    }
}
