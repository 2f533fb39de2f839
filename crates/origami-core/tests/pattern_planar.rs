//! Faces built from the lines.

mod pattern_support;

use pattern_support::{
    SQUARE, SQUARE_EDGES, assert_warned, build, degrees, euler, flat, letters, refused, total_area, triangles,
};

/// Four sides of an axis-parallel square, appended to coordinates and edges.
fn add_square(coords: &mut Vec<[f64; 2]>, edges: &mut Vec<[u32; 2]>, low: f64, high: f64) {
    let first = coords.len() as u32;
    coords.extend([[low, low], [high, low], [high, high], [low, high]]);
    edges.extend((0..4).map(|side| [first + side, first + (side + 1) % 4]));
}

#[test]
fn crossing_lines_get_a_vertex() {
    let edges = [&SQUARE_EDGES[..4], &[[0, 2], [1, 3]]].concat();
    let mut frame = flat(&SQUARE, &edges, "BBBBMV", &[]);
    frame.edges_fold_angle = Some(vec![None, None, None, None, Some(-90.0), Some(45.0)]);
    let pattern = build(&frame);
    assert_eq!((pattern.faces.len(), pattern.vertices.len(), pattern.edges.len()), (4, 5, 8));
    assert_eq!((pattern.vertices_in_file, pattern.edges_in_file), (4, 6));
    assert_eq!((pattern.vertices[4].x, pattern.vertices[4].y), (0.5, 0.5));
    // The first piece keeps the number, the second is appended.
    assert_eq!(letters(&pattern), "BBBBMVMV");
    assert_eq!(pattern.edges[4].vertices.map(|v| v.0), [0, 4]);
    assert_eq!(pattern.edges[6].vertices.map(|v| v.0), [4, 2]);
    assert_eq!(degrees(&pattern, 6), Some(-90.0));
    assert_eq!((euler(&pattern), total_area(&pattern)), (1, 1.0));
}

#[test]
fn a_vertex_on_a_line_splits_it() {
    // With six digits only, as files have it.
    let coords = [SQUARE.as_slice(), &[[0.333333, 0.333334], [1.0, 0.0]]].concat();
    let edges = [SQUARE_EDGES.as_slice(), &[[4, 5]]].concat();
    let pattern = build(&flat(&coords, &edges, "BBBBMV", &[]));
    assert_eq!((pattern.faces.len(), pattern.edges.len()), (3, 7));
    assert_eq!(pattern.alias_of[5].map(|v| v.0), Some(1));
    assert_eq!(pattern.edges[5].vertices.map(|v| v.0), [4, 1]);
    assert_warned(&pattern, "vertices_coords[5]", "lies on another vertex");
    assert_eq!(euler(&pattern), 1);
    assert!((total_area(&pattern) - 1.0).abs() < 1e-6);
}

#[test]
fn lines_on_top_of_each_other_become_one() {
    let coords = [SQUARE.as_slice(), &[[0.25, 0.25], [0.75, 0.75]]].concat();
    // A long crease, a short one on it; and one of no length.
    let edges = [SQUARE_EDGES.as_slice(), &[[4, 5]]].concat();
    let pattern = build(&flat(&coords, &edges, "BBBBFM", &[]));
    assert_eq!(pattern.faces.len(), 2);
    let living = |letter| {
        let live = pattern.edges.iter().zip(letters(&pattern).chars().collect::<Vec<_>>());
        live.filter(|(edge, l)| edge.alias_of.is_none() && *l == letter).count()
    };
    assert_eq!((living('F'), living('M')), (2, 1));
    let coords = [SQUARE.as_slice(), &[[1.0, 1.0]]].concat();
    let edges = [SQUARE_EDGES.as_slice(), &[[2, 4]]].concat();
    let pattern = build(&flat(&coords, &edges, "BBBBFM", &[]));
    assert!(pattern.edges[5].alias_of.is_some());
    assert_warned(&pattern, "edges_vertices[5]", "without length");
}

#[test]
fn a_grid_of_long_lines() {
    let n = 12u32;
    let mut coords = Vec::new();
    let mut edges = Vec::new();
    for i in 0..=n {
        let at = f64::from(i) / 7.0;
        let end = f64::from(n) / 7.0;
        let first = coords.len() as u32;
        coords.extend([[at, 0.0], [at, end], [0.0, at], [end, at]]);
        edges.extend([[first, first + 1], [first + 2, first + 3]]);
    }
    let letters: String = (0..=n).map(|i| if i == 0 || i == n { "BB" } else { "MV" }).collect();
    let pattern = build(&flat(&coords, &edges, &letters, &[]));
    assert_eq!(pattern.faces.len(), (n * n) as usize);
    assert!(pattern.faces.iter().all(|face| face.len() == 4));
    assert_eq!(euler(&pattern), 1);
    assert!((total_area(&pattern) - f64::from(n * n) / 49.0).abs() < 1e-12);
}

#[test]
fn boundary_edges_enclose_holes_and_islands() {
    let (mut coords, mut edges) = (Vec::new(), Vec::new());
    add_square(&mut coords, &mut edges, 0.0, 6.0);
    add_square(&mut coords, &mut edges, 1.0, 5.0);
    add_square(&mut coords, &mut edges, 2.0, 4.0);
    add_square(&mut coords, &mut edges, 2.5, 3.0);
    // Boundary within boundary: paper, hole, paper, hole.
    let pattern = build(&flat(&coords, &edges, &"B".repeat(16), &[]));
    assert!((total_area(&pattern) - (36.0 - 16.0 + 4.0 - 0.25)).abs() < 1e-12);
    assert_eq!(euler(&pattern), 0);
    assert_warned(&pattern, "faces_vertices", "2 holes");
    triangles(&pattern);
    // As creases, all of it is paper.
    let pattern = build(&flat(&coords, &edges, &format!("BBBB{}", "M".repeat(12)), &[]));
    assert!((total_area(&pattern) - 36.0).abs() < 1e-12);
    assert_eq!(euler(&pattern), 1);
    assert!((4..16).all(|edge| degrees(&pattern, edge) == Some(-180.0)));
    // Regions with islands come in triangles, joined by edges that the file does not have.
    assert!(letters(&pattern)[16..].chars().all(|letter| letter == 'J'));
}

#[test]
fn a_floating_crease_and_a_dangling_one() {
    let coords = [SQUARE.as_slice(), &[[0.3, 0.4], [0.7, 0.6], [0.5, 0.25]]].concat();
    let floating = [&SQUARE_EDGES[..4], &[[4, 5]]].concat();
    let pattern = build(&flat(&coords[..6], &floating, "BBBBV", &[]));
    assert_eq!((pattern.faces.len(), degrees(&pattern, 4)), (6, Some(180.0)));
    assert!((total_area(&pattern) - 1.0).abs() < 1e-12);
    triangles(&pattern);
    // One that hangs on the contour leaves one face, whose outline runs along it to and fro.
    let dangling = [&SQUARE_EDGES[..4], &[[0, 4], [4, 5], [4, 6]]].concat();
    let pattern = build(&flat(&coords, &dangling, "BBBBMMV", &[]));
    assert_eq!((pattern.faces.len(), pattern.faces[0].len()), (1, 10));
    assert_eq!(euler(&pattern), 1);
    assert_eq!(triangles(&pattern).triangles.len(), 8);
}

#[test]
fn a_missing_boundary_is_put_in() {
    for letters_given in ["BBBMV", "MVFUV", ""] {
        let pattern = build(&flat(&SQUARE, &SQUARE_EDGES, letters_given, &[]));
        assert_eq!(&letters(&pattern)[..4], "BBBB", "{letters_given}");
        assert_eq!(pattern.faces.len(), 2);
    }
    let pattern = build(&flat(&SQUARE, &SQUARE_EDGES, "BBBMV", &[]));
    assert_warned(&pattern, "edges_assignment[3]", "M on the contour");
    // A hole is still a hole beside a gap in the outer boundary.
    let (mut coords, mut edges) = (Vec::new(), Vec::new());
    add_square(&mut coords, &mut edges, 0.0, 3.0);
    add_square(&mut coords, &mut edges, 1.0, 2.0);
    let pattern = build(&flat(&coords, &edges, "MMMMBBBB", &[]));
    assert!((total_area(&pattern) - 8.0).abs() < 1e-12);
}

#[test]
fn a_boundary_line_across_the_paper_is_a_cut() {
    let pattern = build(&flat(&SQUARE, &SQUARE_EDGES, "BBBBB", &[]));
    assert_eq!((pattern.faces.len(), pattern.vertices.len(), letters(&pattern).as_str()), (2, 6, "BBBBBB"));
    assert_warned(&pattern, "edges_assignment[4]", "paper on both sides");
}

#[test]
fn sheets_side_by_side_and_lines_outside() {
    let coords: Vec<[f64; 2]> =
        SQUARE.iter().flat_map(|&[x, y]| [[x, y], [x + 3.0, 2.0 * y]]).chain([[1.5, 0.0], [2.5, 1.0]]).collect();
    let edges = [[0, 2], [2, 4], [4, 6], [6, 0], [1, 3], [3, 5], [5, 7], [7, 1], [3, 7], [8, 9]];
    let pattern = build(&flat(&coords, &edges, "BBBBBBBBMV", &[]));
    assert_eq!((pattern.faces.len(), total_area(&pattern)), (3, 3.0));
    assert_warned(&pattern, "edges_vertices[9]", "belongs to no face");
}

#[test]
fn lines_that_enclose_nothing_are_refused() {
    let message = refused(&flat(&SQUARE, &SQUARE_EDGES[..3], "BBB", &[]));
    assert!(message.starts_with("edges_vertices: the lines enclose no paper"), "{message}");
}

/// Numbers in [0, 1) that look random.
fn noise(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64
}

#[test]
fn random_chords_always_fill_the_square() {
    for seed in 0..60u64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1;
        let mut coords = SQUARE.to_vec();
        let mut edges = SQUARE_EDGES[..4].to_vec();
        for _ in 0..seed % 30 {
            let first = coords.len() as u32;
            // Some on a coarse lattice, so that lines overlap and meet in one point.
            let coarse = noise(&mut state) < 0.6;
            let mut place = || {
                let x = noise(&mut state);
                if coarse { (x * 6.0).floor() / 6.0 + 1.0 / 12.0 } else { x }
            };
            coords.extend([[place(), place()], [place(), place()]]);
            edges.push([first, first + 1]);
        }
        let letters = format!("BBBB{}", "V".repeat(edges.len() - 4));
        let pattern = build(&flat(&coords, &edges, &letters, &[]));
        assert!((total_area(&pattern) - 1.0).abs() < 1e-9, "seed {seed}: {}", total_area(&pattern));
        assert_eq!(euler(&pattern), 1, "seed {seed}");
        triangles(&pattern);
    }
}

#[test]
fn lines_without_length_only_are_refused() {
    let coords = [[2.0, 4.0], [4.0, 2.0], [4.0, 2.0], [4.0, 2.0]];
    let message = refused(&flat(&coords, &[[2, 1], [1, 2], [3, 1]], "", &[]));
    assert!(message.starts_with("edges_vertices: the lines enclose no paper"), "{message}");
}
