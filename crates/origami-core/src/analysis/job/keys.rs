//! Supports and loads in the file itself, for each vertex or face; null for those that have none.

use glam::DVec3;
use serde::Deserialize;
use serde_json::Value;

use super::axes::HeldAxes;
use super::pick::node_of;
use crate::analysis::{Axis, Dof, Structure};
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;
use crate::ids::FaceId;
use crate::model::Model;
use crate::pattern::CreasePattern;
use crate::pattern::keys::FIXED;

/// For each vertex its load at load factor 1, `[fx, fy, fz]`.
const LOAD: &str = "vertices_origami:load";
/// For each vertex how far it is moved at load factor 1, `[null, null, -3]`.
pub(super) const DISPLACEMENT: &str = "vertices_origami:displacement";
/// For each face the pressure on its front at load factor 1.
const PRESSURE: &str = "faces_origami:pressure";

/// Adds what the frame says to `structure`; vectors of displacement are multiplied by nothing: they are in the job's lengths.
pub(super) fn add(
    frame: &Frame,
    pattern: &CreasePattern,
    model: &Model,
    structure: &mut Structure,
) -> Result<(), Error> {
    let node = |key: &'static str, index: usize| {
        let vertex = u32::try_from(index).unwrap_or(u32::MAX);
        node_of(&format!("{key}[{index}]"), vertex, pattern, model)
    };
    let expected = "true, letters such as \"xz\", or [true, false, true], or null";
    for (index, value) in entries(frame, FIXED)? {
        // Those that are held in every direction are the pattern's own.
        let Some(HeldAxes(axes)) = read(FIXED, index, value, expected)? else { continue };
        if axes != crate::scene::Axes::default() {
            structure.hold(node(FIXED, index)?, axes);
        }
    }
    for (index, value) in entries(frame, LOAD)? {
        if let Some(force) = read::<[f64; 3]>(LOAD, index, value, "[fx, fy, fz] or null")? {
            structure.loads.points.push((node(LOAD, index)?, DVec3::from_array(force)));
        }
    }
    for (index, value) in entries(frame, DISPLACEMENT)? {
        let Some(ways) = read::<[Option<f64>; 3]>(DISPLACEMENT, index, value, "three numbers or nulls, or null")?
        else {
            continue;
        };
        for (axis, way) in Axis::ALL.into_iter().zip(ways) {
            if let Some(way) = way {
                structure.supports.moved.push((Dof::new(node(DISPLACEMENT, index)?, axis), way));
            }
        }
    }
    for (index, value) in entries(frame, PRESSURE)? {
        if let Some(pressure) = read::<f64>(PRESSURE, index, value, "a number or null")? {
            press(&format!("{PRESSURE}[{index}]"), index, pressure, model, structure)?;
        }
    }
    Ok(())
}

/// Presses on the triangles of a face.
pub(super) fn press(
    place: &str,
    face: usize,
    pressure: f64,
    model: &Model,
    structure: &mut Structure,
) -> Result<(), Error> {
    let before = structure.loads.pressures.len();
    let triangles = model.mesh.triangles.iter().zip(&model.mesh.face_of_triangle);
    let own = triangles.filter(|(_, own)| own.index() == face).map(|(nodes, _)| (*nodes, pressure));
    structure.loads.pressures.extend(own);
    if structure.loads.pressures.len() == before {
        let faces = model.mesh.face_of_triangle.iter().map(|f: &FaceId| f.index() + 1).max().unwrap_or(0);
        let expected = format!("one of the pattern's {faces} faces");
        return Err(Error::new(
            ErrorCode::WrongValue,
            Place::key(place.to_owned()),
            format!("is face {face}"),
            expected,
        ));
    }
    Ok(())
}

/// The entries of a key's array, without those that are null.
pub(super) fn entries<'a>(
    frame: &'a Frame,
    key: &'static str,
) -> Result<impl Iterator<Item = (usize, &'a Value)>, Error> {
    let value = frame.extra.get(key).filter(|value| !value.is_null());
    let array = value.map(|value| value.as_array().map(Vec::as_slice));
    match array {
        Some(None) => Err(Error::new(ErrorCode::WrongType, Place::key(key), "is not an array", "an array")),
        found => Ok(found.flatten().unwrap_or_default().iter().enumerate()),
    }
}

/// An entry's value; none where it is null.
pub(super) fn read<T: serde::de::DeserializeOwned>(
    key: &'static str,
    index: usize,
    value: &Value,
    expected: &str,
) -> Result<Option<T>, Error> {
    // 0 and 1 are false and true, as in the pattern.
    let flag = value.as_f64().filter(|x| key == FIXED && (*x == 0.0 || *x == 1.0)).map(|x| Value::Bool(x == 1.0));
    Option::deserialize(flag.as_ref().unwrap_or(value)).map_err(|_| {
        let shown: String = value.to_string().chars().take(24).collect();
        Error::new(ErrorCode::WrongValue, Place::entry(key, index), format!("is {shown}"), expected)
    })
}
