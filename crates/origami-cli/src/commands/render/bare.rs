//! The lines of a frame of which no sheet can be made: drawn as they are, so that one can see why.

use origami::error::{Error, ErrorCode, Place};
use origami::fold::Frame;
use origami::glam::DVec3;
use origami::ids::VertexId;
use origami::pattern::{Assignment, CreasePattern, PatternEdge};

/// Lines without faces.
pub(super) struct Bare {
    /// The lines, in the plane of the picture.
    pub(super) lines: CreasePattern,
    /// Where a line ends that nothing else touches.
    pub(super) open_ends: Vec<DVec3>,
    /// The places that the refusal names.
    pub(super) blamed: Vec<DVec3>,
}

impl Bare {
    /// The lines of `frame`, whose reading ended with `refusal`; `None` where there are none to draw.
    pub(super) fn of(frame: &Frame, refusal: &Error) -> Option<Self> {
        // What the system or the text refused has no lines.
        if matches!(refusal.code(), ErrorCode::Io | ErrorCode::NotUtf8 | ErrorCode::NotJson) {
            return None;
        }
        let places: Vec<Option<DVec3>> = { frame.vertices_coords.as_ref()?.iter() }
            .map(|coords| Some(coords.position).filter(|p| p.is_finite() && p.abs().max_element() < 1e100))
            .collect();
        let vertices = seen_from_above(&places);
        let there = |vertex: u32| places.get(vertex as usize).copied().flatten().is_some();
        let letters = frame.edges_assignment.as_deref().unwrap_or_default();
        let listed = frame.edges_vertices.as_deref().unwrap_or_default().iter().enumerate();
        let mut edges: Vec<PatternEdge> = listed
            .filter(|(_, [a, b])| there(*a) && there(*b) && a != b)
            .map(|(e, ends)| edge(*ends, letters.get(e).map_or("U", |letter| letter)))
            .collect();
        if frame.edges_vertices.is_none() {
            let sides = |face: &Vec<u32>| -> Vec<[u32; 2]> {
                face.iter().zip(face.iter().cycle().skip(1)).map(|(a, b)| [*a, *b]).collect()
            };
            let all = frame.faces_vertices.as_deref().unwrap_or_default().iter().flat_map(sides);
            edges.extend(all.filter(|[a, b]| there(*a) && there(*b) && a != b).map(|ends| edge(ends, "F")));
        }
        if edges.is_empty() {
            return None;
        }
        let mut ends = vec![0_usize; vertices.len()];
        edges.iter().flat_map(|edge| edge.vertices).for_each(|vertex| ends[vertex.index()] += 1);
        let open = ends.iter().enumerate().filter(|(_, lines)| **lines == 1).map(|(vertex, _)| vertices[vertex]);
        let open_ends: Vec<DVec3> = open.collect();
        let blamed = blamed(frame, &refusal.place(), &vertices);
        // Only what is drawn counts for the frame of the picture.
        let some = edges.first().map(|edge| vertices[edge.vertices[0].index()])?;
        let vertices: Vec<DVec3> =
            vertices.iter().zip(&ends).map(|(place, lines)| if *lines > 0 { *place } else { some }).collect();
        let lines = CreasePattern {
            alias_of: vec![None; vertices.len()],
            vertices_in_file: vertices.len(),
            edges_in_file: edges.len(),
            vertices,
            edges,
            ..CreasePattern::default()
        };
        (lines.size() > 0.0).then_some(Self { lines, open_ends, blamed })
    }
}

fn edge(ends: [u32; 2], letter: &str) -> PatternEdge {
    let assignment = match letter.to_ascii_uppercase().as_str() {
        "M" => Assignment::Mountain,
        "V" => Assignment::Valley,
        "B" | "C" => Assignment::Boundary,
        "F" | "J" => Assignment::Flat,
        _ => Assignment::Unassigned,
    };
    let fold_angle = match assignment {
        Assignment::Mountain => Some(-std::f64::consts::PI),
        Assignment::Valley => Some(std::f64::consts::PI),
        _ => None,
    };
    PatternEdge { vertices: ends.map(VertexId), assignment, fold_angle, k_crease: None, ea: None, alias_of: None }
}

/// The points in the plane of the picture: along the axis in which they extend least.
fn seen_from_above(places: &[Option<DVec3>]) -> Vec<DVec3> {
    let known = || places.iter().flatten().copied();
    let low = known().reduce(DVec3::min).unwrap_or_default();
    let extent = known().reduce(DVec3::max).unwrap_or_default() - low;
    let flattened = |p: DVec3| match extent {
        e if e.z <= e.x && e.z <= e.y => DVec3::new(p.x, p.y, 0.0),
        e if e.y <= e.x => DVec3::new(p.x, p.z, 0.0),
        _ => DVec3::new(p.y, p.z, 0.0),
    };
    places.iter().map(|p| flattened(p.unwrap_or(low))).collect()
}

/// The middle of the edge or face, or the vertex, that a refusal names.
fn blamed(frame: &Frame, place: &Place, vertices: &[DVec3]) -> Vec<DVec3> {
    let at = |vertex: u32| vertices.get(vertex as usize).copied();
    let middle = |corners: &[u32]| {
        let known: Vec<DVec3> = corners.iter().filter_map(|vertex| at(*vertex)).collect();
        (!known.is_empty()).then(|| known.iter().sum::<DVec3>() / known.len() as f64)
    };
    let of_edge = place.edge().and_then(|e| middle(frame.edges_vertices.as_ref()?.get(e.index())?));
    let of_face = place.face().and_then(|f| middle(frame.faces_vertices.as_ref()?.get(f.index())?));
    let of_vertex = place.vertex().and_then(|v| at(v.0));
    let named =
        if let Place::Vertices(named) = place { named.iter().filter_map(|v| at(v.0)).collect() } else { vec![] };
    of_edge.into_iter().chain(of_face).chain(of_vertex).chain(named).collect()
}
