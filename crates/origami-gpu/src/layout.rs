//! The structs that lie in buffers, as `shaders/src` declares them. A test compares every offset with the shaders'.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use origami_core::contact::ListedPair;
use origami_core::scene::Axes;
use origami_core::twins::settle_decide::{LEAST, SHORTEST, WINDOWS};

/// The length of one unit of [`Node::high`], in radii.
pub(crate) const QUANTUM: f64 = 1.0 / 4096.0;

/// No node.
pub(crate) const NONE: u32 = u32::MAX;

/// Why an instance stands still.
pub(crate) const SETTLED: u32 = 1;
pub(crate) const LIMITED: u32 = 3;
/// Under contact: its list of pairs is spent, or layers have held it up for too long.
pub(crate) const SPENT: u32 = 4;
pub(crate) const HELD_UP: u32 = 5;

/// A node: its position is `high * QUANTUM + low`.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Node {
    pub(crate) high: [i32; 3],
    /// The axes along which it is held: bit 0 for x, 1 for y, 2 for z.
    pub(crate) held: u32,
    pub(crate) low: [f32; 3],
    pub(crate) mass: f32,
    pub(crate) velocity: [f32; 3],
    pub(crate) softness: f32,
    pub(crate) force: [f32; 3],
    pub(crate) unused: f32,
}

impl Node {
    /// A node at `position`, which is kept to 4e-12 radii.
    #[expect(clippy::cast_possible_truncation, reason = "high saturates beyond 500 000 radii; low is a remainder")]
    pub(crate) fn set_position(&mut self, position: DVec3) {
        let high = (position / QUANTUM).round();
        self.high = high.to_array().map(|x| x as i32);
        self.low = (position - high * QUANTUM).to_array().map(|x| x as f32);
    }

    /// Holds it along these axes and no others: there it stops.
    pub(crate) fn hold(&mut self, axes: Axes) {
        self.held = held_mask(axes);
        for (axis, _) in axes.to_array().into_iter().enumerate().filter(|(_, held)| *held) {
            (self.velocity[axis], self.force[axis]) = (0.0, 0.0);
        }
    }

    /// In radii.
    pub(crate) fn position(&self) -> DVec3 {
        DVec3::from_array(self.high.map(f64::from)) * QUANTUM + vector(self.low)
    }
}

/// What [`Node::held`] is for these axes.
pub(crate) fn held_mask(axes: Axes) -> u32 {
    axes.to_array().into_iter().zip(0..).map(|(held, bit)| u32::from(held) << bit).sum()
}

/// The square of a rest length in two parts: integer times `QUANTUM`^2, and the rest.
#[expect(clippy::cast_possible_truncation, reason = "a beam is at most 2 radii long; the rest is a remainder")]
pub(crate) fn split_square(length: f64) -> (i32, f32) {
    let square = length * length / (QUANTUM * QUANTUM);
    (square.round() as i32, ((square - square.round()) * QUANTUM * QUANTUM) as f32)
}

/// A vector of three numbers in double precision.
pub(crate) fn vector(v: [f32; 3]) -> DVec3 {
    DVec3::from_array(v.map(f64::from))
}

/// And in single.
#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
pub(crate) fn single(v: DVec3) -> [f32; 3] {
    v.to_array().map(|x| x as f32)
}

/// The state of a crease; angles in radians. The ramp leads from `start_target` to `end_target`.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct CreaseState {
    pub(crate) angle: f32,
    pub(crate) moment: f32,
    pub(crate) start_target: f32,
    pub(crate) end_target: f32,
}

impl CreaseState {
    /// The angles between which its ramp leads.
    #[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
    pub(crate) fn aim(&mut self, from: f64, to: f64) {
        (self.start_target, self.end_target) = (from as f32, to as f32);
    }
}

/// The control block of one instance: where it stands, and what the passes share.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Control {
    pub(crate) stop: u32,
    pub(crate) step: u32,
    pub(crate) limit: u32,
    pub(crate) bad_node: u32,
    pub(crate) ramp_step: u32,
    pub(crate) ramp_before: u32,
    pub(crate) ramp_length: u32,
    pub(crate) too_fast: u32,
    pub(crate) ramp_waits: u32,
    pub(crate) checks: u32,
    pub(crate) window_end: u32,
    pub(crate) settled_windows: u32,
    pub(crate) disturbed_at: u32,
    pub(crate) window_is_sound: u32,
    pub(crate) stops_when_settled: u32,
    pub(crate) distance: f32,
    pub(crate) tolerance: f32,
    pub(crate) fire_step: f32,
    pub(crate) mixing: f32,
    pub(crate) downhill: u32,
    pub(crate) keep: f32,
    pub(crate) towards_force: f32,
    pub(crate) back: f32,
    pub(crate) time_step: f32,
    pub(crate) previous_step: f32,
    pub(crate) next_step: f32,
    pub(crate) damping_sum: f32,
    pub(crate) stiffness_max: u32,
    pub(crate) speed_squared_max: u32,
    pub(crate) distance_squared_max: u32,
    pub(crate) move_squared_max: u32,
    pub(crate) checkpoint_step: u32,
    pub(crate) ea: f32,
    pub(crate) k_fold: f32,
    pub(crate) k_facet: f32,
    pub(crate) k_face: f32,
    pub(crate) zeta: f32,
    pub(crate) k_area: f32,
    pub(crate) soft_ea: f32,
    pub(crate) soft_corners: f32,
    pub(crate) wrong_side: f32,
}

impl Control {
    /// As `Windows::disturb` of the core: what the sheet looked like before counts no more.
    pub(crate) fn disturb(&mut self) {
        (self.settled_windows, self.window_is_sound, self.disturbed_at) = (0, 0, self.checks);
        self.window_end = self.window_end.min(self.checks + 1);
        self.distance = f32::INFINITY;
    }

    /// Whether the sheet is softer than its material at present, as `softens` of the shaders.
    pub(crate) fn is_soft(&self) -> bool {
        self.soft_ea > 0.0 && self.ramp_step < self.ramp_length
    }

    /// As `Windows::has_settled` of the core: whether the last windows had all settled.
    pub(crate) fn has_settled(&self) -> bool {
        self.settled_windows >= WINDOWS && u64::from(self.checks) * SHORTEST > LEAST
    }
}

/// A crease that never changes.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Hinge {
    pub(crate) apex_one: u32,
    pub(crate) apex_two: u32,
    pub(crate) end_one: u32,
    pub(crate) end_two: u32,
    pub(crate) length: f32,
    pub(crate) kind: u32,
}

/// Kinds of [`Hinge`]: stiffness by `k_fold`, by `k_facet`, or its own.
pub(crate) const FOLD: u32 = 0;
pub(crate) const FACET: u32 = 1;
pub(crate) const OWN: u32 = 2;

/// A triangle that never changes.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Face {
    pub(crate) nodes: [u32; 3],
    pub(crate) slots: [u32; 3],
    pub(crate) sides: [u32; 3],
    pub(crate) rest_high: [i32; 3],
    pub(crate) rest_low: [f32; 3],
}

/// Flags of [`Face::sides`], and the rest of it: no crease where all its bits are set.
pub(crate) const ALONE: u32 = 0x8000_0000;
pub(crate) const RIGHT: u32 = 0x4000_0000;
pub(crate) const CREASE: u32 = 0x3fff_ffff;

/// A beam outside any face.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct LooseBeam {
    pub(crate) nodes: [u32; 2],
    pub(crate) slots: [u32; 2],
    pub(crate) rest_high: i32,
    pub(crate) rest_low: f32,
    pub(crate) rigidity: f32,
}

/// A node when its window began.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Before {
    pub(crate) high: [i32; 3],
    pub(crate) unused: u32,
    pub(crate) low: [f32; 3],
    pub(crate) unused_too: f32,
    pub(crate) force: [f32; 3],
    pub(crate) unused_as_well: f32,
}

/// A point and a triangle, or two edges, that may touch.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Pair {
    pub(crate) nodes: [u32; 4],
    pub(crate) slots: [u32; 4],
    pub(crate) split: u32,
    pub(crate) closed: f32,
    pub(crate) width: f32,
    pub(crate) eased: f32,
}

impl From<&ListedPair> for Pair {
    #[expect(clippy::cast_possible_truncation, reason = "to the nearest, and 1 or 2")]
    fn from(pair: &ListedPair) -> Self {
        Self {
            nodes: pair.nodes.map(|node| node.0),
            slots: [0; 4],
            split: pair.split as u32,
            closed: pair.closed as f32,
            width: pair.width as f32,
            eased: pair.eased as f32,
        }
    }
}

/// What a node under contact is about to do.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Move {
    pub(crate) by: [f32; 3],
    pub(crate) springs: f32,
}

/// What contact does on the way.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(crate) struct Touch {
    pub(crate) limited_now: u32,
    pub(crate) spent: u32,
    pub(crate) limited: u32,
    pub(crate) last_limited: u32,
    pub(crate) first_limited: u32,
    pub(crate) arrived: u32,
    pub(crate) lasts: f32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::{Kernel, contact_move, loose_beams, pair_limits, row_sums, settle_windows, triangle_forces};
    use crate::shader_checks::{Checked, checked, same_layout};
    use crate::testing::variants;

    fn shader(kernel: &Kernel) -> Checked {
        let variant = variants::plain();
        checked(kernel.name, &kernel.source(&variant))
    }

    #[test]
    fn structs_lie_as_in_the_shaders() {
        let forces = shader(&triangle_forces::KERNEL);
        same_layout!(&forces, Node { high, held, low, mass, velocity, softness, force, unused });
        same_layout!(&forces, CreaseState { angle, moment, start_target, end_target });
        same_layout!(&forces, Face { nodes, slots, sides, rest_high, rest_low });
        same_layout!(
            &forces,
            Control {
                stop,
                step,
                limit,
                bad_node,
                ramp_step,
                ramp_before,
                ramp_length,
                too_fast,
                ramp_waits,
                checks,
                window_end,
                settled_windows,
                disturbed_at,
                window_is_sound,
                stops_when_settled,
                distance,
                tolerance,
                fire_step,
                mixing,
                downhill,
                keep,
                towards_force,
                back,
                time_step,
                previous_step,
                next_step,
                damping_sum,
                stiffness_max,
                speed_squared_max,
                distance_squared_max,
                move_squared_max,
                checkpoint_step,
                ea,
                k_fold,
                k_facet,
                k_face,
                zeta,
                k_area,
                soft_ea,
                soft_corners,
                wrong_side,
            }
        );
        let hinges = shader(&row_sums::KERNEL);
        same_layout!(&hinges, Hinge { apex_one, apex_two, end_one, end_two, length, kind });
        let loose = shader(&loose_beams::KERNEL);
        same_layout!(&loose, LooseBeam { nodes, slots, rest_high, rest_low, rigidity });
        let windows = shader(&settle_windows::KERNEL);
        same_layout!(&windows, Before { high, unused, low, unused_too, force, unused_as_well });
        let limits = shader(&pair_limits::KERNEL);
        same_layout!(&limits, Pair { nodes, slots, split, closed, width, eased });
        same_layout!(&limits, Move { by, springs });
        let moved = shader(&contact_move::KERNEL);
        same_layout!(&moved, Touch { limited_now, spent, limited, last_limited, first_limited, arrived, lasts });
    }

    /// Bytes of the control block as a text tells them.
    fn documented_size(text: &str) -> Option<usize> {
        let (_, after) = text.split_once("control block (")?;
        after.split(' ').next()?.parse().ok()
    }

    #[test]
    fn the_control_block_is_as_long_as_the_documents_say() {
        // In the program, so that it runs on a machine that has not the source.
        assert_eq!(documented_size(include_str!("../../../docs/GPU.md")), Some(size_of::<Control>()));
        assert_eq!(documented_size("reads the control block (128 bytes"), Some(128), "another size is seen");
    }

    /// Constants that both sides write out.
    #[test]
    fn constants_are_those_of_the_shaders() {
        let texts: String = origami_shaders::ALL.iter().map(|(_, text)| *text).collect();
        let constants = [
            ("NONE: u32", format!("{NONE:#x}u")),
            ("SETTLED: u32", format!("{SETTLED}u")),
            ("LIMITED: u32", format!("{LIMITED}u")),
            ("SPENT: u32", format!("{SPENT}u")),
            ("HELD_UP: u32", format!("{HELD_UP}u")),
            ("ALONE: u32", format!("{ALONE:#x}u")),
            ("RIGHT: u32", format!("{RIGHT:#x}u")),
            ("CREASE: u32", format!("{CREASE:#x}u")),
            ("FOLD: u32", format!("{FOLD}u")),
            ("FACET: u32", format!("{FACET}u")),
            ("QUANTUM: f32", format!("{QUANTUM}")),
            ("PER_QUANTUM: f32", format!("{:?}", 1.0 / QUANTUM)),
        ];
        for (name, value) in constants {
            let line = format!("const {name} = {value};");
            assert!(texts.contains(&line), "{line}");
        }
        assert!(![FOLD, FACET].contains(&OWN), "the shaders take all other kinds for it");
    }

    #[test]
    fn squares_of_rest_lengths_are_kept_far_beyond_single_precision() {
        for length in [1e-6, 0.013, 1.0 / 3.0, 1.0, 1.999] {
            let (high, low) = split_square(length);
            let square = f64::from(high) * QUANTUM * QUANTUM + f64::from(low);
            assert!((square - length * length).abs() < 2e-15, "{length}: {square}");
        }
    }

    #[test]
    fn positions_are_kept_far_beyond_single_precision() {
        for x in [0.0, 1.0, -0.1, 1.0 / 3.0, -99.9, 1e-9, 7.6e-6] {
            let position = DVec3::new(x, -x, 0.5 * x);
            let mut node = Node::default();
            node.set_position(position);
            assert!(node.position().distance(position) < 1e-11, "{x}");
            assert!(node.low.iter().all(|low| f64::from(low.abs()) <= 0.51 * QUANTUM), "{x}: {:?}", node.low);
        }
    }
}
