//! Where on the sheet a warning is.

use origami_core::error::Place;
use origami_core::ids::{EdgeId, VertexId};
use origami_core::{CreasePattern, Model, Warning};

use crate::message::Note;

/// A warning with the nodes and edges that it names.
pub(crate) fn note(warning: &Warning, pattern: &CreasePattern, model: &Model) -> Note {
    let place = &warning.place;
    let mut vertices: Vec<VertexId> = place.vertex().into_iter().collect();
    let mut edges: Vec<EdgeId> = place.edge().into_iter().collect();
    if let Some(face) = place.face() {
        vertices.extend(pattern.faces.get(face.index()).into_iter().flatten());
    }
    match place {
        Place::Vertices(named) => vertices.extend(named),
        Place::Creases(creases) => {
            edges.extend(creases.iter().filter_map(|crease| crease.edge));
            vertices.extend(creases.iter().filter(|crease| crease.edge.is_none()).flat_map(|crease| crease.vertices));
        }
        Place::Triangles(triangles) => vertices.extend(triangles.iter().flatten()),
        _ => {}
    }
    edges.retain(|edge| edge.index() < pattern.edges.len());
    Note {
        code: warning.code.name(),
        text: warning.to_string(),
        nodes: vertices.into_iter().filter_map(|vertex| model.node(vertex)).map(|node| node.0).collect(),
        edges: edges.into_iter().map(|edge| edge.0).collect(),
    }
}
