//! A crease pattern put into a FOLD frame.

use std::borrow::Cow;

use serde_json::{Map, Value};

use crate::fold::{Coordinates, Frame};
use crate::ids::{EdgeId, VertexId};
use crate::pattern::keys::{EA, FIXED, FOLD_ANGLE, K_CREASE};
use crate::pattern::{Assignment, CreasePattern};

/// Sets edges, letters and faces, our own keys with them.
pub(super) fn set_topology(frame: &mut Frame, pattern: &CreasePattern) {
    let edges = pattern.edges.iter().map(|edge| edge.vertices.map(|vertex| vertex.0)).collect();
    let faces = pattern.faces.iter().map(|face| face.iter().map(|vertex| vertex.0).collect()).collect();
    let letters = (0..pattern.edges.len()).map(|edge| pattern.edges[stand_in_edge(pattern, edge)].assignment.letter());
    let letters = letters.map(Cow::Borrowed).collect();
    frame.edges_vertices = Some(edges);
    frame.edges_assignment = Some(letters);
    frame.faces_vertices = Some(faces);
    set_overrides(&mut frame.extra, pattern);
}

/// Positions, one for each vertex of the pattern.
pub(super) fn coordinates(
    pattern: &CreasePattern,
    positions: &[glam::DVec3],
    write: impl Fn(glam::DVec3) -> Coordinates,
) -> Vec<Coordinates> {
    (0..positions.len()).map(|vertex| write(positions[stand_in_vertex(pattern, vertex)])).collect()
}

/// An angle that passes 180 degrees by less than this, in degrees, is flat folded: solvers come so near.
const NEARLY: f64 = 0.1;

/// Fold angles given in radians, in degrees. Boundaries have 0, as the specification wants it; others without an angle
/// have `null`. Angles beyond 180 degrees are cut off there and also kept as they are under [`FOLD_ANGLE`], unless they are so by
/// a tenth of a degree only.
pub(super) fn set_angles(frame: &mut Frame, pattern: &CreasePattern, angle: impl Fn(usize) -> Option<f64>) {
    let degrees: Vec<_> = (0..pattern.edges.len())
        .map(|edge| {
            let edge = stand_in_edge(pattern, edge);
            match angle(edge) {
                None if pattern.edges[edge].assignment == Assignment::Boundary => Some(0.0),
                angle => angle.map(to_degrees).map(flat_where_nearly),
            }
        })
        .collect();
    if frame.extra.contains_key(FOLD_ANGLE) || degrees.iter().flatten().any(|angle| angle.abs() > 180.0) {
        frame.extra.insert(FOLD_ANGLE.into(), degrees.iter().map(|&angle| optional(angle)).collect());
    }
    frame.edges_fold_angle = Some(degrees.into_iter().map(|angle| angle.map(|a| a.clamp(-180.0, 180.0))).collect());
}

/// A number for a key of our own, whole where it is.
pub(super) fn number(number: f64) -> Value {
    let whole = number as i32;
    if f64::from(whole) == number { Value::from(whole) } else { Value::from(number) }
}

fn flat_where_nearly(degrees: f64) -> f64 {
    if (180.0..180.0 + NEARLY).contains(&degrees.abs()) { 180.0_f64.copysign(degrees) } else { degrees }
}

fn optional(value: Option<f64>) -> Value {
    value.map_or(Value::Null, number)
}

/// Without the last digits where they come from the way to radians and back: 60, not 59.99999999999999.
fn to_degrees(radians: f64) -> f64 {
    let degrees = radians.to_degrees();
    let rounded = (degrees * 1e9).round() / 1e9;
    if (degrees - rounded).abs() <= 4.0 * f64::EPSILON * degrees.abs() { rounded } else { degrees }
}

fn set_overrides(extra: &mut Map<String, Value>, pattern: &CreasePattern) {
    let per_edge = |value: fn(&crate::pattern::PatternEdge) -> Option<f64>| {
        let values: Vec<_> =
            (0..pattern.edges.len()).map(|edge| value(&pattern.edges[stand_in_edge(pattern, edge)])).collect();
        values.iter().any(Option::is_some).then(|| values.into_iter().map(optional).collect())
    };
    let mut fixed = vec![false; pattern.vertices.len()];
    for vertex in &pattern.fixed {
        fixed[vertex.index()] = true;
    }
    let fixed = (!pattern.fixed.is_empty())
        .then(|| (0..fixed.len()).map(|vertex| Value::from(fixed[stand_in_vertex(pattern, vertex)])).collect());
    for (key, values) in [(K_CREASE, per_edge(|edge| edge.k_crease)), (EA, per_edge(|edge| edge.ea)), (FIXED, fixed)] {
        match values {
            Some(values) => extra.insert(key.into(), values),
            None => extra.shift_remove(key),
        };
    }
}

/// The vertex that stands for `vertex`, itself unless it was merged into another.
fn stand_in_vertex(pattern: &CreasePattern, vertex: usize) -> usize {
    let alias = pattern.alias_of.get(vertex).copied().flatten();
    alias.map_or(vertex, VertexId::index)
}

/// The edge that stands for `edge`, itself unless the file has it twice.
fn stand_in_edge(pattern: &CreasePattern, edge: usize) -> usize {
    pattern.edges[edge].alias_of.map_or(edge, EdgeId::index)
}
