//! What the five passes read and write.

use origami_core::Model;

use super::kernel::Kernel;
use super::layout::Slot;
use super::lists::Lists;
use super::passes::PASSES;
use crate::traffic::{BufferSize, PassTraffic, Traffic};

impl Traffic {
    /// Of the paper's five passes.
    #[must_use]
    pub fn of_paper(model: &Model) -> Self {
        // The length of a step does not matter.
        let lists = Lists::new(model, 0.0);
        let size = |slot| lists.size(slot) as u64;
        let moved = |kernel: &&Kernel| {
            let sum = |which: fn(&Kernel, Slot) -> bool| {
                kernel.slots.iter().filter(|s| which(kernel, **s)).map(|s| size(*s)).sum()
            };
            PassTraffic { name: kernel.name, per_step: 1.0, read: sum(reads), written: sum(writes) }
        };
        Self {
            nodes: model.node_count(),
            buffers: Slot::ALL.map(|slot| BufferSize { what: slot.what(), bytes: size(slot) }).into(),
            passes: PASSES.iter().map(moved).collect(),
        }
    }
}

/// The status and the settings, few bytes for the whole sheet, are not counted.
fn counts(slot: Slot) -> bool {
    !matches!(slot, Slot::Settings | Slot::Status)
}

fn writes(kernel: &Kernel, slot: Slot) -> bool {
    let written = match kernel.name {
        "normals" => Slot::FaceNormals,
        "fold_angles" | "coefficients" => Slot::Springs,
        "forces" => Slot::NextVelocities,
        _ => Slot::Motions,
    };
    counts(slot) && slot == written
}

fn reads(kernel: &Kernel, slot: Slot) -> bool {
    // The angle before, and the displacement before, are read; what else is written is written only.
    let both = [("fold_angles", Slot::Springs), ("positions", Slot::Motions)];
    counts(slot) && (!writes(kernel, slot) || both.contains(&(kernel.name, slot)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper::testing;
    use crate::shader_checks::{accesses, checked};

    #[test]
    fn passes_read_and_write_what_their_shaders_do() {
        for kernel in PASSES {
            let there = accesses(&checked(kernel.name, &kernel.text()), kernel.name);
            for slot in kernel.slots.iter().filter(|slot| counts(**slot)) {
                let expected = there[&(*slot as u32)];
                assert_eq!((reads(kernel, *slot), writes(kernel, *slot)), expected, "{}: {slot:?}", kernel.name);
            }
        }
    }

    #[test]
    fn a_sheet_is_counted_by_hand() {
        let model = testing::miura();
        let (n, t, c) = (model.node_count() as u64, model.mesh.triangles.len() as u64, model.creases.len() as u64);
        let traffic = Traffic::of_paper(&model);
        let normals = &traffic.passes[0];
        assert_eq!((normals.read, normals.written), (80 * t + 32 * n, 16 * t));
        let positions = &traffic.passes[4];
        assert_eq!((positions.read, positions.written), (48 * n + 32 * n + 16 * n, 32 * n));
        let roles = 16 * (4 * c + 3 * model.corner_angles.len() as u64);
        let beam_ends = 32 * 2 * model.beams.len() as u64;
        let forces = &traffic.passes[3];
        assert_eq!((forces.read, forces.written), ((48 + 32) * n + 96 * t + 32 * c + beam_ends + roles, 16 * n));
        let per_step: u64 = traffic.passes.iter().map(|pass| pass.read + pass.written).sum();
        assert_eq!(traffic.bytes_per_step(), per_step as f64, "every pass once a step");
    }
}
