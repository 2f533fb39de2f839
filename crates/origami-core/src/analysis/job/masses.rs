//! Masses of nodes: of the sheet a third of each triangle at each of its corners, of vertices what the job and the file say.
//!
//! A rectangle that turns about a side is too heavy so, by a half, and a triangle by a factor of two: frequencies of single
//! facets are too low by that much's root.

use super::Job;
use super::keys::{entries, read};
use super::pick::node_of;
use crate::analysis::Structure;
use crate::error::{Error, ErrorCode, Place};
use crate::fold::Frame;
use crate::model::Model;
use crate::pattern::CreasePattern;

/// For each vertex its mass besides the sheet's.
const MASS: &str = "vertices_origami:mass";
/// The same as rtori has it.
const RTORI_MASS: &str = "rtori:vertices_mass";

/// Gives the nodes their masses, where there are any.
pub(super) fn set(
    job: &Job,
    frame: &Frame,
    pattern: &CreasePattern,
    model: &Model,
    structure: &mut Structure,
) -> Result<(), Error> {
    let mut masses = vec![0.0; structure.nodes.len()];
    if let Some(sheet) = &job.sheet
        && let Some(density) = sheet.density
    {
        for triangle in &model.mesh.triangles {
            let [a, b, c] = triangle.map(|n| structure.nodes[n.index()]);
            let share = density * sheet.t * 0.5 * (b - a).cross(c - a).length() / 3.0;
            triangle.iter().for_each(|n| masses[n.index()] += share);
        }
    }
    for (i, entry) in job.masses.iter().enumerate() {
        if !(entry.mass.is_finite() && entry.mass > 0.0) {
            let place = Place::key(format!("masses[{i}].mass"));
            return Err(Error::new(ErrorCode::WrongValue, place, format!("is {}", entry.mass), "a number above 0"));
        }
        for node in entry.on.nodes(&format!("masses[{i}].on"), pattern, model)? {
            masses[node.index()] += entry.mass;
        }
    }
    let key = if frame.extra.contains_key(MASS) { MASS } else { RTORI_MASS };
    for (index, value) in entries(frame, key)? {
        let expected = "a number that is not negative, or null";
        if let Some(mass) = read::<f64>(key, index, value, expected)? {
            if mass < 0.0 {
                return Err(Error::new(
                    ErrorCode::WrongValue,
                    Place::entry(key, index),
                    format!("is {mass}"),
                    expected,
                ));
            }
            let vertex = u32::try_from(index).unwrap_or(u32::MAX);
            masses[node_of(&format!("{key}[{index}]"), vertex, pattern, model)?.index()] += mass;
        }
    }
    if masses.iter().all(|mass| *mass == 0.0) {
        return Ok(());
    }
    if let Some(node) = masses.iter().position(|mass| *mass == 0.0) {
        let vertex = model.mesh.vertex_of_node[node].0;
        let problem = format!("vertex {vertex} has no mass, and others have");
        let expected = "a mass at each vertex, or none at all; `sheet.density` gives each its share";
        return Err(Error::new(ErrorCode::MissingKey, Place::key("masses"), problem, expected));
    }
    if job.units.as_ref().is_some_and(|units| units.mass.is_none()) {
        let expected = "that of the masses: `kg`, `g`, `mg`, `t` or `unit`";
        return Err(Error::new(ErrorCode::MissingKey, Place::key("units.mass"), "is missing", expected));
    }
    structure.masses = masses;
    Ok(())
}
