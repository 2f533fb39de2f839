//! The stopping rule, per node: moves and forces over a window.

use origami_shaders as wgsl;

use super::parts::force_on;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `settle_windows.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "settle_windows",
    entry: "settle_windows",
    text: wgsl::SETTLE_WINDOWS,
    shared: SHARED,
    parts: |variant| [force_on(variant), vec![wgsl::REDUCE, wgsl::PARTIALS, wgsl::WINDOWS]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows, Binding::Partials, Binding::Windows],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use glam::DVec4;
    use origami_core::forces::Forces;
    use origami_core::solve::row_sums;

    use super::super::{fold_angles, settle_decide, triangle_forces};
    use super::*;
    use crate::testing::bench::{Bench, held};
    use crate::testing::cases::{Case, Random, cases};
    use crate::testing::{gpu, sheets};
    use crate::variant::Scheme;

    /// Relative to the magnitude of what is summed: forces in single precision, over some hundred nodes. The fold angles of
    /// the second check start from the first one's, which changes nothing but rounding.
    const TOLERANCE: f64 = 1e-5;

    /// The largest square of a move, the least distance, force along the moves and its change along them, as the core's
    /// stopping rule has them; and the magnitudes of each.
    fn found(then: &Case, now: &Case) -> [DVec4; 2] {
        let forces = |case: &Case| {
            let mut angles = case.state.fold_angles.clone();
            Forces::new(&case.model).evaluate(&case.state.positions, &case.state.targets, &mut angles).to_vec()
        };
        let (f0, f) = (forces(then), forces(now));
        let [mut sums, mut sizes] = [DVec4::ZERO; 2];
        for (n, soft) in row_sums::soft_sums(&now.model).into_iter().enumerate() {
            let moved = now.state.positions[n] - then.state.positions[n];
            sums.x = sums.x.max(moved.length_squared());
            sums.y = sums.y.max(f[n].length() / soft);
            sums.z += f[n].dot(moved);
            sums.w += (f[n] - f0[n]).dot(moved);
            sizes.z += f[n].length() * moved.length();
            sizes.w += (f[n].length() + f0[n].length()) * moved.length();
        }
        (sizes.x, sizes.y) = (sums.x, sums.y);
        [sums, sizes]
    }

    fn is_far(got: DVec4, [want, size]: [DVec4; 2]) -> [bool; 4] {
        let far = (got - want).abs().cmpgt(size * TOLERANCE);
        [far.test(0), far.test(1), far.test(2), far.test(3)]
    }

    /// The sheet a window later.
    fn later(case: &Case) -> Case {
        let mut random = Random(5);
        let mut later = case.clone();
        later.state.positions.iter_mut().for_each(|p| *p += random.vector(3e-3));
        held(&later)
    }

    #[test]
    fn two_states_are_compared_as_on_the_processor() {
        let Some(gpu) = gpu() else { return };
        for case in cases().into_iter().skip(3).chain(sheets::special()) {
            let (then, now) = (held(&case), later(&case));
            let bench = Bench::new(&gpu, &then, Scheme::Relax);
            let check = || {
                bench.run(&bench.with_loose(&[&fold_angles::KERNEL, &triangle_forces::KERNEL]), false);
                bench.run(&[&KERNEL, &settle_decide::KERNEL], false);
            };
            check();
            assert_eq!((bench.control().checks, bench.control().window_end), (1, 1), "a window has begun");
            bench.change_nodes(|i, node| node.set_position(now.state.positions[i]));
            check();
            let partials: Vec<[f32; 4]> = bench.read(Binding::Partials, bench.groups());
            let got = partials
                .iter()
                .map(|p| DVec4::from_array(p.map(f64::from)))
                .reduce(|a, b| DVec4::new(a.x.max(b.x), a.y.max(b.y), a.z + b.z, a.w + b.w));
            let got = got.expect("one part at least");
            let wanted = found(&then, &now);
            assert_eq!(is_far(got, wanted), [false; 4], "{}: {got} is not {}", case.name, wanted[0]);

            let wrong = later(&now);
            assert_eq!(is_far(got, found(&then, &wrong)), [true; 4], "{}: another move is seen", case.name);

            let sums = wanted[0];
            let further = sums.x.sqrt() * (sums.z / sums.w).abs();
            let want = sums.x.sqrt().max(further).max(sums.y);
            let distance = f64::from(bench.control().distance);
            // A quotient of sums that cancel.
            let tolerance = TOLERANCE * (1.0 + wanted[1].z / sums.z.abs() + wanted[1].w / sums.w.abs());
            assert!((distance / want - 1.0).abs() < tolerance, "{}: {distance} is not {want}", case.name);
        }
    }

    #[test]
    fn nothing_is_checked_before_the_ramp_is_done_or_within_a_window() {
        let Some(gpu) = gpu() else { return };
        let bench = Bench::new(&gpu, &held(&cases()[3]), Scheme::Relax);
        let is_checked = |ramp: (u32, u32), checks: (u32, u32)| {
            bench.write(Binding::Windows, &vec![crate::layout::Before::default(); bench.arrays.nodes]);
            bench.change_control(|c| {
                (c.ramp_step, c.ramp_length) = ramp;
                (c.checks, c.window_end) = checks;
            });
            bench.run(&[&fold_angles::KERNEL, &triangle_forces::KERNEL, &KERNEL], false);
            let windows: Vec<crate::layout::Before> = bench.read(Binding::Windows, bench.arrays.nodes);
            windows.iter().any(|window| window.high != [0; 3])
        };
        assert!(is_checked((0, 0), (0, 0)) && is_checked((5, 5), (7, 7)));
        assert!(!is_checked((4, 5), (0, 0)), "on the ramp");
        assert!(!is_checked((0, 0), (3, 4)), "within a window");
    }
}
