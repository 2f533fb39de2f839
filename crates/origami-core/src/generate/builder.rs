//! Makes a [`CreasePattern`] from faces and creases: what is not said to be a crease is flat, or the border.

use std::collections::HashMap;

use glam::DVec3;

use crate::error::Error;
use crate::ids::VertexId;
use crate::pattern::{Assignment, CreasePattern, PatternEdge, fold_angle};

/// The most vertices that a generator makes; some gigabytes of pattern.
const MAX_VERTICES: usize = 1 << 24;

/// A sheet in the making.
#[derive(Default)]
pub(super) struct SheetBuilder {
    vertices: Vec<DVec3>,
    faces: Vec<Vec<VertexId>>,
    edges: Vec<PatternEdge>,
    /// How many faces each edge has.
    uses: Vec<u32>,
    /// The edge between two vertices, the lower one first.
    between: HashMap<[VertexId; 2], usize>,
}

impl SheetBuilder {
    /// Adds a vertex at rest at `position`.
    pub(super) fn vertex(&mut self, position: DVec3) -> VertexId {
        let id = VertexId::new(self.vertices.len());
        self.vertices.push(position);
        id
    }

    /// Adds a vertex at rest in the plane z = 0.
    pub(super) fn at(&mut self, x: f64, y: f64) -> VertexId {
        self.vertex(DVec3::new(x, y, 0.0))
    }

    /// Adds a face, counterclockwise.
    pub(super) fn face(&mut self, corners: &[VertexId]) {
        for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let edge = self.edge(a, b);
            self.uses[edge] += 1;
        }
        self.faces.push(corners.to_vec());
    }

    /// Folds the edge by `angle`, whose sign is its letter. The border stays border.
    pub(super) fn crease(&mut self, a: VertexId, b: VertexId, angle: f64) {
        let edge = self.edge(a, b);
        self.edges[edge].assignment = letter(angle);
        self.edges[edge].fold_angle = Some(angle);
    }

    /// Makes the edge a hinge without a spring.
    pub(super) fn free(&mut self, a: VertexId, b: VertexId) {
        let edge = self.edge(a, b);
        self.edges[edge].assignment = Assignment::Unassigned;
        self.edges[edge].fold_angle = None;
    }

    /// Makes every edge so far a hinge without a spring.
    pub(super) fn free_all(&mut self) {
        for edge in &mut self.edges {
            edge.assignment = Assignment::Unassigned;
            edge.fold_angle = None;
        }
    }

    /// Folds every edge between two triangles by the angle that it has when the vertices are at `space`.
    pub(super) fn fold_to(&mut self, space: &[DVec3]) {
        let mut sides = Vec::new();
        for face in &self.faces {
            let &[a, b, c] = face.as_slice() else { continue };
            for [a, b, c] in [[a, b, c], [b, c, a], [c, a, b]] {
                sides.push(([a.min(b), a.max(b)], [a, b, c].map(|v| space[v.index()])));
            }
        }
        sides.sort_by_key(|(ends, _)| *ends);
        for pair in sides.windows(2) {
            if let [(one, [from, to, left]), (other, [_, _, right])] = pair
                && one == other
            {
                self.crease(one[0], one[1], fold_angle(*left, *right, *from, *to));
            }
        }
    }

    fn edge(&mut self, a: VertexId, b: VertexId) -> usize {
        *self.between.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            self.edges.push(PatternEdge {
                vertices: [a, b],
                assignment: Assignment::Flat,
                fold_angle: Some(0.0),
                k_crease: None,
                ea: None,
                alias_of: None,
            });
            self.uses.push(0);
            self.edges.len() - 1
        })
    }

    /// The finished pattern: edges with one face become the border.
    pub(super) fn finish(mut self) -> CreasePattern {
        for (edge, &uses) in self.edges.iter_mut().zip(&self.uses) {
            if uses < 2 {
                edge.assignment = Assignment::Boundary;
                edge.fold_angle = None;
            }
        }
        CreasePattern {
            alias_of: vec![None; self.vertices.len()],
            vertices_in_file: self.vertices.len(),
            edges_in_file: self.edges.len(),
            vertices: self.vertices,
            edges: self.edges,
            faces: self.faces,
            ..CreasePattern::default()
        }
    }
}

/// The letter of a crease that folds by `angle`.
fn letter(angle: f64) -> Assignment {
    if angle > 0.0 {
        Assignment::Valley
    } else if angle < 0.0 {
        Assignment::Mountain
    } else {
        Assignment::Flat
    }
}

fn refused(name: &str, value: impl std::fmt::Display, expected: impl Into<String>) -> Error {
    Error::invalid(format!("parameter {name}"), format!("is {value}"), expected)
}

/// A length must be positive, and such that its powers are finite and not 0.
pub(super) fn positive(name: &str, value: f64) -> Result<(), Error> {
    let sound = (1e-60..=1e60).contains(&value);
    if sound { Ok(()) } else { Err(refused(name, value, "a number from 1e-60 to 1e60")) }
}

/// An angle in radians must lie strictly between `low` and `high`.
pub(super) fn between(name: &str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    let sound = value > low && value < high;
    if sound { Ok(()) } else { Err(refused_angle(name, value, format!("above {} and below {}", deg(low), deg(high)))) }
}

/// An angle in radians must lie in `low..=high`.
pub(super) fn within(name: &str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    let sound = value >= low && value <= high;
    if sound { Ok(()) } else { Err(refused_angle(name, value, format!("from {} to {}", deg(low), deg(high)))) }
}

/// A share must lie in `low..=high`.
pub(super) fn share(name: &str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    let sound = value >= low && value <= high;
    if sound { Ok(()) } else { Err(refused(name, value, format!("a number from {low} to {high}"))) }
}

fn refused_angle(name: &str, value: f64, expected: String) -> Error {
    refused(name, deg(value), format!("an angle {expected}"))
}

/// For messages: nine decimals hide the rounding of the unit.
fn deg(radians: f64) -> String {
    format!("{} degrees", (radians.to_degrees() * 1e9).round() / 1e9)
}

/// A count must be at least `least`.
pub(super) fn at_least(name: &str, value: usize, least: usize) -> Result<(), Error> {
    if value >= least { Ok(()) } else { Err(refused(name, value, format!("a whole number from {least}"))) }
}

/// Refuses a grid of more than [`MAX_VERTICES`], `names` being the counts that make it so large.
pub(super) fn room(names: &str, sides: [usize; 2], vertices_each: usize) -> Result<(), Error> {
    let cells = sides.iter().try_fold(vertices_each, |product, side| product.checked_mul(side.checked_add(2)?));
    match cells {
        Some(vertices) if vertices <= MAX_VERTICES => Ok(()),
        _ => Err(Error::invalid(
            format!("parameter {names}"),
            match names.contains(',') {
                true => format!("are {} and {}, too large a sheet", sides[0], sides[1]),
                false => format!("is {}, too large a sheet", sides[0]),
            },
            format!("at most {MAX_VERTICES} vertices"),
        )),
    }
}
