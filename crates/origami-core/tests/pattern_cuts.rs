//! Cuts open into pairs of boundary edges.

mod pattern_support;

use origami_core::CreasePattern;
use pattern_support::{assert_warned, build, euler, flat, letters, total_area, triangles};
use serde_json::json;

/// A grid of `n` by `n` unit squares; vertex `(x, y)` is `x + (n + 1) y`. Letters by a rule from the two ends.
fn grid(n: u32, with_faces: bool, cut: impl Fn([u32; 2], [u32; 2]) -> bool) -> origami_core::fold::Frame {
    let at = |x: u32, y: u32| x + (n + 1) * y;
    let coords: Vec<_> = (0..=n).flat_map(|y| (0..=n).map(move |x| [f64::from(x), f64::from(y)])).collect();
    let mut edges = Vec::new();
    let mut letters = String::new();
    for y in 0..=n {
        for x in 0..=n {
            for (to, rim) in [([x + 1, y], y == 0 || y == n), ([x, y + 1], x == 0 || x == n)] {
                if to[0] <= n && to[1] <= n {
                    edges.push([at(x, y), at(to[0], to[1])]);
                    let letter = if cut([x, y], to) { 'C' } else { 'V' };
                    letters.push(if rim && letter == 'V' { 'B' } else { letter });
                }
            }
        }
    }
    let squares: Vec<Vec<u32>> = (0..n * n)
        .map(|i| (i % n, i / n))
        .map(|(x, y)| vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)])
        .collect();
    let faces: Vec<&[u32]> = if with_faces { squares.iter().map(Vec::as_slice).collect() } else { Vec::new() };
    flat(&coords, &edges, &letters, &faces)
}

/// Pieces that hang together by edges of two faces.
fn pieces(pattern: &CreasePattern) -> usize {
    let mut piece: Vec<usize> = (0..pattern.faces.len()).collect();
    let mut seen = std::collections::HashMap::new();
    for (index, face) in pattern.faces.iter().enumerate() {
        for corner in 0..face.len() {
            let (a, b) = (face[corner], face[(corner + 1) % face.len()]);
            if let Some(other) = seen.insert([a.min(b), a.max(b)], index) {
                let (from, to) = (piece[index], piece[other]);
                piece.iter_mut().filter(|p| **p == from).for_each(|p| *p = to);
            }
        }
    }
    piece.sort_unstable();
    piece.dedup();
    piece.len()
}

/// Vertices added, edges added, pieces, Euler characteristic.
fn opened(cut: impl Fn([u32; 2], [u32; 2]) -> bool) -> (usize, usize, usize, isize) {
    let [given, built] = [true, false].map(|with_faces| build(&grid(4, with_faces, &cut)));
    let count = |pattern: &CreasePattern| {
        assert!((total_area(pattern) - 16.0).abs() < 1e-12);
        triangles(pattern);
        let more = (pattern.vertices.len() - pattern.vertices_in_file, pattern.edges.len() - pattern.edges_in_file);
        (more.0, more.1, pieces(pattern), euler(pattern))
    };
    assert_eq!(count(&given), count(&built));
    count(&given)
}

#[test]
fn cuts_of_each_kind() {
    // None; on the rim only.
    assert_eq!(opened(|_, _| false), (0, 0, 1, 1));
    assert_eq!(opened(|a, b| a[1] == 0 && b[1] == 0), (0, 0, 1, 1));
    // A slit of two edges inside: one vertex in the middle comes apart; a hole in the sheet.
    assert_eq!(opened(|a, b| a[1] == 2 && b[1] == 2 && (1..3).contains(&a[0])), (1, 2, 1, 0));
    // A slit from the rim inwards.
    assert_eq!(opened(|a, b| a[1] == 2 && b[1] == 2 && a[0] < 2), (2, 2, 1, 1));
    // Right across.
    assert_eq!(opened(|a, b| a[1] == 2 && b[1] == 2), (5, 4, 2, 2));
    // Closed: a square of four cells falls out.
    let on_ring = |p: [u32; 2]| (1..=3).contains(&p[0]) && (1..=3).contains(&p[1]) && p != [2, 2];
    assert_eq!(opened(|a, b| on_ring(a) && on_ring(b)), (8, 8, 2, 1));
    // A T: across, with a branch to the rim.
    assert_eq!(opened(|a, b| a[1] == 2 && b[1] == 2 || a[0] == 2 && b[0] == 2 && a[1] < 2), (8, 6, 3, 3));
    // Every line: sixteen single cells.
    assert_eq!(opened(|_, _| true), (64 - 25, 24, 16, 16));
}

#[test]
fn the_first_face_keeps_the_vertex() {
    let pattern = build(&grid(2, true, |a, b| a[1] == 1 && b[1] == 1));
    let ids = |face: usize| pattern.faces[face].iter().map(|v| v.0).collect::<Vec<_>>();
    assert_eq!((ids(0), ids(1)), (vec![0, 1, 4, 3], vec![1, 2, 5, 4]));
    assert!(ids(2)[..2].iter().all(|&v| v >= 9), "{:?}", ids(2));
    assert_eq!(ids(2)[1], ids(3)[0]);
    assert!(letters(&pattern)[12..].chars().all(|letter| letter == 'B'));
}

#[test]
fn a_slit_of_one_edge_cannot_open() {
    let pattern = build(&grid(3, true, |a, b| [a, b] == [[1, 1], [2, 1]]));
    assert_eq!(pattern.vertices.len(), 16);
    let warning = pattern.warnings.iter().find(|w| w.message.contains("cannot open")).expect("a warning");
    let edge = warning.place.edge().expect("an edge").index();
    assert_eq!(&letters(&pattern)[edge..=edge], "U");
    assert_eq!(pattern.edges[edge].fold_angle, None);
}

#[test]
fn a_slit_in_one_face_is_walked_twice() {
    let coords = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 2.0], [1.0, 2.0], [2.0, 2.0]];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0], [4, 5], [5, 6]];
    for letter in ["C", "B"] {
        let pattern = build(&flat(&coords, &edges, &format!("BBBBB{letter}{letter}"), &[]));
        // Vertices 4 and 5 come apart, 6 is where the slit ends.
        assert_eq!((pattern.vertices.len(), pattern.edges.len(), pattern.faces.len()), (9, 9, 1));
        assert_eq!((euler(&pattern), triangles(&pattern).triangles.len()), (1, 7));
        assert!(letters(&pattern).chars().all(|letter| letter == 'B'));
    }
    let pattern = build(&flat(&coords, &edges, "BBBBBBB", &[]));
    assert_warned(&pattern, "edges_assignment[5]", "paper on both sides; the sheet is cut there (and 1 more)");
}

#[test]
fn copies_of_fixed_vertices_are_fixed() {
    let mut frame = grid(2, true, |a, b| a[1] == 1 && b[1] == 1);
    let fixed: Vec<bool> = (0..9).map(|v| v == 4 || v == 8).collect();
    frame.extra.insert("vertices_origami:fixed".into(), json!(fixed));
    let pattern = build(&frame);
    let places: Vec<_> = pattern.fixed.iter().map(|v| pattern.vertices[v.index()].truncate().to_array()).collect();
    assert_eq!(places, [[1.0, 1.0], [2.0, 2.0], [1.0, 1.0]]);
}

#[test]
fn cut_letters_keep_the_stiffness_of_their_edge() {
    let mut frame = grid(2, true, |a, b| a[1] == 1 && b[1] == 1);
    let count = frame.edges_vertices.as_ref().map_or(0, Vec::len);
    frame.extra.insert("edges_origami:ea".into(), json!(vec![3.0; count]));
    assert!(build(&frame).edges.iter().all(|edge| edge.ea == Some(3.0)));
}
