//! Where the nodes are, seen where they lie: nothing is copied until it is asked for.

use glam::DVec3;

use crate::ids::NodeId;
use crate::kernel::{Quad64, vector};
use crate::model::Normalisation;

/// Units of length of positions that are handed out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Units {
    /// The radius of the sheet, about its centre: what the simulation computes in.
    #[default]
    Radii,
    /// The unit and the origin of the pattern's file.
    File,
}

/// The positions of all nodes of a simulation, by node.
#[derive(Clone, Copy, Debug)]
pub struct Positions<'a> {
    nodes: Nodes<'a>,
    normalisation: &'a Normalisation,
}

#[derive(Clone, Copy, Debug)]
enum Nodes<'a> {
    Quads(&'a [Quad64]),
    Vectors(&'a [DVec3]),
}

impl<'a> Positions<'a> {
    /// A view of positions in radii.
    #[must_use]
    pub fn new(positions: &'a [DVec3], normalisation: &'a Normalisation) -> Self {
        Self { nodes: Nodes::Vectors(positions), normalisation }
    }

    pub(super) fn of_quads(quads: &'a [Quad64], normalisation: &'a Normalisation) -> Self {
        Self { nodes: Nodes::Quads(quads), normalisation }
    }

    /// How many nodes there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self.nodes {
            Nodes::Quads(quads) => quads.len(),
            Nodes::Vectors(vectors) => vectors.len(),
        }
    }

    /// Whether there is no node.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Where a node is, in radii.
    #[must_use]
    pub fn get(&self, node: NodeId) -> Option<DVec3> {
        match self.nodes {
            Nodes::Quads(quads) => quads.get(node.index()).map(|quad| vector(*quad)),
            Nodes::Vectors(vectors) => vectors.get(node.index()).copied(),
        }
    }

    /// All positions in radii, in the order of the nodes.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = DVec3> + 'a {
        let nodes = self.nodes;
        let at = move |i: usize| match nodes {
            Nodes::Quads(quads) => vector(quads[i]),
            Nodes::Vectors(vectors) => vectors[i],
        };
        (0..self.len()).map(at)
    }

    /// Writes x, y and z of one node after the other to `to`, as many nodes as fit; returns how many these are.
    pub fn write_f32(&self, units: Units, to: &mut [f32]) -> usize {
        let normalisation = self.normalisation;
        let written = self.iter().zip(to.chunks_exact_mut(3)).map(|(position, to)| {
            let position = match units {
                Units::Radii => position,
                Units::File => normalisation.to_file(position),
            };
            to.copy_from_slice(&position.as_vec3().to_array());
        });
        written.count()
    }
}
