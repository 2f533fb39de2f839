//! A step of dynamics, by blocks.

use origami_shaders as wgsl;

use super::parts::in_blocks;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `block_dynamics.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "block_dynamics",
    entry: "block_dynamics",
    text: wgsl::BLOCK_DYNAMICS,
    shared: SHARED,
    parts: |variant| [in_blocks(variant), vec![wgsl::MOTION]].concat(),
    uses: &[Binding::Control, Binding::Nodes, Binding::Blocks, Binding::Angles, Binding::Targets],
    springs: true,
    per: Per::Block,
};

#[cfg(test)]
mod tests {
    use super::super::{block_clock, bring_home};
    use super::*;
    use crate::layout::{Control, Node};
    use crate::purpose::Dispatch;
    use crate::testing::bench::{Bench, EULER, VERLET, held};
    use crate::testing::cases::{Random, cases, tampered};
    use crate::testing::steps::{STEP, STEP_BEFORE, TOLERANCE, errors, stepped};
    use crate::testing::{gpu, sheets};

    #[test]
    fn one_step_is_that_of_the_processor() {
        let Some(gpu) = gpu() else { return };
        for (i, case) in cases().into_iter().chain(sheets::special()).enumerate() {
            let case = held(&case);
            let mut random = Random(11);
            let accelerations: Vec<glam::DVec3> =
                case.state.positions.iter().map(|_| random.vector(1.0).as_vec3().as_dvec3()).collect();
            let verlet = i % 2 == 0;
            let bench = Bench::by(&gpu, &case, if verlet { VERLET } else { EULER }, Dispatch::Blocks);
            bench.change_nodes(|i, node| node.force = accelerations[i].as_vec3().to_array());
            bench.change_control(|c| (c.time_step, c.next_step) = (STEP_BEFORE, STEP));
            bench.run(&[&block_clock::KERNEL, &KERNEL], false);
            assert_eq!(bench.nodes()[0].position(), case.state.positions[0], "others may still read where it was");
            bench.run(&[&bring_home::KERNEL], false);
            let (nodes, dt) = (bench.nodes(), f64::from(STEP));
            let found = errors(&case, &nodes, &stepped(&case, &accelerations, verlet, dt));
            println!("block_dynamics, {}: {found:.2?}", case.name);
            assert!(found.iter().all(|e| *e < TOLERANCE + 1.0), "{}: {found:?} roundings", case.name);
            let wrong = errors(&case, &nodes, &stepped(&tampered(&case), &accelerations, verlet, dt));
            assert!(wrong.iter().all(|e| *e > TOLERANCE + 1.0), "{}: a moved node is seen: {wrong:?}", case.name);
        }
    }

    #[test]
    fn the_clock_goes_first_and_stops_who_has_left_all_bounds() {
        let Some(gpu) = gpu() else { return };
        let bench = Bench::by(&gpu, &held(&cases()[3]), EULER, Dispatch::Blocks);
        bench.change_control(|c| (c.ramp_step, c.ramp_length) = (1, 2));
        bench.run(&[&block_clock::KERNEL], false);
        let Control { step, ramp_step, ramp_before, .. } = bench.control();
        assert_eq!((step, ramp_before, ramp_step), (1, 1, 2));
        bench.change_control(|c| c.bad_node = 3);
        bench.run(&[&block_clock::KERNEL], false);
        assert_eq!((bench.control().stop, bench.control().step), (2, 1), "it diverged in the step before");
        bench.run(&[&KERNEL], false);
        let there: Vec<Node> = bench.read(Binding::Nodes, 2 * bench.arrays.nodes);
        assert!(there[bench.arrays.nodes..].iter().all(|node| node.mass == 0.0), "nothing has moved");
    }
}
