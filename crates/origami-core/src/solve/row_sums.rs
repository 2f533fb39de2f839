//! A bound on the stiffness that each node feels, by one pass over the elements.
//!
//! With `J_ei` the gradient of element e's length or angle at node i, the stiffness matrix is bounded row by row by
//! `K_i = sum over e at i of k_e |J_ei| sum_j |J_ej|`; beams give 2k. Valence, thin triangles, creases and corner angles
//! are all in it, where the paper's rule (2.5) looks at one beam at a time.

use std::sync::Arc;

use glam::DVec3;

use crate::forces::areas::acting;
use crate::forces::corner_angles::Triangle;
use crate::forces::creases::hinge;
use crate::ids::{CreaseId, NodeId};
use crate::model::{CornerAngles, Crease, Model, Softening};
use crate::parallel;
use crate::scene::Force;

/// Springs whose shares are found before they are added up.
const BLOCK: usize = 4096;

/// Writes `K_i` of every node at `positions`; all above 0, as every node has a beam.
pub fn row_sums(model: &Model, positions: &[DVec3], sums: &mut [f64]) {
    shared_row_sums(false, (model, &OnTheWay::default()), positions, sums);
}

/// How a sheet is softened at present.
#[derive(Clone, Debug, Default)]
pub(super) struct OnTheWay {
    pub(super) softening: Option<Softening>,
    /// The creases that are folded to the other side than their targets.
    pub(super) wrong: Vec<CreaseId>,
}

/// The same of a sheet that is softened, with what forces of one's own add. A force that has no bound has been refused.
pub(super) fn all_row_sums(
    shared: bool,
    (model, way, own): (&Model, &OnTheWay, &[Arc<dyn Force>]),
    positions: &[DVec3],
    sums: &mut [f64],
) {
    shared_row_sums(shared, (model, way), positions, sums);
    own.iter().for_each(|own| {
        own.add_row_sums(positions, sums);
    });
}

/// [`row_sums`], `shared` out among the threads of this thread's pool or not: equal bits.
fn shared_row_sums(shared: bool, (model, way): (&Model, &OnTheWay), positions: &[DVec3], sums: &mut [f64]) {
    sums.fill(0.0);
    for beam in &model.beams {
        let stiffness = way.softening.map_or(beam.stiffness, |soft| soft.of_beam(model, beam));
        for n in beam.nodes {
            sums[n.index()] += 2.0 * stiffness;
        }
    }
    add_springs(shared, (model, way), positions, sums);
}

/// Adds to `sums` the row sums of clusters of nodes that move as one, by the springs that resist that: of each node `cluster`
/// has the number of its own.
pub(super) fn cluster_sums(
    (model, way, own): (&Model, &OnTheWay, &[Arc<dyn Force>]),
    cluster: &[Option<u32>],
    positions: &[DVec3],
    sums: &mut [f64],
) {
    // What is within one cluster does not resist it.
    let numbers = |nodes: &[NodeId]| {
        let own = |n: &NodeId| cluster[n.index()];
        nodes.iter().any(|n| own(n).is_some() && nodes.iter().any(|other| own(other) != own(n)))
    };
    let mut add = |nodes: &[NodeId], gradient: &[DVec3], stiffness: f64| {
        let own = |i: usize| cluster[nodes[i].index()];
        let with = |i: usize, j: usize| i == j || own(i).is_some() && own(i) == own(j);
        let of = |i: usize| {
            let is_first = !(0..i).any(|j| with(i, j));
            let sum: DVec3 = (i..nodes.len()).filter(|j| with(i, *j)).map(|j| gradient[j]).sum();
            if is_first { sum.length() } else { 0.0 }
        };
        let total: f64 = (0..nodes.len()).map(of).sum();
        for i in 0..nodes.len() {
            if let Some(number) = own(i) {
                sums[number as usize] += stiffness * of(i) * total;
            }
        }
    };
    for beam in model.beams.iter().filter(|beam| numbers(&beam.nodes)) {
        let stiffness = way.softening.map_or(beam.stiffness, |soft| soft.of_beam(model, beam));
        // Any direction will do.
        add(&beam.nodes, &[DVec3::X, -DVec3::X], stiffness);
    }
    let (wrong_side, corner_angles) = way.softening.map_or((0.0, 1.0), |soft| (soft.wrong_side, soft.corner_angles));
    let wrong = way.wrong.iter().map(|wrong| (&model.creases[wrong.index()], wrong_side));
    let creases = model.creases.iter().map(|crease| (crease, 1.0)).chain(wrong);
    for (crease, share) in creases.filter(|(crease, _)| numbers(&crease.nodes)) {
        let Some(hinge) = hinge(crease.nodes.map(|n| positions[n.index()])) else { continue };
        add(&crease.nodes, &hinge.gradient, share * crease.stiffness);
    }
    for corners in model.corner_angles.iter().filter(|corners| numbers(&corners.nodes)) {
        let triangle = Triangle::new(corners.nodes.map(|n| positions[n.index()]));
        if triangle.collapsed() {
            continue;
        }
        let sides = triangle.side_vectors();
        for corner in 0..3 {
            let (next, before) = ((corner + 1) % 3, (corner + 2) % 3);
            let nodes = [corner, next, before].map(|i| corners.nodes[i]);
            let gradient = [sides[corner] + sides[before], -sides[corner], -sides[before]];
            add(&nodes, &gradient, corner_angles * model.material.k_face);
        }
    }
    for (_, nodes, triangle, area) in acting(model, positions).filter(|(_, nodes, ..)| numbers(nodes)) {
        add(&nodes, &triangle.area_gradient(), area.curvature(triangle.doubled_area()));
    }
    // Of forces of one's own nothing is known but the bounds of the nodes, which bound that of the cluster together.
    let mut of_nodes = vec![0.0; if own.is_empty() { 0 } else { cluster.len() }];
    own.iter().for_each(|own| {
        own.add_row_sums(positions, &mut of_nodes);
    });
    for (sum, number) in of_nodes.iter().zip(cluster) {
        if let Some(number) = number {
            sums[*number as usize] += sum;
        }
    }
}

/// `K_i` of every node at rest as if its beams did not resist, and that of its beams where it has nothing else.
#[must_use]
pub fn soft_sums(model: &Model) -> Vec<f64> {
    let mut sums = vec![0.0; model.node_count()];
    add_springs(false, (model, &OnTheWay::default()), &model.rest, &mut sums);
    let mut with_beams = vec![0.0; model.node_count()];
    row_sums(model, &model.rest, &mut with_beams);
    sums.iter().zip(with_beams).map(|(soft, all)| if *soft > 0.0 { *soft } else { all }).collect()
}

/// Adds what creases, corner angles and areas have.
fn add_springs(shared: bool, (model, way): (&Model, &OnTheWay), positions: &[DVec3], sums: &mut [f64]) {
    let at = |nodes: [NodeId; 4]| nodes.map(|n| positions[n.index()]);
    let of_crease = |crease: &Crease| {
        let gradient = hinge(at(crease.nodes))?.gradient.map(DVec3::length);
        Some(shares(gradient).map(|share| crease.stiffness * share))
    };
    add(shared, &model.creases, |crease| crease.nodes, of_crease, sums);
    let (wrong_side, corner_angles) = way.softening.map_or((0.0, 1.0), |soft| (soft.wrong_side, soft.corner_angles));
    for crease in way.wrong.iter().map(|wrong| &model.creases[wrong.index()]) {
        let more = of_crease(crease).map(|shares| shares.map(|share| wrong_side * share));
        add_one(crease.nodes, more, sums);
    }
    let k_face = corner_angles * model.material.k_face;
    let of_triangle = |corners: &CornerAngles| {
        let triangle = Triangle::new(corners.nodes.map(|n| positions[n.index()]));
        if triangle.collapsed() {
            return None;
        }
        let sides = triangle.side_vectors();
        let lengths = sides.map(DVec3::length);
        let mut sums = [0.0; 3];
        for corner in 0..3 {
            let (next, before) = ((corner + 1) % 3, (corner + 2) % 3);
            let gradient = [(sides[corner] + sides[before]).length(), lengths[corner], lengths[before]];
            for (place, share) in [corner, next, before].into_iter().zip(shares(gradient)) {
                sums[place] += k_face * share;
            }
        }
        Some(sums)
    };
    add(shared, &model.corner_angles, |corners| corners.nodes, of_triangle, sums);
    for (_, nodes, triangle, area) in acting(model, positions) {
        let curvature = area.curvature(triangle.doubled_area());
        let gradient = triangle.area_gradient().map(DVec3::length);
        add_one(nodes, Some(shares(gradient).map(|share| curvature * share)), sums);
    }
}

/// `|J_i| sum_j |J_j|`.
fn shares<const N: usize>(gradient: [f64; N]) -> [f64; N] {
    let total: f64 = gradient.iter().sum();
    gradient.map(|length| length * total)
}

/// Adds to the nodes of each spring what is `of` it, spring after spring.
fn add<S: Sync, const N: usize>(
    shared: bool,
    springs: &[S],
    nodes: impl Fn(&S) -> [NodeId; N],
    of: impl Fn(&S) -> Option<[f64; N]> + Sync,
    sums: &mut [f64],
) {
    if !shared {
        for spring in springs {
            add_one(nodes(spring), of(spring), sums);
        }
        return;
    }
    let mut found = Vec::with_capacity(BLOCK.min(springs.len()));
    for block in springs.chunks(BLOCK) {
        parallel::map_into(block, BLOCK / 4, &of, &mut found);
        for (spring, shares) in block.iter().zip(&found) {
            add_one(nodes(spring), *shares, sums);
        }
    }
}

fn add_one<const N: usize>(nodes: [NodeId; N], shares: Option<[f64; N]>, sums: &mut [f64]) {
    for (n, share) in nodes.into_iter().zip(shares.iter().flatten()) {
        sums[n.index()] += share;
    }
}
