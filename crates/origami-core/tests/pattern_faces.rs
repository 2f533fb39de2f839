//! Faces as the file gives them.

mod pattern_support;

use origami_core::fold::Frame;
use pattern_support::{
    SQUARE, SQUARE_EDGES, assert_warned, build, degrees, flat, letters, refused, spatial, total_area,
};

fn ids(pattern: &origami_core::CreasePattern, face: usize) -> Vec<u32> {
    pattern.faces[face].iter().map(|v| v.0).collect()
}

#[test]
fn what_has_no_sensible_reading_is_refused() {
    let cases: [(Frame, &str); 12] = [
        (Frame::default(), "vertices_coords: is missing"),
        (flat(&[[1.0, 1.0]; 3], &[[0, 1]], "", &[]), "vertices_coords: all vertices lie at one place"),
        (flat(&[[0.0, 0.0], [1e200, 1.0], [2.0, 2.0]], &[[0, 1]], "", &[]), "vertices_coords: the pattern is 1e200 in"),
        (flat(&[[0.0, f64::INFINITY]], &[], "", &[]), "vertices_coords[0]: is not finite"),
        (flat(&SQUARE, &[], "", &[]), "edges_vertices: is missing or empty, and so is faces_vertices"),
        (flat(&SQUARE, &[[0, 4]], "", &[]), "edges_vertices[0]: vertex 4 does not exist; expected numbers below 4"),
        (flat(&SQUARE, &[[0, 1], [2, 2]], "", &[]), "edges_vertices[1]: joins vertex 2 to itself"),
        (flat(&SQUARE, &[], "", &[&[0, 1, 7]]), "faces_vertices[0]: vertex 7 does not exist"),
        (flat(&SQUARE, &[], "", &[&[0, 1, 2], &[0, 3]]), "faces_vertices[1]: has 2 different vertices"),
        (flat(&SQUARE, &[], "", &[&[0, 1, 2, 2]]), "faces_vertices[0]: names vertex 2 twice in a row"),
        (flat(&SQUARE, &[], "", &[&[0, 1, 2, 1]]), "faces_vertices[0]: encloses no area"),
        (flat(&SQUARE, &[], "B", &[&[0, 1, 2]]), "edges_assignment: has 1 entries where edges_vertices has 0"),
    ];
    for (frame, message) in cases {
        assert!(refused(&frame).starts_with(message), "{}", refused(&frame));
    }
}

#[test]
fn no_length_and_no_area() {
    let coords = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 0.0]];
    let frame = flat(&coords, &[[0, 1], [0, 3]], "", &[&[0, 1, 2]]);
    assert!(refused(&frame).starts_with("edges_vertices[1]: vertices 0 and 3 lie at one place"), "{}", refused(&frame));
    let frame = flat(&coords, &[], "", &[&[0, 1, 2, 3]]);
    assert!(refused(&frame).starts_with("faces_vertices[0]: vertices 3 and 0 lie at one place"), "{}", refused(&frame));
    let coords = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.5]];
    let pattern = build(&flat(&coords, &[], "", &[&[0, 1, 2], &[0, 2, 3]]));
    assert_warned(&pattern, "faces_vertices[1]", "without area");
}

#[test]
fn faces_need_three_dimensions_or_a_plane() {
    let coords = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]];
    let frame = spatial(&coords, &SQUARE_EDGES, "BBBBM", &[]);
    assert!(
        refused(&frame).starts_with("faces_vertices: is missing, and the vertices do not lie"),
        "{}",
        refused(&frame)
    );
}

#[test]
fn unlisted_edges_are_appended() {
    let faces: [&[u32]; 2] = [&[0, 1, 2], &[0, 2, 3]];
    let pattern = build(&flat(&SQUARE, &SQUARE_EDGES[..3], "BBB", &faces));
    assert_eq!((letters(&pattern).as_str(), pattern.edges_in_file), ("BBBJB", 3));
    assert_eq!(degrees(&pattern, 3), Some(0.0));
    let pattern = build(&flat(&SQUARE, &[], "", &faces));
    assert_eq!(letters(&pattern), "BBUBB");
    assert_warned(&pattern, "edges_assignment", "nothing drives");
}

#[test]
fn three_faces_at_an_edge_are_refused() {
    let coords = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
    let frame = spatial(&coords, &[[1, 2], [0, 1]], "", &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]]);
    assert_eq!(
        refused(&frame),
        "edges_vertices[1]: the line is a side of faces_vertices 0, 1 and 2; expected at most two faces at an edge"
    );
}

#[test]
fn clockwise_faces_are_kept_when_all_agree() {
    let pattern = build(&flat(&SQUARE, &SQUARE_EDGES, "BBBBM", &[&[2, 1, 0], &[3, 2, 0]]));
    assert_eq!((ids(&pattern, 0), ids(&pattern, 1)), (vec![2, 1, 0], vec![3, 2, 0]));
    assert_warned(&pattern, "faces_vertices[0]", "runs clockwise");
}

#[test]
fn mixed_faces_follow_the_larger_area() {
    // A strip of three unit squares; the middle one runs the other way.
    let coords: Vec<[f64; 2]> = (0..8).map(|i| [f64::from(i / 2), f64::from(i % 2)]).collect();
    let pattern = build(&flat(&coords, &[], "", &[&[0, 2, 3, 1], &[2, 3, 5, 4], &[4, 6, 7, 5]]));
    assert_eq!(ids(&pattern, 1), [2, 4, 5, 3]);
    assert!((total_area(&pattern) - 3.0).abs() < 1e-12);
    assert_warned(&pattern, "faces_vertices[1]", "turned over");
    // Clockwise has the majority here.
    let pattern = build(&flat(&coords, &[], "", &[&[0, 1, 3, 2], &[2, 4, 5, 3], &[4, 5, 7, 6]]));
    assert!((total_area(&pattern) + 3.0).abs() < 1e-12);
    // A tie goes to counterclockwise, whichever comes first.
    for faces in [[[0, 1, 2], [0, 3, 2]], [[2, 1, 0], [0, 2, 3]]] {
        let pattern = build(&flat(&SQUARE, &SQUARE_EDGES, "BBBBM", &[&faces[0], &faces[1]]));
        assert!((total_area(&pattern) - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_moebius_strip_is_refused() {
    let corner = |i: u32, side: f64| {
        let (turn, twist) = (f64::from(i) * std::f64::consts::TAU / 5.0, f64::from(i) * std::f64::consts::PI / 5.0);
        let radius = 3.0 + side * twist.cos();
        [radius * turn.cos(), radius * turn.sin(), side * twist.sin()]
    };
    let coords: Vec<_> = (0..5).flat_map(|i| [corner(i, -1.0), corner(i, 1.0)]).collect();
    let faces: Vec<Vec<u32>> =
        (0..5).map(|i| if i < 4 { vec![2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1] } else { vec![8, 1, 0, 9] }).collect();
    let faces: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    assert!(refused(&spatial(&coords, &[], "", &faces)).contains("one side only"));
    // Cut somewhere it is an ordinary strip.
    let pattern = build(&spatial(&coords, &[[0, 1]], "C", &faces));
    assert_eq!((pattern.vertices.len(), pattern.faces.len()), (12, 5));
}

#[test]
fn lines_and_vertices_outside_all_faces_are_kept() {
    let coords = [SQUARE.as_slice(), &[[2.0, 0.0], [2.0, 1.0], [3.0, 3.0]]].concat();
    let edges = [SQUARE_EDGES.as_slice(), &[[4, 5]]].concat();
    let pattern = build(&flat(&coords, &edges, "BBBBVM", &[&[0, 1, 2], &[0, 2, 3]]));
    assert_eq!((degrees(&pattern, 5), pattern.edges[5].alias_of), (None, None));
    assert_warned(&pattern, "edges_vertices[5]", "belongs to no face");
    assert_warned(&pattern, "vertices_coords[6]", "belongs to no edge");
    assert_eq!(pattern.vertices.len(), 7);
}

#[test]
fn coordinates_come_through_unchanged() {
    let third = 1.0 / 3.0;
    let coords = [[0.1 * third, 1e-7 * third], [1e3 * third, 0.2], [1e3 * third, 0.7e3], [-0.3 * third, 0.6e3]];
    let pattern = build(&flat(&coords, &SQUARE_EDGES, "BBBBV", &[]));
    assert_eq!(pattern.vertices.iter().map(|v| [v.x, v.y]).collect::<Vec<_>>(), coords);
    assert!((pattern.size() - 700.0).abs() < 1e-3);
    assert!(pattern.is_flat());
}
