//! A session in a file: the pattern, all that is asked of the sheet, and where it is.

use origami_core::fold::Document;
use origami_core::glam::DVec3;
use origami_core::{Error, Material};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::message::Wishes;
use crate::sheet::Sheet;

/// The key that says that a file is a session, and its version.
const VERSION: u32 = 1;

/// What the file holds.
#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(rename = "origami:session")]
    version: u32,
    name: String,
    format: String,
    wishes: Wishes,
    /// By node, in radii.
    positions: Vec<[f64; 3]>,
    /// By crease with a spring, in radians, with all turns.
    fold_angles: Vec<f64>,
    /// FOLD.
    pattern: Value,
}

/// A session that was read.
pub(crate) struct Restored {
    pub(crate) sheet: Sheet,
    pub(crate) wishes: Wishes,
    pub(crate) positions: Vec<DVec3>,
    pub(crate) fold_angles: Vec<f64>,
}

/// As bytes.
pub(crate) fn write(
    sheet: &Sheet,
    wishes: &Wishes,
    positions: &[DVec3],
    fold_angles: &[f64],
) -> Result<Vec<u8>, Error> {
    let mut pattern = Vec::new();
    sheet.document().write_to(&mut pattern)?;
    let file = File {
        version: VERSION,
        name: sheet.named.name.clone(),
        format: sheet.named.format.clone(),
        wishes: wishes.clone(),
        positions: positions.iter().map(DVec3::to_array).collect(),
        fold_angles: fold_angles.to_vec(),
        pattern: serde_json::from_slice(&pattern).unwrap_or_default(),
    };
    serde_json::to_vec(&file).map_err(|error| invalid(error.to_string()))
}

/// From bytes.
pub(crate) fn read(bytes: &[u8]) -> Result<Restored, Error> {
    let file: File = serde_json::from_slice(bytes).map_err(|error| invalid(error.to_string()))?;
    if file.version != VERSION {
        return Err(invalid(format!("is of version {}", file.version)));
    }
    let pattern = serde_json::to_vec(&file.pattern).map_err(|error| invalid(error.to_string()))?;
    let document = Document::from_slice(&pattern)?;
    let sheet = Sheet::of_document(&file.name, file.format, &document, &Material::default())?;
    let positions: Vec<DVec3> = file.positions.into_iter().map(DVec3::from_array).collect();
    if positions.len() != sheet.model.node_count() || !positions.iter().all(|position| position.is_finite()) {
        let problem = format!("{} positions for {} nodes", positions.len(), sheet.model.node_count());
        return Err(invalid(problem));
    }
    if !file.fold_angles.iter().all(|angle| angle.is_finite()) {
        return Err(invalid("a fold angle is not finite".to_owned()));
    }
    Ok(Restored { sheet, wishes: file.wishes, positions, fold_angles: file.fold_angles })
}

fn invalid(problem: String) -> Error {
    Error::invalid("session", problem, "a file that a session was saved to, of version 1")
}
