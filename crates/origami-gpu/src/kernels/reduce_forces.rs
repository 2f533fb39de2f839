//! Third pass of a relaxation: forces on the nodes, and the sums that FIRE needs.

use origami_shaders as wgsl;

use super::parts::{fire, gather};
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `reduce_forces.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "reduce_forces",
    entry: "reduce_forces",
    text: wgsl::REDUCE_FORCES,
    shared: SHARED,
    parts: |variant| [gather(variant), fire(variant), vec![wgsl::REDUCE, wgsl::PARTIALS]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows, Binding::Partials],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use glam::DVec4;
    use origami_core::solve::row_sums;

    use super::super::{fold_angles, row_sums as row_sums_kernel, triangle_forces};
    use super::*;
    use crate::layout::vector;
    use crate::testing::bench::{Bench, held};
    use crate::testing::cases::{Case, ROUNDING, cases, tampered, worst};
    use crate::testing::{gpu, magnitudes, sheets};
    use crate::variant::Scheme;

    /// Masses, in roundings of all that is summed: as for the row sums themselves.
    const MASS: f64 = 8.0;
    /// Sums over all nodes, in roundings of their magnitude: added up in a tree, of which the errors hardly grow.
    const SUMS: f64 = 8.0;

    fn mass_error(case: &Case, bench: &Bench) -> f64 {
        let mut wanted = vec![0.0; case.model.node_count()];
        row_sums::row_sums(&case.model, &case.state.positions, &mut wanted);
        let scales = magnitudes::of_row_sums(case).into_iter().map(|size| ROUNDING * size);
        worst(bench.nodes().iter().zip(wanted).zip(scales).map(|((n, want), s)| ((f64::from(n.mass) - want).abs(), s)))
    }

    /// What the nodes, as they were read, come to: power, speed and pull, and the magnitude of each.
    fn sums(bench: &Bench) -> [DVec4; 2] {
        let mut sums = [DVec4::ZERO; 2];
        for node in bench.nodes() {
            let (force, velocity, mass) = (vector(node.force), vector(node.velocity), f64::from(node.mass));
            let own =
                DVec4::new(force.dot(velocity), mass * velocity.length_squared(), force.length_squared() / mass, 0.0);
            sums[0] += own;
            sums[1] += DVec4::new(force.length() * velocity.length(), own.y, own.z, 0.0);
        }
        sums
    }

    fn sums_error(bench: &Bench) -> f64 {
        let partials: Vec<[f32; 4]> = bench.read(Binding::Partials, bench.groups());
        let got: DVec4 = partials.iter().map(|p| DVec4::from_array(p.map(f64::from))).sum();
        let [want, size] = sums(bench);
        let errors = (got - want).abs().to_array();
        worst(errors.into_iter().zip(size.to_array()).take(3).map(|(error, size)| (error, ROUNDING * size)))
    }

    #[test]
    fn masses_and_sums_are_those_of_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases().into_iter().chain(sheets::special()) {
            let case = held(&case);
            let bench = Bench::new(&gpu, &case, Scheme::Relax);
            bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &triangle_forces::KERNEL]), false);
            bench.run(&[&row_sums_kernel::KERNEL, &KERNEL], false);
            let (masses, sums) = (mass_error(&case, &bench), sums_error(&bench));
            println!("reduce_forces, {}: masses {masses:.2}, sums {sums:.2}", case.name);
            assert!(masses < MASS && sums < SUMS, "{}: {masses} and {sums} roundings", case.name);
            if !case.model.creases.is_empty() {
                assert!(mass_error(&tampered(&case), &bench) > MASS, "{}: a moved node is seen", case.name);
            }
            // Forces as they were gathered; none on fixed nodes.
            let fixed = |i: usize| case.model.fixed.iter().any(|n| n.index() == i);
            let gathered = bench.gathered();
            let sizes = magnitudes::of_forces(&case, false);
            for (i, node) in bench.nodes().iter().enumerate() {
                let want = if fixed(i) { glam::DVec3::ZERO } else { gathered[i].truncate() };
                assert!(vector(node.force).distance(want) <= 8.0 * ROUNDING * sizes[i], "{}: node {i}", case.name);
            }
            bench.change_nodes(|i, node| node.velocity[0] += if i == 1 { 0.5 } else { 0.0 });
            assert!(sums_error(&bench) > SUMS, "{}: a velocity is seen", case.name);
        }
    }

    #[test]
    fn masses_are_renewed_now_and_then_only() {
        let Some(gpu) = gpu() else { return };
        let bench = Bench::new(&gpu, &held(&cases()[3]), Scheme::Relax);
        let renewal = origami_core::twins::fire_update::RENEWAL as u32;
        for (step, renewed) in [(1, false), (renewal - 1, false), (renewal, true), (3 * renewal, true)] {
            bench.change_nodes(|_, node| node.mass = 1.0);
            bench.change_control(|c| c.step = step);
            bench.run(&[&fold_angles::KERNEL, &triangle_forces::KERNEL, &row_sums_kernel::KERNEL, &KERNEL], false);
            assert_eq!(bench.nodes()[0].mass != 1.0, renewed, "step {step}");
        }
    }
}
