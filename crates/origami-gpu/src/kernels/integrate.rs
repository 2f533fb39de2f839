//! Third pass of dynamics: sums the forces on the nodes and moves them.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `integrate.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "integrate",
    entry: "integrate",
    text: wgsl::INTEGRATE,
    shared: SHARED,
    parts: |_| vec![wgsl::SLOTS, wgsl::GATHER, wgsl::MOTION],
    uses: &[Binding::Control, Binding::Nodes, Binding::Slots, Binding::Rows],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::{fold_angles, triangle_forces};
    use super::*;
    use crate::testing::bench::{Bench, EULER, VERLET, held};
    use crate::testing::cases::{Case, Random, cases, tampered};
    use crate::testing::steps::{STEP, STEP_BEFORE, TOLERANCE, errors, stepped};
    use crate::testing::{gpu, sheets};
    use crate::variant::Scheme;

    fn step(gpu: &crate::Gpu, case: &Case, scheme: Scheme, accelerations: &[DVec3]) -> Bench {
        let bench = Bench::new(gpu, case, scheme);
        bench.change_nodes(|i, node| node.force = accelerations[i].as_vec3().to_array());
        bench.change_control(|c| (c.time_step, c.next_step) = (STEP_BEFORE, STEP));
        bench.run(&bench.with_loose(&[&fold_angles::KERNEL]), false);
        bench.run(&[&triangle_forces::KERNEL], true);
        bench.run(&[&KERNEL], false);
        bench
    }

    #[test]
    fn one_step_is_that_of_the_processor() {
        let Some(gpu) = gpu() else { return };
        for (i, case) in cases().into_iter().chain(sheets::special()).enumerate() {
            let case = held(&case);
            let mut random = Random(11);
            let accelerations: Vec<DVec3> =
                case.state.positions.iter().map(|_| random.vector(1.0).as_vec3().as_dvec3()).collect();
            let verlet = i % 2 == 0;
            let bench = step(&gpu, &case, if verlet { VERLET } else { EULER }, &accelerations);
            let (nodes, dt) = (bench.nodes(), f64::from(STEP));
            let found = errors(&case, &nodes, &stepped(&case, &accelerations, verlet, dt));
            println!("integrate, {}: {found:.2?}", case.name);
            assert!(found.iter().all(|e| *e < TOLERANCE), "{}: {found:?} roundings", case.name);
            let wrongs = [
                ("the other integrator", stepped(&case, &accelerations, !verlet, dt)),
                ("another step", stepped(&case, &accelerations, verlet, 1.001 * dt)),
                ("a moved node", stepped(&tampered(&case), &accelerations, verlet, dt)),
            ];
            for (what, wrong) in wrongs {
                let seen = errors(&case, &nodes, &wrong);
                assert!(seen.iter().all(|e| *e > TOLERANCE), "{}: {what} is seen: {seen:?}", case.name);
            }
        }
    }

    #[test]
    fn fixed_nodes_stay_and_the_others_do_not() {
        let Some(gpu) = gpu() else { return };
        let mut case = cases().into_iter().find(|case| !case.model.fixed.is_empty()).expect("one has fixed nodes");
        case.state.velocities.fill(DVec3::ZERO);
        let none = vec![DVec3::ZERO; case.model.node_count()];
        for scheme in [EULER, VERLET] {
            let bench = Bench::new(&gpu, &case, scheme);
            let before = bench.nodes();
            let after = step(&gpu, &case, scheme, &none).nodes();
            for (i, (before, after)) in before.iter().zip(&after).enumerate() {
                let fixed = case.model.fixed.iter().any(|n| n.index() == i);
                assert_eq!(before.position() == after.position(), fixed, "node {i}");
            }
        }
    }

    #[test]
    fn one_thread_keeps_the_time() {
        let Some(gpu) = gpu() else { return };
        let bench = Bench::new(&gpu, &held(&cases()[3]), EULER);
        let before = bench.control();
        bench.change_control(|c| {
            (c.ramp_step, c.ramp_length, c.distance_squared_max, c.move_squared_max) = (1, 2, 9, 9);
        });
        bench.run(&[&triangle_forces::KERNEL], false);
        assert_eq!(bench.control().step, 0, "forces alone take no time");
        for (steps, ramp) in [(1, 2), (2, 2)] {
            bench.run(&[&triangle_forces::KERNEL], true);
            let now = bench.control();
            assert_eq!((now.step, now.ramp_step, now.distance_squared_max, now.move_squared_max), (steps, ramp, 0, 0));
            assert_eq!((now.previous_step == 0.0, now.time_step), (steps == 1, before.next_step));
        }
        bench.change_control(|c| c.bad_node = 3);
        bench.run(&[&triangle_forces::KERNEL], true);
        assert_eq!((bench.control().stop, bench.control().step), (2, 2), "it diverged in the step before");
    }
}
