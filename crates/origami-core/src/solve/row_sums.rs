//! A bound on the stiffness that each node feels, by one pass over the elements.
//!
//! With `J_ei` the gradient of element e's length or angle at node i, the stiffness matrix is bounded row by row by
//! `K_i = sum over e at i of k_e |J_ei| sum_j |J_ej|`; beams give 2k. Valence, thin triangles, creases and corner angles
//! are all in it, where the paper's rule (2.5) looks at one beam at a time.

use glam::DVec3;

use crate::forces::corner_angles::Triangle;
use crate::forces::creases::hinge;
use crate::model::Model;

/// Writes `K_i` of every node at `positions`; all above 0, as every node has a beam.
pub fn row_sums(model: &Model, positions: &[DVec3], sums: &mut [f64]) {
    sums.fill(0.0);
    for beam in &model.beams {
        for n in beam.nodes {
            sums[n.index()] += 2.0 * beam.stiffness;
        }
    }
    add_springs(model, positions, sums);
}

/// `K_i` of every node at rest as if its beams did not resist, and that of its beams where it has nothing else.
#[must_use]
pub fn soft_sums(model: &Model) -> Vec<f64> {
    let mut sums = vec![0.0; model.node_count()];
    add_springs(model, &model.rest, &mut sums);
    let mut with_beams = vec![0.0; model.node_count()];
    row_sums(model, &model.rest, &mut with_beams);
    sums.iter().zip(with_beams).map(|(soft, all)| if *soft > 0.0 { *soft } else { all }).collect()
}

/// Adds what creases and corner angles have.
fn add_springs(model: &Model, positions: &[DVec3], sums: &mut [f64]) {
    for crease in &model.creases {
        let nodes = crease.nodes.map(|n| n.index());
        if let Some(hinge) = hinge(nodes.map(|n| positions[n])) {
            add(sums, &nodes, &hinge.gradient.map(DVec3::length), crease.stiffness);
        }
    }
    for corners in &model.corner_angles {
        let nodes = corners.nodes.map(|n| n.index());
        let triangle = Triangle::new(nodes.map(|n| positions[n]));
        if triangle.collapsed() {
            continue;
        }
        let sides = triangle.side_vectors();
        let lengths = sides.map(DVec3::length);
        for corner in 0..3 {
            let (next, before) = (corner, (corner + 2) % 3);
            let gradient = [(sides[next] + sides[before]).length(), lengths[next], lengths[before]];
            let places = [nodes[corner], nodes[(corner + 1) % 3], nodes[before]];
            add(sums, &places, &gradient, model.material.k_face);
        }
    }
}

fn add(sums: &mut [f64], nodes: &[usize], gradient: &[f64], stiffness: f64) {
    let total: f64 = gradient.iter().sum();
    for (n, g) in nodes.iter().zip(gradient) {
        sums[*n] += stiffness * g * total;
    }
}
