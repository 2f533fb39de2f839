//! Faces between curves in triangles whose sides are, as nearly as they can, rulings: at right angles to the curves at both
//! ends. Of all triangulations the one is taken where the sum over all sides is least.

use glam::DVec2;

use super::faces::{Corner, Face};

/// Faces with more corners are left to the triangulation of the mesh.
const MOST: usize = 700;
/// Triangles with less area than this, in squares of the face's size, are none.
const AREA: f64 = 1e-10;
/// How much the length of a side counts, in sizes of the face, where angles do not decide.
const LENGTH: f64 = 1e-3;

/// The lines that cut `faces`.
pub(super) fn of(faces: &[Face]) -> Vec<[DVec2; 2]> {
    faces.iter().flat_map(|face| cut(face).into_iter().map(|[i, j]| [face[i].at, face[j].at])).collect()
}

/// The diagonals that cut a face in triangles, by their corners; none if it cannot be cut.
fn cut(face: &[Corner]) -> Vec<[usize; 2]> {
    let count = face.len();
    if !(4..=MOST).contains(&count) {
        if count > MOST {
            eprintln!("MANY {count}");
        }
        return Vec::new();
    }
    let low = face.iter().fold(DVec2::INFINITY, |low, corner| low.min(corner.at));
    let high = face.iter().fold(DVec2::NEG_INFINITY, |high, corner| high.max(corner.at));
    let size = (high - low).max_element();
    let area = |i: usize, j: usize, k: usize| (face[j].at - face[i].at).perp_dot(face[k].at - face[i].at);
    let inside = diagonals(face, AREA * size * size);
    let open = |i: usize, j: usize| j == i + 1 || (i == 0 && j + 1 == count) || inside[i * count + j];
    let cost = |i: usize, j: usize| {
        if j == i + 1 { 0.0 } else { slant(&face[i], &face[j]) + LENGTH * face[i].at.distance(face[j].at) / size }
    };
    // The least sum for the part of the face from corner i to corner j, and the third corner of its triangle on that side.
    let mut least = vec![f64::INFINITY; count * count];
    let mut third = vec![usize::MAX; count * count];
    for i in 0..count - 1 {
        least[i * count + i + 1] = 0.0;
    }
    for span in 2..count {
        for i in 0..count - span {
            let j = i + span;
            if !open(i, j) {
                continue;
            }
            for k in i + 1..j {
                let sum = least[i * count + k] + least[k * count + j];
                if sum < least[i * count + j] && area(i, k, j) > AREA * size * size {
                    (least[i * count + j], third[i * count + j]) = (sum, k);
                }
            }
            if span + 1 < count {
                least[i * count + j] += cost(i, j);
            }
        }
    }
    let mut found = Vec::new();
    let mut waiting = vec![[0, count - 1]];
    while let Some([i, j]) = waiting.pop() {
        if j == i + 1 {
            continue;
        }
        let k = third[i * count + j];
        if k == usize::MAX {}
        for part in [[i, k], [k, j]] {
            if part[1] > part[0] + 1 {
                found.push(part);
            }
            waiting.push(part);
        }
    }
    found
}

/// How far a line between two corners is from right angles to their curves: the sum of the squared cosines.
pub(super) fn slant(one: &Corner, two: &Corner) -> f64 {
    let ruling = (two.at - one.at).normalize_or_zero();
    [one, two].iter().filter_map(|corner| corner.tangent).map(|tangent| tangent.dot(ruling).powi(2)).sum()
}

/// Which lines between corners lie within the face and meet its outline in these two corners only.
fn diagonals(face: &[Corner], least: f64) -> Vec<bool> {
    let count = face.len();
    let at = |i: usize| face[i % count].at;
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let mut inside = vec![false; count * count];
    for i in 0..count {
        for j in i + 2..count {
            if i == 0 && j + 1 == count {
                continue;
            }
            let enters = |i: usize, j: usize| {
                let [before, here, after, to] = [at(i + count - 1), at(i), at(i + 1), at(j)];
                let (left, right) = (turn(here, after, to) > least, turn(here, to, before) > least);
                if turn(before, here, after) >= 0.0 { left && right } else { left || right }
            };
            if !enters(i, j) || !enters(j, i) {
                continue;
            }
            let [a, b] = [at(i), at(j)];
            let blocked = (0..count).any(|side| {
                let next = (side + 1) % count;
                if [side, next].iter().any(|end| *end == i || *end == j) {
                    // A corner on the line, seen from its neighbours too.
                    return [side, next].into_iter().any(|end| end != i && end != j && touches(a, b, at(end), least));
                }
                let [c, d] = [at(side), at(next)];
                let (from_c, from_d) = (turn(a, b, c), turn(a, b, d));
                let (from_a, from_b) = (turn(c, d, a), turn(c, d, b));
                ((from_c > 0.0) != (from_d > 0.0) && (from_a > 0.0) != (from_b > 0.0)) || touches(a, b, c, least)
            });
            inside[i * count + j] = !blocked;
        }
    }
    inside
}

/// Whether a point lies on a line, between its ends.
fn touches(a: DVec2, b: DVec2, point: DVec2, least: f64) -> bool {
    let along = (point - a).dot(b - a);
    (b - a).perp_dot(point - a).abs() <= least && along >= 0.0 && along <= a.distance_squared(b)
}
