//! Warnings and places as data, as `docs/REPORT.md` has them.

use origami::Warning;
use origami::error::{CreasePlace, Place};
use origami::ids::VertexId;
use serde_json::{Value, json};

/// How many creases or triangles one warning lists.
const LISTED: usize = 1000;

/// Warnings, each with its code, its place as text and as data, and its message.
pub(crate) fn notes(warnings: &[Warning]) -> Value {
    let note = |warning: &Warning| {
        json!({
            "code": warning.code.name(),
            "place": warning.place.to_string(),
            "message": warning.message,
            "at": at(&warning.place),
        })
    };
    warnings.iter().map(note).collect()
}

/// A place as data: an object that has the keys of its kind.
pub(crate) fn at(place: &Place) -> Value {
    let numbers = |vertices: &[VertexId]| -> Vec<u32> { vertices.iter().map(|vertex| vertex.0).collect() };
    match place {
        Place::Key { frame, key, index, source, .. } => {
            with_source(json!({"frame": frame, "key": key, "index": index}), source)
        }
        Place::Line { line, column } => json!({"line": line, "column": column}),
        Place::Vertices(vertices) => json!({"vertices": numbers(vertices)}),
        Place::Creases(creases) => {
            let crease = |crease: &CreasePlace| {
                let edge = crease.edge.map(|edge| edge.0);
                with_source(json!({"vertices": numbers(&crease.vertices), "edge": edge}), &crease.source)
            };
            json!({"creases": creases.iter().take(LISTED).map(crease).collect::<Vec<_>>()})
        }
        Place::Triangles(triangles) => {
            let corners = triangles.iter().take(LISTED).map(|triangle| numbers(triangle));
            json!({"triangles": corners.collect::<Vec<_>>()})
        }
        Place::Sheet { percent } => json!({"percent": percent}),
        Place::Setting(setting) => json!({"setting": setting}),
        _ => json!({}),
    }
}

/// Where it was written in a file of another format, where something says it.
fn with_source(mut place: Value, source: &str) -> Value {
    if let (Value::Object(place), false) = (&mut place, source.is_empty()) {
        place.insert("source".into(), source.into());
    }
    place
}
