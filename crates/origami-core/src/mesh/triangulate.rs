//! Faces cut into triangles. Which diagonals are chosen decides how a face bends, so the rules are fixed:
//! triangles stay, quadrilaterals get the shorter diagonal (the one from the first corner on a tie), larger faces a
//! constrained Delaunay triangulation in their own plane.

use std::collections::HashSet;

use glam::{DVec2, DVec3};

use crate::error::{Error, ErrorCode, Place};
use crate::ids::{FaceId, VertexId};
use crate::pattern::CreasePattern;
use crate::pattern::plane::{Plane, SLIVER, area_vector, flatness, unit_scale};
use crate::pattern::point_grid::PointGrid;
use crate::pattern::region::{self, Fault};

/// The faces of a pattern in triangles, in the order of the faces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Triangulation {
    /// Corners, in the orientation of the face.
    pub triangles: Vec<[VertexId; 3]>,
    /// The face that each triangle is a part of.
    pub face_of: Vec<FaceId>,
}

/// Diagonals as long as each other but for this share are a tie.
const TIE: f64 = 1e-9;
/// Corners nearer than this, in sizes of the pattern, are at one position (the two lips of a slit).
const ONE_PLACE: f64 = 1e-12;
/// Faces smaller than this, in squared sizes, have no area.
const SMALLEST: f64 = 1e-14;

/// Cuts every face of `pattern` into triangles, without new vertices.
///
/// # Errors
/// [`Error::Invalid`] for a face that crosses itself or has a corner on one of its own sides, for corners that do not
/// exist, and for a pattern whose size is zero or not finite.
pub fn triangulate(pattern: &CreasePattern) -> Result<Triangulation, Error> {
    let size = pattern.size();
    if !(size > 0.0 && size.is_finite()) {
        let (place, problem) = (Place::key("vertices_coords"), format!("the pattern is {size} in size"));
        return Err(Error::new(ErrorCode::SheetSize, place, problem, "a positive size"));
    }
    let flat = pattern.is_flat();
    let scale = unit_scale(size);
    let points: Vec<DVec3> = pattern.vertices.iter().map(|&vertex| vertex * scale).collect();
    let mut result = Triangulation::default();
    for (index, face) in pattern.faces.iter().enumerate() {
        let refuse = |code, problem: String, expected: &str| {
            Error::new(code, Place::entry("faces_vertices", index), problem, expected)
        };
        let broken = |fault: Fault| refuse(ErrorCode::FaceNotSimple, format!("the face {fault}"), "a simple polygon");
        let place = |vertex: &VertexId| points.get(vertex.index()).copied();
        let corners: Option<Vec<DVec3>> = face.iter().map(place).collect();
        let missing = || refuse(ErrorCode::NoSuchVertex, "names a vertex that does not exist".into(), "vertices");
        let corners = corners.ok_or_else(missing)?;
        let triangles = match corners.as_slice() {
            [_, _, _] => vec![[0, 1, 2]],
            [a, b, c, d] => quadrilateral([*a, *b, *c, *d], flat).map_err(broken)?.into(),
            [_, _, _, ..] => {
                let triangles = polygon(&corners, flat).map_err(broken)?;
                if !has_all_sides(face, &triangles) {
                    return Err(broken(Fault::Touches));
                }
                triangles
            }
            _ => {
                let problem = format!("has {} corners", corners.len());
                return Err(refuse(ErrorCode::FaceOfFewCorners, problem, "three or more"));
            }
        };
        result.face_of.extend(std::iter::repeat_n(FaceId::new(index), triangles.len()));
        result.triangles.extend(triangles.into_iter().map(|corners| corners.map(|corner| face[corner])));
    }
    Ok(result)
}

type Corners = [usize; 3];

/// Two triangles, by the shorter diagonal that lies inside.
fn quadrilateral(corners: [DVec3; 4], flat: bool) -> Result<[Corners; 2], Fault> {
    let plane = Plane::new(area_vector(corners), flat);
    let points = corners.map(|corner| plane.project(corner));
    let [a, b, c, d] = corners;
    let from_first = [[0, 1, 2], [0, 2, 3]];
    let from_second = [[0, 1, 3], [1, 2, 3]];
    let flattest =
        |split: &[Corners; 2]| split.map(|t| flatness(&points, t).0).into_iter().fold(f64::INFINITY, f64::min);
    let order = if a.distance(c) <= b.distance(d) * (1.0 + TIE) {
        [from_first, from_second]
    } else {
        [from_second, from_first]
    };
    if order.iter().all(|split| flattest(split) < -SLIVER) {
        return Err(Fault::Crosses);
    }
    let inside = order.into_iter().find(|split| flattest(split) > SLIVER);
    Ok(inside.unwrap_or(order[0]))
}

/// Triangles of a face with more corners; it may touch itself at corners and run to and fro along a line.
fn polygon(corners: &[DVec3], flat: bool) -> Result<Vec<Corners>, Fault> {
    let normal = area_vector(corners.iter().copied());
    if 0.5 * normal.length() < SMALLEST {
        return Ok((2..corners.len()).map(|corner| [0, corner - 1, corner]).collect());
    }
    let plane = Plane::new(normal, flat);
    let mut points: Vec<DVec2> = corners.iter().map(|&corner| plane.project(corner)).collect();
    let mut grid = PointGrid::new(points.iter().fold(DVec2::INFINITY, |low, &p| low.min(p)), ONE_PLACE, points.len());
    for corner in 0..points.len() {
        match grid.find(points[corner]) {
            Some(first) => points[corner] = points[first as usize],
            None => grid.insert(corner as u32, points[corner]),
        }
    }
    region::triangulate(&[points])
}

/// Whether each side of the face is a side of a triangle. It is not where parts of a face hang together by two vertices
/// at one position.
fn has_all_sides(face: &[VertexId], triangles: &[Corners]) -> bool {
    let sides: HashSet<[VertexId; 2]> = triangles
        .iter()
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|side| side.map(|corner| face[corner]))
        .collect();
    face.iter().zip(face.iter().cycle().skip(1)).all(|(&a, &b)| sides.contains(&[a, b]))
}
