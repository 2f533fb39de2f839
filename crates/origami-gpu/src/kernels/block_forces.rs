//! The springs' forces and the row sums of their stiffness, by blocks.

use origami_shaders as wgsl;

use super::parts::{in_blocks, soft_creases};
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `block_forces.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "block_forces",
    entry: "block_forces",
    text: wgsl::BLOCK_FORCES,
    shared: SHARED,
    parts: |variant| {
        [in_blocks(variant), vec![wgsl::RAMP, soft_creases(variant), wgsl::ROW_SUMS, wgsl::BLOCK_ROW_SUMS]].concat()
    },
    uses: &[Binding::Control, Binding::Nodes, Binding::Blocks, Binding::Angles, Binding::Targets, Binding::Slots],
    springs: true,
    per: Per::Block,
};

#[cfg(test)]
mod tests {
    use glam::DVec4;
    use origami_core::forces::Forces;
    use origami_core::model::Softening;
    use origami_core::solve::row_sums;

    use super::*;
    use crate::Gpu;
    use crate::purpose::Dispatch;
    use crate::testing::bench::{Bench, held};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, softened, tampered, worst};
    use crate::testing::sheets::creased;
    use crate::testing::{gpu, magnitudes, sheets};
    use crate::variant::Scheme;

    /// In roundings of all that is summed at a node, as for the passes; rest angles come from the sides with two more.
    const FORCES: f64 = 5.0;
    const ROW_SUMS: f64 = 8.0;

    fn sums(gpu: &Gpu, case: &Case) -> Vec<DVec4> {
        summed(&Bench::by(gpu, case, Scheme::Relax, Dispatch::Blocks))
    }

    fn summed(bench: &Bench) -> Vec<DVec4> {
        bench.run(&[&KERNEL], false);
        let slots: Vec<[f32; 4]> = bench.read(Binding::Slots, bench.arrays.nodes);
        slots.iter().map(|slot| DVec4::from_array(slot.map(f64::from))).collect()
    }

    /// The largest errors of forces and of row sums, in roundings.
    fn errors(case: &Case, got: &[DVec4]) -> [f64; 2] {
        let (model, state) = (&case.model, &case.state);
        let (mut angles, mut forces) = (state.fold_angles.clone(), Forces::new(model));
        let wanted = forces.evaluate(&state.positions, &state.targets, &mut angles);
        let scales = magnitudes::of_forces(case, false).into_iter().map(|size| ROUNDING * size);
        let force =
            worst(got.iter().zip(wanted).zip(scales).map(|((got, want), s)| (got.truncate().distance(*want), s)));
        let mut wanted = vec![0.0; model.node_count()];
        row_sums::row_sums(model, &state.positions, &mut wanted);
        let scales = magnitudes::of_row_sums(case).into_iter().map(|size| ROUNDING * size);
        [force, worst(got.iter().zip(&wanted).zip(scales).map(|((got, want), scale)| ((got.w - want).abs(), scale)))]
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases().into_iter().chain(sheets::special()) {
            let case = held(&case);
            let got = sums(&gpu, &case);
            let [force, row] = errors(&case, &got);
            println!("block_forces, {}: forces {force:.2}, row sums {row:.2}", case.name);
            assert!(force < FORCES && row < ROW_SUMS, "{}: {force} and {row} roundings", case.name);
            let wrong = |change: &dyn Fn(&mut Case)| {
                let mut wrong = case.clone();
                change(&mut wrong);
                errors(&wrong, &got)
            };
            let stiffer = wrong(&|c| c.model.beams.iter_mut().for_each(|b| b.stiffness *= 1.001));
            assert!(stiffer[1] > ROW_SUMS, "{}: stiffness is seen", case.name);
            let moved = errors(&tampered(&case), &got);
            assert!(moved[0] > FORCES, "{}: a moved node is seen", case.name);
            if case.model.k_area() > 0.0 {
                let areas = wrong(&|c| c.model.material.collapse *= 1.001);
                assert!(areas[0] > FORCES && areas[1] > ROW_SUMS, "{}: areas are seen", case.name);
            }
            if !case.model.corner_angles.is_empty() {
                let turned = wrong(&|c| c.model.material.k_face *= 1.01);
                assert!(turned[0] > FORCES && turned[1] > ROW_SUMS, "{}: corner angles are seen", case.name);
            }
        }
    }

    #[test]
    fn a_soft_sheet_has_those_of_a_softer_one() {
        let Some(gpu) = gpu() else { return };
        let softening = Softening::default();
        for case in creased() {
            let case = held(&case);
            let bench = Bench::by(&gpu, &case, Scheme::Relax, Dispatch::Blocks);
            bench.soften(&case.model, softening);
            let got = summed(&bench);
            let [force, row] = errors(&softened(&case, softening), &got);
            println!("block_forces of a soft sheet, {}: forces {force:.2}, row sums {row:.2}", case.name);
            assert!(force < FORCES && row < ROW_SUMS, "{}: {force} and {row} roundings", case.name);
            let [force, row] = errors(&case, &got);
            assert!(force > FORCES && row > ROW_SUMS, "{}: as stiff as it is, it is another", case.name);
        }
    }

    #[test]
    fn collapsed_triangles_have_finite_forces() {
        let Some(gpu) = gpu() else { return };
        assert!(sums(&gpu, &held(&collapsed())).iter().all(|sum| sum.is_finite()));
    }
}
