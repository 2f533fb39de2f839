//! What acts on a sheet from outside, as far as its arrays and pipelines make room for it.

use std::collections::BTreeSet;

use origami_core::ids::NodeId;
use origami_core::scene::Scene;

/// Whether nodes are held, and which are loaded, in any of several scenes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Outside {
    /// Whether nodes are held, or may be.
    pub(crate) holds: bool,
    /// The nodes that have a slot for a load.
    pub(crate) loaded: BTreeSet<NodeId>,
}

impl Outside {
    /// What these scenes need.
    pub(crate) fn of<'s>(scenes: impl IntoIterator<Item = &'s Scene>) -> Self {
        scenes.into_iter().fold(Self::default(), Self::with)
    }

    /// The same and what `scene` needs.
    pub(crate) fn with(mut self, scene: &Scene) -> Self {
        self.holds |= !scene.supports.is_empty();
        self.loaded.extend(scene.loads.iter().map(|load| load.node));
        self
    }

    /// Whether there is room for all that `scene` needs.
    pub(crate) fn covers(&self, scene: &Scene) -> bool {
        (self.holds || scene.supports.is_empty()) && scene.loads.iter().all(|load| self.loaded.contains(&load.node))
    }
}

#[cfg(test)]
mod tests {
    use origami_core::glam::DVec3;
    use origami_core::scene::{Load, Support};

    use super::*;

    #[test]
    fn room_for_several_scenes_is_room_for_each() {
        let load = |node| Load { node: NodeId(node), force: DVec3::X };
        let held = Scene::percent(10.0).with_support(Support::fixed(NodeId(3)));
        let loaded = Scene::percent(20.0).with_load(load(5)).with_load(load(1));
        let both = Outside::of([&held, &loaded]);
        assert!(both.covers(&held) && both.covers(&loaded) && both.covers(&Scene::default()));
        assert!(!Outside::default().covers(&held) && !Outside::of([&held]).covers(&loaded));
        assert!(!both.covers(&Scene::default().with_load(load(2))), "a node without a slot");
        assert!(Outside::default().covers(&Scene::percent(50.0)));
    }
}
