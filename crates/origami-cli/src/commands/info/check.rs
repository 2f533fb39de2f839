//! Which frames of a file go through themselves.

use std::fmt::Write;

use origami::contact::Crossings;
use origami::fold::{Document, Frame};
use origami::glam::DVec3;
use origami::model::Model;
use serde::Serialize;

use crate::numbers::count;
use crate::report::CrossingFacts;

/// What the exact test says of one frame.
#[derive(Debug, Serialize)]
pub(super) struct CheckedFrame {
    /// Its number.
    frame: usize,
    /// None where it could not be tested.
    crossings: Option<CrossingFacts>,
    /// Why not.
    #[serde(skip_serializing_if = "Option::is_none")]
    why_not: Option<&'static str>,
}

/// Tests all frames that have places for the vertices of the pattern, which is that of frame `index`.
pub(super) fn frames(document: &Document, index: usize, model: &Model) -> Vec<CheckedFrame> {
    let Ok(own) = document.frame(index) else { return Vec::new() };
    let placed = (0..document.frame_count()).filter_map(|i| Some((i, document.frame(i).ok()?)));
    let placed = placed.filter(|(_, frame)| frame.vertices_coords.is_some());
    let checked = placed.map(|(frame, other)| match positions(&own, &other, model) {
        Ok(positions) => {
            let crossings = Crossings::of(&model.mesh, &positions);
            let facts = CrossingFacts::new(&crossings, model.normalisation.radius);
            CheckedFrame { frame, crossings: Some(facts), why_not: None }
        }
        Err(why_not) => CheckedFrame { frame, crossings: None, why_not: Some(why_not) },
    });
    checked.collect()
}

/// Where a frame has the nodes of a model, in the file's unit; or why it does not say so.
fn positions(own: &Frame, other: &Frame, model: &Model) -> Result<Vec<DVec3>, &'static str> {
    if (&own.edges_vertices, &own.faces_vertices) != (&other.edges_vertices, &other.faces_vertices) {
        return Err("it has edges or faces of its own");
    }
    let places = other.vertices_coords.as_deref().unwrap_or_default();
    let place = |vertex: &origami::ids::VertexId| places.get(vertex.index()).map(|coordinates| coordinates.position);
    let all: Option<Vec<DVec3>> = model.mesh.vertex_of_node.iter().map(place).collect();
    all.ok_or("the pattern was read with vertices that the frame does not have")
}

/// A line for each, where there are few; else one for all, and one for the first that crosses.
pub(super) fn tell(text: &mut String, frames: &[CheckedFrame]) -> std::fmt::Result {
    const FEW: usize = 8;
    let crossing = |frame: &&CheckedFrame| frame.crossings.as_ref().is_some_and(|facts| facts.count > 0);
    let few = if frames.len() > FEW {
        let crossed = frames.iter().filter(crossing).count();
        writeln!(text, "  crossings   {} of {} cross themselves", crossed, count(frames.len(), "frame", "frames"))?;
        frames.iter().find(crossing).into_iter().collect()
    } else {
        frames.iter().collect::<Vec<_>>()
    };
    for CheckedFrame { frame, crossings, why_not } in few {
        match (crossings, why_not) {
            (Some(facts), _) => writeln!(text, "  crossings   frame {frame}: {facts}")?,
            (None, why) => writeln!(text, "  crossings   frame {frame} not tested: {}", why.unwrap_or_default())?,
        }
    }
    Ok(())
}
