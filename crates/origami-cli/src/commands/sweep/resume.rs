//! The rows of a sweep that ended early, for one that goes on.

use std::ops::Range;
use std::path::Path;

use serde_json::{Map, Value};

use crate::report::{Head, Row};

/// Characters of a setting that a message shows.
const SHOWN: usize = 60;

/// The rows of the table at `path`, which is to have those of `places`, from the first on, as far as the files that they name are there; none where there is no
/// table.
///
/// # Errors
/// That it is no table of ours, or was made with other settings.
pub(super) fn rows(path: &Path, head: &Head, places: Range<usize>) -> Result<Vec<Row>, String> {
    let shown = path.display();
    let bytes = match std::fs::read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(format!("{shown}: {error}")),
    };
    let expected = "expected the table of a sweep, or none of --resume";
    let table: Map<String, Value> =
        serde_json::from_slice(&bytes).map_err(|error| format!("{shown}: {error}; {expected}"))?;
    let now = serde_json::to_value(head).map_err(|error| error.to_string())?;
    let now = now.as_object().cloned().unwrap_or_default();
    if let Some((setting, before, now)) = difference(&table, &now) {
        return Err(format!(
            "{shown}: was made with {setting} {before}, not {now}; expected the same settings and pattern, or none of --resume"
        ));
    }
    let instances =
        table.get("instances").and_then(Value::as_array).ok_or(format!("{shown}: has no rows; {expected}"))?;
    let mut rows = Vec::with_capacity(instances.len());
    for (i, instance) in instances.iter().take(places.len()).enumerate() {
        let row: Row = serde_json::from_value(instance.clone())
            .map_err(|error| format!("{shown}: instances[{i}]: {error}; {expected}"))?;
        if row.index != places.start + i {
            return Err(format!("{shown}: instances[{i}]: is row {}; {expected}", row.index));
        }
        if !row.outputs.iter().all(|output| Path::new(output).is_file()) {
            break;
        }
        rows.push(row);
    }
    Ok(rows)
}

/// The first setting that is not the same, with both values. The input may have another name, and what computes may have been
/// chosen in another way.
pub(super) fn difference(table: &Map<String, Value>, now: &Map<String, Value>) -> Option<(String, String, String)> {
    let settings =
        |head: &Map<String, Value>| head.get("settings").and_then(Value::as_object).cloned().unwrap_or_default();
    let top = now.clone().into_iter().filter(|(key, _)| !["input", "settings", "backend_by"].contains(&key.as_str()));
    let before = settings(table);
    let of_top = top.map(|(key, value)| (table.get(&key).cloned(), key, value));
    let of_settings = settings(now).into_iter().map(|(key, value)| (before.get(&key).cloned(), key, value));
    let (before, key, now) = of_top.chain(of_settings).find(|(before, _, now)| before.as_ref() != Some(now))?;
    Some((key, before.map_or_else(|| "nothing".to_owned(), |before| short(&before)), short(&now)))
}

fn short(value: &Value) -> String {
    let text = value.to_string();
    match text.char_indices().nth(SHOWN) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text,
    }
}
