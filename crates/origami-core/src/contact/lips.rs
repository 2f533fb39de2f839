//! What contact does not keep apart: things that touch in the flat sheet.

use std::collections::BTreeSet;

use glam::DVec3;

use super::Contact;
use super::finder::Finder;
use crate::ids::NodeId;
use crate::mesh::Mesh;

/// How many pairs of a node and a triangle, or of two edges, touch each other where the nodes are at `rest`, the flat sheet, though
/// they have no node in common, as the two lips of a cut do, and the nodes at which they do, in order. [`Contact`] leaves these
/// pairs out, since nothing says on which side of each other they are: they may go through each other.
#[must_use]
pub fn touching_lips(mesh: &Mesh, rest: &[DVec3]) -> (usize, Vec<NodeId>) {
    let touching = Finder::new(mesh, rest, Contact::default()).touching();
    // Where edges touch, an end of one does so with a triangle of the other.
    let points = touching.iter().filter(|(_, split)| *split == 1).map(|([point, ..], _)| *point);
    let nodes: BTreeSet<NodeId> = points.collect();
    (touching.len(), nodes.into_iter().collect())
}
