//! The faces as the file gives them.

use super::draft::{Draft, EdgeMap};
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::pattern::plane::{area_vector, extent, radius};

/// Edges shorter than this, in sizes of the pattern, have no length.
const SHORTEST: f64 = 1e-12;
/// Faces smaller than this, in squared sizes, have no area.
pub(super) const SMALLEST: f64 = 1e-14;
/// Faces thinner than this, in radii of the sheet, get no springs: the limit of the model.
const THIN: f64 = 1e-6;

/// Takes over `faces`, and lets one edge stand for all that have the same ends.
pub(super) fn take(draft: &mut Draft, faces: &[Vec<u32>]) -> Result<EdgeMap, Error> {
    let map = merge_edges(draft)?;
    let thin = THIN * radius(&draft.points);
    for (index, face) in faces.iter().enumerate() {
        check_corners(draft, face, index)?;
        check_area(draft, face, index, thin)?;
    }
    draft.faces = faces.to_vec();
    Ok(map)
}

fn merge_edges(draft: &mut Draft) -> Result<EdgeMap, Error> {
    for (index, edge) in draft.edges.iter().enumerate() {
        let [a, b] = edge.ends.map(|v| draft.points[v as usize]);
        if a.distance(b) < SHORTEST {
            let problem = format!("vertices {} and {} lie at one place", edge.ends[0], edge.ends[1]);
            let place = Place::entry("edges_vertices", index);
            return Err(Error::new(ErrorCode::EdgeWithoutLength, place, problem, "an edge with a length"));
        }
    }
    let map = EdgeMap::new(draft.points.len(), &draft.edges);
    for index in 0..draft.edges.len() {
        if let Some(first) = map.get(draft.edges[index].ends).filter(|first| *first != index) {
            let other = draft.edges[index].clone();
            draft.absorb(first, &other);
            draft.edges[index].alias = Some(first as u32);
        }
    }
    Ok(map)
}

fn check_corners(draft: &Draft, face: &[u32], index: usize) -> Result<(), Error> {
    let refuse = |code, problem, expected: &str| Err(Error::new(code, place(index), problem, expected));
    let vertices = draft.points.len();
    if let Some(&vertex) = face.iter().find(|&&vertex| vertex as usize >= vertices) {
        let code = ErrorCode::NoSuchVertex;
        return refuse(code, format!("vertex {vertex} does not exist"), &format!("numbers below {vertices}"));
    }
    let distinct = distinct(face);
    if distinct < 3 {
        return refuse(ErrorCode::FaceOfFewCorners, format!("has {distinct} different vertices"), "three or more");
    }
    let points = &draft.points;
    for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)) {
        if a == b {
            return refuse(ErrorCode::CornerTwice, format!("names vertex {a} twice in a row"), "each corner once");
        }
        if points[a as usize].distance(points[b as usize]) < SHORTEST {
            return refuse(
                ErrorCode::EdgeWithoutLength,
                format!("vertices {a} and {b} lie at one place"),
                "sides with a length",
            );
        }
    }
    Ok(())
}

fn check_area(draft: &mut Draft, face: &[u32], index: usize, thin: f64) -> Result<(), Error> {
    let corners: Vec<_> = face.iter().map(|&v| draft.points[v as usize]).collect();
    let area = 0.5 * area_vector(corners.iter().copied()).length();
    if area < SMALLEST {
        if distinct(face) < face.len() {
            return Err(Error::new(ErrorCode::FaceWithoutArea, place(index), "encloses no area", "a polygon"));
        }
        draft.notes.add(
            WarningCode::FaceWithoutArea,
            "faces_vertices",
            index,
            "face without area; its folds have no direction",
        );
        return Ok(());
    }
    let height = match corners.as_slice() {
        &[a, b, c] => 2.0 * area / a.distance(b).max(b.distance(c)).max(c.distance(a)),
        more => area / extent(more).length(),
    };
    if height < thin {
        let message = "thinner than 1e-6 of the sheet's radius; its springs are left out";
        draft.notes.add(WarningCode::ThinFace, "faces_vertices", index, message);
    }
    Ok(())
}

fn place(index: usize) -> Place {
    Place::entry("faces_vertices", index)
}

/// How many different vertices a face has.
fn distinct(face: &[u32]) -> usize {
    let mut distinct = face.to_vec();
    distinct.sort_unstable();
    distinct.dedup();
    distinct.len()
}

#[cfg(test)]
mod tests {
    #[test]
    fn what_is_too_thin_for_the_model_is_warned_of() {
        assert_eq!(super::THIN, crate::model::DEGENERATE);
    }
}
