//! Constrained Delaunay triangulation of a region of the plane that is given by its outlines.

use std::collections::{HashMap, VecDeque};
use std::fmt;

use glam::DVec2;
use spade::handles::{DirectedEdgeHandle, FixedVertexHandle};
use spade::{CdtEdge, ConstrainedDelaunayTriangulation, Point2, Triangulation};

use super::plane::{SLIVER, flatness};

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Directed<'a> = DirectedEdgeHandle<'a, Point2<f64>, (), CdtEdge<()>, ()>;

/// Why a region cannot be triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// Two sides cross, or the outline winds around twice.
    Crosses,
    /// A corner lies on a side, or two corners in a row at one position.
    Touches,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Crosses => "crosses itself",
            Self::Touches => "touches itself between corners",
        })
    }
}

const NONE: u32 = u32::MAX;
/// Regions of so many corners are not triangulated point by point.
const MANY: usize = 1000;

/// Triangles of the region to the left of `outlines`: one counterclockwise outline, and a clockwise one around each
/// island. Corners are numbered through all outlines.
///
/// Outlines may visit a position several times, and run along a line twice, to and fro (a slit, a dangling crease). Then
/// each triangle names the visit that it belongs to; only where two parts hang together by one point, which visit is
/// named is not defined. Coordinates must be near one in size.
pub(crate) fn triangulate(outlines: &[Vec<DVec2>]) -> Result<Vec<[usize; 3]>, Fault> {
    let points: Vec<DVec2> = outlines.concat();
    let next = followers(outlines);
    let (cdt, handles) = delaunay(&points, &next)?;
    let owner = owners(&cdt, &handles, &next)?;
    let inside = inside(&cdt, &owner)?;
    let mut triangles = Vec::with_capacity(points.len());
    for face in cdt.inner_faces().filter(|face| inside[face.fix().index()]) {
        let [a, b, c] = face.adjacent_edges().map(|edge| corner(edge, &owner));
        triangles.push([a.ok_or(Fault::Touches)?, b.ok_or(Fault::Touches)?, c.ok_or(Fault::Touches)?]);
    }
    flip_slivers(&points, &next, &mut triangles);
    Ok(triangles)
}

/// The corner after each corner.
fn followers(outlines: &[Vec<DVec2>]) -> Vec<usize> {
    let mut next = Vec::new();
    for outline in outlines {
        let first = next.len();
        next.extend((0..outline.len()).map(|corner| first + (corner + 1) % outline.len()));
    }
    next
}

/// The triangulation with all sides in it, and the vertex of each corner.
fn delaunay(points: &[DVec2], next: &[usize]) -> Result<(Cdt, Vec<FixedVertexHandle>), Fault> {
    let (mut cdt, handles) = vertices(points)?;
    for (&from, &next) in handles.iter().zip(next) {
        let to = handles[next];
        if from == to {
            return Err(Fault::Touches);
        }
        if !cdt.can_add_constraint(from, to) {
            return Err(Fault::Crosses);
        }
        cdt.add_constraint(from, to);
    }
    Ok((cdt, handles))
}

/// The triangulation of the points alone, and the vertex of each.
fn vertices(points: &[DVec2]) -> Result<(Cdt, Vec<FixedVertexHandle>), Fault> {
    let points = points.iter().map(|point| spade::mitigate_underflow(Point2::new(point.x, point.y)));
    let mut cdt = Cdt::new();
    if points.len() >= MANY {
        // All at once: one by one, the outlines of long combs take the square of their length.
        cdt = Cdt::bulk_load(points.clone().collect()).map_err(|_| Fault::Touches)?;
    }
    // Those that are there already get their vertex.
    let handles = points.map(|point| cdt.insert(point).map_err(|_| Fault::Touches)).collect::<Result<_, _>>()?;
    Ok((cdt, handles))
}

/// For each directed edge of the triangulation the corner from which an outline runs along it.
fn owners(cdt: &Cdt, handles: &[FixedVertexHandle], next: &[usize]) -> Result<Vec<u32>, Fault> {
    let mut owner = vec![NONE; cdt.num_directed_edges()];
    for (corner, &next) in next.iter().enumerate() {
        let edge = cdt.get_edge_from_neighbors(handles[corner], handles[next]).ok_or(Fault::Touches)?;
        if std::mem::replace(&mut owner[edge.fix().index()], corner as u32) != NONE {
            return Err(Fault::Crosses);
        }
    }
    Ok(owner)
}

/// Whether each face lies inside: the outlines wind around it once.
fn inside(cdt: &Cdt, owner: &[u32]) -> Result<Vec<bool>, Fault> {
    let mut winding: Vec<Option<i32>> = vec![None; cdt.num_all_faces()];
    let count = |edge: Directed<'_>| i32::from(owner[edge.fix().index()] != NONE);
    let outer = cdt.outer_face().fix().index();
    winding[outer] = Some(0);
    let mut stack: Vec<_> = cdt.directed_edges().filter(|edge| edge.face().is_outer()).collect();
    while let Some(edge) = stack.pop() {
        let across = edge.rev().face();
        let Some(here) = winding[edge.face().fix().index()] else { continue };
        let there = here - count(edge) + count(edge.rev());
        match winding[across.fix().index()] {
            None => {
                winding[across.fix().index()] = Some(there);
                if let Some(face) = across.as_inner() {
                    stack.extend(face.adjacent_edges());
                }
            }
            Some(known) if known != there => return Err(Fault::Crosses),
            Some(_) => {}
        }
    }
    let inside = |winding: &Option<i32>| match winding {
        Some(0) => Ok(false),
        Some(1) => Ok(true),
        _ => Err(Fault::Crosses),
    };
    winding.iter().map(inside).collect()
}

/// The visit of an outline to the start of `edge` that has the triangle on the left of `edge` on its inner side:
/// turning clockwise from there, the first side met starts at it.
fn corner(edge: Directed<'_>, owner: &[u32]) -> Option<usize> {
    let mut at = edge;
    loop {
        let corner = owner[at.fix().index()];
        if corner != NONE {
            return Some(corner as usize);
        }
        at = at.cw();
        if at == edge {
            return None;
        }
    }
}

/// Corners that lie on a line but for rounding leave triangles of no height: flips their longest sides.
fn flip_slivers(points: &[DVec2], next: &[usize], triangles: &mut [[usize; 3]]) {
    let flat = |triangle: &[usize; 3]| flatness(points, *triangle).0 < SLIVER;
    let mut queue: VecDeque<usize> = (0..triangles.len()).filter(|&t| flat(&triangles[t])).collect();
    if queue.is_empty() {
        return;
    }
    let sides = |t: usize, [a, b, c]: [usize; 3]| [((a, b), t), ((b, c), t), ((c, a), t)];
    let mut at: HashMap<(usize, usize), usize> =
        triangles.iter().enumerate().flat_map(|(t, &triangle)| sides(t, triangle)).collect();
    let mut budget = 16 * triangles.len();
    while let (Some(t), true) = (queue.pop_front(), budget > 0) {
        budget -= 1;
        let triangle = triangles[t];
        let (height, apex) = flatness(points, triangle);
        let [c, a, b] = [0, 1, 2].map(|step| triangle[(apex + step) % 3]);
        let Some(&other) = at.get(&(b, a)) else { continue };
        if height >= SLIVER || next[a] == b || next[b] == a {
            continue;
        }
        let Some(&d) = triangles[other].iter().find(|&&corner| corner != a && corner != b) else { continue };
        let (one, two) = ([c, a, d], [d, b, c]);
        let worst = |t: [[usize; 3]; 2]| t.map(|t| flatness(points, t).0).into_iter().fold(f64::INFINITY, f64::min);
        if worst([one, two]) <= worst([triangle, triangles[other]]) {
            continue;
        }
        at.remove(&(a, b));
        at.remove(&(b, a));
        (triangles[t], triangles[other]) = (one, two);
        at.extend(sides(t, one).into_iter().chain(sides(other, two)));
        let beside = [one, two].into_iter().flat_map(|[a, b, c]| [(b, a), (c, b), (a, c)]);
        let around: Vec<usize> = beside.filter_map(|side| at.get(&side).copied()).collect();
        queue.extend(around.into_iter().chain([t, other]).filter(|&t| flat(&triangles[t])));
    }
}
