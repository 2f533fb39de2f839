//! What a step reads and writes, and how much memory a sheet takes, counted from the buffers: no GPU is asked.

use origami_core::Model;
use origami_core::solve::{Dynamics, Relax};

use origami_core::twins::fire_update;

use crate::blocks::{Extent, MEMORY};
use crate::device::Abilities;
use crate::engine::sizes;
use crate::kernels::{Binding, Kernel, Per, workgroup_dynamics, workgroup_relax};
use crate::layout::Node;
use crate::method::Method;
use crate::plan::{CHECK_INTERVAL, Plan, batch};
use crate::purpose::{Dispatch, Purpose};
use crate::route::{Route, small_variant};
use crate::sheet_arrays::SheetArrays;
use crate::variant::Variant;

/// What one step of a single sheet moves between memory and processors, and what the sheet's buffers take.
///
/// Each pass counts every buffer that it reads or writes once, whole: what neighbours share is read once, and nothing
/// stays in a cache from one pass to the next. Only nodes count by halves of 32 bytes, position apart from velocity and
/// force. The control block is not counted.
///
/// [`of_relax`](Self::of_relax) and [`of_dynamics`](Self::of_dynamics) are for [`Dispatch::Passes`]. In [`Dispatch::Blocks`] what
/// several blocks read counts for each of them. A workgroup that has the whole sheet reads and writes it once in a dispatch.
#[derive(Clone, Debug, PartialEq)]
pub struct Traffic {
    /// Nodes of the sheet.
    pub nodes: usize,
    /// In the order of their bindings.
    pub buffers: Vec<BufferSize>,
    /// In the order in which they run.
    pub passes: Vec<PassTraffic>,
}

/// A buffer and its length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BufferSize {
    /// What it holds.
    pub what: &'static str,
    /// Its length for one instance.
    pub bytes: u64,
}

/// What one pass moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PassTraffic {
    /// The shader's file, without its extension.
    pub name: &'static str,
    /// Runs in a step; less than 1 where it runs now and then.
    pub per_step: f64,
    /// Bytes that a run reads.
    pub read: u64,
    /// Bytes that a run writes.
    pub written: u64,
}

impl Traffic {
    /// Of a relaxation by passes.
    #[must_use]
    pub fn of_relax(model: &Model) -> Self {
        Self::of(model, relax(model, Dispatch::Passes), PLAIN)
    }

    /// Of dynamics by passes.
    #[must_use]
    pub fn of_dynamics(model: &Model, method: &Dynamics) -> Self {
        Self::of(model, dynamics(model, method, Dispatch::Passes), PLAIN)
    }

    /// Of a relaxation by blocks; by passes where there can be no blocks.
    #[must_use]
    pub fn of_relax_in_blocks(model: &Model) -> Self {
        Self::of(model, relax(model, Dispatch::Blocks), PLAIN)
    }

    /// Of dynamics by blocks; by passes where there can be no blocks.
    #[must_use]
    pub fn of_dynamics_in_blocks(model: &Model, method: &Dynamics) -> Self {
        Self::of(model, dynamics(model, method, Dispatch::Blocks), PLAIN)
    }

    /// On an adapter with these abilities.
    pub(crate) fn of(model: &Model, purpose: Purpose, abilities: Abilities) -> Self {
        let safe = purpose.safe;
        let arrays = SheetArrays::new(model);
        let plain = purpose.variant(&arrays, Some(model.material));
        let route = Route::new(&arrays, purpose, abilities);
        let variant = route.variant(&plain);
        let buffers = sizes(&arrays, &variant, &route).into_iter();
        let mut buffers: Vec<_> = buffers.map(|(binding, each, once)| (binding, each + once)).collect();
        buffers.sort_by_key(|(binding, _)| *binding);
        let plan = Plan::new(&variant, safe);
        let checks = 1.0 / CHECK_INTERVAL as f64;
        let renewals = if plan.renewal == 0 { 0.0 } else { 1.0 / plan.renewal as f64 };
        let moved = |kernels: &[&Kernel], variant: &Variant, per_step| -> Vec<PassTraffic> {
            kernels.iter().map(|k| moved(k, variant, &buffers, per_step)).collect()
        };
        if let Some(blocks) = route.blocks().filter(|_| route.dispatch() == Dispatch::Workgroup) {
            let small = small_variant(&arrays, blocks, &variant, safe, batch(arrays.nodes));
            let kernel = if variant.relaxing() { &workgroup_relax::KERNEL } else { &workgroup_dynamics::KERNEL };
            let passes = moved(&[kernel], &small, 1.0 / f64::from(small.small.steps));
            return Self { nodes: arrays.nodes, passes, buffers: named(&buffers) };
        }
        let in_blocks = variant.blocks.is_some();
        let forces = match (in_blocks, variant.relaxing()) {
            // For checks and renewals, of which some are both.
            (true, _) => vec![moved(&plan.forces, &variant.undamped(), seldom(plan.renewal))],
            (false, true) => vec![moved(plan.angles, &variant, 1.0), moved(&plan.forces, &variant, 1.0)],
            (false, false) => vec![
                moved(plan.angles, &variant, 1.0),
                moved(&plan.forces, &variant.undamped(), checks),
                moved(&plan.forces, &variant, 1.0),
            ],
        };
        let others = [
            moved(plan.settling, &variant, checks),
            moved(plan.row_sums, &variant, renewals),
            moved(plan.integration, &variant, 1.0),
            moved(plan.checkpoint, &variant, 1.0 / batch(arrays.nodes) as f64),
        ];
        Self {
            nodes: arrays.nodes,
            passes: forces.into_iter().chain(others).flatten().collect(),
            buffers: named(&buffers),
        }
    }

    /// Bytes that one step moves, what runs now and then with its share.
    #[must_use]
    pub fn bytes_per_step(&self) -> f64 {
        self.passes.iter().map(|pass| pass.per_step * (pass.read + pass.written) as f64).sum()
    }

    /// The same for each node.
    #[must_use]
    pub fn bytes_per_node_and_step(&self) -> f64 {
        self.bytes_per_step() / self.nodes as f64
    }

    /// Bytes that all buffers take.
    #[must_use]
    pub fn memory(&self) -> u64 {
        self.buffers.iter().map(|buffer| buffer.bytes).sum()
    }

    /// The most nodes times steps in a second that a memory of `bandwidth` bytes a second allows.
    #[must_use]
    pub fn most_node_steps_per_second(&self, bandwidth: f64) -> f64 {
        bandwidth / self.bytes_per_node_and_step()
    }
}

/// What every adapter has.
const PLAIN: Abilities = Abilities { hardware: false, workgroup_storage: MEMORY };

fn relax(model: &Model, dispatch: Dispatch) -> Purpose {
    Method::Relax(&Relax::default()).purpose(dispatch, [model].into_iter())
}

fn dynamics(model: &Model, method: &Dynamics, dispatch: Dispatch) -> Purpose {
    Method::Dynamics(method).purpose(dispatch, [model].into_iter())
}

/// The share of the steps that have a check or a renewal.
fn seldom(renewal: u64) -> f64 {
    let is_seldom = |step: &u64| step.is_multiple_of(CHECK_INTERVAL) || renewal > 0 && step.is_multiple_of(renewal);
    let all = CHECK_INTERVAL * renewal.max(1);
    (0..all).filter(is_seldom).count() as f64 / all as f64
}

/// What a run of `kernel` moves, of buffers with these lengths in bytes.
pub(crate) fn moved(kernel: &Kernel, variant: &Variant, buffers: &[(Binding, u64)], per_step: f64) -> PassTraffic {
    let (mut read, mut written) = (0, 0);
    for binding in kernel.bindings(variant) {
        if let Some(blocks) = variant.blocks.filter(|_| kernel.per == Per::Block) {
            let (own_read, own_written) = of_blocks(kernel, binding, variant, blocks, size(buffers, binding));
            read += own_read;
            written += own_written;
            continue;
        }
        let bytes = match binding {
            // In blocks dynamics has room for them twice.
            Binding::Nodes => (variant.nodes * size_of::<Node>()) as u64,
            _ => size(buffers, binding),
        };
        let part = part(kernel, binding, variant);
        let share = |halves: u64| bytes * halves / 2;
        read += share(part.read).min(part.most);
        written += share(part.written).min(part.most);
    }
    PassTraffic { name: kernel.name, per_step, read, written }
}

fn named(buffers: &[(Binding, u64)]) -> Vec<BufferSize> {
    buffers.iter().map(|(binding, bytes)| BufferSize { what: binding.what(), bytes: *bytes }).collect()
}

fn size(buffers: &[(Binding, u64)], binding: Binding) -> u64 {
    buffers.iter().find(|(other, _)| *other == binding).map_or(0, |(_, bytes)| *bytes)
}

/// Bytes that a kernel reads and writes where each workgroup works on a block: what several of them read counts for each.
fn of_blocks(kernel: &Kernel, binding: Binding, variant: &Variant, blocks: Extent, bytes: u64) -> (u64, u64) {
    let half = |count: usize| (count * size_of::<Node>() / 2) as u64;
    let (own, positions) = (half(variant.nodes), half(blocks.positions));
    match (binding, kernel.name) {
        (Binding::Control, _) => (0, 0),
        (Binding::Nodes, "block_dynamics") => {
            (positions + if variant.damped() { half(blocks.velocities) } else { own }, 2 * own)
        }
        // Velocities of its own; the forces.
        (Binding::Nodes, "block_relax") => (positions + own, own),
        (Binding::Nodes, _) => (positions, 0),
        (Binding::Angles, _) => (bytes, bytes),
        // Masses, where they are renewed.
        (Binding::Slots, "block_relax") => (bytes / fire_update::RENEWAL, 0),
        (Binding::Slots | Binding::Partials, _) => (0, bytes),
        _ => (bytes, 0),
    }
}

/// How much of a buffer a kernel touches, in halves; and at most so many bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Part {
    read: u64,
    written: u64,
    most: u64,
}

const fn halves(read: u64, written: u64) -> Part {
    Part { read, written, most: u64::MAX }
}

fn part(kernel: &Kernel, binding: Binding, variant: &Variant) -> Part {
    let beams = 2 * variant.loose_beams as u64;
    match (binding, kernel.name) {
        // Few bytes for the whole sheet.
        (Binding::Control | Binding::Settings, _) => halves(0, 0),
        (Binding::Nodes | Binding::Angles, "workgroup_dynamics" | "workgroup_relax") => halves(2, 2),
        // The position; dampers read velocities too.
        (Binding::Nodes, "triangle_forces") if !variant.damped() => halves(1, 0),
        (Binding::Nodes, "fold_angles" | "row_sums") => halves(1, 0),
        (Binding::Nodes, "loose_beams") => Part { most: beams * 64, ..halves(2, 0) },
        // The velocity, and whether it is fixed.
        (Binding::Nodes, "stiffness_max") => halves(1 + u64::from(variant.fixed), 0),
        // The force.
        (Binding::Nodes, "reduce_forces") => halves(2, 1),
        (Binding::Nodes, "integrate" | "fire_move") => halves(2, 2),
        (Binding::CreaseStates, "fold_angles") => halves(2, 2),
        (Binding::Slots, "triangle_forces" | "row_sums") => Part { most: variant.faces as u64 * 48, ..halves(0, 2) },
        (Binding::Slots, "loose_beams") => Part { most: beams * 16, ..halves(0, 2) },
        (Binding::Partials, "reduce_forces" | "settle_windows")
        | (Binding::CheckpointNodes | Binding::CheckpointAngles, _) => halves(0, 2),
        (Binding::Windows, _) => halves(2, 2),
        // The paper's passes: the angle before and the displacement before are read, the rest is written only.
        (Binding::FaceNormals, "normals")
        | (Binding::Springs, "coefficients")
        | (Binding::NextVelocities, "forces") => halves(0, 2),
        (Binding::Springs, "fold_angles") | (Binding::Motions, "positions") => halves(2, 2),
        _ => halves(2, 0),
    }
}

#[cfg(test)]
mod tests {
    use origami_core::generate::miura;
    use origami_core::solve::TimeStep;
    use origami_core::{CreasePattern, Material};

    use super::*;
    use crate::paper::PASSES;
    use crate::shader_checks::{accesses, checked};
    use crate::testing::variants;
    use crate::variant::Scheme;

    fn model(pattern: &CreasePattern, material: &Material) -> Model {
        Model::new(pattern, material).expect("a generated pattern")
    }

    fn sheet() -> Model {
        model(&miura(7, 5).expect("valid"), &Material::default())
    }

    /// Whatever a pass may have: loose beams, beams of their own rigidity, fixed nodes.
    fn with_everything(scheme: Scheme) -> Variant {
        let variant = Variant::new(&SheetArrays::new(&sheet()), scheme, Some(Material::default()));
        Variant { loose_beams: 3, rigidities: true, fixed: true, ..variant }
    }

    #[test]
    fn passes_read_and_write_what_their_shaders_do() {
        let schemes = [Scheme::Relax, Scheme::Dynamics { verlet: true, damped: true }];
        let plain = schemes.map(with_everything);
        let in_blocks =
            plain.clone().map(|variant| Variant { blocks: Some(variants::extent()), loads: true, ..variant });
        for variant in plain.into_iter().chain(in_blocks) {
            let plan = Plan::new(&variant, true);
            let paper: &[&Kernel] = if variant.blocks.is_some() { &[] } else { &PASSES };
            let lists =
                [plan.angles, &plan.forces, plan.settling, plan.row_sums, plan.integration, plan.checkpoint, paper];
            for kernel in lists.concat() {
                let shader = checked(kernel.name, &kernel.source(&variant));
                for (binding, expected) in accesses(&shader, kernel.entry) {
                    let bindings = kernel.bindings(&variant);
                    let binding = *bindings.iter().find(|b| **b as u32 == binding).expect("a binding of Rust");
                    let part = part(kernel, binding, &variant);
                    let counted = match variant.blocks.filter(|_| kernel.per == Per::Block) {
                        Some(blocks) => {
                            let (read, written) = of_blocks(kernel, binding, &variant, blocks, 1_000);
                            (read > 0, written > 0)
                        }
                        None => (part.read > 0, part.written > 0),
                    };
                    assert!(
                        counted == expected || [Binding::Control, Binding::Settings].contains(&binding),
                        "{} of {}",
                        binding.what(),
                        kernel.name
                    );
                }
            }
        }
    }

    #[test]
    fn a_sheet_is_counted_by_hand() {
        let model = sheet();
        let (n, t, c) = (model.node_count() as u64, model.mesh.triangles.len() as u64, model.creases.len() as u64);
        let traffic = Traffic::of_dynamics(&model, &Dynamics::default());
        let find =
            |name, often: f64| *traffic.passes.iter().find(|p| p.name == name && p.per_step == often).expect(name);
        let (angles, forces, integrate) =
            (find("fold_angles", 1.0), find("triangle_forces", 1.0), find("integrate", 1.0));
        assert_eq!((angles.read, angles.written), (32 * n + (16 + 24) * c, 16 * c));
        assert_eq!((forces.read, forces.written), (64 * n + 16 * c + (60 + 16) * t, 48 * t));
        assert_eq!((integrate.read, integrate.written), (64 * n + 48 * t + 4 * (n + 1), 64 * n));
        assert_eq!(find("triangle_forces", 0.05).read, forces.read - 32 * n, "without damping no velocities");
        let memory =
            164 + 64 * n + 16 * c + 24 * c + 60 * t + 48 * t + 4 * (n + 1) + 16 * t + 16 + 48 * n + 64 * n + 4 * c;
        assert_eq!(traffic.memory(), memory);
        let two = PassTraffic { name: "two", per_step: 0.5, read: 60, written: 20 };
        let simple = Traffic { nodes: 4, buffers: Vec::new(), passes: vec![two, two] };
        assert_eq!((simple.bytes_per_step(), simple.bytes_per_node_and_step()), (80.0, 20.0));
        assert_eq!(simple.most_node_steps_per_second(100.0), 5.0);
    }

    /// What issue 14 asks of blocks, beside what passes move.
    #[test]
    fn blocks_move_few_bytes() {
        for side in [10, 31, 99] {
            let model = model(&miura(side, side).expect("valid"), &Material::default());
            let dynamics = |time_step| Dynamics { time_step, ..Dynamics::default() };
            let of = |traffic: Traffic| traffic.bytes_per_node_and_step();
            let relax = [Traffic::of_relax(&model), Traffic::of_relax_in_blocks(&model)].map(of);
            let paper = dynamics(TimeStep::Paper);
            let paper = [Traffic::of_dynamics(&model, &paper), Traffic::of_dynamics_in_blocks(&model, &paper)].map(of);
            let safe = of(Traffic::of_dynamics_in_blocks(&model, &dynamics(TimeStep::Safe)));
            println!(
                "{} nodes: relax {relax:.0?}, dynamics {paper:.0?}, with the safe step {safe:.0}",
                model.node_count()
            );
            assert!(paper[1] <= 400.0 && safe <= 400.0 && relax[1] <= 450.0, "{} nodes", model.node_count());
        }
    }

    #[test]
    fn what_a_sheet_does_without_is_not_moved() {
        let pattern = miura(7, 5).expect("valid");
        let of = |material: &Material| Traffic::of_relax(&model(&pattern, material)).bytes_per_step();
        let all = of(&Material::default());
        assert!(of(&Material { k_face: 0.0, ..Material::default() }) < all, "corner angles");
        assert!(of(&Material { k_facet: 0.0, ..Material::default() }) < all, "creases");
        let damped = |zeta| {
            let model = model(&pattern, &Material { zeta, ..Material::default() });
            Traffic::of_dynamics(&model, &Dynamics::default()).bytes_per_step()
        };
        assert!(damped(0.0) < damped(0.45), "velocities");
    }

    #[test]
    fn a_million_nodes_fit_into_the_default_bindings() {
        let model = model(&miura(999, 999).expect("valid"), &Material::default());
        let dynamics = Dynamics::default();
        // Dynamics keeps the nodes twice, a relaxation does not.
        let blocks = Traffic::of_dynamics_in_blocks(&model, &dynamics);
        for traffic in [Traffic::of_relax(&model), Traffic::of_dynamics(&model, &dynamics), blocks] {
            let largest = traffic.buffers.iter().max_by_key(|buffer| buffer.bytes).expect("some");
            assert!(largest.bytes <= wgpu::Limits::default().max_storage_buffer_binding_size, "{largest:?}");
        }
    }
}
