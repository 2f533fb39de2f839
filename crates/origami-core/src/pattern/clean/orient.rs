//! Faces turned so that neighbours agree on which side of the sheet is up.

use super::draft::Draft;
use super::letters::Letter;
use super::sides::Sides;
use crate::csr::Csr;
use crate::error::{Error, ErrorCode, WarningCode};
use crate::pattern::plane::area_vector;

/// How another face lies at a side of this one.
#[derive(Clone, Copy)]
struct Neighbour {
    face: u32,
    edge: u32,
    /// Both run along the edge in the same direction, so one of them is upside down.
    disagrees: bool,
}

/// Turns faces over until all that meet at an edge agree; cuts do not count. In each connected piece the orientation
/// with the larger area wins. Says whether any face was turned, which makes `sides` stale.
pub(super) fn orient(draft: &mut Draft, sides: &Sides) -> Result<bool, Error> {
    let meetings = sides.iter().enumerate().filter_map(|(edge, pair)| {
        let [a, b] = [pair[0]?, pair[1]?];
        let disagrees = a.ends(&draft.faces) == b.ends(&draft.faces);
        let cut = draft.edges[edge].letter == Some(Letter::Cut);
        (!cut).then_some((a.face, b.face, edge as u32, disagrees))
    });
    if !meetings.clone().any(|(.., disagrees)| disagrees) {
        return Ok(false);
    }
    let both = meetings.flat_map(|(a, b, edge, disagrees)| {
        [(a as usize, Neighbour { face: b, edge, disagrees }), (b as usize, Neighbour { face: a, edge, disagrees })]
    });
    let neighbours = Csr::from_entries(draft.faces.len(), both);
    let mut turned: Vec<Option<bool>> = vec![None; draft.faces.len()];
    for seed in 0..draft.faces.len() {
        if turned[seed].is_none() {
            let piece = walk(draft, &neighbours, &mut turned, seed)?;
            settle(draft, &piece, &mut turned);
        }
    }
    let mut any = false;
    for (index, _) in turned.iter().enumerate().filter(|(_, turned)| **turned == Some(true)) {
        draft.faces[index][1..].reverse();
        let message = "runs the other way round than its neighbours; turned over";
        draft.notes.add(WarningCode::FaceTurned, "faces_vertices", index, message);
        any = true;
    }
    Ok(any)
}

/// Warns of faces of a flat pattern that are seen from their back: as a rule all, or half of a form folded flat.
pub(super) fn note_clockwise(draft: &mut Draft) {
    if !draft.flat {
        return;
    }
    let Draft { faces, points, notes, .. } = draft;
    for (index, face) in faces.iter().enumerate() {
        if area_vector(face.iter().map(|&v| points[v as usize])).z < 0.0 {
            let message = "runs clockwise: its letters and angles are taken as seen from the other side";
            notes.add(WarningCode::FaceClockwise, "faces_vertices", index, message);
        }
    }
}

/// Marks every face that hangs together with `seed` as agreeing with it or as turned; gives their list.
fn walk(
    draft: &Draft,
    neighbours: &Csr<Neighbour>,
    turned: &mut [Option<bool>],
    seed: usize,
) -> Result<Vec<u32>, Error> {
    turned[seed] = Some(false);
    let mut piece = vec![seed as u32];
    let mut at = 0;
    while let Some(&face) = piece.get(at) {
        at += 1;
        let here = turned[face as usize] == Some(true);
        for next in neighbours.row(face as usize) {
            let there = here != next.disagrees;
            match turned[next.face as usize] {
                None => {
                    turned[next.face as usize] = Some(there);
                    piece.push(next.face);
                }
                Some(mark) if mark != there => {
                    let place = draft.edges[next.edge as usize].origin.place("edges_vertices");
                    let problem = format!(
                        "faces_vertices {face} and {} cannot be turned to agree: the sheet has one side only",
                        next.face
                    );
                    return Err(Error::new(ErrorCode::OneSided, place, problem, "a sheet with two sides"));
                }
                Some(_) => {}
            }
        }
    }
    Ok(piece)
}

/// Lets the larger area of a piece keep its orientation; on a tie the piece shall be counterclockwise.
fn settle(draft: &Draft, piece: &[u32], turned: &mut [Option<bool>]) {
    let (mut kept, mut other, mut upward) = (0.0, 0.0, 0.0);
    for &face in piece {
        let area = area_vector(draft.faces[face as usize].iter().map(|&v| draft.points[v as usize]));
        if turned[face as usize] == Some(true) {
            other += area.length();
            upward -= area.z;
        } else {
            kept += area.length();
            upward += area.z;
        }
    }
    let tie = (kept - other).abs() <= 1e-12 * (kept + other);
    if (tie && draft.flat && upward < 0.0) || (!tie && other > kept) {
        for &face in piece {
            turned[face as usize] = turned[face as usize].map(|mark| !mark);
        }
    }
}
