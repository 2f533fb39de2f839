//! The safe time step.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `safe_time_step.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "safe_time_step",
    entry: "safe_time_step",
    text: wgsl::SAFE_TIME_STEP,
    shared: SHARED,
    parts: |_| vec![wgsl::TIME_STEP],
    uses: &[Binding::Control],
    springs: false,
    per: Per::Instance,
};

#[cfg(test)]
mod tests {
    use origami_core::glam::DVec3;
    use origami_core::solve::{Integrator, time_step};

    use super::super::{fold_angles, row_sums, stiffness_max, triangle_forces};
    use super::*;
    use crate::testing::bench::{Bench, EULER, VERLET, held};
    use crate::testing::cases::{Case, cases};
    use crate::testing::{gpu, sheets};

    /// As a share of the step. It is the root of a sum of some twenty numbers in single precision; of thin triangles, whose
    /// heights come rounded, it is off by 1.4e-7.
    const TOLERANCE: f64 = 1e-6;

    fn off(case: &Case, next: f32, integrator: Integrator) -> f64 {
        let want = time_step::safe(&case.model, &case.state.positions, integrator);
        (f64::from(next) / want - 1.0).abs()
    }

    #[test]
    fn the_safe_step_is_that_of_the_processor() {
        let Some(gpu) = gpu() else { return };
        for (i, case) in cases().into_iter().chain(sheets::special()).enumerate() {
            let case = held(&case);
            let (scheme, integrator) =
                if i % 2 == 0 { (EULER, Integrator::Euler) } else { (VERLET, Integrator::Verlet) };
            let bench = Bench::new(&gpu, &case, scheme);
            bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &triangle_forces::KERNEL]), false);
            bench.run(&[&row_sums::KERNEL, &stiffness_max::KERNEL, &KERNEL], false);
            let control = bench.control();
            let found = off(&case, control.next_step, integrator);
            println!("safe_time_step, {}: {found:.1e}", case.name);
            assert!(found < TOLERANCE, "{}: {found}", case.name);
            let mut stiffer = case.clone();
            stiffer.model.beams.iter_mut().for_each(|b| b.stiffness *= 1.01);
            stiffer.model.creases.iter_mut().for_each(|c| c.stiffness *= 1.01);
            assert!(off(&stiffer, control.next_step, integrator) > TOLERANCE, "{}: it is seen", case.name);
            assert_eq!((control.stiffness_max, control.speed_squared_max), (0, 0), "ready for the next time");
        }
    }

    #[test]
    fn it_shrinks_for_swift_nodes_and_grows_slowly() {
        let Some(gpu) = gpu() else { return };
        let mut case = held(&cases()[0]);
        for velocity in [0.01, 50.0, 3e4] {
            case.state.velocities.iter_mut().for_each(|v| *v = DVec3::Y * velocity);
            for (step, before) in [(0, 1e-9), (20, 1e-9), (20, 1.0)] {
                let bench = Bench::new(&gpu, &case, EULER);
                bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &triangle_forces::KERNEL]), false);
                bench.change_control(|c| (c.step, c.next_step) = (step, before));
                bench.run(&[&row_sums::KERNEL, &stiffness_max::KERNEL, &KERNEL], false);
                let safe = time_step::safe(&case.model, &case.state.positions, Integrator::Euler);
                let want = time_step::renewed(safe, &case.state.velocities, (step > 0).then_some(f64::from(before)));
                let found = f64::from(bench.control().next_step);
                assert!((found / want - 1.0).abs() < TOLERANCE, "{velocity}, {step}, {before}: {found}, not {want}");
            }
        }
    }
}
