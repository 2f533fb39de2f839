//! The part of a file that its folded forms keep.

use serde_json::{Map, Value};

use super::CREATOR;
use crate::error::Error;
use crate::fold::{Document, Frame};
use crate::pattern::CreasePattern;
use crate::pattern::keys::{FACES_SOURCE, SOURCE};

/// Keys that follow from `edges_vertices`.
const FROM_EDGES: [&str; 6] =
    ["vertices_vertices", "vertices_edges", "edges_length", "edges_lengths", "edgeOrders", SOURCE];
/// Keys that follow from `edges_vertices` and `faces_vertices`.
const FROM_FACES: [&str; 6] =
    ["vertices_faces", "edges_faces", "faces_edges", "faces_faces", "faceOrders", FACES_SOURCE];
/// Classes of files of more than one frame.
const MANY_FRAMES: [&str; 3] = ["animation", "multiModel", "diagrams"];

/// The part of a document that the folded forms of its sheet keep: metadata and unknown keys, but no arrays that the pattern
/// has too. So the document itself, as large as the model, need not be kept while the sheet is folded.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Template {
    classes: Vec<String>,
    metadata: Map<String, Value>,
    /// Unknown keys of the one frame.
    extra: Map<String, Value>,
}

impl Template {
    /// The template for folded forms of `pattern`, which was made from frame `frame` of `source`.
    ///
    /// Arrays that follow from others (`faces_edges`, `edges_length`, `faceOrders` and such) are kept where those are in the
    /// pattern as in the source, else dropped: their counts, ends or order changed when the pattern was cleaned. Where edges were
    /// written in a file of another format is the pattern's own.
    ///
    /// # Errors
    /// [`Error::Invalid`] if there is no such frame.
    pub fn new(source: &Document, frame: usize, pattern: &CreasePattern) -> Result<Self, Error> {
        let frame = source.resolved(frame)?;
        let (same_edges, same_faces) = same(&frame, pattern);
        let holds =
            |key: &str| (same_edges || !FROM_EDGES.contains(&key)) && (same_faces || !FROM_FACES.contains(&key));
        let kept = frame.extra.iter().filter(|(key, _)| holds(key));
        let mut extra: Map<String, Value> = kept.map(|(key, value)| (key.clone(), value.clone())).collect();
        // Pieces know which line they are pieces of, whatever became of the file's edges.
        if !pattern.sources.is_empty() {
            extra.insert(SOURCE.into(), pattern.sources.iter().map(|at| Value::from(&**at)).collect());
        }
        let classes = source.classes.iter().filter(|class| !MANY_FRAMES.contains(&class.as_str()));
        Ok(Self { classes: classes.cloned().collect(), metadata: source.metadata.clone(), extra })
    }

    /// The one frame, without any array of its own.
    pub(super) fn frame(&self) -> Frame {
        Frame { extra: self.extra.clone(), ..Frame::default() }
    }

    /// With `frame` as the only one.
    pub(super) fn document(&self, frame: Frame) -> Document {
        let mut metadata = self.metadata.clone();
        metadata.insert("file_creator".into(), CREATOR.into());
        Document {
            spec: Some(Value::from(1.2)),
            classes: self.classes.clone(),
            metadata,
            key_frame: frame,
            ..Document::default()
        }
    }
}

/// Whether the pattern has vertices and edges, and whether it has faces too, as `frame` has them.
fn same(frame: &Frame, pattern: &CreasePattern) -> (bool, bool) {
    let vertices = frame.vertices_coords.as_ref().is_some_and(|vertices| vertices.len() == pattern.vertices.len());
    let own = pattern.edges.iter().map(|edge| edge.vertices.map(|vertex| vertex.0));
    let edges = vertices && frame.edges_vertices.as_ref().is_some_and(|edges| own.eq(edges.iter().copied()));
    let mut own = pattern.faces.iter().map(|face| face.iter().map(|vertex| vertex.0));
    let same_face = |face: &Vec<u32>| own.next().is_some_and(|own| own.eq(face.iter().copied()));
    let faces = frame.faces_vertices.as_ref().filter(|faces| faces.len() == pattern.faces.len());
    (edges, edges && faces.is_some_and(|faces| faces.iter().all(same_face)))
}
