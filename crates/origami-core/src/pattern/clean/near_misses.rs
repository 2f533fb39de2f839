//! Ends that come near a line and are not joined to it: in doubt nothing is, but it is told.

use glam::DVec2;

use super::boxes::{Bounds, BoxTree};
use super::draft::Draft;
use super::letters::Letter;
use crate::csr::Csr;
use crate::error::{Place, Short, WarningCode, rounded};
use crate::pattern::plane::extent;

/// Ends farther away than this, in sizes, end there on purpose;
const FAR: f64 = 0.02;
/// and those farther away than this share of their own line.
const SHARE: f64 = 0.125;

/// Warns of the loose ends of creases and borders that are near another line.
pub(super) fn note(draft: &mut Draft) {
    let live = || draft.edges.iter().zip(0u32..).filter(|(edge, _)| edge.alias.is_none());
    let ends = live().flat_map(|(edge, index)| edge.ends.map(|v| (v as usize, index)));
    let at = Csr::from_entries(draft.points.len(), ends);
    let matters = |edge: u32| {
        let letter = draft.edges[edge as usize].letter;
        letter.is_none_or(|letter| letter.drives() || matches!(letter, Letter::Boundary | Letter::Cut))
    };
    let loose: Vec<(u32, u32)> = (0..)
        .zip(at.iter())
        .filter_map(|(vertex, edges)| match edges {
            &[only] if matters(only) => Some((vertex, only)),
            _ => None,
        })
        .collect();
    if loose.is_empty() {
        return;
    }
    let points: Vec<DVec2> = draft.points.iter().map(|point| point.truncate()).collect();
    let place = |v: u32| points[v as usize];
    let lines: Vec<u32> = live().map(|(_, index)| index).collect();
    let ends_of = |line: u32| draft.edges[line as usize].ends.map(place);
    let boxes: Vec<Bounds> = lines.iter().map(|&line| ends_of(line)).map(|[a, b]| Bounds::of(a, b)).collect();
    let tree = BoxTree::new(&boxes);
    let size = extent(&draft.points).max_element();
    let mut found = Vec::new();
    for (vertex, own) in loose {
        let [a, b] = ends_of(own);
        let reach = (FAR * size).min(SHARE * a.distance(b));
        let around = Bounds::of(place(vertex), place(vertex)).grown(reach);
        let mut nearest: Option<(f64, u32)> = None;
        tree.visit(
            |bounds| bounds.overlaps(&around),
            |item| {
                let [a, b] = ends_of(lines[item]);
                let share = ((place(vertex) - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
                let distance = (a + share * (b - a)).distance(place(vertex));
                if lines[item] != own && distance <= reach && nearest.is_none_or(|best| (distance, lines[item]) < best)
                {
                    nearest = Some((distance, lines[item]));
                }
            },
        );
        found.extend(nearest.map(|(distance, line)| (vertex, line, distance)));
    }
    let Draft { edges, notes, scale, .. } = draft;
    for (vertex, line, distance) in found {
        let message = "and is not joined to it";
        notes.add_with(WarningCode::NearMiss, message, || {
            let line = edges[line as usize].origin.place("edges_vertices");
            let detail = format!("is a loose end {} from {line}", Short(rounded(distance / *scale)));
            (Place::entry("vertices_coords", vertex as usize), detail)
        });
    }
}
