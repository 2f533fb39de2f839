//! The last word on each edge: its letter and its fold angle, once the faces are known.

use std::f64::consts::PI;

use super::draft::{Draft, DraftEdge, GivenAngle, Origin};
use super::letters::Letter;
use super::level;
use super::notes::Notes;
use super::sides::{Side, Sides};
use crate::error::{Short, WarningCode};
use crate::pattern::dihedral::angle_between;
use crate::pattern::plane::area_vector;

/// Angles nearer to 0, or to half a turn, than this (radians) are taken as flat, or as folded over.
const NEARLY: f64 = 1e-6;

/// Which keys the file has.
#[derive(Clone, Copy, Debug)]
pub(super) struct Keys {
    pub(super) letters: bool,
    pub(super) angles: bool,
}

/// Gives every live edge its final letter and fold angle.
pub(super) fn settle(draft: &mut Draft, sides: &Sides, keys: Keys) {
    let measured = measure(draft, sides, keys);
    let Draft { edges, notes, .. } = draft;
    let mut idle = true;
    for (index, (edge, pair)) in edges.iter_mut().zip(sides).enumerate().filter(|(_, (edge, _))| edge.alias.is_none()) {
        match pair {
            [None, _] => outside(edge, notes),
            [_, None] => contour(edge, notes),
            _ => {
                hinge(edge, measured.as_ref().and_then(|angles| angles[index]), notes);
                idle &= edge.letter.is_none_or(|letter| !letter.drives());
            }
        }
        edge.letter = edge.letter.or(Some(Letter::Unassigned));
    }
    note_missing(notes, keys, idle, measured.is_some());
}

/// Warns of missing keys, and says where their values are taken from. `idle`: there is no mountain and no valley.
fn note_missing(notes: &mut Notes, keys: Keys, idle: bool, measured: bool) {
    let letters = (WarningCode::MissingLetters, "edges_assignment");
    let angles = (WarningCode::MissingAngles, "edges_foldAngle");
    let ((code, key), message) = match (keys.letters, keys.angles) {
        (false, false) if measured && !idle => {
            (letters, "is missing, and so is edges_foldAngle; both are measured from the coordinates")
        }
        (false, false) => (letters, "is missing, and so is edges_foldAngle: nothing drives the sheet"),
        (false, true) => (letters, "is missing; the letters follow from the fold angles"),
        (true, false) if measured => (angles, "is missing; the angles are measured from the coordinates"),
        (true, false) if !idle => (angles, "is missing; M and V fold by -180 and 180 degrees"),
        _ => return,
    };
    notes.add_once(code, key, message);
}

/// An edge of no face.
fn outside(edge: &mut DraftEdge, notes: &mut Notes) {
    if matches!(edge.letter, None | Some(Letter::Cut)) {
        edge.letter = Some(Letter::Boundary);
    }
    notes.add_with(WarningCode::EdgeOutside, "belongs to no face; it is kept and does not fold", || {
        (edge.origin.place("edges_vertices"), String::new())
    });
}

/// An edge of one face.
fn contour(edge: &mut DraftEdge, notes: &mut Notes) {
    let was = edge.letter.filter(|letter| !matches!(letter, Letter::Boundary | Letter::Cut));
    if let (Some(letter), Origin::File(_)) = (was, edge.origin) {
        let place = || edge.origin.place("edges_assignment");
        let first = || (place(), letter.name().into());
        notes.add_with(WarningCode::LetterOnContour, "on the contour, taken as B", first);
    } else {
        note_useless_angle(edge, notes);
    }
    edge.letter = Some(Letter::Boundary);
}

/// A boundary or cut with an angle.
fn note_useless_angle(edge: &DraftEdge, notes: &mut Notes) {
    if let GivenAngle::Degrees(degrees) = edge.given
        && degrees != 0.0
    {
        let place = || edge.origin.place("edges_foldAngle");
        let message = "degrees on a boundary or cut; ignored";
        notes.add_with(WarningCode::AngleOnBoundary, message, || (place(), Short(degrees).to_string()));
    }
}

/// An edge between two faces.
fn hinge(edge: &mut DraftEdge, measured: Option<f64>, notes: &mut Notes) {
    let place = || edge.origin.place("edges_assignment");
    if edge.letter == Some(Letter::Boundary) {
        notes.add_with(WarningCode::BoundaryInside, "between two faces, taken as U", || (place(), "B".into()));
        edge.letter = Some(Letter::Unassigned);
    }
    if edge.letter == Some(Letter::Cut) {
        return note_useless_angle(edge, notes);
    }
    let angle = match (edge.given, edge.letter) {
        (GivenAngle::Free, letter) => {
            if let Some(letter) = letter.filter(|letter| letter.drives()) {
                let place = || edge.origin.place("edges_foldAngle");
                let message = "with null: a free crease, which nothing drives";
                notes.add_with(WarningCode::NullAngle, message, || (place(), letter.name().into()));
            }
            None
        }
        (GivenAngle::Degrees(degrees), Some(Letter::Unassigned)) => {
            if degrees != 0.0 {
                let message = "has a fold angle; unassigned, so nothing drives it";
                notes.add_with(WarningCode::AngleOnUnassigned, message, || (place(), "U".into()));
            }
            None
        }
        (GivenAngle::Degrees(degrees), _) => {
            if degrees.abs() > 180.0 + NEARLY {
                let place = edge.origin.place("edges_foldAngle");
                let message = "degrees is past flat folded; kept";
                notes.add_with(WarningCode::AnglePastFlat, message, || (place, Short(degrees).to_string()));
            }
            Some(degrees.to_radians())
        }
        (GivenAngle::Absent, letter) => by_letter(letter, measured),
    };
    match (edge.letter, angle) {
        (None, angle) => edge.letter = Some(letter_of(angle)),
        (Some(Letter::Mountain), Some(angle)) if angle > NEARLY => opposite(edge, angle, notes),
        (Some(Letter::Valley), Some(angle)) if angle < -NEARLY => opposite(edge, angle, notes),
        (Some(letter @ (Letter::Flat | Letter::Join)), Some(angle)) if angle != 0.0 && measured.is_none() => {
            notes.add_with(WarningCode::AngleOnFlat, "has a fold angle, which is kept", || {
                (edge.origin.place("edges_assignment"), letter.name().into())
            });
        }
        _ => {}
    }
    edge.fold_angle = angle;
}

fn opposite(edge: &DraftEdge, angle: f64, notes: &mut Notes) {
    let letter = edge.letter.map_or("", Letter::name);
    let message = "degrees: letter and fold angle are of opposite sign; the angle is kept";
    notes.add_with(WarningCode::OppositeSigns, message, || {
        (edge.origin.place("edges_foldAngle"), format!("{letter} with {}", Short(angle.to_degrees())))
    });
}

/// The fold angle where the file gives none: as measured, or what the letter means on a flat sheet.
fn by_letter(letter: Option<Letter>, measured: Option<f64>) -> Option<f64> {
    match (letter, measured) {
        (Some(Letter::Unassigned | Letter::Boundary | Letter::Cut), _) | (None, None) => None,
        // Folded over, the coordinates do not tell to which side.
        (Some(Letter::Mountain), Some(angle)) if angle.abs() > PI - NEARLY => Some(-angle.abs()),
        (Some(Letter::Valley), Some(angle)) if angle.abs() > PI - NEARLY => Some(angle.abs()),
        (_, Some(angle)) => Some(angle),
        (Some(Letter::Mountain), None) => Some(-PI),
        (Some(Letter::Valley), None) => Some(PI),
        (Some(Letter::Flat | Letter::Join), None) => Some(0.0),
    }
}

/// The letter that a fold angle stands for.
fn letter_of(angle: Option<f64>) -> Letter {
    match angle {
        None => Letter::Unassigned,
        Some(angle) if angle > NEARLY => Letter::Valley,
        Some(angle) if angle < -NEARLY => Letter::Mountain,
        Some(_) => Letter::Flat,
    }
}

/// The fold angles of the sheet as it lies in space; none when it is flat, where they would say nothing.
fn measure(draft: &mut Draft, sides: &Sides, keys: Keys) -> Option<Vec<Option<f64>>> {
    if draft.flat {
        return None;
    }
    let point = |v: u32| draft.points[v as usize];
    let normals: Vec<_> = draft.faces.iter().map(|face| area_vector(face.iter().map(|&v| point(v)))).collect();
    let angle = |one: Side, two: Side| {
        let [from, to] = one.ends(&draft.faces).map(point);
        angle_between(to - from, normals[one.face as usize], normals[two.face as usize])
    };
    let angles: Vec<_> = sides.iter().map(|pair| Some(angle(pair[0]?, pair[1]?))).collect();
    if angles.iter().flatten().any(|angle| angle.abs() > NEARLY) {
        return Some(angles);
    }
    if keys.letters && !keys.angles && level::turn(&draft.points).is_some() {
        let message = "the sheet lies flat in a tilted plane: nothing to measure";
        draft.notes.add_once(WarningCode::TiltedPlane, "vertices_coords", message);
    }
    None
}
