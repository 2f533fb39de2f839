//! What is asked of a sheet and done to it, in the pattern's vertices and units.

use origami::glam::DVec3;
use origami::ids::FaceId;
use origami::measure::attitude::Hold;
use origami::scene::{Load, Support};
use origami::{Scene, Targets};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{Numbers, to_numbers};
use crate::errors::{OrRaise, refused};
use crate::model::Sheet;

/// Loads by vertex: a mapping of vertex numbers to forces.
pub(crate) fn loads(sheet: &Sheet, loads: &Bound<'_, PyDict>) -> PyResult<Vec<Load>> {
    let load = |(vertex, force): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let node = sheet.node("loads", vertex.extract()?)?;
        Ok(Load { node, force: vector("loads", &force)? })
    };
    loads.iter().map(load).collect()
}

/// Supports by vertex: a mapping of vertex numbers to `None` (where it is) or a place in the file's units.
fn supports(sheet: &Sheet, supports: &Bound<'_, PyDict>) -> PyResult<Vec<Support>> {
    let support = |(vertex, place): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let support = Support::fixed(sheet.node("supports", vertex.extract()?)?);
        if place.is_none() {
            return Ok(support);
        }
        Ok(support.at(sheet.to_model(vector("supports", &place)?.to_array())))
    };
    supports.iter().map(support).collect()
}

/// Three finite numbers; `name` is the argument's.
pub(crate) fn vector(name: &str, numbers: &Bound<'_, PyAny>) -> PyResult<DVec3> {
    let vector: Option<[f64; 3]> = numbers.extract().ok();
    let finite = vector.map(DVec3::from_array).filter(|vector| vector.is_finite());
    finite.ok_or_else(|| refused(name, &numbers.to_string(), "three finite numbers"))
}

/// Targets: a percentage, or an angle for each crease of the model, in radians.
pub(crate) fn targets(sheet: &Sheet, percent: f64, angles: Option<&Numbers<'_>>) -> PyResult<Targets> {
    match angles {
        None => Ok(Targets::percent(percent)),
        Some(angles) => {
            let angles = to_numbers("targets", angles, sheet.model.creases.len(), "creases")?;
            Ok(Targets::angles(angles))
        }
    }
}

/// A scene of all of them.
pub(crate) fn scene(
    sheet: &Sheet,
    targets: Targets,
    held: Option<&Bound<'_, PyDict>>,
    loaded: Option<&Bound<'_, PyDict>>,
) -> PyResult<Scene> {
    let mut scene = Scene::new(targets);
    if let Some(held) = held {
        scene.supports = supports(sheet, held)?;
    }
    if let Some(loaded) = loaded {
        scene.loads = loads(sheet, loaded)?;
    }
    Ok(scene)
}

/// What keeps its place: `sheet`, `none` or the number of a face. By default the sheet, or nothing where the scene itself
/// holds or pushes it.
pub(crate) fn hold(sheet: &Sheet, asked: Option<&Bound<'_, PyAny>>, scene: &Scene) -> PyResult<Hold> {
    let Some(asked) = asked else {
        let by_scene = !scene.supports.is_empty() || !scene.has_springs_only();
        return Ok(if by_scene { Hold::Nothing } else { Hold::Sheet });
    };
    let hold = match (asked.extract::<String>().as_deref(), asked.extract::<u32>()) {
        (Ok("sheet"), _) => Hold::Sheet,
        (Ok("none"), _) => Hold::Nothing,
        (_, Ok(face)) => Hold::Face(FaceId(face)),
        _ => return Err(refused("hold", &asked.to_string(), "`sheet`, `none` or the number of a face")),
    };
    // A face that is not there is refused before the work.
    origami::measure::attitude::motion(&sheet.model, &sheet.model.rest, hold).or_raise()?;
    Ok(hold)
}
