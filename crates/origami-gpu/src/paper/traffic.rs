//! What the five passes read and write.

use origami_core::Model;

use super::lists::Lists;
use super::passes::PASSES;
use super::sheet;
use crate::traffic::{BufferSize, Traffic, moved};

impl Traffic {
    /// Of the paper's five passes.
    #[must_use]
    pub fn of_paper(model: &Model) -> Self {
        // The length of a step does not matter.
        let lists = Lists::new(model, 0.0);
        let buffers = lists.buffers().map(|(binding, bytes, _)| (binding, bytes));
        let variant = sheet::variant(model);
        Self {
            nodes: model.node_count(),
            buffers: buffers.map(|(binding, bytes)| BufferSize { what: binding.what(), bytes }).into(),
            passes: PASSES.map(|kernel| moved(kernel, &variant, &buffers, 1.0)).into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::cases;

    #[test]
    fn a_sheet_is_counted_by_hand() {
        let model = cases::miura();
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
