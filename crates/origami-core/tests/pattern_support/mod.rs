//! Frames in one line, and what every pattern built from them must satisfy.
#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

use glam::DVec3;
use origami_core::CreasePattern;
use origami_core::fold::{Coordinates, Frame};
use origami_core::ids::VertexId;
use origami_core::mesh::triangulate::{Triangulation, triangulate};

/// A flat frame; one letter for each edge, or none at all.
pub fn flat(coords: &[[f64; 2]], edges: &[[u32; 2]], letters: &str, faces: &[&[u32]]) -> Frame {
    let coords: Vec<_> = coords.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    Frame {
        vertices_coords: Some(
            coords.into_iter().map(|c| Coordinates { position: DVec3::from_array(c), dimension: 2 }).collect(),
        ),
        ..spatial(&[], edges, letters, faces)
    }
}

/// A frame in space.
pub fn spatial(coords: &[[f64; 3]], edges: &[[u32; 2]], letters: &str, faces: &[&[u32]]) -> Frame {
    let position = |&c: &[f64; 3]| Coordinates { position: DVec3::from_array(c), dimension: 3 };
    Frame {
        vertices_coords: Some(coords.iter().map(position).collect()),
        edges_vertices: (!edges.is_empty()).then(|| edges.to_vec()),
        edges_assignment: (!letters.is_empty()).then(|| letters.chars().map(|l| l.to_string().into()).collect()),
        faces_vertices: (!faces.is_empty()).then(|| faces.iter().map(|face| face.to_vec()).collect()),
        ..Frame::default()
    }
}

pub const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
pub const SQUARE_EDGES: [[u32; 2]; 5] = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];

/// The unit square with a crease from corner 0 to corner 2, edge 4.
pub fn square(letters: &str, with_faces: bool) -> Frame {
    let faces: &[&[u32]] = if with_faces { &[&[0, 1, 2], &[0, 2, 3]] } else { &[] };
    flat(&SQUARE, &SQUARE_EDGES, letters, faces)
}

/// Builds a pattern and checks all its invariants.
pub fn build(frame: &Frame) -> CreasePattern {
    let pattern = CreasePattern::from_frame(frame).unwrap_or_else(|error| panic!("{error}"));
    pattern.sanity_check().unwrap_or_else(|broken| panic!("{broken}: {pattern:?}"));
    pattern
}

/// The message with which a frame is refused.
pub fn refused(frame: &Frame) -> String {
    CreasePattern::from_frame(frame).expect_err("this frame must be refused").to_string()
}

/// Asserts that a warning names the place and says the words.
pub fn assert_warned(pattern: &CreasePattern, place: &str, words: &str) {
    let found = pattern.warnings.iter().any(|w| w.place.to_string() == place && w.message.contains(words));
    assert!(found, "no warning at {place} saying {words:?} in {:#?}", pattern.warnings);
}

pub fn letters(pattern: &CreasePattern) -> String {
    pattern.edges.iter().map(|edge| edge.assignment.letter()).collect()
}

/// Fold angle of an edge, in degrees.
pub fn degrees(pattern: &CreasePattern, edge: usize) -> Option<f64> {
    pattern.edges[edge].fold_angle.map(f64::to_degrees)
}

/// Signed area in the plane z = 0.
pub fn area(pattern: &CreasePattern, corners: &[VertexId]) -> f64 {
    let at = |i: usize| pattern.vertices[corners[i % corners.len()].index()];
    0.5 * (0..corners.len()).map(|i| at(i).x * at(i + 1).y - at(i + 1).x * at(i).y).sum::<f64>()
}

pub fn total_area(pattern: &CreasePattern) -> f64 {
    pattern.faces.iter().map(|face| area(pattern, face)).sum()
}

/// Triangulates, and checks each face: its triangles fill its area, none is flat or turned over, their sides are paired.
pub fn triangles(pattern: &CreasePattern) -> Triangulation {
    let result = triangulate(pattern).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(result.triangles.len(), result.face_of.len(), "one face for each triangle");
    let mut sums = vec![0.0; pattern.faces.len()];
    let mut sides = std::collections::HashSet::new();
    for (triangle, face) in result.triangles.iter().zip(&result.face_of) {
        let part = area(pattern, triangle);
        sums[face.index()] += part;
        let right_way = part * area(pattern, &pattern.faces[face.index()]).signum();
        assert!(right_way > 1e-13 * pattern.size().powi(2), "{triangle:?} of {face:?} has area {part}");
        for corner in 0..3 {
            let side = [triangle[corner], triangle[(corner + 1) % 3]];
            assert!(sides.insert(side), "side {side:?} is on two triangles in one direction");
        }
    }
    for (index, face) in pattern.faces.iter().enumerate() {
        let whole = area(pattern, face);
        assert!(
            (sums[index] - whole).abs() < 1e-12 * pattern.size().powi(2),
            "face {index}: {} of {whole}",
            sums[index]
        );
        for corner in 0..face.len() {
            let side = [face[corner], face[(corner + 1) % face.len()]];
            assert!(sides.contains(&side), "side {side:?} of face {index} is on no triangle");
        }
    }
    result
}

/// Vertices less edges plus faces, of what belongs to the sheet.
pub fn euler(pattern: &CreasePattern) -> isize {
    let used: std::collections::HashSet<_> = pattern.faces.iter().flatten().collect();
    let edges = pattern.edges.iter().filter(|edge| edge.alias_of.is_none());
    let on_sheet = edges.filter(|edge| edge.vertices.iter().all(|v| used.contains(v)));
    used.len() as isize - on_sheet.count() as isize + pattern.faces.len() as isize
}
