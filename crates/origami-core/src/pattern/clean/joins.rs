//! What was joined though it did not touch: each place, with its distance.

use super::draft::Draft;
use super::letters::Letter;
use crate::error::{Place, Short, WarningCode, rounded};
use crate::ids::{EdgeId, VertexId};
use crate::pattern::joins::{Join, JoinedTo};

/// So many near misses are named one by one; all are in the pattern.
const NAMED: usize = 10;

/// A vertex of the file and what it is now one with, or on.
#[derive(Clone, Copy)]
pub(super) struct Meeting {
    vertex: u32,
    with: JoinedTo,
    /// In the unit of the points.
    pub(super) distance: f64,
}

/// A vertex that was merged into `other`.
pub(super) fn on_vertex(vertex: u32, other: u32, distance: f64) -> Meeting {
    Meeting { vertex, with: JoinedTo::Vertex(VertexId(other)), distance }
}

/// A vertex at which `line` of the file is split.
pub(super) fn on_line(vertex: u32, line: u32, distance: f64) -> Meeting {
    Meeting { vertex, with: JoinedTo::Edge(EdgeId(line)), distance }
}

/// Warns of what meets, and keeps what was farther apart than `rounding`.
pub(super) fn note(draft: &mut Draft, meetings: &[Meeting], rounding: f64) {
    let mut on_border = vec![false; draft.points.len()];
    for edge in draft.edges.iter().filter(|edge| edge.letter == Some(Letter::Boundary)) {
        edge.ends.iter().for_each(|&v| on_border[v as usize] = true);
    }
    let mut named = 0;
    for meeting in meetings {
        let vertex = meeting.vertex as usize;
        let place = Place::entry("vertices_coords", vertex);
        if meeting.distance <= rounding {
            note_touching(draft, *meeting);
            continue;
        }
        let border = on_border[vertex]
            && match meeting.with {
                JoinedTo::Vertex(other) => on_border[other.index()],
                JoinedTo::Edge(_) => true,
            };
        let distance = meeting.distance / draft.scale;
        draft.joins.push(Join { vertex: VertexId(meeting.vertex), with: meeting.with, distance, border });
        let code = if border { WarningCode::BorderJoined } else { WarningCode::NearMissJoined };
        if border || named < NAMED {
            named += usize::from(!border);
            draft.notes.add_one(code, place, said(meeting.with, distance, border));
        } else {
            draft.notes.add_with(code, "", || (place, String::new()));
        }
    }
}

fn said(with: JoinedTo, distance: f64, border: bool) -> String {
    let beside = format!("lies {} beside", Short(rounded(distance)));
    let what = if border { "the border is joined" } else { "they are joined" };
    match with {
        JoinedTo::Vertex(v) => format!("{beside} vertices_coords[{}]; {what} there", v.0),
        JoinedTo::Edge(e) => format!("{beside} edges_vertices[{}]; {what} there", e.0),
    }
}

/// What touches but for rounding.
fn note_touching(draft: &mut Draft, meeting: Meeting) {
    let vertex = meeting.vertex as usize;
    match meeting.with {
        JoinedTo::Vertex(_) => {
            let message = "lies on another vertex; the two are one";
            draft.notes.add(WarningCode::VerticesMerged, "vertices_coords", vertex, message);
        }
        JoinedTo::Edge(edge) => {
            draft.notes.add_with(WarningCode::VertexOnEdge, "lies on it; the line is split there", || {
                (Place::entry("edges_vertices", edge.index()), format!("vertex {vertex}"))
            });
        }
    }
}
