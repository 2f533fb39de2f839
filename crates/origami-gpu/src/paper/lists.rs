//! A model as the lists that the passes read. All differences are taken in f64 before they are rounded.

use glam::DVec3;
use origami_core::forces::damping;
use origami_core::ids::NodeId;
use origami_core::model::Model;

use super::layout::{BeamEnd, Crease, Motion, Node, Role, Settings, Spring, Triangle};
use crate::kernels::Binding;
use crate::layout::Control;

/// The constant buffers of a sheet.
pub(super) struct Lists {
    pub(super) settings: Settings,
    pub(super) nodes: Vec<Node>,
    pub(super) triangles: Vec<Triangle>,
    pub(super) creases: Vec<Crease>,
    pub(super) beam_ends: Vec<BeamEnd>,
    pub(super) roles: Vec<Role>,
}

impl Lists {
    pub(super) fn new(model: &Model, time_step: f64) -> Self {
        let count = model.node_count();
        let (beams, beam_ends) = by_node(count, beam_ends(model));
        let (creases, mut roles) = by_node(count, crease_roles(model));
        let (corners, corner_roles) = by_node(count, corner_roles(model));
        let first_corner = small(roles.len());
        roles.extend(corner_roles);
        let node = |n: usize| Node {
            rest: model.rest[n].as_vec3().to_array(),
            fixed_in_place: u32::from(model.fixed.binary_search(&NodeId::new(n)).is_ok()),
            beams: beams[n],
            creases: creases[n],
            corners: corners[n].map(|place| place.saturating_add(first_corner)),
            padding: [0; 2],
        };
        Self {
            nodes: (0..count).map(node).collect(),
            triangles: triangles(model),
            creases: hinges(model),
            beam_ends,
            roles,
            settings: Settings { time_step: time_step as f32 },
        }
    }

    /// Each buffer with its length in bytes and what it holds from the beginning; the rest is zeros.
    pub(super) fn buffers(&self) -> [(Binding, u64, &[u8]); 11] {
        fn filled(binding: Binding, contents: &[u8]) -> (Binding, u64, &[u8]) {
            (binding, contents.len() as u64, contents)
        }
        let zeros = |binding, count: usize, size: usize| (binding, (count * size) as u64, [].as_slice());
        let (nodes, triangles, creases) = (self.nodes.len(), self.triangles.len(), self.creases.len());
        [
            zeros(Binding::Control, 1, size_of::<Control>()),
            filled(Binding::Settings, bytemuck::bytes_of(&self.settings)),
            filled(Binding::RestNodes, bytemuck::cast_slice(&self.nodes)),
            zeros(Binding::Motions, nodes, size_of::<Motion>()),
            zeros(Binding::NextVelocities, nodes, size_of::<[f32; 4]>()),
            filled(Binding::Triangles, bytemuck::cast_slice(&self.triangles)),
            zeros(Binding::FaceNormals, triangles, size_of::<[f32; 4]>()),
            filled(Binding::Creases, bytemuck::cast_slice(&self.creases)),
            zeros(Binding::Springs, creases, size_of::<Spring>()),
            filled(Binding::BeamEnds, bytemuck::cast_slice(&self.beam_ends)),
            filled(Binding::Roles, bytemuck::cast_slice(&self.roles)),
        ]
    }
}

/// A place in a list. What is too many for 32 bits is too much for any buffer, which is found when that is made.
fn small(place: usize) -> u32 {
    u32::try_from(place).unwrap_or(u32::MAX)
}

/// The range of each node, and the items sorted by node; those of one node keep their order.
fn by_node<T>(nodes: usize, mut items: Vec<(NodeId, T)>) -> (Vec<[u32; 2]>, Vec<T>) {
    items.sort_by_key(|(node, _)| *node);
    let mut ranges = Vec::with_capacity(nodes);
    let mut first = 0;
    for n in 0..nodes {
        let last = first + items[first..].partition_point(|(node, _)| node.index() <= n);
        ranges.push([small(first), small(last)]);
        first = last;
    }
    (ranges, items.into_iter().map(|(_, item)| item).collect())
}

fn rounded(vector: DVec3) -> [f32; 3] {
    vector.as_vec3().to_array()
}

/// Each beam at both of its ends.
fn beam_ends(model: &Model) -> Vec<(NodeId, BeamEnd)> {
    let mut ends = Vec::with_capacity(2 * model.beams.len());
    for (beam, damping) in model.beams.iter().zip(damping::coefficients(model)) {
        let [i, j] = beam.nodes;
        for (own, other) in [(i, j), (j, i)] {
            let end = BeamEnd {
                rest: rounded(model.rest[other.index()] - model.rest[own.index()]),
                rest_length: beam.rest_length as f32,
                other: other.0,
                stiffness: beam.stiffness as f32,
                damping: damping as f32,
                padding: 0,
            };
            ends.push((own, end));
        }
    }
    ends
}

/// The triangles to the left and to the right of each crease.
fn triangles_beside(model: &Model) -> impl Iterator<Item = [u32; 2]> + '_ {
    let beside = |crease: &origami_core::model::Crease| model.mesh.sides[crease.side.index()].triangles;
    model.creases.iter().map(move |crease| beside(crease).map(|t| t.expect("a crease has two triangles").0))
}

fn crease_roles(model: &Model) -> Vec<(NodeId, Role)> {
    let mut roles = Vec::with_capacity(4 * model.creases.len());
    for (c, (crease, [triangle_one, triangle_two])) in model.creases.iter().zip(triangles_beside(model)).enumerate() {
        for (place, node) in (0..).zip(crease.nodes) {
            roles.push((node, Role { element: small(c), place, triangle_one, triangle_two }));
        }
    }
    roles
}

fn corner_roles(model: &Model) -> Vec<(NodeId, Role)> {
    let mut roles = Vec::with_capacity(3 * model.corner_angles.len());
    for corners in &model.corner_angles {
        for (place, node) in (0..).zip(corners.nodes) {
            roles.push((node, Role { element: corners.triangle.0, place, triangle_one: 0, triangle_two: 0 }));
        }
    }
    roles
}

fn triangles(model: &Model) -> Vec<Triangle> {
    let triangle = |nodes: &[NodeId; 3]| {
        let [a, b, c] = nodes.map(|n| model.rest[n.index()]);
        let sides = [b - a, c - b, a - c].map(|side| side.as_vec3().extend(0.0).to_array());
        Triangle { nodes: nodes.map(|n| n.0), padding: 0, sides, angles: [0.0; 4] }
    };
    let mut triangles: Vec<Triangle> = model.mesh.triangles.iter().map(triangle).collect();
    for corners in &model.corner_angles {
        let [(cos_a, sin_a), (cos_b, sin_b)] = corners.rest;
        triangles[corners.triangle.index()].angles = [cos_a, sin_a, cos_b, sin_b].map(|x| x as f32);
    }
    triangles
}

fn hinges(model: &Model) -> Vec<Crease> {
    let creases = model.creases.iter().zip(triangles_beside(model));
    creases
        .map(|(crease, [triangle_one, triangle_two])| {
            let [p1, p2, p3, p4] = crease.nodes.map(|n| model.rest[n.index()]);
            Crease {
                nodes: crease.nodes.map(|n| n.0),
                along: rounded(p4 - p3),
                triangle_one,
                to_one: rounded(p1 - p3),
                triangle_two,
                to_two: rounded(p2 - p3),
                padding: 0,
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_are_found_by_their_node_in_their_order() {
        let items = [(3, 'a'), (1, 'b'), (3, 'c'), (1, 'd'), (3, 'e')].map(|(n, item)| (NodeId(n), item));
        let (ranges, items) = by_node(5, items.to_vec());
        assert_eq!(ranges, [[0, 0], [0, 2], [2, 2], [2, 5], [5, 5]]);
        assert_eq!(items, ['b', 'd', 'a', 'c', 'e']);
    }
}
