//! Which faces lie at an edge.

use super::draft::{Draft, DraftEdge, EdgeMap};
use super::letters::Letter;
use crate::error::{Error, ErrorCode};

/// The side of a face that runs from one corner to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Side {
    pub(super) face: u32,
    pub(super) corner: u32,
}

impl Side {
    /// The vertices from and to which it runs.
    pub(super) fn ends(self, faces: &[Vec<u32>]) -> [u32; 2] {
        let face = &faces[self.face as usize];
        let corner = self.corner as usize;
        [face[corner], face[(corner + 1) % face.len()]]
    }
}

/// The one or two sides at each edge, in the order of the faces; none at an edge outside all faces.
pub(super) type Sides = Vec<[Option<Side>; 2]>;

/// Finds the edge of every side of every face. Sides that no edge has yet get one, with `letter`.
pub(super) fn collect(draft: &mut Draft, map: &mut EdgeMap, letter: Option<Letter>) -> Result<Sides, Error> {
    if add_missing(draft, map, letter) {
        *map = EdgeMap::new(draft.points.len(), &draft.edges);
    }
    let mut sides: Sides = vec![[None; 2]; draft.edges.len()];
    for side in sides_of(&draft.faces) {
        let edge = map.get(side.ends(&draft.faces)).expect("every side has an edge by now");
        match &mut sides[edge] {
            [free @ None, _] | [Some(_), free @ None] => *free = Some(side),
            [Some(a), Some(b)] => {
                let place = draft.edges[edge].origin.place("edges_vertices");
                let problem = format!("the line is a side of faces_vertices {}, {} and {}", a.face, b.face, side.face);
                return Err(Error::new(ErrorCode::EdgeOfManyFaces, place, problem, "at most two faces at an edge"));
            }
        }
    }
    Ok(sides)
}

fn sides_of(faces: &[Vec<u32>]) -> impl Iterator<Item = Side> {
    let of = |(face, corners): (u32, usize)| (0..corners as u32).map(move |corner| Side { face, corner });
    (0..).zip(faces.iter().map(Vec::len)).flat_map(of)
}

/// Appends the edges that sides lack, in the order of the sides. Says whether there were any.
fn add_missing(draft: &mut Draft, map: &EdgeMap, letter: Option<Letter>) -> bool {
    let lacking = |(place, side): (usize, Side)| {
        let [a, b] = side.ends(&draft.faces);
        map.get([a, b]).is_none().then_some(([a.min(b), a.max(b)], place, side))
    };
    let mut missing: Vec<_> = sides_of(&draft.faces).enumerate().filter_map(lacking).collect();
    missing.sort_unstable_by_key(|(ends, place, _)| (*ends, *place));
    missing.dedup_by_key(|(ends, ..)| *ends);
    missing.sort_unstable_by_key(|(_, place, _)| *place);
    for (.., side) in &missing {
        draft.edges.push(DraftEdge::new(side.ends(&draft.faces), letter, side.face as usize));
    }
    !missing.is_empty()
}
