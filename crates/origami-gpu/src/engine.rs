//! A scene on the GPU: its buffers, and the passes of a step in their order.

use origami_core::Model;
use origami_core::model::Material;
use origami_core::solve::dynamics;

use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::{Binding, Kernel, faces, workgroup_dynamics, workgroup_relax};
use crate::layout::{Before, Control, CreaseState, Node};
use crate::pipeline::{Buffers, Pass};
use crate::plan::{Plan, TICK};
use crate::scene::Scene;
use crate::variant::{Motion, Variant};

/// How the passes of a step reach the GPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dispatch {
    /// As the size of the scene suggests.
    Auto,
    /// Each pass over all elements, one dispatch after the other.
    Passes,
    /// One workgroup for each sheet, which takes many steps in one dispatch.
    Workgroup,
}

/// Nodes up to which [`Dispatch::Auto`] gives a workgroup the whole sheet.
///
/// Measured on a software adapter only (llvmpipe, LLVM 15, two cores, over which it spreads passes but not one workgroup):
/// one workgroup wins at 49 nodes and loses at 64, in both solvers (`cargo bench --features gpu --bench gpu_step --
/// crossover`). Hardware may differ either way.
pub const WORKGROUP_NODES: usize = 50;

/// Loop iterations that one dispatch may take: software adapters end every loop at 65 535, silently.
const MOST_ITERATIONS: usize = 50_000;

/// A scene's buffers and passes, for up to so many instances.
#[derive(Debug)]
pub(crate) struct Engine {
    pub(crate) gpu: Gpu,
    pub(crate) variant: Variant,
    pub(crate) buffers: Buffers,
    pub(crate) instances: usize,
    /// Steps between two runs of `row_sums`.
    renewal: u64,
    forces: Vec<Pass>,
    damped_forces: Vec<Pass>,
    settling: Vec<Pass>,
    row_sums: Vec<Pass>,
    motion: Vec<Pass>,
    keeping: Vec<Pass>,
    workgroup: Option<Pass>,
}

/// What an engine is built for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Purpose {
    pub(crate) motion: Motion,
    /// Whether dynamics renews its time step.
    pub(crate) safe: bool,
    pub(crate) dispatch: Dispatch,
}

impl Engine {
    /// For `instances` sheets of `models`, which differ in nothing but their material.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] where a buffer is larger than the adapter allows, or what the device says.
    pub(crate) fn new(gpu: &Gpu, models: &[&Model], purpose: Purpose, instances: usize) -> Result<Self, GpuError> {
        Self::of_scene(gpu, &Scene::new(models), uniform(models), purpose, instances)
    }

    /// The same for a scene, and the material of all its instances, or `None` where they differ.
    ///
    /// # Errors
    /// As [`Engine::new`].
    pub(crate) fn of_scene(
        gpu: &Gpu,
        scene: &Scene,
        material: Option<Material>,
        purpose: Purpose,
        instances: usize,
    ) -> Result<Self, GpuError> {
        let mut variant = Variant::new(scene, purpose.motion, material);
        let workgroup = workgroup_variant(scene, &variant, purpose);
        if let Some(workgroup) = &workgroup {
            variant.steps = workgroup.steps;
        }
        check_counts(&variant)?;
        gpu.scoped(|| {
            let buffers = buffers(gpu, scene, &variant, instances)?;
            Ok(Self::with_buffers(gpu, variant, workgroup.as_ref(), buffers, instances, purpose.safe))
        })?
    }

    /// The buffers of one sheet, without any pass.
    #[cfg(test)]
    pub(crate) fn bare(gpu: &Gpu, models: &[&Model], motion: Motion) -> Result<Self, GpuError> {
        let scene = Scene::new(models);
        let variant = Variant::new(&scene, motion, uniform(models));
        let buffers = gpu.scoped(|| buffers(gpu, &scene, &variant, 1))??;
        let none = Vec::new;
        Ok(Self {
            gpu: gpu.clone(),
            renewal: TICK,
            forces: none(),
            damped_forces: none(),
            settling: none(),
            row_sums: none(),
            motion: none(),
            keeping: none(),
            workgroup: None,
            variant,
            buffers,
            instances: 1,
        })
    }

    fn with_buffers(
        gpu: &Gpu,
        variant: Variant,
        workgroup: Option<&Variant>,
        buffers: Buffers,
        instances: usize,
        safe: bool,
    ) -> Self {
        let pass = |kernel, variant: &Variant, ticks| Pass::new(gpu, kernel, variant, ticks, &buffers);
        let plan = Plan::new(&variant, safe);
        let passes = |kernels: &[&'static Kernel]| kernels.iter().map(|k| pass(k, &variant, false)).collect();
        let undamped = variant.undamped();
        let forces = plan.forces.iter().map(|k| pass(k, &undamped, false)).collect();
        let dynamics = !variant.relaxing();
        // A workgroup that takes many steps does without the passes of single steps.
        let wide = workgroup.is_none();
        let damped_forces = match dynamics && wide {
            // The faces keep the time.
            true => plan.forces[1..].iter().map(|k| pass(k, &variant, k.name == faces::KERNEL.name)).collect(),
            false => Vec::new(),
        };
        let settling = passes(plan.settling);
        let row_sums = if dynamics || wide { passes(plan.row_sums) } else { Vec::new() };
        let motion = if wide { passes(plan.motion) } else { Vec::new() };
        let keeping = passes(plan.keeping);
        let kernel = if dynamics { &workgroup_dynamics::KERNEL } else { &workgroup_relax::KERNEL };
        let workgroup = workgroup.map(|variant| pass(kernel, variant, false));
        Self {
            gpu: gpu.clone(),
            renewal: plan.renewal,
            forces,
            damped_forces,
            settling,
            row_sums,
            motion,
            keeping,
            workgroup,
            variant,
            buffers,
            instances,
        }
    }

    /// Records the steps `from..to`, counted since the start; `from` is a multiple of [`TICK`].
    pub(crate) fn record(&self, pass: &mut wgpu::ComputePass<'_>, instances: u32, from: u64, to: u64) {
        let mut record = |passes: &[Pass]| passes.iter().for_each(|p| p.record(pass, instances));
        let dynamics = !self.variant.relaxing();
        // Dynamics begins with a time step, a relaxation without masses.
        let has_renewals = !self.row_sums.is_empty();
        let renews = |step: u64| has_renewals && step.is_multiple_of(self.renewal) && (step > 0 || !dynamics);
        if let Some(workgroup) = &self.workgroup {
            for step in (from..to.next_multiple_of(TICK)).step_by(self.variant.steps as usize) {
                let looks = step.is_multiple_of(TICK);
                if looks || renews(step) {
                    record(&self.forces);
                }
                if looks {
                    record(&self.settling);
                }
                if renews(step) {
                    record(&self.row_sums);
                }
                record(std::slice::from_ref(workgroup));
            }
        } else {
            for step in from..to {
                let looks = step.is_multiple_of(TICK);
                if dynamics {
                    // The springs alone are what the stopping rule looks at.
                    record(if looks { &self.forces } else { &self.forces[..1] });
                } else {
                    record(&self.forces);
                }
                if looks {
                    record(&self.settling);
                }
                if renews(step) {
                    record(&self.row_sums);
                }
                record(&self.damped_forces);
                record(&self.motion);
            }
        }
        record(&self.keeping);
    }
}

/// The material that all models share.
pub(crate) fn uniform(models: &[&Model]) -> Option<Material> {
    let material = models[0].material;
    models.iter().all(|m| m.material == material).then_some(material)
}

/// Whether one workgroup would take many steps of a sheet.
pub(crate) fn is_by_workgroup(scene: &Scene, variant: &Variant, purpose: Purpose) -> bool {
    workgroup_variant(scene, variant, purpose).is_some()
}

/// The variant of the one-workgroup kernel, where it is wanted and can be had.
fn workgroup_variant(scene: &Scene, variant: &Variant, purpose: Purpose) -> Option<Variant> {
    let wanted = match purpose.dispatch {
        Dispatch::Passes => false,
        Dispatch::Workgroup => true,
        Dispatch::Auto => scene.nodes <= WORKGROUP_NODES,
    };
    // Eight buffers are all that every adapter has, and these scenes need more.
    if !wanted || variant.rigidities || variant.loose_beams > 0 {
        return None;
    }
    let most = scene.nodes.max(scene.hinges.len()).max(scene.faces.len());
    #[expect(clippy::cast_possible_truncation, reason = "at most 256")]
    let workgroup = most.next_power_of_two().clamp(32, 256) as u32;
    let most = (MOST_ITERATIONS / iterations(scene, workgroup as usize)) as u64;
    // Whole dispatches make a tick, at whose end the stopping rule is due, and a renewal of the safe step.
    let renewal = if purpose.safe { dynamics::RENEWAL } else { TICK };
    let whole = |steps: &u64| TICK.is_multiple_of(*steps) && renewal.is_multiple_of(*steps);
    let steps = (1..=TICK.min(most)).rev().find(whole)?;
    #[expect(clippy::cast_possible_truncation, reason = "at most a tick")]
    let steps = steps as u32;
    Some(Variant { workgroup, steps, ..variant.clone() })
}

/// Loop iterations of one invocation in one step, at most: every loop of the kernel counted as written.
fn iterations(scene: &Scene, workgroup: usize) -> usize {
    let rounds = |count: usize| count.div_ceil(workgroup);
    let of_a_face = 1 + 3 + 3 + 3 + 3 + 3 + 3;
    let of_a_node = 1 + scene.most_slots() + 1;
    1 + rounds(scene.hinges.len()) + rounds(scene.faces.len()) * of_a_face + rounds(scene.nodes) * of_a_node + 8
}

/// Dispatches count workgroups in 16 bits.
fn check_counts(variant: &Variant) -> Result<(), GpuError> {
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

/// Bytes that each buffer takes for one instance, and once for all: what a scene needs.
pub(crate) fn sizes(scene: &Scene, variant: &Variant) -> Vec<(Binding, u64, u64)> {
    let size = |count: usize, of: usize| (count * of) as u64;
    let nodes = scene.nodes;
    let mut sizes = vec![
        (Binding::Control, size(1, size_of::<Control>()), 0),
        (Binding::Nodes, size(nodes, size_of::<Node>()), 0),
        (Binding::CreaseStates, size(scene.hinges.len(), size_of::<CreaseState>()), 0),
        (Binding::Hinges, 0, bytemuck::cast_slice::<_, u8>(&scene.hinges).len() as u64),
        (Binding::Faces, 0, bytemuck::cast_slice::<_, u8>(&scene.faces).len() as u64),
        (Binding::Slots, size(scene.slot_count(), 16), 0),
        (Binding::Rows, 0, size(nodes + 1, 4)),
        (Binding::Partials, size(variant.groups(nodes), 16), 0),
        (Binding::Windows, size(nodes, size_of::<Before>()), 0),
        (Binding::KeptNodes, size(nodes, size_of::<Node>()), 0),
        (Binding::KeptAngles, size(scene.hinges.len(), 4), 0),
    ];
    if variant.corners {
        sizes.push((Binding::Corners, 0, size(scene.corners.len(), 16)));
    }
    if variant.rigidities {
        sizes.push((Binding::Rigidities, 0, size(scene.rigidities.len(), 4)));
    }
    if variant.loose_beams > 0 {
        sizes.push((Binding::LooseBeams, 0, bytemuck::cast_slice::<_, u8>(&scene.loose_beams).len() as u64));
    }
    sizes
}

fn buffers(gpu: &Gpu, scene: &Scene, variant: &Variant, instances: usize) -> Result<Buffers, GpuError> {
    let mut buffers = Buffers::new();
    for (binding, each, once) in sizes(scene, variant) {
        // An empty binding is not allowed.
        let needed = (each * instances as u64 + once).max(64);
        gpu.fits(binding.what(), needed)?;
        let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some(binding.what()),
            size: needed,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        let contents: &[u8] = match binding {
            Binding::Hinges => bytemuck::cast_slice(&scene.hinges),
            Binding::Faces => bytemuck::cast_slice(&scene.faces),
            Binding::Rows => bytemuck::cast_slice(&scene.rows),
            Binding::Corners => bytemuck::cast_slice(&scene.corners),
            Binding::Rigidities => bytemuck::cast_slice(&scene.rigidities),
            Binding::LooseBeams => bytemuck::cast_slice(&scene.loose_beams),
            _ => &[],
        };
        if !contents.is_empty() {
            gpu.queue().write_buffer(&buffer, 0, contents);
        }
        buffers.insert(binding, buffer);
    }
    Ok(buffers)
}

/// How many instances of a scene fit into the adapter's buffers.
pub(crate) fn most_instances(gpu: &Gpu, scene: &Scene, motion: Motion) -> usize {
    // Buffers are as large with one material as with many.
    let variant = Variant::new(scene, motion, None);
    let allowed = gpu.largest_buffer();
    let fits = sizes(scene, &variant).into_iter().filter(|(_, each, _)| *each > 0);
    let most = fits.map(|(_, each, once)| allowed.saturating_sub(once) / each).min().unwrap_or(1);
    usize::try_from(most.clamp(1, 65_535)).unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use origami_core::Material;
    use origami_core::generate::Miura;

    use super::*;
    use crate::paper::testing::miura;
    use crate::testing::bench::EULER;
    use crate::testing::{gpu, sheets};

    const BY_WORKGROUP: Purpose = Purpose { motion: EULER, safe: true, dispatch: Dispatch::Workgroup };

    fn scene_and_variant(model: &Model) -> (Scene, Variant) {
        let scene = Scene::new(&[model]);
        let variant = Variant::new(&scene, EULER, Some(model.material));
        (scene, variant)
    }

    #[test]
    fn loops_in_a_workgroup_stay_below_the_cap_and_make_whole_ticks() {
        let (mut scene, variant) = scene_and_variant(&miura());
        let mut steps = Vec::new();
        for faces in [1, 100, 10_000, 40_000, 100_000, 400_000, 4_000_000] {
            scene.faces.resize(faces, scene.faces[0]);
            let renewing = workgroup_variant(&scene, &variant, BY_WORKGROUP).map(|built| u64::from(built.steps));
            assert!(renewing.is_none_or(|steps| dynamics::RENEWAL.is_multiple_of(steps)), "{renewing:?}");
            let kept = Purpose { safe: false, ..BY_WORKGROUP };
            let Some(built) = workgroup_variant(&scene, &variant, kept) else {
                assert!(iterations(&scene, 256) > MOST_ITERATIONS, "{faces} faces: one step would fit");
                continue;
            };
            let made = built.steps as usize * iterations(&scene, built.workgroup as usize);
            assert!(made <= MOST_ITERATIONS, "{faces} faces: {made} iterations");
            assert!(TICK.is_multiple_of(u64::from(built.steps)), "{faces} faces: {} steps", built.steps);
            steps.push(built.steps);
        }
        assert_eq!((steps.first(), steps.is_sorted_by(|a, b| a >= b)), (Some(&20), true), "{steps:?}");
        assert!(steps.iter().any(|s| (1..20).contains(s)), "some are between: {steps:?}");
        assert!(steps.len() < 7, "too many faces even for one step");
    }

    #[test]
    fn a_workgroup_takes_a_sheet_where_its_buffers_suffice_and_it_is_small() {
        let is_taken = |model: &Model, dispatch| {
            let (scene, variant) = scene_and_variant(model);
            is_by_workgroup(&scene, &variant, Purpose { dispatch, ..BY_WORKGROUP })
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
        let (_, mut variant) = scene_and_variant(&miura());
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
        let (mut scene, variant) = scene_and_variant(&model);
        let allowed = gpu.largest_buffer();
        // As if it had so many nodes: only what is allowed is ever made.
        scene.nodes = usize::try_from(allowed).expect("64 bits") / size_of::<Node>() + 1;
        let refused = buffers(&gpu, &scene, &variant, 1).expect_err("too large");
        let needed = (scene.nodes * size_of::<Node>()) as u64;
        assert_eq!(refused, GpuError::TooLarge { what: "the nodes", needed, allowed });
    }

    #[test]
    fn as_many_instances_as_fit_and_no_more() {
        let Some(gpu) = gpu() else { return };
        let allowed = gpu.largest_buffer();
        for model in [miura(), sheets::loose_beams()] {
            let (scene, variant) = scene_and_variant(&model);
            let most = most_instances(&gpu, &scene, EULER) as u64;
            let largest = |count: u64| sizes(&scene, &variant).iter().map(|s| s.1 * count + s.2).max();
            assert!(largest(most) <= Some(allowed));
            assert!(most == 65_535 || largest(most + 1) > Some(allowed));
            assert!(most >= 1);
        }
    }
}
