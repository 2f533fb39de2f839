//! The stopping rule, per instance: whether it has settled.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `settle_decide.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "settle_decide",
    entry: "settle_decide",
    text: wgsl::SETTLE_DECIDE,
    shared: SHARED,
    parts: |_| vec![wgsl::REDUCE, wgsl::PARTIALS, wgsl::WINDOWS, wgsl::SETTLING],
    uses: &[Binding::Control, Binding::Partials],
    springs: false,
    per: Per::Instance,
};

#[cfg(test)]
mod tests {
    use origami_core::twins::settle_decide::{LEAST, SHORTEST, Window, Windows, distance};

    use super::*;
    use crate::layout::{Control, SETTLED};
    use crate::testing::bench::{Bench, EULER, held};
    use crate::testing::cases::cases;
    use crate::testing::gpu;
    use crate::variant::Scheme;

    const TOLERANCE: f32 = 1e-4;

    /// What all nodes came to: largest move, least distance, force along the moves, its change.
    fn write(bench: &Bench, largest: f32, least: f32, ahead: f32, change: f32) {
        let mut partials = vec![[0.0_f32; 4]; bench.groups()];
        let last = partials.len() - 1;
        partials[last] = [largest * largest, least, ahead, change];
        bench.write(Binding::Partials, &partials);
    }

    fn bench(gpu: &crate::Gpu, scheme: Scheme) -> Bench {
        Bench::new(gpu, &held(&cases()[0]), scheme)
    }

    #[test]
    fn distances_are_estimated_as_on_the_processor() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu, Scheme::Relax);
        for (found, wanted) in [
            ([2e-3, 1e-3, 0.0, 1.0], 2e-3),
            ([2e-3, 5e-3, 0.0, 1.0], 5e-3),
            ([2e-3, 1e-3, 6.0, -1.0], 12e-3),
            ([2e-3, 1e-3, -6.0, -1.0], 12e-3),
            ([0.0, 4e-3, 0.0, 0.0], 4e-3),
            ([2e-3, 4e-3, 1.0, 0.0], 1e30),
            // Where forces do not feel a move that is far below the tolerance, it is no sign of being far away.
            ([2e-8, 1e-9, 1.0, 0.0], 2e-8),
            ([2e-8, 4e-3, 1.0, 0.0], 4e-3),
            ([2e-7, 1e-9, 1.0, 0.0], 1e30),
        ] {
            let [largest, least, ahead, change] = found;
            write(&bench, largest, least, ahead, change);
            bench.change_control(|c| (c.checks, c.window_end, c.window_is_sound) = (1, 1, 1));
            bench.run(&[&KERNEL], false);
            let got = bench.control().distance;
            assert!((got / wanted - 1.0).abs() < 1e-6, "{found:?}: {got} is not {wanted}");
            let [largest, least, ahead, change] = found.map(f64::from);
            let twin = distance(Window { largest, least, ahead, change }, f64::from(TOLERANCE));
            let same = if twin.is_finite() { (f64::from(got) / twin - 1.0).abs() < 1e-6 } else { got >= 1e30 };
            assert!(same, "{found:?}: {got} is not the twin's {twin}");
        }
    }

    /// Checks until it has settled; how many checks that took on the GPU. Before one of them it may be disturbed.
    fn checks_until_settled(bench: &Bench, disturbed_before: Option<u32>, share_at: impl Fn(u32) -> f64) -> u32 {
        bench.change_control(|c| {
            let (limit, bad_node) = (c.limit, c.bad_node);
            *c = Control { limit, bad_node, tolerance: TOLERANCE, stops_when_settled: 1, ..Control::default() };
        });
        let mut twin = Windows::default();
        for check in 0..200 {
            if disturbed_before == Some(check) {
                bench.change_control(Control::disturb);
                twin.disturb();
            }
            let share = share_at(check);
            write(bench, share as f32 * TOLERANCE, 0.0, 0.0, 1.0);
            bench.run(&[&KERNEL], false);
            let share = (twin.window_ends() && twin.sound).then_some(share);
            let settled = twin.settle_decide(SHORTEST, share);
            let control = bench.control();
            assert_eq!(control.stop == SETTLED, settled, "check {check}");
            assert_eq!(control.settled_windows, twin.settled, "check {check}");
            assert_eq!(u64::from(control.window_end) * SHORTEST, twin.end, "check {check}");
            assert_eq!(control.window_is_sound == 1, twin.sound, "check {check}");
            assert_eq!(control.has_settled(), twin.has_settled(), "check {check}");
            if settled {
                return check;
            }
        }
        panic!("never settled");
    }

    #[test]
    fn windows_are_counted_as_on_the_processor() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu, Scheme::Relax);
        let far = |until: u32, then: f64| move |check: u32| if check < until { 5.0 } else { then };
        let least = (LEAST / SHORTEST) as u32;
        assert_eq!(checks_until_settled(&bench, None, |_| 0.01), least, "never before");
        assert_eq!(bench.control().step, 1, "the evaluation that found it counts");
        let (small, middling) =
            (checks_until_settled(&bench, None, far(60, 0.01)), checks_until_settled(&bench, None, far(60, 0.2)));
        assert!(small < middling, "a small share counts twice");
        for before in [0, 7, 40, 63] {
            let disturbed = checks_until_settled(&bench, Some(before), far(60, 0.01));
            assert!(disturbed >= small.min(before + 3), "disturbed before check {before}: {disturbed}");
        }
        assert!(checks_until_settled(&bench, None, |check| if check % 40 == 30 { 5.0 } else { 0.2 }) > 3);
    }

    #[test]
    fn who_is_to_run_all_steps_goes_on() {
        let Some(gpu) = gpu() else { return };
        let bench = bench(&gpu, EULER);
        write(&bench, 0.0, 0.0, 0.0, 0.0);
        let stop = |stops_when_settled: u32| {
            bench.change_control(|c| {
                (c.stop, c.checks, c.window_end, c.settled_windows) = (0, 20, 20, 5);
                c.stops_when_settled = stops_when_settled;
            });
            bench.run(&[&KERNEL], false);
            (bench.control().stop, bench.control().step)
        };
        assert_eq!(stop(0), (0, 0));
        assert_eq!(stop(1), (SETTLED, 0), "in dynamics no step was taken");
    }
}
