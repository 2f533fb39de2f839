//! Which faces lie at an edge.

use super::draft::{Draft, DraftEdge, EdgeMap};
use super::letters::Letter;
use crate::error::Error;

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
    let mut sides: Sides = vec![[None; 2]; draft.edges.len()];
    for (index, face) in draft.faces.iter().enumerate() {
        for corner in 0..face.len() {
            let side = Side { face: index as u32, corner: corner as u32 };
            let ends = side.ends(&draft.faces);
            let edge = map.get(ends).unwrap_or_else(|| {
                map.enter(ends, draft.edges.len());
                draft.edges.push(DraftEdge::new(ends, letter, index));
                sides.push([None; 2]);
                draft.edges.len() - 1
            });
            match &mut sides[edge] {
                [free @ None, _] | [Some(_), free @ None] => *free = Some(side),
                [Some(a), Some(b)] => {
                    let place = draft.edges[edge].origin.place("edges_vertices");
                    let problem = format!("the line is a side of faces_vertices {}, {} and {index}", a.face, b.face);
                    return Err(Error::invalid(place, problem, "at most two faces at an edge"));
                }
            }
        }
    }
    Ok(sides)
}
