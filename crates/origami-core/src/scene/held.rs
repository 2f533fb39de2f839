//! Which nodes are held along which axes, all supports together.

use glam::DVec3;

use super::{Axes, Scene, Support};
use crate::ids::NodeId;
use crate::model::Model;

/// The held nodes of a scene, each once, in order.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Held(Vec<(NodeId, Axes)>);

impl Held {
    /// Those that the pattern fixes, and those that the scene supports.
    #[must_use]
    pub fn new(model: &Model, scene: &Scene) -> Self {
        let mut held = Self(model.fixed.iter().map(|node| (*node, Axes::ALL)).collect());
        scene.supports.iter().for_each(|support| held.hold(support.node, support.axes));
        held
    }

    /// Holds a node along some axes more.
    pub fn hold(&mut self, node: NodeId, axes: Axes) {
        match self.0.binary_search_by_key(&node, |(own, _)| *own) {
            Ok(i) => self.0[i].1 = self.0[i].1 | axes,
            Err(i) => self.0.insert(i, (node, axes)),
        }
    }

    /// Whether no node is held.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a node is held along any axis.
    pub(crate) fn holds(&self, node: NodeId) -> bool {
        self.0.binary_search_by_key(&node, |(own, _)| *own).is_ok()
    }

    /// The nodes, in order, and the axes along which each is held.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (NodeId, Axes)> + Clone + '_ {
        self.0.iter().copied()
    }

    /// Takes the held part out of vectors of nodes.
    pub fn clear(&self, vectors: &mut [DVec3]) {
        for (node, axes) in self.iter() {
            vectors[node.index()] = axes.without(vectors[node.index()]);
        }
    }
}

impl Scene {
    /// Puts the nodes that have prescribed positions there.
    pub fn place_supports(&self, positions: &mut [DVec3]) {
        for Support { node, axes, position } in &self.supports {
            if let Some(prescribed) = position {
                let own = &mut positions[node.index()];
                *own = axes.choose(*prescribed, *own);
            }
        }
    }
}
