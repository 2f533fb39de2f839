//! The bar-and-hinge model of a sheet (paper section 2): its springs, precomputed once, in units of the sheet's radius.

mod build;
mod elements;
mod grid;
mod inventory;
mod material;
mod normalisation;
mod sheet;
mod softening;

pub use elements::{Beam, CornerAngles, Crease, StiffnessSource};
pub use grid::MaterialGrid;
pub use inventory::{Built, Inventory, LeftOut};
pub use material::Material;
pub use normalisation::Normalisation;
pub use sheet::Sheet;
pub use softening::Softening;

use std::ops::Deref;
use std::sync::Arc;

use glam::DVec3;

use crate::error::Error;
use crate::ids::{CreaseId, EdgeId, NodeId, VertexId};
use crate::parallel;
use crate::pattern::CreasePattern;

/// Heights and lengths under this many radii carry no hinge and no corner angle: their forces grow as 1 / height, and
/// rounding would decide their direction. The reference program draws the same line.
pub const DEGENERATE: f64 = 1e-6;

/// A sheet ready to be folded. Lengths are in units of its radius, masses are 1; FOLD's units come back by
/// [`Model::file_positions`].
#[derive(Clone, Debug)]
pub struct Model {
    /// Mesh, rest positions and scale: one for all models of a pattern.
    pub sheet: Arc<Sheet>,
    /// What it is made of.
    pub material: Material,
    /// All beams; beam `i` lies on side `i`.
    pub beams: Vec<Beam>,
    /// Hinges that have a spring.
    pub creases: Vec<Crease>,
    /// Triangles that have corner springs.
    pub corner_angles: Vec<CornerAngles>,
    /// The largest stiffness per unit of length of a crease: a force per radian; 0 without creases.
    pub stiffest_crease: f64,
    /// Nodes that do not move.
    pub fixed: Vec<NodeId>,
    /// What was built and what was left out.
    pub inventory: Inventory,
}

impl Model {
    /// Triangulates the pattern and computes every constant of its springs.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a material out of range, a face that cannot be triangulated, a beam of no length.
    pub fn new(pattern: &CreasePattern, material: &Material) -> Result<Self, Error> {
        build::build(pattern, Arc::new(Sheet::new(pattern)?), material)
    }

    /// One model for each of `materials`, in their order, as [`Model::new`] makes them. The pattern is triangulated once.
    ///
    /// # Errors
    /// As for [`Model::new`], of the first material that has one.
    pub fn of_each(pattern: &CreasePattern, materials: &[Material]) -> Result<Vec<Self>, Error> {
        let sheet = Arc::new(Sheet::new(pattern)?);
        let models = parallel::map(materials, |_, material| build::build(pattern, Arc::clone(&sheet), material));
        // Of several errors the first.
        models.into_iter().collect()
    }

    /// How many nodes there are.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.rest.len()
    }

    /// The node of a vertex of the pattern; `None` for one that no edge or face uses.
    #[must_use]
    pub fn node(&self, vertex: VertexId) -> Option<NodeId> {
        self.mesh.node_of_vertex.get(vertex.index()).copied().flatten()
    }

    /// The crease on an edge of the pattern; `None` where it has no spring (a border, an undriven edge).
    #[must_use]
    pub fn crease_of(&self, edge: EdgeId) -> Option<CreaseId> {
        let side = self.mesh.side_of_edge.get(edge.index()).copied().flatten()?;
        // Creases lie in the order of their sides.
        self.creases.binary_search_by_key(&side, |crease| crease.side).ok().map(CreaseId::new)
    }

    /// Stiffness of every triangle against collapse, per unit of its perimeter: a force. 0: they have no such springs.
    #[must_use]
    pub fn k_area(&self) -> f64 {
        self.material.collapse * self.stiffest_crease
    }

    /// The fold angle asked of each crease at `percent` of the pattern's angles, in radians.
    #[must_use]
    pub fn targets(&self, percent: f64) -> Vec<f64> {
        self.creases.iter().map(|c| c.full_target * percent / 100.0).collect()
    }

    /// Node positions as positions of the pattern's vertices, in the file's units. Vertices that are no part of the
    /// sheet stay where the file has them; merged ones follow the vertex that stands for them.
    #[must_use]
    pub fn file_positions(&self, pattern: &CreasePattern, positions: &[DVec3]) -> Vec<DVec3> {
        let own = |i: usize| match self.mesh.node_of_vertex[i] {
            Some(node) => self.normalisation.to_file(positions[node.index()]),
            None => pattern.vertices[i],
        };
        let alias = |i: usize| pattern.alias_of.get(i).copied().flatten();
        (0..pattern.vertices.len()).map(|i| own(alias(i).map_or(i, |v| v.index()))).collect()
    }
}

/// A model is its sheet with springs: `model.mesh`, `model.rest` and `model.normalisation` are the sheet's.
impl Deref for Model {
    type Target = Sheet;

    fn deref(&self) -> &Sheet {
        &self.sheet
    }
}
