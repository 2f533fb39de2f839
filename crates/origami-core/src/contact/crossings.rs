//! The exact test: which edges of triangles go through other triangles.

use glam::DVec3;
use robust::Coord3D;

use super::boxes::{Bounds, BoxTree};
use crate::ids::{FaceId, NodeId, SideId, TriangleId};
use crate::mesh::Mesh;
use crate::parallel;

/// Sides that one task looks at.
const TASK: usize = 256;

/// A side of the triangulation that goes through a triangle with which it has no node in common.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Crossing {
    /// The side.
    pub side: SideId,
    /// The triangle that it goes through.
    pub triangle: TriangleId,
    /// Where, in the unit of the positions.
    pub point: DVec3,
    /// How far the side would have to be moved to be clear of the triangle, in that unit: straight along the triangle's normal, or
    /// within its plane over the nearest edge.
    pub depth: f64,
}

/// Where the paper of a state goes through itself.
///
/// The test is exact: the signs of the determinants are those of the positions as they are, to the last bit
/// ([`robust::orient3d`]). What touches does not cross: an edge that ends in a triangle's plane or meets its border, and layers
/// in one plane, which a flat-folded sheet has. Two triangles that cross do so along a line that begins and ends where an edge
/// of one goes through the other, so that nothing is overlooked; those that share a corner cross where the side opposite to it
/// does.
///
/// ```
/// use origami_core::{Material, Model, Relax, Solver, contact::Crossings, generate::catalog};
///
/// let model = Model::new(&catalog::generate("miura", &[])?, &Material::default())?;
/// let half = Relax::default().fold_from_rest(&model, 60.0)?;
/// assert!(Crossings::of(&model.mesh, &half.state.positions).is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Crossings {
    /// All of them, in the order of their sides, then of their triangles.
    pub all: Vec<Crossing>,
    /// The faces of the pattern that cross, each pair once with the lower first, in order. A face that was cut into triangles
    /// may cross itself.
    pub faces: Vec<[FaceId; 2]>,
}

impl Crossings {
    /// Those of a sheet with its nodes at `positions`, in radii or any other unit. The same list for any number of threads.
    ///
    /// Lines outside all faces are no paper and cross nothing.
    ///
    /// # Panics
    /// If there are fewer positions than nodes.
    #[must_use]
    pub fn of(mesh: &Mesh, positions: &[DVec3]) -> Self {
        let corners = |nodes: &[NodeId; 3]| nodes.map(|n| positions[n.index()]);
        let boxes: Vec<Bounds> = mesh.triangles.iter().map(|nodes| Bounds::around(corners(nodes))).collect();
        let tree = BoxTree::new(&boxes);
        let paper = |side: &usize| mesh.sides[*side].triangles.iter().any(Option::is_some);
        let sides: Vec<usize> = (0..mesh.sides.len()).filter(paper).collect();
        let tasks: Vec<&[usize]> = sides.chunks(TASK).collect();
        let found = parallel::map(&tasks, |_, task| {
            let mut found = Vec::new();
            for &side in *task {
                let nodes = mesh.sides[side].nodes;
                let ends = nodes.map(|n| positions[n.index()]);
                let first = found.len();
                tree.near(&Bounds::around(ends), |triangle| {
                    let others = &mesh.triangles[triangle];
                    if nodes.iter().any(|node| others.contains(node)) {
                        return;
                    }
                    let crossing = passes_through(ends, corners(others)).map(|(point, depth)| {
                        let (side, triangle) = (SideId::new(side), TriangleId::new(triangle));
                        Crossing { side, triangle, point, depth }
                    });
                    found.extend(crossing);
                });
                found[first..].sort_unstable_by_key(|crossing| crossing.triangle);
            }
            found
        });
        let all: Vec<Crossing> = found.into_iter().flatten().collect();
        let faces = faces(mesh, &all);
        Self { all, faces }
    }

    /// Whether nothing crosses.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// The depth of the deepest, in the unit of the positions; 0 where there is none. A sheet that is folded flat by a solver has its layers in one
    /// plane but for the solver's tolerance, and crosses itself no deeper than that.
    #[must_use]
    pub fn deepest(&self) -> f64 {
        self.all.iter().map(|crossing| crossing.depth).fold(0.0, f64::max)
    }
}

/// The faces that cross, each pair once.
fn faces(mesh: &Mesh, all: &[Crossing]) -> Vec<[FaceId; 2]> {
    let face = |triangle: TriangleId| mesh.face_of_triangle[triangle.index()];
    let pairs = all.iter().flat_map(|crossing| {
        let through = face(crossing.triangle);
        let own = mesh.sides[crossing.side.index()].triangles.into_iter().flatten();
        own.map(move |triangle| {
            let own = face(triangle);
            [own.min(through), own.max(through)]
        })
    });
    let mut pairs: Vec<[FaceId; 2]> = pairs.collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

/// Whether the line between `ends` passes through the inside of a triangle: the point, and how deep.
fn passes_through(ends: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> Option<(DVec3, f64)> {
    let [p, q] = ends;
    let opposite = |x: f64, y: f64| (x > 0.0 && y < 0.0) || (x < 0.0 && y > 0.0);
    let alike = |x: f64, y: f64| (x > 0.0 && y > 0.0) || (x < 0.0 && y < 0.0);
    if !opposite(side_of_plane(a, b, c, p), side_of_plane(a, b, c, q)) {
        return None;
    }
    let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[from, to]| side_of_plane(p, q, from, to));
    (alike(ab, bc) && alike(bc, ca)).then(|| measured(ends, [a, b, c]))
}

/// The sign is that of the volume between three points and a fourth, without any rounding.
fn side_of_plane(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> f64 {
    let [a, b, c, d] = [a, b, c, d].map(|p| Coord3D { x: p.x, y: p.y, z: p.z });
    robust::orient3d(a, b, c, d)
}

/// Where a line that passes through a triangle does so, and how deep; rounded, as the test itself is not.
fn measured([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3]) -> (DVec3, f64) {
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let [above, below] = [p, q].map(|end| normal.dot(end - a).abs());
    let sum = above + below;
    let point = if sum > 0.0 { p + (q - p) * (above / sum) } else { 0.5 * (p + q) };
    let from_edge = |[from, to]: [DVec3; 2]| {
        let along = to - from;
        along.cross(point - from).length() / along.length()
    };
    let depth = [[a, b], [b, c], [c, a]].map(from_edge).into_iter().fold(above.min(below), f64::min);
    (point, depth)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 1.0, 0.0)];

    #[test]
    fn through_the_inside_it_crosses_and_at_the_border_or_in_the_plane_it_touches() {
        let line = |x: f64, y: f64, low: f64, high: f64| [DVec3::new(x, y, low), DVec3::new(x, y, high)];
        let (point, depth) = passes_through(line(0.25, 0.25, -0.1, 1.0), TRIANGLE).expect("it passes through");
        assert!(
            (point - DVec3::new(0.25, 0.25, 0.0)).length() < 1e-15 && (depth - 0.1).abs() < 1e-15,
            "{point} {depth}"
        );
        let (_, depth) = passes_through(line(0.25, 0.02, -0.1, 1.0), TRIANGLE).expect("it passes through");
        assert!((depth - 0.02).abs() < 1e-15, "over the nearest edge: {depth}");
        for (what, ends) in [
            ("an end in the plane", line(0.25, 0.25, 0.0, 1.0)),
            ("through an edge", line(0.5, 0.5, -1.0, 1.0)),
            ("through a corner", line(0.0, 0.0, -1.0, 1.0)),
            ("beside it", line(0.6, 0.6, -1.0, 1.0)),
            ("above it", line(0.25, 0.25, 0.1, 1.0)),
            ("in its plane", [DVec3::new(-1.0, 0.3, 0.0), DVec3::new(2.0, 0.3, 0.0)]),
            ("no number", line(0.25, 0.25, f64::NAN, 1.0)),
        ] {
            assert_eq!(passes_through(ends, TRIANGLE), None, "{what}");
        }
    }

    #[test]
    fn one_bit_decides() {
        let tilted = TRIANGLE.map(|p| DVec3::new(p.x, p.y, 0.1 * p.x + 0.3 * p.y));
        let (x, y) = (0.25, 0.125);
        let plane = 0.1 * x + 0.3 * y;
        let reaches = |low: f64| passes_through([DVec3::new(x, y, low), DVec3::new(x, y, 1.0)], tilted).is_some();
        // The plane goes through rounded corners: within two bits of where its formula says.
        let bits = |n: i64| f64::from_bits(plane.to_bits().wrapping_add_signed(n));
        assert!(reaches(bits(-3)) && !reaches(bits(3)));
        let changes = (-3..3).filter(|n| reaches(bits(*n)) != reaches(bits(n + 1))).count();
        assert_eq!(changes, 1, "below some bit it crosses, from there on it does not");
    }
}
