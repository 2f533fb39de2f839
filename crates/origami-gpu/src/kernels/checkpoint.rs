//! Copies a state while it is good.

use origami_shaders as wgsl;

use super::{Binding, Kernel, Per, SHARED};

/// The kernel of `checkpoint.wgsl`.
pub(crate) const KERNEL: Kernel = Kernel {
    name: "checkpoint",
    entry: "checkpoint",
    text: wgsl::CHECKPOINT,
    shared: SHARED,
    parts: |variant| vec![if variant.blocks.is_some() { wgsl::BLOCK_ANGLES } else { wgsl::WHOLE_CREASES }],
    uses: &[
        Binding::Control,
        Binding::Nodes,
        Binding::CreaseStates,
        Binding::CheckpointNodes,
        Binding::CheckpointAngles,
    ],
    springs: false,
    per: Per::NodeOrCrease,
};

#[cfg(test)]
mod tests {
    use origami_core::twins::checkpoint::{GOOD_MOVE, GOOD_POSITION};

    use super::super::state_bounds;
    use super::*;
    use crate::layout::Node;
    use crate::testing::bench::{Bench, EULER, held};
    use crate::testing::cases::cases;
    use crate::testing::gpu;
    use crate::variant::Scheme;

    const STEP: f64 = 0.25;

    /// Whether a state is kept in which a node and the control block were changed so.
    fn is_kept(bench: &Bench, change: impl Fn(&mut Node), stop: u32) -> bool {
        bench.change_nodes(|i, node| {
            node.velocity = [0.0; 3];
            node.set_position(glam::DVec3::new(0.1, 0.2, 0.3));
            if i == 6 {
                change(node);
            }
        });
        bench.change_control(|c| {
            (c.stop, c.distance_squared_max, c.move_squared_max, c.step, c.checkpoint_step) = (stop, 0, 0, 40, 0);
            (c.time_step, c.fire_step) = (STEP as f32, STEP as f32);
        });
        bench.write(Binding::CheckpointNodes, &vec![Node::default(); bench.arrays.nodes]);
        bench.run(&[&state_bounds::KERNEL, &KERNEL], false);
        let (now, kept): (_, Vec<Node>) = (bench.nodes(), bench.read(Binding::CheckpointNodes, bench.arrays.nodes));
        let same = now.iter().zip(&kept).all(|(now, kept)| bytemuck::bytes_of(now) == bytemuck::bytes_of(kept));
        assert_eq!(bench.control().checkpoint_step, if same { 40 } else { 0 });
        assert!(same || kept.iter().all(|node| node.high == [0; 3]), "all or nothing");
        same
    }

    #[test]
    fn good_states_are_kept_and_others_not() {
        let Some(gpu) = gpu() else { return };
        for scheme in [Scheme::Relax, EULER] {
            let bench = Bench::new(&gpu, &held(&cases()[3]), scheme);
            let at = |x: f64| move |node: &mut Node| node.set_position(glam::DVec3::Y * x);
            let by = |way: f64| move |node: &mut Node| node.velocity = [0.0, 0.0, (way / STEP) as f32];
            assert!(is_kept(&bench, |_| {}, 0));
            assert!(!is_kept(&bench, |_| {}, 2), "it has stopped");
            assert!(is_kept(&bench, at(0.999 * GOOD_POSITION), 0));
            assert!(!is_kept(&bench, at(1.001 * GOOD_POSITION), 0));
            assert!(is_kept(&bench, by(0.999 * GOOD_MOVE), 0));
            assert!(!is_kept(&bench, by(-1.001 * GOOD_MOVE), 0));
            assert!(!is_kept(&bench, by(f64::NAN), 0));
            assert!(!is_kept(&bench, by(f64::INFINITY), 0));
        }
    }

    #[test]
    fn fold_angles_are_kept_with_the_nodes() {
        let Some(gpu) = gpu() else { return };
        let case = held(&cases()[3]);
        let bench = Bench::new(&gpu, &case, EULER);
        let creases = case.model.creases.len();
        bench.write(Binding::CheckpointAngles, &vec![9.0_f32; creases]);
        bench.run(&[&state_bounds::KERNEL, &KERNEL], false);
        let kept: Vec<f32> = bench.read(Binding::CheckpointAngles, creases);
        assert!(kept.iter().zip(&case.state.fold_angles).all(|(kept, now)| f64::from(*kept) == *now));
    }
}
