//! The edges around each inner vertex, with the sectors between them.

use std::f64::consts::TAU;

use super::corners::{Corner, Edges, corners, place};
use crate::ids::{EdgeId, VertexId};
use crate::pattern::CreasePattern;

/// Sectors that do not add up to a full turn within this, in radians, do not lie around their vertex in one layer.
const FULL_TURN: f64 = 1e-6;

/// An inner vertex with all that meets there.
pub(super) struct Ring {
    pub(super) vertex: VertexId,
    /// Each edge with the sector that follows it counterclockwise, in radians.
    pub(super) spokes: Vec<(EdgeId, f64)>,
}

/// The rings of all vertices that lie inside the sheet, by vertex.
pub(super) fn rings(pattern: &CreasePattern) -> Vec<Ring> {
    let (corners, edges) = (corners(pattern), Edges::of(pattern));
    let turned_over: Vec<bool> = pattern.faces.iter().map(|face| is_turned_over(pattern, face)).collect();
    let of = |(vertex, corners): (usize, &[Corner])| {
        let vertex = VertexId::new(vertex);
        let sector = |corner: &Corner| sector(pattern, vertex, corner, turned_over[corner.face as usize]);
        let mut spokes: Vec<(VertexId, &Corner)> = corners.iter().map(|corner| (corner.next, corner)).collect();
        spokes.sort_unstable_by_key(|(next, _)| *next);
        let first = spokes.first()?.0;
        let (mut at, mut ring) = (first, Vec::with_capacity(spokes.len()));
        for _ in 0..spokes.len() {
            let (_, corner) = spokes[spokes.binary_search_by_key(&at, |(next, _)| *next).ok()?];
            ring.push((edges.between(vertex, at)?, sector(corner)));
            at = corner.previous;
        }
        // A vertex on the rim ends at the rim; where two fans meet in a point there are two loops; the tip of a crease that
        // ends inside a face is an open end.
        let closed = ring.len() > 1
            && at == first
            && (ring.iter().map(|(_, sector)| sector).sum::<f64>() - TAU).abs() < FULL_TURN;
        closed.then_some(Ring { vertex, spokes: ring })
    };
    corners.iter().enumerate().filter_map(of).collect()
}

/// Whether a face is seen from its back.
fn is_turned_over(pattern: &CreasePattern, face: &[VertexId]) -> bool {
    let sides = face.iter().zip(face.iter().cycle().skip(1));
    sides.map(|(a, b)| place(pattern, *a).perp_dot(place(pattern, *b))).sum::<f64>() < 0.0
}

/// The angle of a face at one of its corners, more than 0 and at most a full turn.
fn sector(pattern: &CreasePattern, vertex: VertexId, corner: &Corner, turned_over: bool) -> f64 {
    let [next, previous] = [corner.next, corner.previous].map(|other| place(pattern, other) - place(pattern, vertex));
    let across = if turned_over { -next.perp_dot(previous) } else { next.perp_dot(previous) };
    let angle = across.atan2(next.dot(previous));
    // At the tip of a crease that ends inside a face both sides are one.
    if angle <= 0.0 { angle + TAU } else { angle }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::Miura;

    #[test]
    fn a_miura_has_its_sectors_around_each_inner_vertex() {
        let miura = Miura { columns: 4, rows: 3, ..Miura::default() };
        let rings = rings(&miura.pattern().expect("a pattern"));
        assert_eq!(rings.len(), 3 * 2, "the inner vertices of 4 x 3");
        for ring in rings {
            let mut sectors: Vec<f64> = ring.spokes.iter().map(|(_, sector)| *sector).collect();
            assert_eq!(sectors.len(), 4);
            sectors.sort_by(f64::total_cmp);
            assert!((sectors[0] - sectors[1]).abs() < 1e-12 && (sectors[2] - sectors[3]).abs() < 1e-12);
            assert!((sectors[0] + sectors[2] - TAU / 2.0).abs() < 1e-12);
        }
    }
}
