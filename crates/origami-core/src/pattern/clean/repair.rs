//! Faces of the file that contradict its lines: creases across a face, corners on the side of another face, corners that
//! each face has for itself, a side there and back, the outside as a face. On a flat sheet the faces are found anew from
//! the lines, in space those that touch are joined, where that lets more creases fold and no paper goes.

use glam::DVec2;

use super::draft::{Draft, DraftEdge, EdgeMap, GivenAngle};
use super::faces_given::SMALLEST;
use super::letters::Letter;
use super::sides::Sides;
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::fold::Frame;
use crate::pattern::plane::{area_vector, orient};
use crate::pattern::region;

/// Areas that differ by less than this share are of the same paper.
const SAME_AREA: f64 = 1e-3;
/// So many faces are named.
const NAMED: usize = 8;

/// Whether the frame calls itself folded: then faces lie on each other, and lines say nothing.
pub(super) fn is_folded(frame: &Frame) -> bool {
    frame.classes.iter().flatten().any(|class| class == "foldedForm")
}

/// Whether faces that lead to this refusal may be found anew.
pub(super) fn may_cure(error: &Error) -> bool {
    use ErrorCode::{CornerTwice, EdgeOfManyFaces, OneSided};
    matches!(error.code(), CornerTwice | EdgeOfManyFaces | OneSided)
}

/// What speaks against faces that could be taken as they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Doubt {
    /// Nothing.
    None,
    /// Creases or cuts that have not two faces.
    Idle,
    /// A face crosses itself, or touches itself between corners.
    Face,
    /// Borders have a face on both sides, of which one lies on the other: the outside of the sheet is given as a face.
    Outside,
}

/// Whether the faces of a flat draft contradict its lines.
pub(super) fn doubt(draft: &Draft, sides: &Sides) -> Doubt {
    let points: Vec<DVec2> = draft.points.iter().map(|point| point.truncate()).collect();
    let corners = |face: &[u32]| face.iter().map(|&v| points[v as usize]).collect();
    if draft.flat && !draft.faces.iter().all(|face| is_simple(corners(face))) {
        return Doubt::Face;
    }
    if draft.flat && has_outside(draft, sides) {
        return Doubt::Outside;
    }
    let wanted = wanted(draft);
    if hinges(draft, sides, &wanted) < wanted.len() { Doubt::Idle } else { Doubt::None }
}

/// Whether the outside is a face: no side is left without a second face, or one at a border lies on the first.
fn has_outside(draft: &Draft, sides: &Sides) -> bool {
    let is_clockwise =
        |face: u32| area_vector(draft.faces[face as usize].iter().map(|&v| draft.points[v as usize])).z < 0.0;
    let mut contour = false;
    for (edge, pair) in draft.edges.iter().zip(sides) {
        match pair {
            [Some(_), None] => contour = true,
            [Some(one), Some(two)]
                if edge.letter == Some(Letter::Boundary) && is_clockwise(one.face) != is_clockwise(two.face) =>
            {
                return true;
            }
            _ => {}
        }
    }
    !contour
}

/// The edges that want two faces: creases that fold, and cuts.
fn wanted(draft: &Draft) -> Vec<usize> {
    let wants_two = |edge: &DraftEdge| match edge.letter {
        Some(letter) => letter.drives() || letter == Letter::Cut,
        None => matches!(edge.given, GivenAngle::Degrees(degrees) if degrees != 0.0),
    };
    draft.edges.iter().enumerate().filter(|(_, edge)| wants_two(edge)).map(|(index, _)| index).collect()
}

/// How many of these edges, or the edges that stand for them, have two faces.
fn hinges(draft: &Draft, sides: &Sides, edges: &[usize]) -> usize {
    let stands_for = |edge: usize| draft.edges[edge].alias.map_or(edge, |alias| alias as usize);
    edges.iter().filter(|&&edge| sides[stands_for(edge)][1].is_some()).count()
}

/// Whether the outline neither crosses nor touches itself but at corners.
fn is_simple(mut corners: Vec<DVec2>) -> bool {
    let count = corners.len();
    let corner = |i: usize| corners[i % count];
    let turns = |i: usize| orient(corner(i), corner(i + 1), corner(i + 2));
    let ahead = |i: usize| (corner(i + 1) - corner(i)).dot(corner(i + 2) - corner(i + 1)) > 0.0;
    let left = |i: usize| turns(i) > 0.0 || (turns(i) == 0.0 && ahead(i));
    let right = |i: usize| turns(i) < 0.0 || (turns(i) == 0.0 && ahead(i));
    let goes_right = |i: usize| corner(i + 1).x > corner(i).x;
    let changes = (0..count).filter(|&i| goes_right(i) != goes_right(i + 1)).count();
    // Always to one side and once around: convex.
    if changes <= 2 && ((0..count).all(left) || (0..count).all(right)) {
        return true;
    }
    let fan = || (1..count.saturating_sub(1)).map(|i| orient(corner(0), corner(i), corner(i + 1)));
    if fan().all(|area| area.abs() < SMALLEST) {
        // There is a warning of those.
        return true;
    }
    let area: f64 = fan().sum();
    if area.abs() < SMALLEST {
        // Half of it lies the other way round.
        return false;
    }
    if area < 0.0 {
        corners.reverse();
    }
    region::triangulate(&[corners]).is_ok()
}

/// Appends a line for each side of a face that `edges_vertices` does not list: a border where one face has it.
pub(super) fn list_sides(draft: &mut Draft, faces: &[Vec<u32>]) {
    let map = EdgeMap::new(draft.points.len(), &draft.edges);
    let mut missing: Vec<([u32; 2], usize)> = Vec::new();
    for (index, face) in faces.iter().enumerate() {
        for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)) {
            let exist = a.max(b) < draft.points.len() as u32;
            if a != b && exist && map.get([a, b]).is_none() {
                missing.push(([a.min(b), a.max(b)], index));
            }
        }
    }
    missing.sort_unstable();
    for sides in missing.chunk_by(|one, two| one.0 == two.0) {
        let letter = if sides.len() == 1 { Letter::Boundary } else { Letter::Join };
        draft.edges.push(DraftEdge::new(sides[0].0, Some(letter), sides[0].1));
    }
}

/// Whether faces found anew are better than those of the file, of which there is a doubt: more creases fold, and the paper
/// is the same; or the paper is what it was without the outside.
pub(super) fn is_better(anew: (&Draft, &Sides), given: (&Draft, &Sides), doubt: Doubt) -> bool {
    let area = |draft: &Draft| -> f64 {
        let of = |face: &Vec<u32>| area_vector(face.iter().map(|&v| draft.points[v as usize])).length();
        draft.faces.iter().map(of).sum()
    };
    let [new, old] = [area(anew.0), area(given.0)];
    let wanted = wanted(given.0);
    let [folds, folded] = [anew, given].map(|(draft, sides)| hinges(draft, sides, &wanted));
    let is_same = |new: f64, old: f64| (new - old).abs() <= SAME_AREA * old;
    match doubt {
        Doubt::None => false,
        Doubt::Idle => folds > folded && is_same(new, old),
        Doubt::Face => true,
        Doubt::Outside => folds >= folded && is_same(2.0 * new, old),
    }
}

/// Warns of the faces of the file that are not among those found anew; `cure` says how.
pub(super) fn note(anew: &mut Draft, faces: &[Vec<u32>], cure: &str) {
    let stands_for = |v: u32| anew.vertex_alias.get(v as usize).copied().flatten().unwrap_or(v);
    let sorted = |face: &Vec<u32>| {
        let mut face: Vec<u32> = face.iter().map(|&v| stands_for(v)).collect();
        face.sort_unstable();
        face
    };
    let mut found: Vec<Vec<u32>> = anew.faces.iter().map(sorted).collect();
    found.sort_unstable();
    let mut named = vec![false; found.len()];
    let mut wrong = Vec::new();
    for (index, face) in faces.iter().enumerate() {
        match found.binary_search(&sorted(face)) {
            Ok(at) if !std::mem::replace(&mut named[at], true) => {}
            _ => wrong.push(index),
        }
    }
    let Some(&first) = wrong.first() else {
        if anew.vertex_alias.iter().any(Option::is_some) {
            let message = format!("had corners of their own where they touch; {cure}: {}", anew.faces.len());
            anew.notes.add_one(WarningCode::FacesRepaired, Place::key("faces_vertices"), message);
        }
        return;
    };
    let area = |face: &[u32]| {
        let exist = face.iter().all(|&v| (v as usize) < anew.points.len());
        if exist { area_vector(face.iter().map(|&v| anew.points[v as usize])).length() } else { 0.0 }
    };
    let sheet: f64 = anew.faces.iter().map(|face| area(face)).sum();
    // The outside is as large as the sheet, and the others cover it once more.
    let covered: f64 = faces.iter().map(|face| area(face)).sum();
    let twice = covered > 1.5 * sheet && anew.faces.len() > 1;
    let outer = wrong.iter().find(|&&face| twice && (area(&faces[face]) - sheet).abs() <= SAME_AREA * sheet);
    let mut message = String::from("contradicts the lines");
    if wrong.len() > 1 {
        let others: Vec<String> = wrong[1..].iter().take(NAMED).map(|face| format!("[{face}]")).collect();
        let more =
            if wrong.len() > 1 + NAMED { format!(" and {} more", wrong.len() - 1 - NAMED) } else { String::new() };
        message += &format!(", and so do {}{more}", others.join(", "));
    }
    if let Some(outer) = outer {
        message += &format!("; [{outer}] lies on all others: the outside of the sheet?");
    }
    message += &format!("; {cure}: {}", anew.faces.len());
    anew.notes.add_one(WarningCode::FacesRepaired, Place::entry("faces_vertices", first), message);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simple_outlines() {
        let simple = |corners: &[[f64; 2]]| is_simple(corners.iter().copied().map(DVec2::from).collect());
        let square = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        let dart = [[0.0, 0.0], [2.0, -1.0], [0.5, 0.0], [2.0, 1.0]];
        for mut outline in [square.to_vec(), dart.to_vec()] {
            assert!(simple(&outline));
            outline.reverse();
            assert!(simple(&outline));
        }
        let star: Vec<[f64; 2]> =
            (0..5).map(|i| DVec2::from_angle(f64::from(2 * i) * std::f64::consts::TAU / 5.0).to_array()).collect();
        assert!(!simple(&star), "goes around twice");
        assert!(!simple(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]), "crosses itself");
        // There and back: past a corner, and freely.
        assert!(!simple(&[[0.0, 2.0], [0.0, 0.0], [0.0, 2.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0], [1.0, 2.0]]));
        assert!(simple(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0], [1.0, 1.0]]));
    }
}
