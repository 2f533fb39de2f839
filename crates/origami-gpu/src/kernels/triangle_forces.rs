//! Second pass: the forces on the corners of every triangle.

use origami_shaders as wgsl;

use super::parts::springs;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `triangle_forces.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "triangle_forces",
    entry: "triangle_forces",
    text: wgsl::TRIANGLE_FORCES,
    shared: SHARED,
    parts: |variant| [springs(variant), vec![wgsl::CLOCK]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::CreaseStates, Binding::Faces, Binding::Slots],
    springs: true,
    per: Per::Face,
};

#[cfg(test)]
mod tests {
    use glam::{DVec3, DVec4};
    use origami_core::forces::{Forces, damping};
    use origami_core::model::Softening;

    use super::super::fold_angles;
    use super::*;
    use crate::Gpu;
    use crate::testing::bench::{Bench, EULER, held};
    use crate::testing::cases::{Case, ROUNDING, cases, collapsed, softened, tampered, worst};
    use crate::testing::sheets::creased;
    use crate::testing::{gpu, magnitudes, sheets};
    use crate::variant::Scheme;

    /// In roundings of all that is summed at a node. Each spring's force is some ten operations; roots and quotients may be
    /// off by 3.
    const TOLERANCE: f64 = 4.0;

    fn sums(gpu: &Gpu, case: &Case, scheme: Scheme) -> Vec<DVec4> {
        let bench = Bench::new(gpu, case, scheme);
        bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &KERNEL]), false);
        bench.gathered()
    }

    fn error(case: &Case, got: &[DVec4], damped: bool) -> f64 {
        let (model, state) = (&case.model, &case.state);
        let mut free = model.clone();
        // What lies in the slots of fixed nodes is dropped by who gathers it.
        free.fixed.clear();
        let mut angles = state.fold_angles.clone();
        let mut forces = Forces::new(&free);
        let springs = forces.evaluate(&state.positions, &state.targets, &mut angles);
        let damping = if damped { damping::forces(&free, &state.velocities) } else { vec![DVec3::ZERO; springs.len()] };
        let wanted = springs.iter().zip(damping).map(|(spring, damping)| *spring + damping);
        let scales = magnitudes::of_forces(case, damped).into_iter().map(|size| ROUNDING * size);
        worst(got.iter().zip(wanted).zip(scales).map(|((got, want), scale)| (got.truncate().distance(want), scale)))
    }

    /// One of everything that the forces depend on, a little wrong.
    fn wrongs(case: &Case) -> Vec<(&'static str, Case)> {
        let wrong = |change: &dyn Fn(&mut Case)| {
            let mut wrong = case.clone();
            change(&mut wrong);
            wrong
        };
        let mut wrongs = vec![
            ("a moved node", tampered(case)),
            ("the stiffness of beams", wrong(&|c| c.model.beams.iter_mut().for_each(|b| b.stiffness *= 1.01))),
            ("a velocity", wrong(&|c| c.state.velocities[1].y += 1e-3)),
        ];
        if case.model.material.zeta > 0.0 {
            wrongs.push(("damping", wrong(&|c| c.model.material.zeta *= 1.01)));
        }
        if !case.model.creases.is_empty() {
            wrongs.push(("targets", wrong(&|c| c.state.targets.iter_mut().for_each(|t| *t += 1e-3))));
            let stiffer = wrong(&|c| c.model.creases.iter_mut().for_each(|s| s.stiffness *= 1.001));
            wrongs.push(("the stiffness of creases", stiffer));
        }
        if !case.model.corner_angles.is_empty() {
            wrongs.push(("corner angles", wrong(&|c| c.model.material.k_face *= 1.01)));
        }
        if case.model.k_area() > 0.0 {
            wrongs.push(("areas", wrong(&|c| c.model.material.collapse *= 1.001)));
        }
        wrongs
    }

    #[test]
    fn agree_with_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases().into_iter().chain(sheets::special()) {
            let case = held(&case);
            let damped = case.model.material.zeta > 0.0;
            let got = sums(&gpu, &case, EULER);
            let error = error(&case, &got, damped);
            println!("triangle_forces, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            for (what, wrong) in wrongs(&case) {
                let seen = self::error(&wrong, &got, damped);
                assert!(seen > TOLERANCE || !damped && what == "a velocity", "{}: {what} is seen", case.name);
            }
            let relaxing = self::error(&case, &sums(&gpu, &case, Scheme::Relax), false);
            assert!(relaxing < TOLERANCE, "{}, no damping in a relaxation: {relaxing} roundings", case.name);
        }
    }

    #[test]
    fn a_soft_sheet_has_the_forces_of_a_softer_one() {
        let Some(gpu) = gpu() else { return };
        let softening = Softening::default();
        for case in creased() {
            let case = held(&case);
            let bench = Bench::new(&gpu, &case, Scheme::Relax);
            bench.soften(&case.model, softening);
            bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &KERNEL]), false);
            let got = bench.gathered();
            let error = error(&softened(&case, softening), &got, false);
            println!("triangle_forces of a soft sheet, {}: {error:.2}", case.name);
            assert!(error < TOLERANCE, "{}: {error} roundings", case.name);
            assert!(self::error(&case, &got, false) > TOLERANCE, "{}: as stiff as it is, it is another", case.name);
            let other = Softening { wrong_side: 1.001 * softening.wrong_side, ..softening };
            let seen = self::error(&softened(&case, other), &got, false) > TOLERANCE;
            assert!(seen || case.state.targets.iter().all(|t| *t == 0.0), "{}: creases are pulled back", case.name);
            // At the end of the ramp it is as stiff as its material.
            bench.change_control(|c| c.ramp_step = c.ramp_length);
            bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &KERNEL]), false);
            assert!(self::error(&case, &bench.gathered(), false) < TOLERANCE, "{}", case.name);
        }
    }

    #[test]
    fn collapsed_triangles_have_finite_forces() {
        let Some(gpu) = gpu() else { return };
        let case = held(&collapsed());
        let got = sums(&gpu, &case, EULER);
        assert!(got.iter().all(|sum| sum.is_finite()));
        let mut open = case.clone();
        open.state.positions[0].y += 1e-3;
        let off = |node: usize, got: &[DVec4]| {
            let mut forces = Forces::new(&case.model);
            let mut angles = case.state.fold_angles.clone();
            let springs = forces.evaluate(&case.state.positions, &case.state.targets, &mut angles);
            let damping = damping::forces(&case.model, &case.state.velocities);
            let want = springs[node] + damping[node];
            got[node].truncate().distance(want) / want.length()
        };
        // Those of the two collapsed hinges.
        assert!((0..8).all(|node| off(node, &got) < 1e-5), "{:?}", (0..8).map(|n| off(n, &got)).collect::<Vec<_>>());
        assert!(off(0, &sums(&gpu, &held(&open), EULER)) > 1e-5, "a moved node is seen");
    }

    #[test]
    fn forces_on_a_triangle_sum_to_nothing() {
        let Some(gpu) = gpu() else { return };
        for case in cases() {
            let got = sums(&gpu, &held(&case), EULER);
            let total: DVec3 = got.iter().map(|sum| sum.truncate()).sum();
            let size: f64 = magnitudes::of_forces(&case, true).iter().sum();
            assert!(total.length() < ROUNDING * size, "{}: {total} of {size}", case.name);
        }
    }

    /// Plain f32 has steps of 6e-8 where these nodes lie: a way of 1e-9 would be zero, or nothing but rounding.
    #[test]
    fn small_differences_of_large_positions_survive_the_compiler() {
        let Some(gpu) = gpu() else { return };
        let far = DVec3::new(0.731_234_567_89, -0.612_345_678_91, 0.0);
        let way = DVec3::new(0.6e-9, -0.5e-9, 0.62e-9);
        let case = held(&sheets::beam(far, far + way));
        let [from, to] = [0, 1].map(|node| case.state.positions[node]);
        let got = sums(&gpu, &case, Scheme::Relax);
        // The beam is squeezed to nearly nothing, and pushes along what is left.
        let push = (got[0].truncate() - got[1].truncate()).normalize();
        assert!(push.dot(to - from) < 0.0);
        let off = (push + (to - from).normalize()).length();
        assert!(off < 1e-3, "{off}");
        let plain = (to.as_vec3() - from.as_vec3()).as_dvec3();
        assert!(plain.length() == 0.0 || (plain.normalize() + push).length() > 0.1, "plain f32 could not");
    }

    #[test]
    fn small_elongations_survive_the_compiler() {
        let Some(gpu) = gpu() else { return };
        let far = DVec3::new(0.731_234_567_89, -0.612_345_678_91, 0.213_243_546_5);
        let direction = DVec3::new(-0.48, 0.6, -0.64);
        for elongation in [1e-7, -1e-7, 3e-8] {
            let rest = sheets::beam_length();
            let case = held(&sheets::beam(far, far + direction * (rest + elongation)));
            let got = sums(&gpu, &case, Scheme::Relax)[0].truncate();
            let beam = &case.model.beams[sheets::BEAM];
            let stretched = case.state.positions[0].distance(case.state.positions[1]) - beam.rest_length;
            assert!((stretched / elongation - 1.0).abs() < 1e-3, "the case is what it says: {stretched}");
            let want = direction * (beam.stiffness * stretched);
            assert!(got.distance(want) < 1e-3 * want.length(), "{elongation}: {got} is not {want}");
            let mut wrong = case.clone();
            wrong.state.positions[1] += direction * 0.01 * elongation;
            let got = sums(&gpu, &held(&wrong), Scheme::Relax)[0].truncate();
            assert!(got.distance(want) > 1e-3 * want.length(), "a hundredth of the elongation is seen");
        }
    }
}
