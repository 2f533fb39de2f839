//! Fourth pass of a relaxation: FIRE's step and mixing.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `fire_update.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "fire_update",
    entry: "fire_update",
    text: wgsl::FIRE_UPDATE,
    shared: SHARED,
    parts: |_| vec![wgsl::GATHER, wgsl::REDUCE, wgsl::PARTIALS, wgsl::FIRE],
    uses: &[Binding::Control, Binding::Partials],
    springs: false,
    per: Per::Instance,
};

#[cfg(test)]
mod tests {
    use origami_core::solve::fire;

    use super::*;
    use crate::layout::Control;
    use crate::testing::bench::{Bench, held};
    use crate::testing::cases::cases;
    use crate::testing::gpu;
    use crate::variant::Scheme;

    /// Relative, over a few dozen decisions of which each rounds.
    const TOLERANCE: f64 = 1e-5;

    /// FIRE as in `origami_core::solve::fire`, without the nodes.
    #[derive(Clone, PartialEq)]
    struct Twin {
        step: f64,
        mixing: f64,
        downhill: u32,
        keep: f64,
        towards_force: f64,
        back: f64,
    }

    impl Twin {
        fn new() -> Self {
            Self { step: fire::FIRST_STEP, mixing: fire::MIXING, downhill: 0, keep: 0.0, towards_force: 0.0, back: 0.0 }
        }

        fn decide(&mut self, [power, speed, pull]: [f64; 3]) {
            if power < 0.0 {
                self.step = (self.step * fire::SHORTER).max(fire::SHORTEST_STEP);
                self.mixing = fire::MIXING;
                self.downhill = 0;
                (self.keep, self.towards_force, self.back) = (0.0, self.step, -0.5 * self.step);
                return;
            }
            self.downhill += 1;
            if self.downhill > fire::PATIENCE {
                self.step = (self.step * fire::LONGER).min(fire::LONGEST_STEP);
                self.mixing *= fire::LESS_MIXING;
            }
            let turn = if pull > 0.0 { self.mixing * (speed / pull).sqrt() } else { 0.0 };
            (self.keep, self.towards_force, self.back) = (1.0 - self.mixing, turn + self.step, 0.0);
        }

        fn is(&self, control: &Control) -> bool {
            let same = |a: f64, b: f32| (a - f64::from(b)).abs() <= TOLERANCE * a.abs();
            same(self.step, control.fire_step)
                && same(self.mixing, control.mixing)
                && self.downhill == control.downhill
                && same(self.keep, control.keep)
                && same(self.towards_force, control.towards_force)
                && same(self.back, control.back)
        }
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
        let mut twin = Twin::new();
        // Downhill beyond all patience and to the longest step, uphill to the shortest, then in turns; once at rest.
        let down = std::iter::repeat_n([2.0, 3.0, 5.0], 25);
        let up = std::iter::repeat_n([-1e-3, 0.5, 7.0], 8);
        let turns = [[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1e-9, 1e-12, 4.0], [-1.0, 1.0, 1.0], [4.0, 1.0, 1.0]];
        for (i, sums) in down.chain(up).chain(turns).enumerate() {
            write_sums(&bench, sums);
            bench.run(&[&KERNEL], false);
            let before = twin.clone();
            twin.decide(sums);
            let control = bench.control();
            assert!(twin.is(&control), "decision {i}: {control:?}");
            assert!(
                twin == before || !before.is(&control),
                "decision {i}: that of the step before is not taken for it"
            );
            assert_eq!(control.step as usize, i + 1);
            if i == 24 {
                assert_eq!(f64::from(control.fire_step), fire::LONGEST_STEP);
            }
        }
    }

    #[test]
    fn the_ramp_waits_while_it_is_held() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu);
        write_sums(&bench, [1.0, 1.0, 1.0]);
        bench.change_control(|c| {
            (c.ramp_step, c.ramp_length, c.held, c.distance_squared_max, c.move_squared_max) = (1, 3, 1, 7, 7);
        });
        let mut steps = Vec::new();
        for _ in 0..4 {
            bench.run(&[&KERNEL], false);
            let control = bench.control();
            assert_eq!((control.held, control.distance_squared_max, control.move_squared_max), (0, 0, 0));
            steps.push(control.ramp_step);
        }
        assert_eq!(steps, [1, 2, 3, 3]);
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
