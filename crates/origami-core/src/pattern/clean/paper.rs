//! Which regions between the lines are paper, and the faces they make.

use super::draft::{Draft, EdgeMap};
use super::letters::Letter;
use super::loops::{OUTSIDE, Regions, regions};
use super::sides::{self, Sides};
use crate::csr::Csr;
use crate::error::{Error, ErrorCode, Place, WarningCode};
use crate::pattern::region;

/// Builds the faces of a flat draft whose edges meet at their ends only. `was` says what became of the file's own, where that
/// is to be told.
pub(super) fn build_faces(draft: &mut Draft, map: &mut EdgeMap, was: Option<&str>) -> Result<Sides, Error> {
    let regions = regions(draft);
    let paper = paper(draft, &regions);
    for (walks, _) in regions.loops.iter().zip(&paper).filter(|(_, paper)| **paper) {
        add_faces(draft, walks)?;
    }
    if draft.faces.is_empty() {
        return Err(no_paper());
    }
    // The region outside is none.
    let holes = paper.iter().skip(1).filter(|paper| !**paper).count();
    let (faces, holes) = (counted(draft.faces.len(), "face"), counted(holes, "hole"));
    if let Some(was) = was {
        let message = format!("{was}; built from the lines: {faces}, {holes}");
        draft.notes.add_once(WarningCode::FacesBuilt, "faces_vertices", message);
    }
    note_in_holes(draft, &regions, &paper);
    let sides = sides::collect(draft, map, Some(Letter::Join))?;
    for (edge, _) in sides.iter().enumerate().filter(|(_, pair)| pair[1].is_some()) {
        if draft.edges[edge].letter == Some(Letter::Boundary) {
            draft.edges[edge].letter = Some(Letter::Cut);
            let place = draft.edges[edge].origin.place("edges_assignment");
            let message = "with paper on both sides; the sheet is cut there";
            draft.notes.add_with(WarningCode::BoundaryCut, message, || (place, "B".into()));
        }
    }
    Ok(sides)
}

/// Warns of creases that lie in a hole: as a rule the sheet is taken for a hole in what was drawn around it.
fn note_in_holes(draft: &mut Draft, regions: &Regions, paper: &[bool]) {
    let in_hole = |half: usize| {
        let region = regions.left_of[half] as usize;
        region != OUTSIDE as usize && paper.get(region) == Some(&false)
    };
    let Draft { edges, notes, .. } = draft;
    for (index, edge) in edges.iter().enumerate().filter(|(_, edge)| edge.alias.is_none()) {
        if edge.letter.is_some_and(Letter::drives) && in_hole(2 * index) && in_hole(2 * index + 1) {
            let message = "lies in a hole and folds nothing; is the border around it a frame, and the hole the sheet?";
            notes.add_with(WarningCode::CreaseInHole, message, || (edge.origin.place("edges_vertices"), String::new()));
        }
    }
}

/// Such as `1 face`, `2 faces`.
fn counted(count: usize, one: &str) -> String {
    let end = if count == 1 { "" } else { "s" };
    format!("{count} {one}{end}")
}

/// The refusal of lines that make no face.
pub(super) fn no_paper() -> Error {
    let problem = "the lines enclose no paper, and there is no faces_vertices";
    Error::new(ErrorCode::NoPaper, Place::key("edges_vertices"), problem, "closed outlines, or faces")
}

/// Whether each region is paper. Crossing a boundary edge leads from outside into paper, from paper into a hole and from
/// there into paper again; other lines have the same on both sides. In doubt it is paper.
fn paper(draft: &Draft, regions: &Regions) -> Vec<bool> {
    let lines = draft.edges.iter().enumerate().filter(|(_, edge)| edge.alias.is_none());
    let crossings = lines.flat_map(|(index, edge)| {
        let [a, b] = [regions.left_of[2 * index], regions.left_of[2 * index + 1]];
        let boundary = edge.letter == Some(Letter::Boundary);
        [(a as usize, (b, boundary)), (b as usize, (a, boundary))]
    });
    let neighbours = Csr::from_entries(regions.loops.len(), crossings);
    let mut paper: Vec<Option<bool>> = vec![None; regions.loops.len()];
    paper[OUTSIDE as usize] = Some(false);
    flood(&neighbours, &mut paper, vec![OUTSIDE]);
    // What no boundary edge closes off from outside.
    let open = |paper: &[Option<bool>]| {
        neighbours
            .row(OUTSIDE as usize)
            .iter()
            .map(|next| next.0)
            .filter(|&next| paper[next as usize].is_none())
            .collect()
    };
    let mut rest: Vec<u32> = open(&paper);
    rest.sort_unstable();
    rest.dedup();
    rest.iter().for_each(|&region| paper[region as usize] = Some(true));
    flood(&neighbours, &mut paper, rest);
    paper.into_iter().map(|mark| mark.unwrap_or(true)).collect()
}

/// Spreads from regions of one kind, all that can be reached without crossing a boundary edge before any beyond one.
/// Outside, only boundary edges are crossed.
fn flood(neighbours: &Csr<(u32, bool)>, paper: &mut [Option<bool>], mut layer: Vec<u32>) {
    while !layer.is_empty() {
        let mut beyond = Vec::new();
        let mut at = 0;
        while let Some(&region) = layer.get(at) {
            at += 1;
            for &(next, boundary) in neighbours.row(region as usize) {
                if boundary {
                    beyond.push((next, paper[region as usize] == Some(false)));
                } else if region != OUTSIDE && paper[next as usize].is_none() {
                    paper[next as usize] = paper[region as usize];
                    layer.push(next);
                }
            }
        }
        layer = Vec::new();
        for (next, mark) in beyond {
            if paper[next as usize].is_none() {
                paper[next as usize] = Some(mark);
                layer.push(next);
            }
        }
    }
}

/// A region without islands is one face; one with islands is handed out in triangles.
fn add_faces(draft: &mut Draft, walks: &[Vec<u32>]) -> Result<(), Error> {
    let vertex = |half: u32| draft.edges[half as usize / 2].ends[half as usize % 2];
    let corners: Vec<Vec<u32>> = walks.iter().map(|walk| walk.iter().map(|&half| vertex(half)).collect()).collect();
    if let [only] = corners.as_slice() {
        draft.faces.push(only.clone());
        return Ok(());
    }
    let place = |&v: &u32| draft.points[v as usize].truncate();
    let outlines: Vec<Vec<_>> = corners.iter().map(|corners| corners.iter().map(place).collect()).collect();
    let flat: Vec<u32> = corners.concat();
    let triangles = region::triangulate(&outlines).map_err(|fault| {
        let edge = draft.edges[walks[0][0] as usize / 2].origin.place("edges_vertices");
        let problem = format!("the region beside it {fault}");
        Error::new(ErrorCode::FaceNotSimple, edge, problem, "a region with separate islands")
    })?;
    draft.faces.extend(triangles.iter().map(|corners| corners.iter().map(|&corner| flat[corner]).collect::<Vec<_>>()));
    Ok(())
}
