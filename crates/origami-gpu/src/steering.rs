//! Changes to a sheet in the memory of a GPU between two steps. They go to the queue; what was submitted before is done by then.

use std::collections::BTreeMap;
use std::mem::offset_of;

use bytemuck::Pod;
use glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::{Axes, Held};

use crate::engine::Engine;
use crate::kernels::Binding;
use crate::layout::{Node, held_mask};

impl Engine {
    /// Holds the nodes of `now` in place of those of `before`: along the axes that hold them they stop.
    pub(crate) fn hold(&self, before: &Held, now: &Held) {
        let [before, now] = [before, now].map(|held| held.iter().collect::<BTreeMap<NodeId, Axes>>());
        for node in before.keys().filter(|node| !now.contains_key(node)) {
            self.write_node(*node, offset_of!(Node, held), &[0_u32]);
        }
        for (node, axes) in now.iter().filter(|(node, axes)| before.get(node) != Some(axes)) {
            self.write_node(*node, offset_of!(Node, held), &[held_mask(*axes)]);
            for axis in along(*axes) {
                self.write_node(*node, offset_of!(Node, velocity) + 4 * axis, &[0.0_f32]);
                self.write_node(*node, offset_of!(Node, force) + 4 * axis, &[0.0_f32]);
            }
        }
    }

    /// Puts a node to a position along some axes.
    pub(crate) fn place(&self, node: NodeId, axes: Axes, position: DVec3) {
        let mut placed = Node::default();
        placed.set_position(position);
        for axis in along(axes) {
            self.write_node(node, offset_of!(Node, high) + 4 * axis, &[placed.high[axis]]);
            self.write_node(node, offset_of!(Node, low) + 4 * axis, &[placed.low[axis]]);
        }
    }

    /// Writes a part of a node of the first instance, from a byte of it on.
    fn write_node<T: Pod>(&self, node: NodeId, offset: usize, contents: &[T]) {
        let at = (node.index() * size_of::<Node>() + offset) as u64;
        self.gpu.queue().write_buffer(&self.buffers[&Binding::Nodes], at, bytemuck::cast_slice(contents));
    }
}

/// The indices of the axes.
fn along(axes: Axes) -> impl Iterator<Item = usize> {
    axes.to_array().into_iter().enumerate().filter(|(_, is)| *is).map(|(axis, _)| axis)
}
