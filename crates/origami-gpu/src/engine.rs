//! A sheet on the GPU: its buffers, and the passes of a step in their order.

use origami_core::Model;
use origami_core::ids::NodeId;
use origami_core::model::Material;
use origami_core::twins::safe_time_step;

use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::{Binding, Kernel, triangle_forces, workgroup_dynamics, workgroup_relax};
use crate::layout::{Before, Control, CreaseState, Node};
use crate::outside::Outside;
use crate::pipeline::{Buffers, Pass, buffer};
use crate::plan::{CHECK_INTERVAL, Plan};
use crate::purpose::{Dispatch, Purpose, WORKGROUP_NODES};
use crate::sheet_arrays::SheetArrays;
use crate::variant::{Scheme, Variant};

/// Loop iterations that one dispatch may take: software adapters end every loop at 65 535, silently.
const MOST_ITERATIONS: usize = 50_000;

/// The buffers and passes of a sheet, for up to `instances` instances.
#[derive(Debug)]
pub(crate) struct Engine {
    pub(crate) gpu: Gpu,
    pub(crate) variant: Variant,
    pub(crate) buffers: Buffers,
    pub(crate) instances: usize,
    /// The nodes that may be loaded, in order, and the slot of each for its load.
    pub(crate) load_slots: Vec<(NodeId, u32)>,
    /// Steps between two runs of `row_sums`.
    renewal: u64,
    fold_angles: Vec<Pass>,
    /// The forces of the springs alone: those of a relaxation, and what the stopping rule of dynamics takes.
    spring_forces: Vec<Pass>,
    damped_forces: Vec<Pass>,
    settling: Vec<Pass>,
    row_sums: Vec<Pass>,
    /// From forces to new positions; of an engine without a plan, all passes of a step.
    integration: Vec<Pass>,
    checkpoint: Vec<Pass>,
    workgroup: Option<Pass>,
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
        let mut variant = Variant::new(arrays, purpose.scheme, material);
        let workgroup = workgroup_variant(arrays, &variant, purpose);
        if let Some(workgroup) = &workgroup {
            variant.steps = workgroup.steps;
        }
        check_counts(&variant)?;
        gpu.scoped(|| {
            let buffers = buffers(gpu, arrays, &variant, instances)?;
            let engine = Self::with_buffers(gpu, variant, workgroup.as_ref(), buffers, instances, purpose.safe);
            Ok(Self { load_slots: arrays.load_slots.clone(), ..engine })
        })?
    }

    /// The buffers of one sheet, without any pass.
    #[cfg(test)]
    pub(crate) fn bare(gpu: &Gpu, model: &Model, scheme: Scheme) -> Result<Self, GpuError> {
        let arrays = SheetArrays::new(model);
        let variant = Variant::new(&arrays, scheme, Some(model.material));
        let buffers = gpu.scoped(|| buffers(gpu, &arrays, &variant, 1))??;
        Ok(Self::plain(gpu, variant, buffers, Vec::new()))
    }

    /// One sheet of which a step is `passes` one after the other: no stopping rule, nothing to be renewed.
    pub(crate) fn plain(gpu: &Gpu, variant: Variant, buffers: Buffers, passes: Vec<Pass>) -> Self {
        let none = Vec::new;
        Self {
            gpu: gpu.clone(),
            renewal: CHECK_INTERVAL,
            fold_angles: none(),
            spring_forces: none(),
            damped_forces: none(),
            settling: none(),
            row_sums: none(),
            integration: passes,
            checkpoint: none(),
            workgroup: None,
            variant,
            buffers,
            instances: 1,
            load_slots: Vec::new(),
        }
    }

    fn with_buffers(
        gpu: &Gpu,
        variant: Variant,
        workgroup: Option<&Variant>,
        buffers: Buffers,
        instances: usize,
        safe: bool,
    ) -> Self {
        let pass =
            |kernel, variant: &Variant, advances_clock| Pass::new(gpu, kernel, variant, advances_clock, &buffers);
        let plan = Plan::new(&variant, safe);
        let passes = |kernels: &[&'static Kernel]| kernels.iter().map(|k| pass(k, &variant, false)).collect();
        let undamped = variant.undamped();
        let mut fold_angles: Vec<Pass> = plan.forces.iter().map(|k| pass(k, &undamped, false)).collect();
        let spring_forces = fold_angles.split_off(1);
        let dynamics = !variant.relaxing();
        // A workgroup that takes many steps does without the passes of single steps.
        let wide = workgroup.is_none();
        let damped_forces = match dynamics && wide {
            // The pass over the triangles advances the clock.
            true => {
                plan.forces[1..].iter().map(|k| pass(k, &variant, k.name == triangle_forces::KERNEL.name)).collect()
            }
            false => Vec::new(),
        };
        let settling = passes(plan.settling);
        let row_sums = if dynamics || wide { passes(plan.row_sums) } else { Vec::new() };
        let integration = if wide { passes(plan.integration) } else { Vec::new() };
        let checkpoint = passes(plan.checkpoint);
        let kernel = if dynamics { &workgroup_dynamics::KERNEL } else { &workgroup_relax::KERNEL };
        let workgroup = workgroup.map(|variant| pass(kernel, variant, false));
        Self {
            gpu: gpu.clone(),
            renewal: plan.renewal,
            fold_angles,
            spring_forces,
            damped_forces,
            settling,
            row_sums,
            integration,
            checkpoint,
            workgroup,
            variant,
            buffers,
            instances,
            load_slots: Vec::new(),
        }
    }

    /// Whether dynamics renews its time step, which no sheet does at its first step.
    pub(crate) fn renews_time_step(&self) -> bool {
        !self.variant.relaxing() && !self.row_sums.is_empty()
    }

    /// So many steps as whole dispatches that are no fewer.
    pub(crate) fn whole_dispatches(&self, steps: u64) -> u64 {
        if self.workgroup.is_some() { steps.next_multiple_of(CHECK_INTERVAL) } else { steps }
    }

    /// What may act on its sheets from outside.
    pub(crate) fn outside(&self) -> Outside {
        Outside { holds: self.variant.fixed, loaded: self.load_slots.iter().map(|(node, _)| *node).collect() }
    }

    /// Records the steps `from..to`, counted since the start; where a workgroup takes many steps `from` is a multiple of
    /// [`CHECK_INTERVAL`].
    pub(crate) fn record(&self, pass: &mut wgpu::ComputePass<'_>, instances: u32, from: u64, to: u64) {
        let mut record = |passes: &[Pass]| passes.iter().for_each(|p| p.record(pass, instances));
        let dynamics = !self.variant.relaxing();
        // Dynamics begins with a time step, a relaxation without masses.
        let has_renewals = !self.row_sums.is_empty();
        let renews = |step: u64| has_renewals && step.is_multiple_of(self.renewal) && (step > 0 || !dynamics);
        if let Some(workgroup) = &self.workgroup {
            for step in (from..to.next_multiple_of(CHECK_INTERVAL)).step_by(self.variant.steps as usize) {
                let is_check = step.is_multiple_of(CHECK_INTERVAL);
                if is_check || renews(step) {
                    record(&self.fold_angles);
                    record(&self.spring_forces);
                }
                if is_check {
                    record(&self.settling);
                }
                if renews(step) {
                    record(&self.row_sums);
                }
                record(std::slice::from_ref(workgroup));
            }
        } else {
            for step in from..to {
                let is_check = step.is_multiple_of(CHECK_INTERVAL);
                record(&self.fold_angles);
                if is_check || !dynamics {
                    record(&self.spring_forces);
                }
                if is_check {
                    record(&self.settling);
                }
                if renews(step) {
                    record(&self.row_sums);
                }
                record(&self.damped_forces);
                record(&self.integration);
            }
        }
    }

    /// Records a copy of the state, where it is good.
    pub(crate) fn record_checkpoint(&self, pass: &mut wgpu::ComputePass<'_>, instances: u32) {
        self.checkpoint.iter().for_each(|p| p.record(pass, instances));
    }
}

/// The material that all models share.
pub(crate) fn uniform(models: &[&Model]) -> Option<Material> {
    let material = models[0].material;
    models.iter().all(|m| m.material == material).then_some(material)
}

/// Whether one workgroup would take many steps of a sheet.
pub(crate) fn is_by_workgroup(arrays: &SheetArrays, variant: &Variant, purpose: Purpose) -> bool {
    workgroup_variant(arrays, variant, purpose).is_some()
}

/// The variant of the one-workgroup kernel, where it is wanted and can be had.
fn workgroup_variant(arrays: &SheetArrays, variant: &Variant, purpose: Purpose) -> Option<Variant> {
    let wanted = match purpose.dispatch {
        Dispatch::Passes => false,
        Dispatch::Workgroup => true,
        Dispatch::Auto => arrays.nodes <= WORKGROUP_NODES,
    };
    // Eight buffers are all that every adapter has, and these sheets need more.
    if !wanted || variant.rigidities || variant.loose_beams > 0 {
        return None;
    }
    let most = arrays.nodes.max(arrays.hinges.len()).max(arrays.faces.len());
    #[expect(clippy::cast_possible_truncation, reason = "at most 256")]
    let workgroup = most.next_power_of_two().clamp(32, 256) as u32;
    let most = (MOST_ITERATIONS / iterations(arrays, workgroup as usize)) as u64;
    // Whole dispatches fill the interval after which the stopping rule is checked, and that of the safe step's renewal.
    let renewal = if purpose.safe { safe_time_step::RENEWAL } else { CHECK_INTERVAL };
    let whole = |steps: &u64| CHECK_INTERVAL.is_multiple_of(*steps) && renewal.is_multiple_of(*steps);
    let steps = (1..=CHECK_INTERVAL.min(most)).rev().find(whole)?;
    #[expect(clippy::cast_possible_truncation, reason = "at most a checks")]
    let steps = steps as u32;
    Some(Variant { workgroup, steps, ..variant.clone() })
}

/// Loop iterations of one invocation in one step, at most: every loop of the kernel counted as written.
fn iterations(arrays: &SheetArrays, workgroup: usize) -> usize {
    let rounds = |count: usize| count.div_ceil(workgroup);
    let of_a_face = 1 + 3 + 3 + 3 + 3 + 3 + 3;
    let of_a_node = 1 + arrays.most_slots() + 1;
    1 + rounds(arrays.hinges.len()) + rounds(arrays.faces.len()) * of_a_face + rounds(arrays.nodes) * of_a_node + 8
}

/// Dispatches count workgroups in 16 bits.
pub(crate) fn check_counts(variant: &Variant) -> Result<(), GpuError> {
    let most = variant.creases.max(variant.faces).max(variant.nodes);
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
pub(crate) fn sizes(arrays: &SheetArrays, variant: &Variant) -> Vec<(Binding, u64, u64)> {
    let size = |count: usize, of: usize| (count * of) as u64;
    let nodes = arrays.nodes;
    let mut sizes = vec![
        (Binding::Control, size(1, size_of::<Control>()), 0),
        (Binding::Nodes, size(nodes, size_of::<Node>()), 0),
        (Binding::CreaseStates, size(arrays.hinges.len(), size_of::<CreaseState>()), 0),
        (Binding::Hinges, 0, bytemuck::cast_slice::<_, u8>(&arrays.hinges).len() as u64),
        (Binding::Faces, 0, bytemuck::cast_slice::<_, u8>(&arrays.faces).len() as u64),
        (Binding::Slots, size(arrays.slot_count(), 16), 0),
        (Binding::Rows, 0, size(nodes + 1, 4)),
        (Binding::Partials, size(variant.groups(nodes), 16), 0),
        (Binding::Windows, size(nodes, size_of::<Before>()), 0),
        (Binding::CheckpointNodes, size(nodes, size_of::<Node>()), 0),
        (Binding::CheckpointAngles, size(arrays.hinges.len(), 4), 0),
    ];
    if variant.corners {
        sizes.push((Binding::Corners, 0, size(arrays.corners.len(), 16)));
    }
    if variant.rigidities {
        sizes.push((Binding::Rigidities, 0, size(arrays.rigidities.len(), 4)));
    }
    if variant.loose_beams > 0 {
        sizes.push((Binding::LooseBeams, 0, bytemuck::cast_slice::<_, u8>(&arrays.loose_beams).len() as u64));
    }
    sizes
}

fn buffers(gpu: &Gpu, arrays: &SheetArrays, variant: &Variant, instances: usize) -> Result<Buffers, GpuError> {
    let mut buffers = Buffers::new();
    for (binding, each, once) in sizes(arrays, variant) {
        let contents: &[u8] = match binding {
            Binding::Hinges => bytemuck::cast_slice(&arrays.hinges),
            Binding::Faces => bytemuck::cast_slice(&arrays.faces),
            Binding::Rows => bytemuck::cast_slice(&arrays.rows),
            Binding::Corners => bytemuck::cast_slice(&arrays.corners),
            Binding::Rigidities => bytemuck::cast_slice(&arrays.rigidities),
            Binding::LooseBeams => bytemuck::cast_slice(&arrays.loose_beams),
            _ => &[],
        };
        buffers.insert(binding, buffer(gpu, binding, each * instances as u64 + once, contents)?);
    }
    Ok(buffers)
}

/// How many instances of a sheet fit into the adapter's buffers.
pub(crate) fn most_instances(gpu: &Gpu, arrays: &SheetArrays, scheme: Scheme) -> usize {
    // Buffers are as large with one material as with many.
    let variant = Variant::new(arrays, scheme, None);
    let allowed = gpu.largest_buffer();
    let fits = sizes(arrays, &variant).into_iter().filter(|(_, each, _)| *each > 0);
    let most = fits.map(|(_, each, once)| allowed.saturating_sub(once) / each).min().unwrap_or(1);
    usize::try_from(most.clamp(1, 65_535)).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use origami_core::Material;
    use origami_core::generate::Miura;

    use super::*;
    use crate::testing::bench::EULER;
    use crate::testing::cases::miura;
    use crate::testing::{gpu, sheets};

    const BY_WORKGROUP: Purpose = Purpose { scheme: EULER, safe: true, dispatch: Dispatch::Workgroup };

    fn arrays_and_variant(model: &Model) -> (SheetArrays, Variant) {
        let arrays = SheetArrays::new(model);
        let variant = Variant::new(&arrays, EULER, Some(model.material));
        (arrays, variant)
    }

    #[test]
    fn loops_in_a_workgroup_stay_below_the_cap_and_fill_whole_intervals() {
        let (mut arrays, variant) = arrays_and_variant(&miura());
        let mut steps = Vec::new();
        for faces in [1, 100, 10_000, 40_000, 100_000, 400_000, 4_000_000] {
            arrays.faces.resize(faces, arrays.faces[0]);
            let renewing = workgroup_variant(&arrays, &variant, BY_WORKGROUP).map(|built| u64::from(built.steps));
            assert!(renewing.is_none_or(|steps| safe_time_step::RENEWAL.is_multiple_of(steps)), "{renewing:?}");
            let constant = Purpose { safe: false, ..BY_WORKGROUP };
            let Some(built) = workgroup_variant(&arrays, &variant, constant) else {
                assert!(iterations(&arrays, 256) > MOST_ITERATIONS, "{faces} faces: one step would fit");
                continue;
            };
            let made = built.steps as usize * iterations(&arrays, built.workgroup as usize);
            assert!(made <= MOST_ITERATIONS, "{faces} faces: {made} iterations");
            assert!(CHECK_INTERVAL.is_multiple_of(u64::from(built.steps)), "{faces} faces: {} steps", built.steps);
            steps.push(built.steps);
        }
        assert_eq!((steps.first(), steps.is_sorted_by(|a, b| a >= b)), (Some(&20), true), "{steps:?}");
        assert!(steps.iter().any(|s| (1..20).contains(s)), "some are between: {steps:?}");
        assert!(steps.len() < 7, "too many faces even for one step");
    }

    #[test]
    fn a_workgroup_takes_a_sheet_where_its_buffers_suffice_and_it_is_small() {
        let is_taken = |model: &Model, dispatch| {
            let (arrays, variant) = arrays_and_variant(model);
            is_by_workgroup(&arrays, &variant, Purpose { dispatch, ..BY_WORKGROUP })
        };
        let small = miura();
        assert!(is_taken(&small, Dispatch::Auto) && is_taken(&small, Dispatch::Workgroup));
        assert!(!is_taken(&small, Dispatch::Passes));
        assert!(!is_taken(&sheets::loose_beams(), Dispatch::Workgroup), "it would need a ninth buffer");
        let large = Miura { columns: 20, rows: 20, ..Miura::default() }.pattern().expect("a pattern");
        let large = Model::new(&large, &Material::default()).expect("a model");
        assert!(large.node_count() > WORKGROUP_NODES);
        assert!(!is_taken(&large, Dispatch::Auto) && is_taken(&large, Dispatch::Workgroup));
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
        let refused = buffers(&gpu, &arrays, &variant, 1).expect_err("too large");
        let needed = (arrays.nodes * size_of::<Node>()) as u64;
        assert_eq!(refused, GpuError::TooLarge { what: "the nodes", needed, allowed });
    }

    #[test]
    fn as_many_instances_as_fit_and_no_more() {
        let Some(gpu) = gpu() else { return };
        let allowed = gpu.largest_buffer();
        for model in [miura(), sheets::loose_beams()] {
            let (arrays, variant) = arrays_and_variant(&model);
            let most = most_instances(&gpu, &arrays, EULER) as u64;
            let largest = |count: u64| sizes(&arrays, &variant).iter().map(|s| s.1 * count + s.2).max();
            assert!(largest(most) <= Some(allowed));
            assert!(most == 65_535 || largest(most + 1) > Some(allowed));
            assert!(most >= 1);
        }
    }
}
