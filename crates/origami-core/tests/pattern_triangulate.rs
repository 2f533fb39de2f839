//! Faces cut into triangles.

mod pattern_support;

use std::f64::consts::TAU;

use origami_core::CreasePattern;
use origami_core::mesh::triangulate::triangulate;
use pattern_support::{build, flat, spatial, triangles};

/// One face through all points.
fn face(coords: &[[f64; 2]]) -> CreasePattern {
    let corners: Vec<u32> = (0..coords.len() as u32).collect();
    build(&flat(coords, &[], "", &[&corners]))
}

fn corners(coords: &[[f64; 2]]) -> Vec<[u32; 3]> {
    triangles(&face(coords)).triangles.iter().map(|t| t.map(|v| v.0)).collect()
}

#[test]
fn quadrilaterals_get_the_shorter_diagonal() {
    let first = [[0, 1, 2], [0, 2, 3]];
    let second = [[0, 1, 3], [1, 2, 3]];
    assert_eq!(corners(&[[0.0, 0.0], [3.0, -1.0], [4.0, 0.0], [3.0, 2.0]]), second);
    assert_eq!(corners(&[[0.0, -1.0], [4.0, 0.0], [0.0, 1.0], [-4.0, 0.0]]), first);
    // A tie, also but for rounding.
    assert_eq!(corners(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]), first);
    let (sin, cos) = 0.3f64.sin_cos();
    assert_eq!(corners(&[[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]]), first);
    // Concave: only one lies inside, though the other is shorter.
    assert_eq!(corners(&[[0.0, 0.0], [5.0, -1.0], [1.0, 0.0], [5.0, 1.0]]), first);
    assert_eq!(corners(&[[5.0, 1.0], [0.0, 0.0], [5.0, -1.0], [1.0, 0.0]]), second);
    // A corner in the middle of a side: one diagonal would leave a triangle without area.
    assert_eq!(corners(&[[0.0, 0.0], [0.5, 0.0], [1.0, 0.0], [0.5, 1.0]]), second);
    // Clockwise faces stay clockwise.
    assert_eq!(corners(&[[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]]), first);
}

#[test]
fn larger_faces_of_many_shapes() {
    let regular = |n: u32| -> Vec<[f64; 2]> {
        (0..n).map(|i| f64::from(i) * TAU / f64::from(n)).map(|t| [t.cos(), t.sin()]).collect()
    };
    let star: Vec<[f64; 2]> =
        regular(14).iter().enumerate().map(|(i, p)| p.map(|c| if i % 2 == 0 { c } else { 0.3 * c })).collect();
    let comb: Vec<[f64; 2]> =
        (0..20).map(|i| [f64::from(i), if i % 2 == 0 { 5.0 } else { 0.5 }]).chain([[19.0, 0.0], [0.0, 0.0]]).collect();
    for mut coords in [regular(5), regular(100), star, comb] {
        assert_eq!(corners(&coords).len(), coords.len() - 2);
        coords.reverse();
        assert_eq!(corners(&coords).len(), coords.len() - 2);
    }
}

#[test]
fn corners_on_a_line_leave_no_flat_triangles() {
    // Sides in seven parts, turned so that rounding puts the corners beside the line.
    for turn in 0..40 {
        let (sin, cos) = (f64::from(turn) * 0.1).sin_cos();
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let mut coords = Vec::new();
        for side in 0..4 {
            let ([ax, ay], [bx, by]) = (square[side], square[(side + 1) % 4]);
            for part in 0..7 {
                let t = f64::from(part) / 7.0;
                let (x, y) = (ax + t * (bx - ax), ay + t * (by - ay));
                coords.push([cos * x - sin * y, sin * x + cos * y]);
            }
        }
        assert_eq!(corners(&coords).len(), 26);
    }
}

#[test]
fn faces_may_touch_themselves() {
    // Two triangles that meet in a corner that is named twice.
    let coords = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0]];
    let pattern = build(&flat(&coords, &[], "", &[&[0, 1, 2, 3, 4, 2]]));
    assert_eq!(triangles(&pattern).triangles.len(), 2);
    // Of a square whose inner outline touches the outer one in a corner that is named twice.
    let coords = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [1.0, 3.0], [3.0, 2.0]];
    let pattern = build(&flat(&coords, &[], "", &[&[0, 1, 2, 3, 0, 4, 5]]));
    assert_eq!(triangles(&pattern).triangles.len(), 5);
    // Hanging together by two vertices at one place, the parts of a face would come apart.
    let coords = [[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
    assert!(triangulate(&face(&coords)).expect_err("not a pattern").to_string().contains("touches itself"));
}

#[test]
fn lips_of_a_slit_that_is_already_split() {
    // A slit from (0, 2) to (2, 2): the lower lip is vertices 7 and 8, the upper one 4 and 5.
    let coords =
        [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 2.0], [1.0, 2.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0]];
    let pattern = face(&coords);
    let result = triangles(&pattern);
    assert_eq!(result.triangles.len(), 7);
    for triangle in &result.triangles {
        let centre = triangle.iter().map(|v| pattern.vertices[v.index()].y).sum::<f64>() / 3.0;
        let wrong = if centre > 2.0 { [7, 8] } else { [4, 5] };
        assert!(triangle.iter().all(|v| !wrong.contains(&v.0)), "{triangle:?} uses the other lip");
    }
}

#[test]
fn faces_in_space_are_cut_in_their_own_plane() {
    // A hexagon in a tilted plane, one corner a little out of it.
    let coords: Vec<[f64; 3]> = (0..6)
        .map(|i| f64::from(i) * TAU / 6.0)
        .map(|t| [t.cos(), 0.6 * t.sin(), 0.8 * t.sin()])
        .enumerate()
        .map(|(i, [x, y, z])| [x, y, if i == 2 { z + 0.05 } else { z }])
        .collect();
    let pattern = build(&spatial(&coords, &[], "", &[&[0, 1, 2, 3, 4, 5]]));
    let result = triangulate(&pattern).expect("triangles");
    assert_eq!(result.triangles.len(), 4);
    for triangle in &result.triangles {
        let [a, b, c] = triangle.map(|v| pattern.vertices[v.index()]);
        assert!((b - a).cross(c - a).dot(glam::DVec3::new(0.0, -0.8, 0.6)) > 0.1, "{triangle:?}");
    }
}

#[test]
fn a_face_without_area_still_has_triangles() {
    for n in [4u32, 6] {
        let coords: Vec<[f64; 2]> = (0..n).map(|i| [f64::from(i), f64::from(i)]).chain([[0.0, 9.0]]).collect();
        let line: Vec<u32> = (0..n).collect();
        let pattern = build(&flat(&coords, &[], "", &[&line, &[0, n - 1, n]]));
        assert_eq!(triangulate(&pattern).expect("triangles").triangles.len(), n as usize - 2 + 1);
    }
}

#[test]
fn faces_that_cross_themselves_are_refused() {
    let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.5]];
    let pentagram: Vec<[f64; 2]> = (0..5).map(|i| f64::from(2 * i) * TAU / 5.0).map(|t| [t.cos(), t.sin()]).collect();
    let touching = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]];
    for (coords, words) in [(&bow_tie[..], "crosses"), (&pentagram, "crosses"), (&touching, "touches")] {
        let message = triangulate(&face(coords)).expect_err("not simple").to_string();
        assert!(message.starts_with("faces_vertices[0]: the face") && message.contains(words), "{message}");
    }
}

#[test]
fn patterns_made_by_hand_do_not_panic() {
    let mut pattern = face(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
    pattern.faces[0][1].0 = 99;
    assert!(
        triangulate(&pattern).expect_err("not a pattern").to_string().starts_with("faces_vertices[0]: names a vertex")
    );
    pattern.faces[0].truncate(1);
    assert!(triangulate(&pattern).expect_err("not a pattern").to_string().contains("has 1 corners"));
    assert!(
        triangulate(&CreasePattern::default()).expect_err("not a pattern").to_string().starts_with("vertices_coords")
    );
}
