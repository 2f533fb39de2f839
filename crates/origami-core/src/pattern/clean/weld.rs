//! Faces in space that do not hang together though they touch: corners that each face has for itself are made one, and
//! corners on the open side of another face are put into it.

use glam::DVec3;

use super::draft::{Draft, DraftEdge};
use super::joins::{Meeting, on_line, on_vertex};
use super::sides::Sides;

/// Open vertices in the order of their x, so that those near a place are found.
struct Open {
    vertices: Vec<(f64, u32)>,
    touch: f64,
}

impl Open {
    fn near(&self, low: f64, high: f64) -> impl Iterator<Item = u32> {
        let first = self.vertices.partition_point(|(x, _)| *x < low - self.touch);
        let until = high + self.touch;
        self.vertices[first..].iter().take_while(move |(x, _)| *x <= until).map(|(_, vertex)| *vertex)
    }
}

/// The faces with their open sides welded to what they touch, within `touch`; the draft's vertices and edges follow. `open`
/// are the ends of edges that have one face, in the numbers of the file. Says what was joined.
pub(super) fn weld(draft: &mut Draft, faces: &mut [Vec<u32>], open: &[[u32; 2]], touch: f64) -> Vec<Meeting> {
    let mut vertices: Vec<u32> = open.iter().flatten().copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    let place = |v: u32| draft.points[v as usize];
    let mut sorted: Vec<(f64, u32)> = vertices.iter().map(|&v| (place(v).x, v)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let all = Open { vertices: sorted, touch };
    let mut meetings = Vec::new();
    let mut stands_for: Vec<u32> = (0..draft.points.len() as u32).collect();
    for &vertex in &vertices {
        let at = place(vertex);
        let is_first = |other: &u32| *other < vertex && stands_for[*other as usize] == *other;
        let first = all.near(at.x, at.x).filter(is_first).find(|&other| place(other).distance(at) <= touch);
        if let Some(first) = first {
            stands_for[vertex as usize] = first;
            meetings.push(on_vertex(vertex, first, place(first).distance(at)));
        }
    }
    let stands = |v: u32| stands_for[v as usize];
    faces.iter_mut().flatten().for_each(|vertex| *vertex = stands(*vertex));
    for vertex in 0..draft.points.len() as u32 {
        if stands(vertex) != vertex {
            draft.vertex_alias[vertex as usize] = Some(stands(vertex));
            draft.fixed[stands(vertex) as usize] |= draft.fixed[vertex as usize];
        }
    }
    // What lies on each open side, from its lower end to its upper one.
    let mut sides: Vec<([u32; 2], Vec<u32>)> = Vec::new();
    for ends in open {
        let [a, b] = ends.map(stands);
        let ends = [a.min(b), a.max(b)];
        let [low, high] = ends.map(place);
        let on = all.near(low.x.min(high.x), low.x.max(high.x)).filter(|&v| stands(v) == v && !ends.contains(&v));
        let mut on: Vec<(f64, u32)> = on.filter_map(|v| Some((share(place(v), low, high, touch)?, v))).collect();
        on.sort_by(|a, b| a.0.total_cmp(&b.0));
        if !on.is_empty() {
            sides.push((ends, on.into_iter().map(|(_, v)| v).collect()));
        }
    }
    sides.sort();
    sides.dedup();
    let on_side = |a: u32, b: u32| -> Vec<u32> {
        let Ok(at) = sides.binary_search_by(|side| side.0.cmp(&[a.min(b), a.max(b)])) else { return Vec::new() };
        let mut on = sides[at].1.clone();
        if a > b {
            on.reverse();
        }
        on
    };
    for face in faces.iter_mut() {
        let whole = face.clone();
        face.clear();
        for (&a, &b) in whole.iter().zip(whole.iter().cycle().skip(1)) {
            face.push(a);
            face.extend(on_side(a, b).into_iter().filter(|v| !whole.contains(v)));
        }
    }
    let mut pieces: Vec<DraftEdge> = Vec::new();
    for (index, edge) in draft.edges.iter_mut().enumerate() {
        let [a, b] = edge.ends.map(stands);
        let stops = on_side(a, b);
        for &vertex in &stops {
            let [from, to] = [a, b].map(|v| draft.points[v as usize]);
            let at = draft.points[vertex as usize];
            let along = to - from;
            let foot = from + along * ((at - from).dot(along) / along.length_squared());
            meetings.push(on_line(vertex, index as u32, foot.distance(at)));
        }
        let chain: Vec<u32> = [a].into_iter().chain(stops).chain([b]).collect();
        edge.ends = [chain[0], chain[1]];
        pieces.extend(chain[1..].windows(2).map(|ends| DraftEdge { ends: [ends[0], ends[1]], ..edge.clone() }));
    }
    draft.edges.extend(pieces);
    meetings
}

/// At which share of the way from one place to the other a point lies, if it lies on it and between them.
fn share(point: DVec3, from: DVec3, to: DVec3, touch: f64) -> Option<f64> {
    let along = to - from;
    let share = (point - from).dot(along) / along.length_squared();
    (share > 0.0 && share < 1.0 && (from + share * along).distance(point) <= touch).then_some(share)
}

/// The ends of all edges that have one face.
pub(super) fn open_sides(draft: &Draft, sides: &Sides) -> Vec<[u32; 2]> {
    let open = draft.edges.iter().zip(sides).filter(|(_, pair)| pair[0].is_some() && pair[1].is_none());
    open.map(|(edge, _)| edge.ends).collect()
}
