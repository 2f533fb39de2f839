//! The arrays of a frame: lengths, numbers and indices that make sense.

use glam::DVec3;

use super::draft::{DraftEdge, GivenAngle, Origin};
use super::notes::Notes;
use super::{letters, overrides, repair};
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::fold::Frame;
use crate::pattern::{keys, plane};

/// Most entries of an array: leaves room in `u32` for what is appended.
const MOST: usize = 1 << 27;
/// Sizes beyond ten to this power, up or down, overflow when lengths are multiplied.
const RANGE: i32 = 100;
/// Half a turn in radians, and a bit: who folds by no more than so many degrees may have meant radians.
const RADIANS: f64 = 3.15;

pub(super) fn vertices(frame: &Frame, notes: &mut Notes) -> Result<Vec<DVec3>, Error> {
    let coords = frame.vertices_coords.as_deref().unwrap_or_default();
    if coords.is_empty() {
        let place = Place::key("vertices_coords");
        return Err(Error::new(ErrorCode::MissingKey, place, "is missing or empty", "the positions of the vertices"));
    }
    countable("vertices_coords", coords.len())?;
    let dimension = coords[0].dimension;
    for (index, other) in coords.iter().enumerate().filter(|(_, other)| other.dimension != dimension) {
        let message = "numbers, the first vertex has another count; a z that is not given is 0";
        notes.add_with(WarningCode::MixedDimensions, message, || {
            (Place::entry("vertices_coords", index), format!("has {}", other.dimension))
        });
    }
    let position = |(index, coords): (usize, &crate::fold::Coordinates)| {
        let finite = coords.position.is_finite().then_some(coords.position);
        let place = || Place::entry("vertices_coords", index);
        finite.ok_or_else(|| Error::new(ErrorCode::NotFinite, place(), "is not finite", "numbers"))
    };
    coords.iter().enumerate().map(position).collect()
}

pub(super) fn countable(key: &'static str, count: usize) -> Result<(), Error> {
    if count <= MOST {
        return Ok(());
    }
    let (problem, expected) = (format!("has {count} entries"), format!("at most {MOST}"));
    Err(Error::new(ErrorCode::TooManyEntries, Place::key(key), problem, expected))
}

pub(super) fn size(vertices: &[DVec3]) -> Result<f64, Error> {
    let size = plane::extent(vertices).max_element();
    let place = || Place::key("vertices_coords");
    if size == 0.0 {
        let problem = "all vertices lie at one place";
        return Err(Error::new(ErrorCode::SheetSize, place(), problem, "a sheet with an area"));
    }
    let (least, most) = (10f64.powi(-RANGE), 10f64.powi(RANGE));
    if (least..=most).contains(&size) {
        return Ok(size);
    }
    Err(Error::new(
        ErrorCode::SheetSize,
        place(),
        format!("the pattern is {size:e} in size"),
        format!("between {least:e} and {most:e}"),
    ))
}

pub(super) fn edges(frame: &Frame, vertices: usize, notes: &mut Notes) -> Result<Vec<DraftEdge>, Error> {
    let ends = frame.edges_vertices.as_deref().unwrap_or_default();
    let count = ends.len();
    countable("edges_vertices", count)?;
    let letters = letters::read(frame, count, notes)?;
    let angles = given_angles(frame, count, notes)?;
    let k_crease = overrides::edge_numbers(frame, keys::K_CREASE, count, 0.0)?;
    let ea = overrides::edge_numbers(frame, keys::EA, count, 0.0)?;
    let mut edges = Vec::with_capacity(count);
    for (index, &ends) in ends.iter().enumerate() {
        let place = || Place::entry("edges_vertices", index);
        if let Some(vertex) = ends.into_iter().find(|&vertex| vertex as usize >= vertices) {
            let (problem, expected) = (format!("vertex {vertex} does not exist"), format!("numbers below {vertices}"));
            return Err(Error::new(ErrorCode::NoSuchVertex, place(), problem, expected));
        }
        if ends[0] == ends[1] {
            let problem = format!("joins vertex {} to itself", ends[0]);
            return Err(Error::new(ErrorCode::EdgeWithoutLength, place(), problem, "two different vertices"));
        }
        edges.push(DraftEdge {
            ends,
            letter: letters[index],
            given: angles[index],
            fold_angle: None,
            k_crease: k_crease[index],
            ea: ea[index],
            alias: None,
            origin: Origin::File(index as u32),
        });
    }
    Ok(edges)
}

fn given_angles(frame: &Frame, edges: usize, notes: &mut Notes) -> Result<Vec<GivenAngle>, Error> {
    let Some(angles) = &frame.edges_fold_angle else { return Ok(vec![GivenAngle::Absent; edges]) };
    letters::same_length("edges_foldAngle", angles.len(), edges)?;
    let most = angles.iter().flatten().map(|angle| angle.abs()).fold(0.0, f64::max);
    if most > 0.0 && most < RADIANS && !repair::is_folded(frame) {
        let message = format!("all angles are below {RADIANS}: radians? They are taken as degrees");
        notes.add_once(WarningCode::Radians, "edges_foldAngle", message);
    }
    let unclamped = overrides::edge_numbers(frame, keys::FOLD_ANGLE, edges, f64::NEG_INFINITY)?;
    let given = |(index, angle): (usize, &Option<f64>)| match (*angle, unclamped[index]) {
        (None, _) => Ok(GivenAngle::Free),
        // FOLD's range ends there: our own key knows how far it really goes.
        (Some(clamped), Some(degrees)) if clamped.abs() == 180.0 && degrees * clamped > 180.0 * 180.0 => {
            Ok(GivenAngle::Degrees(degrees))
        }
        (Some(degrees), _) if degrees.is_finite() => Ok(GivenAngle::Degrees(degrees)),
        (Some(_), _) => {
            let place = Place::entry("edges_foldAngle", index);
            Err(Error::new(ErrorCode::NotFinite, place, "is not finite", "degrees, or null"))
        }
    };
    angles.iter().enumerate().map(given).collect()
}
