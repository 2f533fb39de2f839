//! What is put right is said, once for each kind and with the first place; what is ordinary is not.

mod pattern_support;

use glam::DVec3;
use origami_core::CreasePattern;
use origami_core::export::crease_pattern_document;
use origami_core::fold::{Coordinates, Document, Frame};
use origami_core::generate::catalog;
use pattern_support::{SQUARE, SQUARE_EDGES, build, flat, spatial, square};

/// All warnings of a frame, as a person reads them.
fn warnings(frame: &Frame) -> Vec<String> {
    build(frame).warnings.iter().map(ToString::to_string).collect()
}

fn with_angles(mut frame: Frame, angles: &[Option<f64>]) -> Frame {
    frame.edges_fold_angle = Some(angles.to_vec());
    frame
}

const NO_ANGLES: &str = "edges_foldAngle: is missing; M and V fold by -180 and 180 degrees";

#[test]
fn a_flat_file_with_all_keys_gives_none() {
    for angle in [0.0, 90.0, 180.0] {
        let frame = with_angles(square("BBBBV", true), &[None, Some(0.0), None, None, Some(angle)]);
        assert_eq!(warnings(&frame), [""; 0]);
    }
    let free = with_angles(square("BBBBU", true), &[None; 5]);
    assert_eq!(warnings(&free), [""; 0]);
}

#[test]
fn generated_patterns_give_none() {
    for name in catalog::names() {
        let generated = catalog::generate(name, &[]).expect("the defaults make a pattern");
        let mut text = Vec::new();
        crease_pattern_document(&generated, name).write_to(&mut text).expect("memory takes it");
        let document = Document::from_slice(&text).expect("what was written can be read");
        assert_eq!(document.warnings, []);
        let read = CreasePattern::from_frame(&document.frame(0).expect("the key frame")).expect("a pattern");
        assert_eq!(read.warnings, [], "{name}");
    }
}

#[test]
fn missing_keys_are_told_with_what_stands_for_them() {
    assert_eq!(warnings(&square("BBBBM", true)), [NO_ANGLES]);
    assert_eq!(warnings(&square("BBBBF", true)), [""; 0], "nothing had to be assumed");
    assert_eq!(
        warnings(&square("BBBBM", false)),
        ["faces_vertices: is missing; built from the lines: 2 faces, 0 holes", NO_ANGLES]
    );
    let mut empty = square("BBBBM", false);
    empty.faces_vertices = Some(Vec::new());
    assert_eq!(warnings(&empty), ["faces_vertices: is empty; built from the lines: 2 faces, 0 holes", NO_ANGLES]);
    let derived = with_angles(square("", true), &[None, None, None, None, Some(20.0)]);
    assert_eq!(warnings(&derived), ["edges_assignment: is missing; the letters follow from the fold angles"]);
    let flap = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 1.0, 0.0], [0.0, 1.0, 1.0]];
    let (edges, faces): (_, &[&[u32]]) = ([[1, 0], [1, 2], [2, 0], [0, 3], [3, 1]], &[&[0, 1, 2], &[1, 0, 3]]);
    let measured = ["edges_foldAngle: is missing; the angles are measured from the coordinates"];
    assert_eq!(warnings(&spatial(&flap, &edges, "VBBBB", faces)), measured);
    let both = ["edges_assignment: is missing, and so is edges_foldAngle; both are measured from the coordinates"];
    assert_eq!(warnings(&spatial(&flap, &edges, "", faces)), both);
}

#[test]
fn a_hole_is_counted() {
    let ring = |low: f64, high: f64| [[low, low], [high, low], [high, high], [low, high]];
    let coords = [ring(0.0, 3.0), ring(1.0, 2.0)].concat();
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let told = warnings(&flat(&coords, &edges, "BBBBBBBB", &[]));
    assert_eq!(told, ["faces_vertices: is missing; built from the lines: 8 faces, 1 hole"]);
}

#[test]
fn lines_that_meet_are_told_once() {
    // Both diagonals and both midlines: three crossings at one point, and four midpoints on the outline.
    let coords = [&SQUARE[..], &[[0.5, 0.0], [1.0, 0.5], [0.5, 1.0], [0.0, 0.5]]].concat();
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2], [1, 3], [4, 6], [5, 7]];
    let told = warnings(&flat(&coords, &edges, "BBBBFFFF", &[]));
    assert_eq!(
        told,
        [
            "edges_vertices[0]: vertex 4 lies on it; the line is split there (and 3 more)",
            "edges_vertices[4]: crosses edges_vertices[5]; both get a vertex there",
            "faces_vertices: is missing; built from the lines: 8 faces, 0 holes",
        ]
    );
}

#[test]
fn faces_seen_from_their_back_are_told() {
    let frame = flat(&SQUARE, &SQUARE_EDGES, "BBBBF", &[&[2, 1, 0], &[3, 2, 0]]);
    let words = "faces_vertices[0]: runs clockwise: its letters and angles are taken as seen from the other side";
    assert_eq!(warnings(&frame), [format!("{words} (and 1 more)")]);
}

#[test]
fn angles_without_effect_are_told() {
    let frame = with_angles(square("BBBBV", true), &[Some(45.0), None, Some(1e300), Some(0.0), None]);
    assert_eq!(
        warnings(&frame),
        [
            "edges_foldAngle[0]: 45 degrees on a boundary or cut; ignored (and 1 more)",
            "edges_foldAngle[4]: V with null: a free crease, which nothing drives",
        ]
    );
    let cut = with_angles(square("BBBBC", true), &[None, None, None, None, Some(1e300)]);
    assert_eq!(warnings(&cut), ["edges_foldAngle[4]: 1e300 degrees on a boundary or cut; ignored"]);
}

#[test]
fn coordinates_of_two_kinds_are_told() {
    let mut frame = square("BBBBF", true);
    let coords = frame.vertices_coords.as_mut().expect("a square has coordinates");
    coords[1] = Coordinates::spatial(DVec3::new(1.0, 0.0, 0.0));
    coords[3] = Coordinates::spatial(DVec3::new(0.0, 1.0, 0.0));
    let words = "has 3 numbers, the first vertex has another count; a z that is not given is 0 (and 1 more)";
    assert_eq!(warnings(&frame), [format!("vertices_coords[1]: {words}")]);
}

#[test]
fn faces_too_thin_for_springs_are_told() {
    let apex = |height: f64| {
        let coords = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 1.0 - height]];
        flat(&coords, &[[2, 4], [4, 3]], "FF", &[&[0, 1, 2, 4, 3], &[4, 2, 3]])
    };
    let words = "faces_vertices[1]: thinner than 1e-6 of the sheet's radius; its springs are left out";
    let thin = |height| warnings(&apex(height)).iter().any(|told| told == words);
    // The radius is the square root of 1/2.
    assert!(thin(0.7e-6) && thin(1e-9) && !thin(0.72e-6) && !thin(0.1));
}

#[test]
fn sides_that_are_no_edges_are_told() {
    let frame = flat(&SQUARE, &SQUARE_EDGES[..4], "BBBB", &[&[0, 1, 2], &[0, 2, 3]]);
    let words = "has a side that edges_vertices does not list; between two faces it is taken as flat";
    assert_eq!(warnings(&frame), [format!("faces_vertices[0]: {words}")]);
}
