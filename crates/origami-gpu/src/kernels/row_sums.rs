//! Row sums of the stiffness: the masses of a relaxation, and what bounds a time step.

use origami_shaders as wgsl;

use super::parts::{soft_creases, springs};
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `row_sums.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "row_sums",
    entry: "row_sums",
    text: wgsl::ROW_SUMS,
    shared: SHARED,
    parts: |variant| [springs(variant), vec![soft_creases(variant)]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Hinges, Binding::Faces, Binding::Slots],
    springs: true,
    per: Per::Face,
};

#[cfg(test)]
mod tests {
    use origami_core::model::Softening;
    use origami_core::solve::row_sums;

    use super::super::{fold_angles, triangle_forces};
    use super::*;
    use crate::Gpu;
    use crate::testing::bench::{Bench, EULER, held};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, softened, tampered, worst};
    use crate::testing::sheets::creased;
    use crate::testing::{gpu, magnitudes, sheets};
    use crate::variant::Scheme;

    /// In roundings of all that is summed at a node: products of two gradients, each some ten operations.
    const TOLERANCE: f64 = 8.0;

    fn sums(gpu: &Gpu, case: &Case) -> Vec<f64> {
        let bench = Bench::new(gpu, case, EULER);
        bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &triangle_forces::KERNEL]), false);
        bench.run(&[&KERNEL], false);
        bench.gathered().into_iter().map(|sum| sum.w).collect()
    }

    fn error(case: &Case, got: &[f64]) -> f64 {
        let mut wanted = vec![0.0; case.model.node_count()];
        row_sums::row_sums(&case.model, &case.state.positions, &mut wanted);
        let scales = magnitudes::of_row_sums(case).into_iter().map(|size| ROUNDING * size);
        worst(got.iter().zip(&wanted).zip(scales).map(|((got, want), scale)| ((got - want).abs(), scale)))
    }

    #[test]
    fn a_soft_sheet_has_those_of_a_softer_one() {
        let Some(gpu) = gpu() else { return };
        let softening = Softening::default();
        for case in creased() {
            let case = held(&case);
            let bench = Bench::new(&gpu, &case, Scheme::Relax);
            bench.soften(&case.model, softening);
            bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &triangle_forces::KERNEL]), false);
            bench.run(&[&KERNEL], false);
            let got: Vec<f64> = bench.gathered().into_iter().map(|sum| sum.w).collect();
            let error = error(&softened(&case, softening), &got);
            println!("row sums of a soft sheet, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert!(self::error(&case, &got) > TOLERANCE, "{}: as stiff as it is, it is another", case.name);
        }
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases().into_iter().chain(sheets::special()).chain([collapsed()]) {
            let case = held(&case);
            let got = sums(&gpu, &case);
            let error = error(&case, &got);
            println!("row sums, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            let wrong = |change: &dyn Fn(&mut Case)| {
                let mut wrong = case.clone();
                change(&mut wrong);
                self::error(&wrong, &got)
            };
            assert!(wrong(&|c| c.model.beams.iter_mut().for_each(|b| b.stiffness *= 1.001)) > TOLERANCE);
            if case.model.k_area() > 0.0 {
                assert!(wrong(&|c| c.model.material.collapse *= 1.001) > TOLERANCE, "{}: areas are seen", case.name);
            }
            if case.model.creases.is_empty() {
                continue;
            }
            assert!(self::error(&tampered(&case), &got) > TOLERANCE, "{}: a moved node is seen", case.name);
            assert!(wrong(&|c| c.model.creases.iter_mut().for_each(|s| s.stiffness *= 1.001)) > TOLERANCE);
            if !case.model.corner_angles.is_empty() {
                assert!(wrong(&|c| c.model.material.k_face *= 1.01) > TOLERANCE, "{}", case.name);
            }
        }
    }
}
