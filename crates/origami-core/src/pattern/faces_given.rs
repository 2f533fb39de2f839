//! The faces as the file gives them.

use super::draft::{Draft, EdgeMap};
use super::plane::area_vector;
use crate::error::Error;

/// Edges shorter than this, in sizes of the pattern, have no length.
const SHORTEST: f64 = 1e-12;
/// Faces smaller than this, in squared sizes, have no area.
const SMALLEST: f64 = 1e-14;

/// Takes over `faces`, and lets one edge stand for all that have the same ends.
pub(super) fn take(draft: &mut Draft, faces: &[Vec<u32>]) -> Result<EdgeMap, Error> {
    let map = merge_edges(draft)?;
    for (index, face) in faces.iter().enumerate() {
        check_corners(draft, face, index)?;
    }
    draft.faces = faces.to_vec();
    Ok(map)
}

fn merge_edges(draft: &mut Draft) -> Result<EdgeMap, Error> {
    let mut map = EdgeMap::default();
    for index in 0..draft.edges.len() {
        let ends = draft.edges[index].ends;
        let [a, b] = ends.map(|v| draft.points[v as usize]);
        if a.distance(b) < SHORTEST {
            let problem = format!("vertices {} and {} lie at one place", ends[0], ends[1]);
            return Err(Error::invalid(format!("edges_vertices[{index}]"), problem, "an edge with a length"));
        }
        if let Some(first) = map.enter(ends, index) {
            let other = draft.edges[index].clone();
            draft.absorb(first, &other);
            draft.edges[index].alias = Some(first as u32);
        }
    }
    Ok(map)
}

fn check_corners(draft: &mut Draft, face: &[u32], index: usize) -> Result<(), Error> {
    let refuse = |problem: String, expected: &str| {
        Err(Error::invalid(format!("faces_vertices[{index}]"), problem, expected)) //
    };
    let vertices = draft.points.len();
    if let Some(&vertex) = face.iter().find(|&&vertex| vertex as usize >= vertices) {
        return refuse(format!("vertex {vertex} does not exist"), &format!("numbers below {vertices}"));
    }
    let mut distinct = face.to_vec();
    distinct.sort_unstable();
    distinct.dedup();
    if distinct.len() < 3 {
        return refuse(format!("has {} different vertices", distinct.len()), "three or more");
    }
    let points = &draft.points;
    for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)) {
        if a == b {
            return refuse(format!("names vertex {a} twice in a row"), "each corner once");
        }
        if points[a as usize].distance(points[b as usize]) < SHORTEST {
            return refuse(format!("vertices {a} and {b} lie at one place"), "sides with a length");
        }
    }
    let area = 0.5 * area_vector(face.iter().map(|&v| points[v as usize])).length();
    if area < SMALLEST {
        if distinct.len() < face.len() {
            return refuse("encloses no area".into(), "a polygon");
        }
        draft.notes.add("faces_vertices", index, "face without area; its folds have no direction");
    }
    Ok(())
}
