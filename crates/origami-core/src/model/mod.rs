//! The bar-and-hinge model of a sheet (paper section 2): its springs, precomputed once, in units of the sheet's radius.

mod build;
mod elements;
mod grid;
mod inventory;
mod material;
mod normalisation;

pub use elements::{Beam, CornerAngles, Crease};
pub use grid::MaterialGrid;
pub use inventory::{Built, Inventory, LeftOut};
pub use material::Material;
pub use normalisation::Normalisation;

use glam::DVec3;

use crate::error::Error;
use crate::ids::NodeId;
use crate::mesh::{Mesh, triangulate};
use crate::parallel;
use crate::pattern::CreasePattern;

/// Heights and lengths under this many radii carry no hinge and no corner angle: their forces grow as 1 / height, and
/// rounding would decide their direction. The reference program draws the same line.
pub const DEGENERATE: f64 = 1e-6;

/// A sheet ready to be folded. Lengths are in units of its radius, masses are 1; FOLD's units come back by
/// [`Model::file_positions`].
#[derive(Clone, Debug)]
pub struct Model {
    /// Topology.
    pub mesh: Mesh,
    /// What it is made of.
    pub material: Material,
    /// File units to radii and back.
    pub normalisation: Normalisation,
    /// Positions at rest, by node.
    pub rest: Vec<DVec3>,
    /// All beams; beam `i` lies on side `i`.
    pub beams: Vec<Beam>,
    /// Hinges that have a spring.
    pub creases: Vec<Crease>,
    /// Triangles that have corner springs.
    pub corner_angles: Vec<CornerAngles>,
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
        build::build(pattern, mesh(pattern)?, material)
    }

    /// One model for each of `materials`, in their order, as [`Model::new`] makes them. The pattern is triangulated once.
    ///
    /// # Errors
    /// As for [`Model::new`], of the first material that has one.
    pub fn of_each(pattern: &CreasePattern, materials: &[Material]) -> Result<Vec<Self>, Error> {
        let mesh = mesh(pattern)?;
        let models = parallel::map(materials, |_, material| build::build(pattern, mesh.clone(), material));
        // Of several errors the first.
        models.into_iter().collect()
    }

    /// How many nodes there are.
    #[must_use]
    pub fn node_count(&self) -> usize {
        self.rest.len()
    }

    /// The fold angle asked of each crease at `percent` of the pattern's angles, in radians.
    #[must_use]
    pub fn targets(&self, percent: f64) -> Vec<f64> {
        self.creases.iter().map(|c| c.goal * percent / 100.0).collect()
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

fn mesh(pattern: &CreasePattern) -> Result<Mesh, Error> {
    let triangulation = triangulate::triangulate(pattern)?;
    Mesh::new(pattern, &triangulation.triangles, triangulation.face_of)
}
