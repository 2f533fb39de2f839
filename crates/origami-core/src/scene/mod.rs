//! What is asked of a sheet and done to it: target angles, supports, loads, forces of the embedder's own.
//!
//! A scene is data of a run. The model, which says what the sheet is, never changes with it: one model serves many scenes.

mod check;
mod force;
mod held;
mod not_flat;
mod supports;
mod targets;
mod timeline;

pub use check::Refusal;
pub use force::{Force, Needs};
pub use held::Held;
pub use not_flat::NotFlat;
pub use supports::{Axes, Load, Reaction, Support};
pub use targets::Targets;
pub use timeline::{KeyRefused, Timeline};

use std::sync::Arc;

use crate::model::{Inventory, Model};

/// What is asked of a sheet and done to it.
///
/// The vertices that the pattern itself fixes ([`Model::fixed`]) are held in every scene.
///
/// ```
/// use origami_core::ids::NodeId;
/// use origami_core::scene::{Load, Scene, Support};
/// use origami_core::glam::DVec3;
///
/// let scene = Scene::percent(60.0)
///     .with_support(Support::fixed(NodeId(0)))
///     .with_load(Load { node: NodeId(3), force: -1e-3 * DVec3::Z });
/// assert_eq!(scene.targets.label(), Some(60.0));
/// ```
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Scene {
    /// The fold angles that the creases are asked for. Default: those that the file gives the sheet.
    pub targets: Targets,
    /// Nodes that are held, besides those that the pattern fixes. Default: none.
    pub supports: Vec<Support>,
    /// Dead loads: forces that keep their direction and size. Default: none.
    pub loads: Vec<Load>,
    /// Forces of the embedder's own. Default: none.
    pub forces: Vec<Arc<dyn Force>>,
}

impl Scene {
    /// Nothing but target angles.
    #[must_use]
    pub fn new(targets: Targets) -> Self {
        Self { targets, ..Self::default() }
    }

    /// Nothing but a percentage of the pattern's fold angles.
    #[must_use]
    pub fn percent(percent: f64) -> Self {
        Self::new(Targets::percent(percent))
    }

    /// The same with other targets.
    #[must_use]
    pub fn with_targets(self, targets: Targets) -> Self {
        Self { targets, ..self }
    }

    /// The same with one more node held.
    #[must_use]
    pub fn with_support(mut self, support: Support) -> Self {
        self.supports.push(support);
        self
    }

    /// The same with one more load.
    #[must_use]
    pub fn with_load(mut self, load: Load) -> Self {
        self.loads.push(load);
        self
    }

    /// The same with one more force of one's own.
    #[must_use]
    pub fn with_force(mut self, force: impl Force + 'static) -> Self {
        self.forces.push(Arc::new(force));
        self
    }

    /// Whether springs alone act on the sheet: no load, no force of one's own.
    #[must_use]
    pub fn has_springs_only(&self) -> bool {
        self.loads.is_empty() && self.forces.is_empty()
    }

    /// Whether the same supports, loads and forces act as in `other`, whatever the targets are.
    #[must_use]
    pub fn acts_as(&self, other: &Self) -> bool {
        self.supports == other.supports
            && self.loads == other.loads
            && self.forces.len() == other.forces.len()
            && self.forces.iter().zip(&other.forces).all(|(a, b)| Arc::ptr_eq(a, b))
    }

    /// What the model holds, and what the scene adds to it.
    #[must_use]
    pub fn inventory(&self, model: &Model) -> Inventory {
        let mut inventory = model.inventory.clone();
        inventory.built("supports", self.supports.len());
        inventory.built("loads", self.loads.len());
        for force in &self.forces {
            let line = force.inventory();
            inventory.built(line.what, line.count);
        }
        inventory
    }
}

impl From<Targets> for Scene {
    fn from(targets: Targets) -> Self {
        Self::new(targets)
    }
}
