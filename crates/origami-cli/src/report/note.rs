//! Warnings in reports.

use origami::Warning;
use origami::error::Place;
use serde::Serialize;

/// How many creases or triangles one warning lists.
const LISTED: usize = 1000;

/// A warning with its place, as text and as data.
#[derive(Debug, Serialize)]
pub(crate) struct Note {
    code: &'static str,
    place: String,
    message: String,
    at: At,
}

/// A [`Place`] as data: an object that has the keys of its kind.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum At {
    Key {
        frame: Option<usize>,
        key: String,
        index: Option<usize>,
        #[serde(skip_serializing_if = "str::is_empty")]
        source: Box<str>,
    },
    Line {
        line: usize,
        column: Option<usize>,
    },
    Vertices {
        vertices: Vec<u32>,
    },
    Creases {
        creases: Vec<Crease>,
    },
    Triangles {
        triangles: Vec<[u32; 3]>,
    },
    Sheet {
        percent: Option<f64>,
    },
    Setting {
        setting: String,
    },
    Nothing {},
}

/// A crease by its ends, and its edge in the file where it has one.
#[derive(Debug, Serialize)]
struct Crease {
    vertices: [u32; 2],
    edge: Option<u32>,
    #[serde(skip_serializing_if = "str::is_empty")]
    source: Box<str>,
}

impl From<&Warning> for Note {
    fn from(warning: &Warning) -> Self {
        Self {
            code: warning.code.name(),
            place: warning.place.to_string(),
            message: warning.message.clone(),
            at: At::from(&warning.place),
        }
    }
}

impl From<&Place> for At {
    fn from(place: &Place) -> Self {
        match place {
            Place::Key { frame, key, index, source, .. } => {
                Self::Key { frame: *frame, key: key.to_string(), index: *index, source: source.clone() }
            }
            Place::Line { line, column } => Self::Line { line: *line, column: *column },
            Place::Vertices(vertices) => Self::Vertices { vertices: vertices.iter().map(|v| v.0).collect() },
            Place::Creases(creases) => {
                let one = |crease: &origami::error::CreasePlace| Crease {
                    vertices: crease.vertices.map(|v| v.0),
                    edge: crease.edge.map(|edge| edge.0),
                    source: crease.source.clone(),
                };
                Self::Creases { creases: creases.iter().take(LISTED).map(one).collect() }
            }
            Place::Triangles(triangles) => {
                let corners = |triangle: &[origami::ids::VertexId; 3]| triangle.map(|v| v.0);
                Self::Triangles { triangles: triangles.iter().take(LISTED).map(corners).collect() }
            }
            Place::Sheet { percent } => Self::Sheet { percent: *percent },
            Place::Setting(setting) => Self::Setting { setting: setting.to_string() },
            _ => Self::Nothing {},
        }
    }
}
