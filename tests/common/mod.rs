//! What several test files share.
#![allow(dead_code, reason = "each test file uses a part of it")]

#[cfg(feature = "gpu")]
pub(crate) mod gpu;

use origami::generate::catalog;
use origami::glam::DVec3;
use origami::ids::VertexId;
use origami::pattern::{Assignment, PatternEdge};
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::{CreasePattern, Folded, Material, Model, Solver, State};

/// Which springs a model has.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Springs {
    Beams,
    Creases,
    CornerAngles,
    All,
}

impl Springs {
    /// The others as weak as the model allows, so that they cannot hide an error.
    pub(crate) fn material(self) -> Material {
        let none = Material { ea: 1e-12, k_fold: 0.0, k_facet: 0.0, k_face: 0.0, zeta: 0.45, collapse: 0.0 };
        match self {
            Self::Beams => Material { ea: 20.0, ..none },
            Self::Creases => Material { k_fold: 0.7, ..none },
            Self::CornerAngles => Material { k_face: 0.2, ..none },
            Self::All => Material::default(),
        }
    }
}

/// With the default material.
pub(crate) fn model(pattern: &CreasePattern) -> Model {
    Model::new(pattern, &Material::default()).expect("a generated pattern")
}

/// A generator's sheet with its default parameters.
pub(crate) fn made(name: &str) -> Model {
    model(&catalog::generate(name, &[]).expect("default parameters"))
}

/// From rest.
pub(crate) fn fold(model: &Model, solver: &dyn Solver, percent: f64) -> Folded {
    solver.fold(model, &State::at_rest(model), &Scene::percent(percent), &mut unwatched).expect("holds")
}

/// An edge with a letter and an angle in radians.
pub(crate) fn edge(a: u32, b: u32, assignment: Assignment, fold_angle: Option<f64>) -> PatternEdge {
    let vertices = [VertexId(a), VertexId(b)];
    PatternEdge { vertices, assignment, fold_angle, k_crease: None, ea: None, alias_of: None }
}

/// A pattern whose numbering is that of its own arrays.
pub(crate) fn pattern(vertices: Vec<DVec3>, edges: Vec<PatternEdge>, faces: &[&[u32]]) -> CreasePattern {
    CreasePattern {
        alias_of: vec![None; vertices.len()],
        vertices_in_file: vertices.len(),
        edges_in_file: edges.len(),
        faces: faces.iter().map(|face| face.iter().map(|v| VertexId(*v)).collect()).collect(),
        vertices,
        edges,
        ..CreasePattern::default()
    }
}

/// Two triangles along the edge between the last two of four points: 0 is the apex to its left, 1 that to its right.
pub(crate) fn hinge(points: [DVec3; 4], fold_angle: f64, material: &Material) -> Model {
    let edges = vec![edge(2, 3, Assignment::Valley, Some(fold_angle))];
    let pattern = pattern(points.to_vec(), edges, &[&[2, 3, 0], &[3, 2, 1]]);
    Model::new(&pattern, material).expect("two proper triangles")
}

/// The largest distance between two lists of points.
pub(crate) fn largest_distance(a: &[DVec3], b: &[DVec3]) -> f64 {
    assert_eq!(a.len(), b.len(), "lists of equal length");
    // `max` drops NaN: it must count as far away.
    a.iter().zip(b).map(|(p, q)| p.distance(*q)).fold(0.0, |far, d| if d.is_nan() { f64::INFINITY } else { far.max(d) })
}
