//! Faces that hang together by hinges, laid in one plane: each reflected across the folded hinges on the way to it. Where
//! they can lie flat, all ways to a face agree; by how much they do not is the closure.

use std::collections::VecDeque;

use glam::DVec2;

use crate::csr::Csr;

/// What joins two faces: folded by half a turn, or not at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Hinge {
    pub(crate) faces: [u32; 2],
    /// The points at its ends.
    pub(crate) ends: [u32; 2],
    pub(crate) folded: bool,
}

/// Faces in one plane.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Laid {
    /// By point: the mean of its images by all its faces; a point of no face stays.
    pub(crate) points: Vec<DVec2>,
    /// By face: whether it is turned over.
    pub(crate) turned_over: Vec<bool>,
    /// How far an image of a point lies from their mean at the most, and of which point it is; `None` where all agree to the
    /// bit.
    pub(crate) worst: Option<(usize, f64)>,
}

/// A motion of the plane: a turn, after a reflection across the axis x where it is `mirrored`, then a shift.
#[derive(Clone, Copy)]
struct Motion {
    mirrored: bool,
    turn: DVec2,
    shift: DVec2,
}

impl Motion {
    const NONE: Self = Self { mirrored: false, turn: DVec2::X, shift: DVec2::ZERO };

    fn of(self, point: DVec2) -> DVec2 {
        self.turned(point) + self.shift
    }

    fn turned(self, direction: DVec2) -> DVec2 {
        self.turn.rotate(if self.mirrored { conjugate(direction) } else { direction })
    }

    /// The same after a reflection across the line from `a` to `b`.
    fn after_reflection(self, a: DVec2, b: DVec2) -> Self {
        let along = (b - a).normalize_or(DVec2::X);
        // Across the line: p -> a + along^2 conj(p - a), as complex numbers.
        let turn = along.rotate(along);
        let shift = a - turn.rotate(conjugate(a));
        Self { mirrored: !self.mirrored, turn: self.turned(turn).normalize_or(DVec2::X), shift: self.of(shift) }
    }
}

fn conjugate(z: DVec2) -> DVec2 {
    DVec2::new(z.x, -z.y)
}

/// Lays the faces, lists of points, flat in linear time. `points` should lie around 0 and be near 1, so that shifts do not
/// lose what turns have. The first of `roots` in each connected piece stays where it is; a piece without one is laid from its
/// first face.
pub(crate) fn lay(points: &[DVec2], faces: &Csr<u32>, hinges: &[Hinge], roots: impl Iterator<Item = usize>) -> Laid {
    let motions = motions(points, faces.rows(), hinges, roots);
    let images = || {
        let of_face = |(face, motion): (usize, &Motion)| {
            let motion = *motion;
            faces.row(face).iter().map(move |corner| (*corner as usize, motion.of(points[*corner as usize])))
        };
        motions.iter().enumerate().flat_map(of_face)
    };
    let mut sums = vec![(DVec2::ZERO, 0_u32); points.len()];
    for (corner, image) in images() {
        sums[corner].0 += image;
        sums[corner].1 += 1;
    }
    let mean = |((sum, count), own): (&(DVec2, u32), &DVec2)| if *count == 0 { *own } else { *sum / f64::from(*count) };
    let means: Vec<DVec2> = sums.iter().zip(points).map(mean).collect();
    let mut worst: Option<(usize, f64)> = None;
    for (corner, image) in images() {
        let off = image.distance(means[corner]);
        if off > worst.map_or(0.0, |(_, most)| most) {
            worst = Some((corner, off));
        }
    }
    Laid { points: means, turned_over: motions.iter().map(|motion| motion.mirrored).collect(), worst }
}

/// How each face moves: from the root of each piece outwards.
fn motions(points: &[DVec2], faces: usize, hinges: &[Hinge], roots: impl Iterator<Item = usize>) -> Vec<Motion> {
    let sides = hinges.iter().enumerate().flat_map(|(h, hinge)| hinge.faces.map(|face| (face as usize, h as u32)));
    let hinges_of_face = Csr::from_entries(faces, sides);
    let mut motions: Vec<Option<Motion>> = vec![None; faces];
    let mut queue = VecDeque::new();
    for root in roots.chain(0..faces) {
        if motions[root].is_some() {
            continue;
        }
        motions[root] = Some(Motion::NONE);
        queue.push_back((root, Motion::NONE));
        while let Some((face, here)) = queue.pop_front() {
            for hinge in hinges_of_face.row(face).iter().map(|h| hinges[*h as usize]) {
                let [one, two] = hinge.faces.map(|face| face as usize);
                let other = if one == face { two } else { one };
                if motions[other].is_some() {
                    continue;
                }
                let [a, b] = hinge.ends.map(|end| points[end as usize]);
                let there = if hinge.folded { here.after_reflection(a, b) } else { here };
                motions[other] = Some(there);
                queue.push_back((other, there));
            }
        }
    }
    // Every face is a root, if nothing else.
    motions.into_iter().map(|motion| motion.unwrap_or(Motion::NONE)).collect()
}
