//! Last pass of a relaxation: moves the nodes.

use origami_shaders as wgsl;

use super::parts::fire;
use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `fire_move.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "fire_move",
    entry: "fire_move",
    text: wgsl::FIRE_MOVE,
    shared: SHARED,
    parts: fire,
    uses: &[Binding::Control, Binding::Nodes],
    springs: false,
    per: Per::Node,
};

#[cfg(test)]
mod tests {
    use origami_core::twins::state_bounds::{FARTHEST, LONGEST_MOVE};

    use super::*;
    use crate::layout::{NONE, Node, vector};
    use crate::testing::bench::{Bench, held};
    use crate::testing::cases::{Random, cases, farthest};
    use crate::testing::gpu;
    use crate::variant::Scheme;

    /// In radii: the last digit of a move of a tenth.
    const TOLERANCE: f64 = 2e-8;

    /// What moves the nodes: keep, towards the force, back and the step.
    const HOW: [f32; 4] = [0.85, 0.7, -0.2, 0.6];

    fn lead(bench: &Bench) {
        bench.change_control(|c| [c.keep, c.towards_force, c.back, c.fire_step] = HOW);
    }

    fn moved(nodes: &[Node], how: [f32; 4]) -> [Vec<glam::DVec3>; 2] {
        let [keep, towards, back, step] = how.map(f64::from);
        let turned = |n: &Node| vector(n.velocity) * keep + vector(n.force) * (towards / f64::from(n.mass));
        let position = |n: &Node| n.position() + turned(n) * step + vector(n.velocity) * back;
        [nodes.iter().map(turned).collect(), nodes.iter().map(position).collect()]
    }

    #[test]
    fn nodes_move_as_was_decided() {
        let Some(gpu) = gpu() else { return };
        let case = held(&cases()[3]);
        let bench = Bench::new(&gpu, &case, Scheme::Relax);
        let mut random = Random(3);
        bench.change_nodes(|_, node| {
            node.velocity = random.vector(0.2).as_vec3().to_array();
            node.force = random.vector(2.0).as_vec3().to_array();
            node.mass = random.between(10.0, 1000.0) as f32;
        });
        lead(&bench);
        let before = bench.nodes();
        bench.run(&[&KERNEL], false);
        let after = bench.nodes();
        let velocities: Vec<_> = after.iter().map(|n| vector(n.velocity)).collect();
        let positions: Vec<_> = after.iter().map(Node::position).collect();
        let [turned, went] = moved(&before, HOW);
        assert!(farthest(&velocities, &turned) < TOLERANCE && farthest(&positions, &went) < TOLERANCE);
        assert!(after.iter().all(|n| n.low.iter().all(|low| f64::from(low.abs()) < 0.51 / 4096.0)), "split anew");
        for wrong in 0..4 {
            let mut how = HOW;
            how[wrong] *= 1.0 + 1e-5;
            assert!(farthest(&positions, &moved(&before, how)[1]) > TOLERANCE, "{wrong}: it is seen");
        }
        assert_eq!(bench.control().bad_node, NONE);
    }

    #[test]
    fn the_first_node_out_of_bounds_is_noted() {
        let Some(gpu) = gpu() else { return };
        let case = held(&cases()[3]);
        let found = |change: &dyn Fn(usize, &mut Node)| {
            let bench = Bench::new(&gpu, &case, Scheme::Relax);
            bench.change_nodes(|i, node| {
                node.velocity = [0.0; 3];
                change(i, node);
            });
            bench.change_control(|c| [c.keep, c.towards_force, c.back, c.fire_step] = [1.0, 0.0, 0.0, 1.0]);
            bench.run(&[&KERNEL], false);
            bench.control().bad_node
        };
        let far = |share: f64| move |node: &mut Node| node.set_position(glam::DVec3::X * (FARTHEST * share));
        let fast = |share: f64| move |node: &mut Node| node.velocity = [0.0, (LONGEST_MOVE * share) as f32, 0.0];
        let only = |index: usize, change: &dyn Fn(&mut Node)| {
            found(&|i, node| {
                if i == index {
                    change(node);
                }
            })
        };
        assert_eq!(only(4, &|_| {}), NONE);
        assert_eq!(only(4, &far(0.999)), NONE);
        assert_eq!(only(4, &far(1.001)), 4);
        assert_eq!(only(4, &fast(0.999)), NONE);
        assert_eq!(only(4, &fast(1.001)), 4);
        assert_eq!(only(3, &|node| node.velocity[2] = f32::NEG_INFINITY), 3);
        assert_eq!(only(2, &|node| node.velocity[2] = f32::NAN), 2);
        assert_eq!(found(&|i, node| node.velocity[0] = if i >= 7 { 1e30 } else { 0.0 }), 7);
    }
}
