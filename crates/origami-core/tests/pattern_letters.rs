//! Letters, fold angles and our own keys.

mod pattern_support;

use origami_core::pattern::Assignment;
use pattern_support::{assert_warned, build, degrees, flat, letters, refused, spatial, square};
use serde_json::json;

#[test]
fn without_angles_the_letters_say_how_far() {
    for (letter, angle) in [("M", Some(-180.0)), ("V", Some(180.0)), ("F", Some(0.0)), ("J", Some(0.0)), ("U", None)] {
        for with_faces in [true, false] {
            let pattern = build(&square(&format!("BBBB{letter}"), with_faces));
            assert_eq!(degrees(&pattern, 4), angle, "{letter}");
            assert_eq!(letters(&pattern), format!("BBBB{letter}"), "{letter}");
        }
    }
}

#[test]
fn lower_case_is_taken_as_upper_case_with_one_warning() {
    let pattern = build(&square("bbbbv", true));
    assert_eq!(letters(&pattern), "BBBBV");
    assert_warned(&pattern, "edges_assignment[0]", "lower-case letter, taken as upper case (and 4 more)");
}

#[test]
fn an_unknown_letter_is_unassigned() {
    let pattern = build(&square("BBBBX", true));
    assert_eq!(letters(&pattern), "BBBBU");
    assert_warned(&pattern, "edges_assignment[4]", "\"X\" is none of");
}

#[test]
fn missing_letters_follow_from_the_angles() {
    for (angle, letter) in [(Some(30.0), "V"), (Some(-30.0), "M"), (Some(0.0), "F"), (None, "U")] {
        let mut frame = square("", true);
        frame.edges_fold_angle = Some(vec![None, None, None, None, angle]);
        let pattern = build(&frame);
        assert_eq!(letters(&pattern), format!("BBBB{letter}"));
        assert_eq!(degrees(&pattern, 4).map(f64::round), angle);
    }
}

#[test]
fn with_neither_letters_nor_angles_nothing_drives_the_sheet() {
    for with_faces in [true, false] {
        let pattern = build(&square("", with_faces));
        assert_eq!(letters(&pattern), "BBBBU");
        assert_warned(&pattern, "edges_assignment", "nothing drives");
    }
}

#[test]
fn angles_are_used_as_they_are() {
    let cases = [
        ("M", Some(-30.0), Some(-30.0), None),
        ("M", Some(30.0), Some(30.0), Some(("edges_foldAngle[4]", "opposite sign"))),
        ("V", Some(-30.0), Some(-30.0), Some(("edges_foldAngle[4]", "opposite sign"))),
        ("M", Some(0.0), Some(0.0), None),
        ("M", None, None, Some(("edges_foldAngle[4]", "M with null"))),
        ("V", Some(270.0), Some(270.0), Some(("edges_foldAngle[4]", "past flat folded"))),
        ("F", Some(20.0), Some(20.0), Some(("edges_assignment[4]", "has a fold angle"))),
        ("U", Some(20.0), None, Some(("edges_assignment[4]", "nothing drives it"))),
        ("U", Some(0.0), None, None),
    ];
    for (letter, given, expected, warning) in cases {
        let mut frame = square(&format!("BBBB{letter}"), true);
        frame.edges_fold_angle = Some(vec![None, Some(0.0), Some(0.0), None, given]);
        let pattern = build(&frame);
        assert_eq!(degrees(&pattern, 4).map(f64::round), expected, "{letter} {given:?}");
        assert_eq!(pattern.warnings.len(), usize::from(warning.is_some()), "{:?}", pattern.warnings);
        if let Some((place, words)) = warning {
            assert_warned(&pattern, place, words);
        }
    }
}

#[test]
fn arrays_of_another_length_are_refused_with_both_lengths() {
    let mut frame = square("BBBB", true);
    assert_eq!(
        refused(&frame),
        "edges_assignment: has 4 entries where edges_vertices has 5; expected one entry for each edge"
    );
    frame.edges_assignment = None;
    frame.edges_fold_angle = Some(vec![None; 3]);
    assert!(refused(&frame).starts_with("edges_foldAngle: has 3 entries where edges_vertices has 5"));
    frame.edges_fold_angle = Some(vec![Some(f64::NAN); 5]);
    assert!(refused(&frame).starts_with("edges_foldAngle[0]: is not finite"));
}

#[test]
fn letters_that_contradict_the_faces_give_way() {
    let pattern = build(&square("BMFBB", true));
    assert_eq!(letters(&pattern), "BBBBU");
    assert_warned(&pattern, "edges_assignment[1]", "M on the contour, taken as B (and 1 more)");
    assert_warned(&pattern, "edges_assignment[4]", "B between two faces, taken as U");
}

/// Two triangles joined by edge 0, the second turned up by `angle`, with edge 0 against (3, 4) of the paper or along it.
fn flap(angle: f64, letter: &str) -> origami_core::fold::Frame {
    let coords = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 1.0, 0.0], [angle.cos(), 1.0, angle.sin()]];
    let letters = if letter.is_empty() { String::new() } else { format!("{letter}BBBB") };
    let edges = [[1, 0], [1, 2], [2, 0], [0, 3], [3, 1]];
    spatial(&coords, &edges, &letters, &[&[0, 1, 2], &[1, 0, 3]])
}

#[test]
fn a_folded_form_without_angles_is_measured() {
    for angle in [-120.0f64, -30.0, 30.0, 120.0] {
        for letter in ["M", "V", "F", "J", ""] {
            let pattern = build(&flap(angle.to_radians(), letter));
            assert!((degrees(&pattern, 0).expect("a driven crease") - angle).abs() < 1e-9, "{letter} {angle}");
            let opposite = (letter == "M" && angle > 0.0) || (letter == "V" && angle < 0.0);
            let told = pattern.warnings.iter().filter(|w| w.message.contains("opposite sign")).count();
            assert_eq!(told, usize::from(opposite), "{:?}", pattern.warnings);
        }
        assert_eq!(degrees(&build(&flap(angle.to_radians(), "U")), 0), None);
        let derived = build(&flap(angle.to_radians(), "")).edges[0].assignment;
        assert_eq!(derived, if angle > 0.0 { Assignment::Valley } else { Assignment::Mountain });
    }
}

#[test]
fn given_angles_win_over_measured_ones() {
    let mut frame = flap(1.0, "V");
    frame.edges_fold_angle = Some(vec![Some(90.0), None, None, None, None]);
    assert_eq!(degrees(&build(&frame), 0), Some(90.0));
}

#[test]
fn folded_over_the_letter_gives_the_sign() {
    // A third triangle keeps the sheet from being flat.
    let coords = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 1.0, 0.0], [-1.0, 1.2, 0.0], [0.0, 0.0, 1.0]];
    let faces: [&[u32]; 3] = [&[0, 1, 2], &[1, 0, 3], &[0, 2, 4]];
    let edges = [[0, 1], [0, 2], [1, 2], [0, 3], [1, 3], [0, 4], [2, 4]];
    for (letter, angle) in [("M", -180.0), ("V", 180.0)] {
        let pattern = build(&spatial(&coords, &edges, &format!("{letter}UBBBBB"), &faces));
        assert_eq!(degrees(&pattern, 0), Some(angle));
    }
}

#[test]
fn a_flat_sheet_in_a_tilted_plane_folds_all_the_way() {
    let pattern = build(&flap(0.0, "V"));
    assert_eq!(degrees(&pattern, 0), Some(180.0));
    let coords = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [-1.0, 1.0, -1.0], [1.0, 1.0, 1.0]];
    let edges = [[1, 0], [1, 2], [2, 0], [0, 3], [3, 1]];
    let pattern = build(&spatial(&coords, &edges, "VBBBB", &[&[0, 1, 2], &[1, 0, 3]]));
    assert_eq!(degrees(&pattern, 0), Some(180.0));
    assert_warned(&pattern, "vertices_coords", "tilted plane");
}

#[test]
fn stiffness_and_fixed_vertices_are_read() {
    let mut frame = square("BBBBV", true);
    frame.extra.insert("edges_origami:k_crease".into(), json!([null, null, null, null, 2.5]));
    frame.extra.insert("edges_origami:ea".into(), json!([7, null, null, null, 0]));
    frame.extra.insert("vertices_origami:fixed".into(), json!([false, true, 0, 1]));
    let pattern = build(&frame);
    assert_eq!((pattern.edges[4].k_crease, pattern.edges[0].k_crease), (Some(2.5), None));
    assert_eq!((pattern.edges[0].ea, pattern.edges[4].ea, pattern.edges[1].ea), (Some(7.0), Some(0.0), None));
    assert_eq!(pattern.fixed.iter().map(|v| v.0).collect::<Vec<_>>(), [1, 3]);
}

#[test]
fn wrong_values_under_our_own_keys_are_refused() {
    let cases = [
        ("edges_origami:k_crease", json!([1, 1, 1, 1]), "edges_origami:k_crease: has 4 entries"),
        ("edges_origami:k_crease", json!([1, -1, 1, 1, 1]), "edges_origami:k_crease[1]: is -1"),
        ("edges_origami:ea", json!([1, 1, "soft", 1, 1]), "edges_origami:ea[2]: is \"soft\""),
        ("edges_origami:ea", json!(20), "edges_origami:ea: is not an array"),
        ("vertices_origami:fixed", json!([true]), "vertices_origami:fixed: has 1 entries where vertices_coords has 4"),
        ("vertices_origami:fixed", json!([0, 2, 0, 0]), "vertices_origami:fixed[1]: is 2"),
    ];
    for (key, value, message) in cases {
        let mut frame = square("BBBBV", true);
        frame.extra.insert(key.into(), value);
        assert!(refused(&frame).starts_with(message), "{}", refused(&frame));
    }
}

#[test]
fn a_line_given_twice_is_one() {
    let mut coords = pattern_support::SQUARE_EDGES.to_vec();
    coords.push([2, 0]);
    for (letters_given, expected, words) in [
        ("BBBBFM", Assignment::Mountain, "M, and F at edges_assignment[4],"),
        ("BBBBMV", Assignment::Mountain, "V, and M at"),
        ("BBBBFU", Assignment::Flat, "U, and F at"),
    ] {
        let pattern = build(&flat(&pattern_support::SQUARE, &coords, letters_given, &[&[0, 1, 2], &[0, 2, 3]]));
        assert_eq!(pattern.edges[4].assignment, expected);
        assert_eq!(pattern.edges[5].alias_of.map(|edge| edge.index()), Some(4));
        assert_warned(&pattern, "edges_assignment[5]", words);
    }
    let pattern = build(&flat(&pattern_support::SQUARE, &coords, "BBBBVV", &[]));
    assert_warned(&pattern, "edges_vertices[5]", "more than once");
    assert_eq!(degrees(&pattern, 4), Some(180.0));
}

#[test]
fn an_angle_cut_off_at_half_a_turn_is_taken_whole_from_our_own_key() {
    let with_own = |written: f64, own: serde_json::Value| {
        let mut frame = square("BBBBV", true);
        frame.edges_fold_angle = Some(vec![None, None, None, None, Some(written)]);
        frame.extra.insert("edges_origami:foldAngle".into(), json!([null, null, null, null, own]));
        frame
    };
    for (written, own, taken) in [
        (180.0, json!(183.5), 183.5),
        (-180.0, json!(-190), -190.0),
        // An angle that FOLD can say was written after ours.
        (170.0, json!(183.5), 170.0),
        (180.0, json!(-183.5), 180.0),
        (180.0, json!(null), 180.0),
    ] {
        let reached = degrees(&build(&with_own(written, own)), 4).expect("an angle");
        assert!((reached - taken).abs() < 1e-12, "{reached} is not {taken}");
    }
    assert!(refused(&with_own(180.0, json!("far"))).contains("edges_origami:foldAngle[4]"));
}
