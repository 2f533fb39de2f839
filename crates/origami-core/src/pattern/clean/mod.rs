//! From a FOLD frame to a crease pattern, one step a file: read letters, angles and overrides; take the faces that the file
//! gives and orient them, or build them from the planar graph (join near misses, split, close the border, trace, tell paper
//! from holes); settle letters and angles; open the cuts.

mod angles;
mod arrays;
mod border;
mod boxes;
mod cuts;
mod draft;
mod faces_given;
mod graph;
mod joins;
mod letters;
mod level;
mod loops;
mod near;
mod near_misses;
mod notes;
mod orient;
mod overrides;
mod paper;
mod planar;
mod repair;
mod rings;
mod sides;
mod sources;
mod tolerance;
mod weld;

use glam::{DMat3, DVec3};

use angles::Keys;
use draft::{Draft, DraftEdge, EdgeMap};
use letters::Letter;
use notes::Notes;
use repair::Doubt;
use sides::Sides;
use sources::Sources;

use crate::error::{Error, ErrorCode, Place, Short, WarningCode, rounded};
use crate::fold::Frame;
use crate::ids::{EdgeId, VertexId};
use crate::pattern::crease_pattern::{CreasePattern, PatternEdge};
use crate::pattern::reading::Reading;
use crate::pattern::{hull, plane};

/// Area lost below this share of the whole is rounding.
const LOST: f64 = 1e-9;

/// The cleaned pattern of a frame.
pub(super) fn pattern(frame: &Frame, reading: &Reading) -> Result<CreasePattern, Error> {
    let sources = Sources::of(frame);
    let mut pattern = cleaned(frame, reading, &sources).map_err(|error| sources.of_error(error))?;
    pattern.warnings.iter_mut().for_each(|warning| sources.of_warning(warning));
    Ok(pattern)
}

fn cleaned(frame: &Frame, reading: &Reading, sources: &Sources) -> Result<CreasePattern, Error> {
    let mut sheet = Sheet::read(frame, reading)?;
    let faces = frame.faces_vertices.as_deref().unwrap_or_default();
    let sides = if faces.is_empty() { sheet.find_faces(frame) } else { with_faces(&mut sheet, frame, reading) }?;
    let Sheet { mut draft, .. } = sheet;
    note_isolated(&mut draft);
    let keys = Keys { letters: frame.edges_assignment.is_some(), angles: frame.edges_fold_angle.is_some() };
    angles::settle(&mut draft, &sides, keys);
    let lost = lost(&mut draft);
    cuts::open(&mut draft, &sides);
    let sources = sources.of_edges(&draft.edges);
    Ok(CreasePattern { sources, ..finish(draft, sheet.vertices, sheet.in_file, sheet.turn, lost) })
}

/// What the file has, before there are faces.
struct Sheet {
    draft: Draft,
    vertices: Vec<DVec3>,
    in_file: [usize; 2],
    /// What turned the points to a height z of their own; `None`: they are as in the file.
    turn: Option<DMat3>,
}

impl Sheet {
    fn read(frame: &Frame, reading: &Reading) -> Result<Self, Error> {
        let mut notes = Notes::default();
        let vertices = arrays::vertices(frame, &mut notes)?;
        let edges = arrays::edges(frame, vertices.len(), &mut notes)?;
        let in_file = [vertices.len(), edges.len()];
        let scale = plane::unit_scale(arrays::size(&vertices)?);
        let draft = Draft {
            scale,
            join: reading.join()?.map(|join| join * scale),
            flat: plane::is_flat(&vertices),
            points: vertices.iter().map(|&vertex| vertex * scale).collect(),
            moved: Vec::new(),
            vertex_alias: vec![None; vertices.len()],
            fixed: overrides::fixed(frame, vertices.len())?,
            edges,
            faces: Vec::new(),
            joins: Vec::new(),
            notes,
        };
        Ok(Self { draft, vertices, in_file, turn: None })
    }

    /// Faces between the lines of a file that has none.
    fn find_faces(&mut self, frame: &Frame) -> Result<Sides, Error> {
        let draft = &mut self.draft;
        if draft.edges.is_empty() {
            let problem = "is missing or empty, and so is faces_vertices";
            let place = Place::key("edges_vertices");
            return Err(Error::new(ErrorCode::MissingKey, place, problem, "edges, or faces, or both"));
        }
        if !draft.flat {
            let Some(turn) = level::turn(&draft.points) else {
                let problem = "is missing, and the vertices do not lie in one plane";
                let place = Place::key("faces_vertices");
                return Err(Error::new(ErrorCode::MissingKey, place, problem, "the faces of a sheet in space"));
            };
            draft.points.iter_mut().for_each(|point| *point = turn * *point);
            draft.flat = true;
            self.turn = Some(turn);
        }
        let was = if frame.faces_vertices.is_some() { "is empty" } else { "is missing" };
        found(&mut self.draft, Some(was))
    }
}

/// The faces between the lines of a flat draft. `was`: what became of those of the file, where that is to be told.
fn found(draft: &mut Draft, was: Option<&str>) -> Result<Sides, Error> {
    let mut map = planar::arrange(draft)?;
    border::close(draft, &mut map)?;
    near_misses::note(draft);
    paper::build_faces(draft, &mut map, was)
}

/// The faces of the file, or, where they contradict its lines, those found anew.
fn with_faces(sheet: &mut Sheet, frame: &Frame, reading: &Reading) -> Result<Sides, Error> {
    let faces = frame.faces_vertices.as_deref().unwrap_or_default();
    let given = taken(&mut sheet.draft, faces);
    let may_differ = sheet.draft.flat && sheet.in_file[1] > 0 && !repair::is_folded(frame);
    let doubt = match &given {
        Ok(sides) => repair::doubt(&sheet.draft, sides),
        Err(error) if repair::may_cure(error) => Doubt::Face,
        Err(_) => Doubt::None,
    };
    if doubt == Doubt::None {
        return given;
    }
    let mut anew = Sheet::read(frame, reading)?;
    let (found, cure) = match &given {
        _ if may_differ => {
            repair::list_sides(&mut anew.draft, faces);
            (found(&mut anew.draft, None), "the faces were found anew from the lines")
        }
        Ok(old) if !sheet.draft.flat => {
            let open = weld::open_sides(&sheet.draft, old);
            (welded(&mut anew.draft, faces, &open), "faces that touch were joined")
        }
        _ => return given,
    };
    let Ok(sides) = found else { return given };
    if let Ok(old) = &given
        && !repair::is_better((&anew.draft, &sides), (&sheet.draft, old), doubt)
    {
        return given;
    }
    repair::note(&mut anew.draft, faces, cure);
    *sheet = anew;
    Ok(sides)
}

/// The faces of a sheet in space, joined where their open sides touch.
fn welded(draft: &mut Draft, faces: &[Vec<u32>], open: &[[u32; 2]]) -> Result<Sides, Error> {
    let mut faces = faces.to_vec();
    let rounding = tolerance::TOUCH * plane::extent(&draft.points).max_element();
    let meetings = weld::weld(draft, &mut faces, open, draft.join.unwrap_or(rounding));
    joins::note(draft, &meetings, rounding);
    taken(draft, &faces)
}

/// The faces of the file as they are.
fn taken(draft: &mut Draft, faces: &[Vec<u32>]) -> Result<Sides, Error> {
    arrays::countable("faces_vertices", faces.iter().map(Vec::len).sum())?;
    // A line between two faces that a list of edges leaves out is no crease.
    let unlisted = (!draft.edges.is_empty()).then_some(Letter::Join);
    let mut map: EdgeMap = faces_given::take(draft, faces)?;
    let listed = draft.edges.len();
    let sides = sides::collect(draft, &mut map, unlisted)?;
    if unlisted.is_some() {
        let message = "has a side that edges_vertices does not list; between two faces it is taken as flat";
        for edge in &draft.edges[listed..] {
            draft
                .notes
                .add_with(WarningCode::UnlistedSide, message, || (edge.origin.place("edges_vertices"), String::new()));
        }
    }
    let turned = orient::orient(draft, &sides)?;
    orient::note_clockwise(draft);
    if turned { sides::collect(draft, &mut map, unlisted) } else { Ok(sides) }
}

/// The area that the lines of a flat draft span and its faces do not, with a warning where there is some.
fn lost(draft: &mut Draft) -> f64 {
    if !draft.flat {
        return 0.0;
    }
    let at = |v: &u32| draft.points[*v as usize].truncate();
    let lines = hull::area(draft.edges.iter().filter(|edge| edge.alias.is_none()).flat_map(|edge| &edge.ends).map(at));
    let faces = hull::area(draft.faces.iter().flatten().map(at));
    let lost = (lines - faces).max(0.0);
    if lost <= LOST * lines {
        return 0.0;
    }
    let area = lost / (draft.scale * draft.scale);
    let percent = rounded(100.0 * lost / lines);
    let message = format!(
        "lines lie outside all faces: of the area that they span, {} ({percent} %) is no paper",
        Short(rounded(area))
    );
    draft.notes.add_once(WarningCode::PaperLost, "edges_vertices", message);
    area
}

fn note_isolated(draft: &mut Draft) {
    let mut used: Vec<bool> = draft.vertex_alias.iter().map(Option::is_some).collect();
    let ends = draft.edges.iter().filter(|edge| edge.alias.is_none()).flat_map(|edge| edge.ends);
    ends.for_each(|vertex| used[vertex as usize] = true);
    for (vertex, _) in used.iter().enumerate().filter(|(_, used)| !**used) {
        let message = "belongs to no edge and no face; it stays where it is";
        draft.notes.add(WarningCode::IsolatedVertex, "vertices_coords", vertex, message);
    }
}

/// The finished pattern. Vertices of the file keep their exact coordinates, but for loose ends that were joined to a line.
fn finish(
    draft: Draft,
    mut vertices: Vec<DVec3>,
    in_file: [usize; 2],
    turn: Option<DMat3>,
    lost_area: f64,
) -> CreasePattern {
    let back = turn.map(|turn| turn.transpose());
    let placed = |&point: &DVec3| back.map_or(point, |back| back * point) / draft.scale;
    vertices.extend(draft.points[vertices.len()..].iter().map(placed));
    for &vertex in &draft.moved {
        vertices[vertex as usize] = placed(&draft.points[vertex as usize]);
    }
    let edge = |edge: DraftEdge| PatternEdge {
        vertices: edge.ends.map(VertexId),
        assignment: edge.letter.unwrap_or(Letter::Unassigned).assignment(),
        fold_angle: edge.fold_angle,
        k_crease: edge.k_crease,
        ea: edge.ea,
        alias_of: edge.alias.map(EdgeId),
    };
    let mut edges: Vec<PatternEdge> = draft.edges.into_iter().map(edge).collect();
    // They were made where the larger ones lay.
    edges.shrink_to_fit();
    let live_fixed = |&v: &usize| draft.fixed[v] && draft.vertex_alias[v].is_none();
    CreasePattern {
        fixed: (0..vertices.len()).filter(live_fixed).map(VertexId::new).collect(),
        vertices,
        alias_of: draft.vertex_alias.into_iter().map(|alias| alias.map(VertexId)).collect(),
        edges,
        faces: draft.faces.into_iter().map(|face| face.into_iter().map(VertexId).collect()).collect(),
        vertices_in_file: in_file[0],
        edges_in_file: in_file[1],
        joins: draft.joins,
        lost_area,
        warnings: draft.notes.into_warnings(),
        sources: Vec::new(),
    }
}
