//! The sheet itself: what all models of one pattern share, whatever they are made of.

use glam::DVec3;

use super::Normalisation;
use crate::error::Error;
use crate::mesh::{Mesh, triangulate};
use crate::pattern::CreasePattern;

/// A pattern's triangulation with its nodes at rest, scaled to radius 1.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Topology.
    pub mesh: Mesh,
    /// File units to radii and back.
    pub normalisation: Normalisation,
    /// Positions at rest, by node, in radii.
    pub rest: Vec<DVec3>,
}

impl Sheet {
    /// Triangulates a pattern and scales it.
    ///
    /// # Errors
    /// [`Error::Invalid`] for a face that cannot be triangulated, or a sheet without a finite radius above 0.
    pub fn new(pattern: &CreasePattern) -> Result<Self, Error> {
        let triangulation = triangulate::triangulate(pattern)?;
        let mesh = Mesh::new(pattern, &triangulation.triangles, triangulation.face_of)?;
        let points = mesh.vertex_of_node.iter().map(|v| pattern.vertices[v.index()]);
        let normalisation = Normalisation::of(points.clone())?;
        let rest = points.map(|p| normalisation.to_model(p)).collect();
        Ok(Self { mesh, normalisation, rest })
    }
}
