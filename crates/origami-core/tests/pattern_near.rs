//! Near misses: lines with ends of their own, a little off, come back to the pattern that they were; what is separate on
//! purpose stays so.

mod pattern_support;

use std::path::Path;

use glam::{DVec2, DVec3};
use origami_core::error::WarningCode;
use origami_core::fold::{Coordinates, Document, Frame};
use origami_core::generate::catalog;
use origami_core::pattern::{JoinedTo, Reading};
use origami_core::{CreasePattern, Error};
use pattern_support::{SQUARE, SQUARE_EDGES, assert_warned, build, flat, refused, spatial, total_area};
use proptest::prelude::*;

/// Patterns of straight lines in the plane.
const FLAT: [&str; 9] = [
    "single-crease",
    "strip",
    "fan",
    "degree-4",
    "waterbomb-vertex",
    "miura",
    "waterbomb",
    "square-twist",
    "bird-base",
];

/// Vertices in use, faces, and pieces.
fn counts(pattern: &CreasePattern) -> [usize; 3] {
    let mut used: Vec<_> = pattern.faces.iter().flatten().collect();
    used.sort_unstable();
    used.dedup();
    [used.len(), pattern.faces.len(), pattern.paper().pieces]
}

/// Each live edge of a pattern as a line between two vertices of its own, which `place` moves.
fn apart(pattern: &CreasePattern, mut place: impl FnMut(DVec2, DVec2) -> DVec2) -> Frame {
    let live: Vec<_> = pattern.edges.iter().filter(|edge| edge.alias_of.is_none()).collect();
    let at = |v: origami_core::ids::VertexId| pattern.vertices[v.index()].truncate();
    let mut coords = Vec::new();
    for edge in &live {
        let [a, b] = edge.vertices.map(at);
        coords.extend([place(a, b).to_array(), place(b, a).to_array()]);
    }
    let edges: Vec<[u32; 2]> = (0..live.len() as u32).map(|line| [2 * line, 2 * line + 1]).collect();
    let letters: String = live.iter().map(|edge| edge.assignment.letter()).collect();
    let angles = live.iter().map(|edge| edge.fold_angle.map(f64::to_degrees)).collect();
    Frame { edges_fold_angle: Some(angles), ..flat(&coords, &edges, &letters, &[]) }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Ends moved every which way.
    #[test]
    fn scattered_ends_come_together(
        which in 0..FLAT.len(),
        power in 5.0..9.0f64,
        offs in proptest::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 997),
    ) {
        let whole = catalog::generate(FLAT[which], &[]).expect("a pattern");
        let far = whole.size() * 10f64.powf(-power);
        let mut offs = offs.iter().cycle();
        let frame = apart(&whole, |a, _| {
            let (x, y) = offs.next().copied().unwrap_or_default();
            a + far * DVec2::new(x, y)
        });
        let pattern = CreasePattern::from_frame(&frame).map_err(|error| TestCaseError::fail(error.to_string()))?;
        pattern.sanity_check().map_err(TestCaseError::fail)?;
        prop_assert_eq!(counts(&pattern), counts(&whole), "{} by {}", FLAT[which], far);
        prop_assert_eq!(pattern.paper().lost, 0.0);
    }

    /// Lines that are a little too long or too short.
    #[test]
    fn gaps_and_overshoots_are_closed(
        which in 0..FLAT.len(),
        power in 5.0..9.0f64,
        offs in proptest::collection::vec(-1.0..1.0f64, 997),
    ) {
        let whole = catalog::generate(FLAT[which], &[]).expect("a pattern");
        let far = whole.size() * 10f64.powf(-power);
        let mut offs = offs.iter().cycle();
        let frame = apart(&whole, |a, b| a + far * offs.next().copied().unwrap_or_default() * (a - b).normalize());
        let pattern = CreasePattern::from_frame(&frame).map_err(|error| TestCaseError::fail(error.to_string()))?;
        pattern.sanity_check().map_err(TestCaseError::fail)?;
        prop_assert_eq!(counts(&pattern), counts(&whole), "{} by {}", FLAT[which], far);
    }

    /// Whole lines, not cut where others meet them: a grid of long creases whose ends miss the border.
    #[test]
    fn long_lines_that_miss_the_border(
        power in 4.0..9.0f64,
        offs in proptest::collection::vec(-1.0..1.0f64, 24),
    ) {
        let far = 10f64.powf(-power);
        let mut coords = SQUARE.to_vec();
        let mut edges = SQUARE_EDGES[..4].to_vec();
        for (index, pair) in offs.chunks(2).enumerate() {
            let at = (index / 2 + 1) as f64 / 7.0;
            let (low, high) = (far * pair[0], 1.0 + far * pair[1]);
            let first = coords.len() as u32;
            coords.extend(if index % 2 == 0 { [[low, at], [high, at]] } else { [[at, low], [at, high]] });
            edges.push([first, first + 1]);
        }
        let pattern = CreasePattern::from_frame(&flat(&coords, &edges, &("BBBB".to_owned() + &"MV".repeat(6)), &[]));
        let pattern = pattern.map_err(|error| TestCaseError::fail(error.to_string()))?;
        prop_assert_eq!(counts(&pattern), [64, 49, 1]);
        prop_assert!((pattern.paper().area - 1.0).abs() < 4e-6, "rounding bends the border, near misses do not");
    }

    /// A border with a gap: closed, or refused by name; never half the sheet.
    #[test]
    fn an_open_border_loses_no_paper(power in 0.0..9.0f64, side in 0..4usize, at in 0.0..1.0f64) {
        let gap = 0.9 * 10f64.powf(-power);
        let (a, b) = (SQUARE[side], SQUARE[(side + 1) % 4]);
        let on = |t: f64| [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
        let low = at * (1.0 - gap);
        let mut coords = SQUARE.to_vec();
        coords.extend([on(low), on(low + gap), [0.5, 0.0], [0.5, 1.0]]);
        let mut edges: Vec<[u32; 2]> = (0..4).filter(|&other| other != side as u32).map(|i| [i, (i + 1) % 4]).collect();
        edges.push([6, 7]);
        for (end, vertex) in [(side as u32, 4), ((side as u32 + 1) % 4, 5)] {
            if coords[end as usize] != coords[vertex] {
                edges.push([end, vertex as u32]);
            }
        }
        let letters: String = (0..edges.len()).map(|i| if i == 3 { 'V' } else { 'B' }).collect();
        match CreasePattern::from_frame(&flat(&coords, &edges, &letters, &[])) {
            Ok(pattern) => {
                prop_assert_eq!(pattern.faces.len(), 2, "gap {} at {}: {:#?}", gap, low, pattern.warnings);
                prop_assert!((pattern.paper().area - 1.0).abs() < 1e-9);
                let told = [WarningCode::BorderClosed, WarningCode::BorderJoined, WarningCode::VerticesMerged];
                prop_assert!(pattern.warnings.iter().any(|warning| told.contains(&warning.code)));
            }
            Err(error) => prop_assert_eq!(error.code().name(), "border-open", "{}", error),
        }
    }
}

#[test]
fn joins_are_named_with_both_places_and_the_distance() {
    let coords = [&SQUARE[..], &[[0.5, 3e-5], [0.5, 1.0]]].concat();
    let edges = [&SQUARE_EDGES[..4], &[[4, 5]]].concat();
    let pattern = build(&flat(&coords, &edges, "BBBBM", &[]));
    assert_eq!(pattern.faces.len(), 2);
    assert_warned(&pattern, "vertices_coords[4]", "lies 0.00003 beside edges_vertices[0]; they are joined there");
    let [join] = pattern.joins[..] else { panic!("{:?}", pattern.joins) };
    assert!((join.distance - 3e-5).abs() < 1e-12 && !join.border);
    // The border stays straight.
    assert_eq!((pattern.vertices[4], total_area(&pattern)), (DVec3::new(0.5, 0.0, 0.0), 1.0));
    assert_eq!(join.with, JoinedTo::Edge(origami_core::ids::EdgeId(0)));
}

#[test]
fn the_distance_can_be_given() -> Result<(), Error> {
    let coords = [&SQUARE[..], &[[0.5, 0.015], [0.5, 1.0]]].concat();
    let edges = [&SQUARE_EDGES[..4], &[[4, 5]]].concat();
    let frame = flat(&coords, &edges, "BBBBM", &[]);
    let with = |join: f64| CreasePattern::from_frame_with(&frame, &Reading::joining(Some(join)));
    assert_eq!(with(0.02)?.faces.len(), 2);
    let pattern = with(0.01)?;
    assert_eq!(pattern.faces.len(), 1);
    assert_warned(
        &pattern,
        "vertices_coords[4]",
        "is a loose end 0.015 from edges_vertices[0] and is not joined to it",
    );
    let own = CreasePattern::from_frame(&frame)?;
    assert_eq!(own.faces.len(), 1, "a crease that ends by 1.5 % before the border may be meant to");
    for wrong in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(with(wrong).is_err_and(|error| error.to_string().starts_with("join: is ")));
    }
    // Through a document.
    let document = Document { key_frame: frame, join: Some(0.04), ..Document::default() };
    assert_eq!(CreasePattern::from_document(&document, 0)?.faces.len(), 2);
    Ok(())
}

#[test]
fn a_whole_side_that_is_missing_is_put_in_and_an_unclear_one_refused() {
    let pattern = build(&flat(&SQUARE, &[[0, 1], [1, 2], [2, 3], [0, 2]], "BBBV", &[]));
    assert_eq!((pattern.faces.len(), total_area(&pattern)), (2, 1.0));
    assert_warned(&pattern, "edges_vertices[2]", "open between vertices_coords[0] and [3], 1 apart; closed");
    // A side is missing, and creases end on it.
    let coords = [&SQUARE[..], &[[0.3, 0.0], [0.3, 1.0], [0.6, 0.0], [0.6, 1.0]]].concat();
    let pattern = build(&flat(&coords, &[[0, 1], [1, 2], [0, 3], [4, 5], [6, 7]], "BBBVM", &[]));
    assert_eq!((pattern.faces.len(), pattern.joins.len()), (3, 0));
    assert!((total_area(&pattern) - 1.0).abs() < 1e-12);
    // A pit in the side: a straight line would not be on the hull, and turns.
    let coords = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [3.0, 2.0], [1.0, 2.0], [0.0, 4.0], [2.0, 0.0], [2.0, 1.5]];
    let edges = [[0, 1], [1, 2], [2, 3], [4, 5], [0, 5], [6, 7]];
    let said = refused(&flat(&coords, &edges, "BBBBBV", &[]));
    assert!(
        said.starts_with("edges_vertices[") && said.contains("the border is open: it ends at vertices_coords["),
        "{said}"
    );
}

/// Patterns that are not ours to ship: they come out as before wherever the folder is.
#[test]
fn patterns_of_designers_are_as_before() {
    let shared = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/patterns");
    let folders = [shared.join("designers"), shared];
    let files = folders.iter().filter_map(|folder| std::fs::read_dir(folder).ok()).flatten().flatten();
    let mut files: Vec<_> =
        files.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "fold")).collect();
    files.sort();
    let mut changed = Vec::new();
    for path in &files {
        let document = Document::read(path).expect("a FOLD file");
        let mut frame = document.frame(document.pattern_frame().expect("a frame")).expect("a frame");
        let given = CreasePattern::from_frame(&frame).expect("faces");
        let size = given.size();
        frame.faces_vertices = None;
        if given.is_flat() && given.vertices.len() == given.vertices_in_file {
            let old = CreasePattern::from_frame_with(&frame, &Reading::joining(Some(2e-6 * size)));
            let new = CreasePattern::from_frame(&frame);
            let (Ok(old), Ok(new)) = (old, new) else { panic!("{}", path.display()) };
            if !new.joins.is_empty() || counts(&old) != counts(&new) || given.paper().lost > 0.0 {
                changed.push((path.display().to_string(), counts(&old), counts(&new)));
            }
        }
    }
    assert!(changed.is_empty(), "{changed:#?}");
}

/// Faces in the file that contradict its lines, of all kinds, on a Miura sheet: it comes back whole.
#[test]
fn faces_that_contradict_the_lines_are_found_anew() {
    let whole = catalog::generate("miura", &[]).expect("a pattern");
    let frame = || {
        let coords = whole.vertices.iter().map(|&position| Coordinates { position, dimension: 2 }).collect();
        Frame {
            vertices_coords: Some(coords),
            edges_vertices: Some(whole.edges.iter().map(|edge| edge.vertices.map(|v| v.0)).collect()),
            edges_assignment: Some(whole.edges.iter().map(|edge| edge.assignment.letter().into()).collect()),
            edges_fold_angle: Some(whole.edges.iter().map(|edge| edge.fold_angle.map(f64::to_degrees)).collect()),
            faces_vertices: Some(whole.faces.iter().map(|face| face.iter().map(|v| v.0).collect()).collect()),
            ..Frame::default()
        }
    };
    fn faces(frame: &mut Frame) -> &mut Vec<Vec<u32>> {
        frame.faces_vertices.as_mut().expect("faces")
    }
    let mut wrong: Vec<(&str, Frame)> = Vec::new();
    // All faces with corners of their own, and creases listed once for each.
    let mut own = frame();
    let (mut coords, mut edges, mut letters, mut angles) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for face in faces(&mut own) {
        let first = coords.len() as u32;
        let count = face.len() as u32;
        for (corner, vertex) in face.iter_mut().enumerate() {
            let next = whole.faces.iter().flatten().next();
            assert!(next.is_some());
            coords.push(Coordinates { position: whole.vertices[*vertex as usize], dimension: 2 });
            edges.push([first + corner as u32, first + (corner as u32 + 1) % count]);
        }
        let corners: Vec<u32> = face.clone();
        for corner in 0..count as usize {
            let ends = [corners[corner], corners[(corner + 1) % corners.len()]];
            let edge = whole.edges.iter().find(|edge| ends.iter().all(|end| edge.vertices.iter().any(|v| v.0 == *end)));
            let edge = edge.expect("a side is an edge");
            letters.push(edge.assignment.letter().into());
            angles.push(edge.fold_angle.map(f64::to_degrees));
        }
        face.iter_mut().enumerate().for_each(|(corner, vertex)| *vertex = first + corner as u32);
    }
    own.vertices_coords = Some(coords);
    own.edges_vertices = Some(edges);
    own.edges_assignment = Some(letters);
    own.edges_fold_angle = Some(angles);
    wrong.push(("corners of their own", own));
    // One face twice; the outline as a face; two faces as one.
    let mut twice = frame();
    let again = faces(&mut twice)[3].clone();
    faces(&mut twice).push(again);
    wrong.push(("a face twice", twice));
    let mut joined = frame();
    let hinge = whole.edges.iter().find(|edge| edge.fold_angle.is_some_and(|angle| angle != 0.0)).expect("a crease");
    let ends = hinge.vertices.map(|v| v.0);
    let beside: Vec<usize> =
        (0..whole.faces.len()).filter(|&f| ends.iter().all(|end| faces(&mut joined)[f].contains(end))).collect();
    let ring = |face: &[u32]| {
        let at = face.iter().position(|v| *v == ends[0]).expect("a corner");
        let mut face = face.to_vec();
        face.rotate_left(at);
        face
    };
    let [one, two] = [ring(&faces(&mut joined)[beside[0]]), ring(&faces(&mut joined)[beside[1]])];
    // The first runs from one end to the other around itself, the second back.
    let (one, two) = if one[1] == ends[1] { (two, one) } else { (one, two) };
    let outline: Vec<u32> = one[..one.len()].iter().chain(&two[2..]).copied().collect();
    faces(&mut joined)[beside[0]] = outline;
    faces(&mut joined).remove(beside[1]);
    wrong.push(("a crease across a face", joined));
    for (name, frame) in wrong {
        let pattern = build(&frame);
        assert_eq!(counts(&pattern), counts(&whole), "{name}: {:#?}", pattern.warnings);
        assert!((pattern.paper().area - whole.paper().area).abs() < 1e-9 * whole.paper().area, "{name}");
        assert_eq!(pattern.warnings.iter().filter(|w| w.code == WarningCode::FacesRepaired).count(), 1, "{name}");
        let driven = |pattern: &CreasePattern| {
            let live = pattern.edges.iter().filter(|edge| edge.alias_of.is_none());
            live.filter(|edge| edge.fold_angle.is_some_and(|angle| angle != 0.0)).count()
        };
        assert_eq!(driven(&pattern), driven(&whole), "{name}");
    }
}

/// A file that calls itself a folded form has faces on each other: lines say nothing of them.
#[test]
fn folded_forms_keep_their_faces() {
    // Folded over: both faces lie on each other, and a crease is listed that has no face.
    let coords = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [0.0, 1.0]];
    let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [1, 4], [4, 5], [5, 2], [0, 2]];
    let frame = flat(&coords, &edges, "BVBBBBBV", &[&[0, 1, 2, 3], &[1, 4, 5, 2]]);
    let folded = Frame { classes: Some(vec!["foldedForm".into()]), ..frame };
    let pattern = build(&folded);
    assert_eq!(pattern.faces.len(), 2);
    assert!(pattern.warnings.iter().all(|warning| warning.code != WarningCode::FacesRepaired));
    let corners: Vec<DVec3> = pattern.faces[1].iter().map(|v| pattern.vertices[v.index()]).collect();
    assert_eq!(corners.len(), 4);
}

/// In space there are no faces to be found between lines; those that touch are joined.
#[test]
fn faces_in_space_are_joined_where_they_touch() {
    // Two squares at a right angle, the second in two halves, with corners of their own.
    let coords = [
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]],
        [[2.0, 0.0, 0.0], [2.0, 0.0, 2.0], [2.0, 1.0, 2.0], [2.0, 1.0, 0.0]],
        [[2.0, 1.0, 0.0], [2.0, 1.0, 2.0], [2.0, 2.0, 2.0], [2.0, 2.0, 0.0]],
    ]
    .concat();
    let edges: Vec<[u32; 2]> = (0..12).map(|i| [i, if i % 4 == 3 { i - 3 } else { i + 1 }]).collect();
    let frame = spatial(&coords, &edges, "BVBBBBFVFBBV", &[&[0, 1, 2, 3], &[4, 5, 6, 7], &[8, 9, 10, 11]]);
    let pattern = build(&frame);
    assert_eq!((pattern.faces.len(), pattern.paper().pieces), (3, 1), "{:#?}", pattern.warnings);
    assert_warned(&pattern, "faces_vertices[0]", "faces that touch were joined: 3");
    assert_warned(&pattern, "vertices_coords[4]", "lies on another vertex");
    let folds = pattern.edges.iter().filter(|edge| edge.alias_of.is_none() && edge.fold_angle.is_some_and(|a| a > 1.0));
    assert_eq!(folds.count(), 2, "both halves of the crease");
}
