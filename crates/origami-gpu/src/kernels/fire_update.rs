//! Fourth pass of a relaxation: FIRE's step and mixing.

use origami_shaders as wgsl;

use super::parts::fire;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `fire_update.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "fire_update",
    entry: "fire_update",
    text: wgsl::FIRE_UPDATE,
    shared: SHARED,
    parts: |variant| [fire(variant), vec![wgsl::REDUCE, wgsl::PARTIALS]].concat(),
    uses: &[Binding::Control, Binding::Partials],
    springs: false,
    per: Per::Instance,
};

#[cfg(test)]
mod tests {
    use origami_core::twins::fire_update::{Decision, Fire, LONGEST_STEP, RENEWAL, Sums, fire_update};

    use super::*;
    use crate::layout::Control;
    use crate::testing::bench::{Bench, held};
    use crate::testing::cases::cases;
    use crate::testing::gpu;
    use crate::variant::Scheme;

    /// Relative, over a few dozen decisions of which each rounds.
    const TOLERANCE: f64 = 1e-5;

    /// What the core's twin of the shader has come to.
    fn is(fire: &Fire, decision: &Decision, control: &Control) -> bool {
        let same = |a: f64, b: f32| (a - f64::from(b)).abs() <= TOLERANCE * a.abs();
        same(fire.step, control.fire_step)
            && same(fire.mixing, control.mixing)
            && fire.downhill == control.downhill
            && same(decision.keep, control.keep)
            && same(decision.towards_force, control.towards_force)
            && same(decision.back, control.back)
    }

    /// Writes sums as parts of equal size.
    fn write_sums(bench: &Bench, sums: [f64; 3]) {
        let parts = bench.groups();
        let [power, speed, pull] = sums.map(|sum| (sum / parts as f64) as f32);
        bench.write(Binding::Partials, &vec![[power, speed, pull, 0.0]; parts]);
    }

    fn bench(gpu: &crate::Gpu) -> Bench {
        let bench = Bench::new(gpu, &held(&cases()[0]), Scheme::Relax);
        assert!(bench.groups() > 5, "several parts to be added up");
        bench
    }

    #[test]
    fn decides_as_the_processor() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu);
        let (mut twin, mut decided) = (Fire::default(), None);
        // Downhill beyond all patience and to the longest step, uphill to the shortest, then in turns; once at rest.
        let down = std::iter::repeat_n([2.0, 3.0, 5.0], 25);
        let up = std::iter::repeat_n([-1e-3, 0.5, 7.0], 8);
        let turns = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1e-9, 1e-12, 4.0], [-1.0, 1.0, 1.0], [4.0, 1.0, 1.0]];
        for (i, sums) in down.chain(up).chain(turns).enumerate() {
            write_sums(&bench, sums);
            bench.run(&[&KERNEL], false);
            let [power, speed, pull] = sums;
            let before = (twin, decided);
            let decision = fire_update(&mut twin, Sums { power, speed, pull });
            decided = Some(decision);
            let control = bench.control();
            assert!(is(&twin, &decision, &control), "decision {i}: {control:?}");
            if let (fire, Some(last)) = before {
                let same = (fire, last) == (twin, decision);
                assert!(
                    same || !is(&fire, &last, &control),
                    "decision {i}: that of the step before is not taken for it"
                );
            }
            assert_eq!(control.step as usize, i + 1);
            if i == 24 {
                assert_eq!(f64::from(control.fire_step), LONGEST_STEP);
            }
        }
    }

    #[test]
    fn the_ramp_waits_while_it_is_held() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu);
        write_sums(&bench, [1.0, 1.0, 1.0]);
        bench.change_control(|c| {
            (c.ramp_step, c.ramp_length, c.too_fast, c.distance_squared_max, c.move_squared_max) = (1, 3, 1, 7, 7);
        });
        let mut steps = Vec::new();
        for _ in 0..4 {
            bench.run(&[&KERNEL], false);
            let control = bench.control();
            assert_eq!((control.too_fast, control.distance_squared_max, control.move_squared_max), (0, 0, 0));
            steps.push(control.ramp_step);
        }
        assert_eq!(steps, [1, 2, 3, 3]);
    }

    #[test]
    fn a_soft_sheet_arrives_where_its_masses_are_renewed() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu);
        write_sums(&bench, [1.0, 1.0, 1.0]);
        let renewal = u32::try_from(RENEWAL).expect("few");
        for (softest, arrives) in [(0.7, renewal), (0.0, renewal - 2)] {
            bench.change_control(|c| {
                (c.step, c.ramp_step, c.ramp_length, c.soft_ea) = (renewal - 4, 1, 3, softest);
            });
            let arrived = (0..6).find_map(|_| {
                bench.run(&[&KERNEL], false);
                let control = bench.control();
                (control.ramp_step == 3).then_some(control.step)
            });
            assert_eq!(arrived, Some(arrives));
        }
    }

    #[test]
    fn stands_still_at_its_limit_and_where_it_diverged() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu);
        write_sums(&bench, [1.0, 1.0, 1.0]);
        for (bad_node, limit, stop) in [(crate::layout::NONE, 7, 3), (5, 100, 2), (5, 7, 2)] {
            bench.change_control(|c| (c.stop, c.step, c.bad_node, c.limit) = (0, 7, bad_node, limit));
            let before = bench.control();
            bench.run(&[&KERNEL], false);
            assert_eq!(bench.control(), Control { stop, ..before });
            bench.run(&[&KERNEL], false);
            assert_eq!(bench.control(), Control { stop, ..before }, "and stays so");
        }
    }
}
