//! Fourth pass under contact: forces on the nodes, their masses, and the sums that FIRE needs.

use origami_shaders as wgsl;

use super::parts::{fire, gather};
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `contact_reduce.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "contact_reduce",
    entry: "contact_reduce",
    text: wgsl::CONTACT_REDUCE,
    shared: SHARED,
    parts: |variant| {
        let pushes = [wgsl::PAIR_ROWS, wgsl::PUSHES, wgsl::MOVES, wgsl::REDUCE, wgsl::PARTIALS];
        [gather(variant), fire(variant), pushes.to_vec()].concat()
    },
    uses: &[
        Binding::Control,
        Binding::Nodes,
        Binding::Slots,
        Binding::Rows,
        Binding::Partials,
        Binding::PairRows,
        Binding::Pushes,
        Binding::Moves,
    ],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use origami_core::contact::Contact;
    use origami_core::contact::PlainContact;
    use origami_core::forces::Forces;
    use origami_core::solve::row_sums;

    use super::super::{fold_angles, pair_forces, row_sums as row_sums_kernel, triangle_forces};
    use super::*;
    use crate::layout::vector;
    use crate::testing::gpu;
    use crate::testing::layers::{Layers, crumpled, model};

    /// Of the largest force and mass.
    const TOLERANCE: f64 = 1e-5;

    #[test]
    fn forces_and_masses_are_those_of_springs_and_layers() {
        let Some(gpu) = gpu() else { return };
        let model = model("bird-base");
        let positions = crumpled(&model, 0.1, 3);
        let contact = Contact { gap: 0.5, ..Contact::default() };
        let layers = Layers::new(&gpu, &model, &positions, contact);
        let springs = [&fold_angles::KERNEL, &triangle_forces::KERNEL, &row_sums_kernel::KERNEL];
        layers.run(&layers.passes(&[&springs[..], &[&pair_forces::KERNEL, &KERNEL]].concat()));
        let (of_layers, sums) = PlainContact::new(&model.mesh, (&model.rest, &positions), contact).forces(&positions);
        let mut angles = vec![0.0; model.creases.len()];
        let mut forces = Forces::new(&model);
        let of_springs = forces.evaluate(&positions, &vec![0.0; angles.len()], &mut angles);
        let mut masses = vec![0.0; positions.len()];
        row_sums::row_sums(&model, &positions, &mut masses);
        let (largest, heaviest) =
            (of_layers.iter().map(|f| f.length()).fold(0.0, f64::max), sums.iter().copied().fold(0.0, f64::max));
        assert!(largest > 0.0);
        let error = |with: f64| {
            let node = |(i, node): (usize, &crate::layout::Node)| {
                let force = of_springs[i] + with * of_layers[i];
                let of_force = vector(node.force).distance(force) / largest.max(force.length());
                let of_mass = (f64::from(node.mass) - masses[i] - with * sums[i]).abs() / heaviest;
                of_force.max(of_mass)
            };
            layers.nodes().iter().enumerate().map(node).fold(0.0, f64::max)
        };
        println!("contact_reduce: {:.1e}", error(1.0));
        assert!(error(1.0) < TOLERANCE, "{}", error(1.0));
        assert!(error(0.0) > TOLERANCE, "without the layers is seen");
        assert!(of_layers.iter().any(|f| *f != DVec3::ZERO));
    }
}
