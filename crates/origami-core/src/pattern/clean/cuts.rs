//! The sheet comes apart along its cuts.

use super::draft::{Draft, DraftEdge};
use super::letters::Letter;
use super::sides::{Side, Sides};
use crate::error::WarningCode;

/// Opens all cuts between two faces. At each vertex on a cut the corners of the faces are grouped by what still hangs
/// together; the first group, in the order of the faces, keeps the vertex, each other one gets a copy. A cut becomes
/// two boundary edges, the second appended.
pub(super) fn open(draft: &mut Draft, sides: &Sides) {
    let is_cut = |edge: usize| sides[edge][1].is_some() && draft.edges[edge].letter == Some(Letter::Cut);
    let cuts: Vec<usize> = (0..sides.len()).filter(|&edge| is_cut(edge)).collect();
    if cuts.is_empty() {
        return;
    }
    let corners = Corners::new(&draft.faces);
    let mut groups = Groups((0..corners.total()).collect());
    for (edge, pair) in sides.iter().enumerate() {
        if let ([Some(one), Some(two)], false) = (pair, is_cut(edge)) {
            // They run against each other: where one starts the other ends.
            groups.join(corners.start(*one), corners.end(*two));
            groups.join(corners.end(*one), corners.start(*two));
        }
    }
    let mut on_cut = vec![false; draft.points.len()];
    cuts.iter().for_each(|&edge| draft.edges[edge].ends.iter().for_each(|&v| on_cut[v as usize] = true));
    copy_vertices(draft, &corners, &mut groups, &on_cut);
    rename_ends(draft, sides);
    for edge in cuts {
        let [Some(one), Some(two)] = sides[edge].map(|side| side.map(|side| side.ends(&draft.faces))) else { continue };
        if one == two || one == [two[1], two[0]] {
            let place = draft.edges[edge].origin.place("edges_assignment");
            let message = "cut whose ends are both inside the sheet: it cannot open, and is a free hinge";
            draft.notes.add_with(WarningCode::ClosedCut, message, || (place, String::new()));
            draft.edges[edge].letter = Some(Letter::Unassigned);
        } else {
            draft.edges[edge].letter = Some(Letter::Boundary);
            let lip = draft.edges[edge].clone();
            draft.edges.push(DraftEdge { ends: two, ..lip });
        }
    }
}

fn copy_vertices(draft: &mut Draft, corners: &Corners, groups: &mut Groups, on_cut: &[bool]) {
    let mut taken = vec![false; draft.points.len()];
    let mut vertex_of_group: Vec<Option<u32>> = vec![None; corners.total() as usize];
    for face in 0..draft.faces.len() {
        for corner in 0..draft.faces[face].len() {
            let vertex = draft.faces[face][corner];
            if !on_cut[vertex as usize] {
                continue;
            }
            let group = groups.find(corners.first[face] + corner as u32) as usize;
            let own = vertex_of_group[group].unwrap_or_else(|| {
                if std::mem::replace(&mut taken[vertex as usize], true) {
                    draft.push_vertex(draft.points[vertex as usize], draft.fixed[vertex as usize])
                } else {
                    vertex
                }
            });
            vertex_of_group[group] = Some(own);
            draft.faces[face][corner] = own;
        }
    }
}

/// Ends of edges follow their first face, and keep their order.
fn rename_ends(draft: &mut Draft, sides: &Sides) {
    for (edge, pair) in sides.iter().enumerate() {
        let Some(side) = pair[0] else { continue };
        let edge = &mut draft.edges[edge];
        let [from, to] = side.ends(&draft.faces);
        let place = |v: u32| draft.points[v as usize];
        let forward = place(edge.ends[0]) == place(from) && place(edge.ends[1]) == place(to);
        edge.ends = if forward { [from, to] } else { [to, from] };
    }
}

/// Numbers for the corners of all faces: those of face `f` start at `first[f]`.
struct Corners {
    first: Vec<u32>,
}

impl Corners {
    fn new(faces: &[Vec<u32>]) -> Self {
        let mut first = vec![0];
        first.extend(faces.iter().scan(0, |sum, face| {
            *sum += face.len() as u32;
            Some(*sum)
        }));
        Self { first }
    }

    fn total(&self) -> u32 {
        self.first[self.first.len() - 1]
    }

    fn start(&self, side: Side) -> u32 {
        self.first[side.face as usize] + side.corner
    }

    fn end(&self, side: Side) -> u32 {
        let [first, next] = [0, 1].map(|more| self.first[side.face as usize + more]);
        first + (side.corner + 1) % (next - first)
    }
}

/// Disjoint sets, halving paths.
struct Groups(Vec<u32>);

impl Groups {
    fn find(&mut self, mut item: u32) -> u32 {
        while self.0[item as usize] != item {
            let above = self.0[self.0[item as usize] as usize];
            self.0[item as usize] = above;
            item = above;
        }
        item
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
