//! Files as they are met in practice, broken in one way each: `tests/broken/NAME.fold` at the root of the repository.
//! Each either folds, with a warning that names the place, or is refused with an error that does.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use assert_cmd::Command;

/// File, exit code, what standard error says (nothing where this is empty).
const CASES: &[(&str, i32, &str)] = &[
    ("all-at-one-place", 1, "vertices_coords: all vertices lie at one place"),
    ("all-on-a-line", 1, "edges_vertices: the lines enclose no paper, and there is no faces_vertices"),
    ("angle-null", 0, "edges_foldAngle[4]: V with null: a free crease, which nothing drives"),
    (
        "angle-of-opposite-sign",
        0,
        "edges_foldAngle[4]: V with -90 degrees: letter and fold angle are of opposite sign; the angle is kept",
    ),
    ("angle-too-large", 0, "edges_foldAngle[4]: 270 degrees is past flat folded; kept"),
    ("angles-too-long", 1, "edges_foldAngle: has 6 entries where edges_vertices has 5"),
    ("assignment-too-short", 1, "edges_assignment: has 4 entries where edges_vertices has 5"),
    ("blank", 1, "line 1: the file is empty"),
    ("boundary-inside", 0, "edges_assignment[4]: B between two faces, taken as U"),
    ("boundary-with-angle", 0, "edges_foldAngle[1]: 45 degrees on a boundary or cut; ignored"),
    ("byte-order-mark", 0, ""),
    (
        "clockwise-faces",
        0,
        "faces_vertices[0]: runs clockwise: its letters and angles are taken as seen from the other side (and 1 more)",
    ),
    ("contour-open", 0, "edges_vertices[2]: the border is open between vertices_coords[0] and [3], 1 apart; closed"),
    ("coordinates-are-one", 1, "vertices_coords[0]: invalid length 1, expected two or three coordinates"),
    ("coordinates-are-text", 1, "vertices_coords[2][0]: invalid type: string \"1\", expected a number"),
    ("coordinates-far-off", 0, ""),
    ("coordinates-huge", 1, "vertices_coords: the pattern is 1e300 in size"),
    (
        "coordinates-in-four-dimensions",
        1,
        "vertices_coords[0]: not 0 beyond the third coordinate, expected at most x, y and z",
    ),
    (
        "coordinates-mixed",
        0,
        "vertices_coords[1]: has 3 numbers, the first vertex has another count; a z that is not given is 0 (and 1 more)",
    ),
    ("coordinates-tiny", 1, "vertices_coords: the pattern is 1e-300 in size"),
    ("crease-that-ends-inside", 0, "faces_vertices: is missing; built from the lines: 2 faces, 0 holes"),
    ("crossing-edges", 0, "edges_vertices[4]: crosses edges_vertices[5]; both get a vertex there"),
    ("cut-in-two", 0, "edges_foldAngle[4]: 90 degrees on a boundary or cut; ignored"),
    ("cut", 0, "faces_vertices: is missing; built from the lines: 2 faces, 0 holes"),
    ("edge-of-no-length-with-faces", 1, "edges_vertices[2]: vertices 2 and 3 lie at one place"),
    ("edge-of-no-length", 0, "vertices_coords[4]: lies on another vertex; the two are one"),
    ("edge-of-one-vertex", 1, "edges_vertices[4]: joins vertex 2 to itself"),
    ("edge-of-three", 1, "edges_vertices[4]: more than two numbers, expected two vertex indices"),
    ("edge-out-of-range", 1, "edges_vertices[4]: vertex 7 does not exist"),
    (
        "edge-twice-other-letter",
        0,
        "edges_assignment[5]: M, and V at edges_assignment[4], given to one line; a mountain or valley wins, otherwise the first letter",
    ),
    ("edge-twice-same-letter", 0, "edges_vertices[5]: line given more than once; the first stands for all"),
    ("empty", 1, "line 1: the file is empty"),
    ("face-of-no-area", 0, "faces_vertices[0]: face without area; its folds have no direction"),
    ("face-of-two-corners", 1, "faces_vertices[1]: has 2 different vertices"),
    ("face-out-of-range", 1, "faces_vertices[1]: vertex 9 does not exist"),
    ("face-twice", 0, "faces_vertices[2]: contradicts the lines; the faces were found anew from the lines: 2"),
    ("face-with-a-corner-twice", 1, "faces_vertices[1]: encloses no area"),
    (
        "face-without-its-edge",
        0,
        "faces_vertices[0]: has a side that edges_vertices does not list; between two faces it is taken as flat",
    ),
    ("faces-empty", 0, "faces_vertices: is empty; built from the lines: 2 faces, 0 holes"),
    ("fixed-out-of-range", 1, "vertices_origami:fixed: has 5 entries where vertices_coords has 4"),
    ("folded-form-without-angles", 0, "edges_foldAngle: is missing; the angles are measured from the coordinates"),
    ("folded-form-without-faces", 1, "faces_vertices: is missing, and the vertices do not lie in one plane"),
    ("frame-is-null", 1, "file_frames[0]: invalid type: null, expected a frame, that is an object"),
    ("frame-parent-missing", 1, "file_frames[0].frame_parent: there is no frame 9"),
    ("frames-in-a-circle", 1, "file_frames[0].frame_parent: the frame inherits from itself"),
    ("frames-not-an-array", 1, "file_frames: invalid type: map, expected an array of frames"),
    ("hole-without-letters", 0, "edges_assignment: is missing, and so is edges_foldAngle: nothing drives the sheet"),
    ("hole", 0, "faces_vertices: is missing; built from the lines: 4 faces, 1 hole"),
    (
        "index-fractional",
        1,
        "edges_vertices[4][1]: invalid value: floating point `1.5`, expected an index, a whole number from 0 to 4294967295",
    ),
    (
        "index-huge",
        1,
        "edges_vertices[4][1]: invalid value: integer `99999999999`, expected an index, a whole number from 0 to 4294967295",
    ),
    (
        "index-negative",
        1,
        "edges_vertices[4][1]: invalid value: integer `-2`, expected an index, a whole number from 0 to 4294967295",
    ),
    ("infinity", 1, "vertices_coords[2][0]: not JSON: expected value"),
    ("isolated-vertex", 0, "vertices_coords[4]: belongs to no edge and no face; it stays where it is"),
    ("key-twice", 1, "vertices_coords: the key is there twice in one object, expected once"),
    ("letter-is-number", 1, "edges_assignment[4]: invalid type: integer `1`, expected a string"),
    ("lower-case", 0, "edges_assignment[0]: lower-case letter, taken as upper case (and 4 more)"),
    ("mixed-faces", 0, "faces_vertices[1]: runs the other way round than its neighbours; turned over"),
    (
        "moebius-strip",
        1,
        "edges_vertices[5]: faces_vertices 1 and 2 cannot be turned to agree: the sheet has one side only",
    ),
    ("mountain-on-contour", 0, "edges_assignment[0]: M on the contour, taken as B"),
    ("nan", 1, "vertices_coords[2][0]: not JSON: expected value"),
    ("nested-deeply-in-an-own-key", 1, "own:key[0][0][0][…][0][0][0][0]: nested too deeply"),
    ("nested-deeply", 1, "vertices_coords[0][0]: invalid type: sequence, expected a number"),
    ("no-angles", 0, "edges_foldAngle: is missing; M and V fold by -180 and 180 degrees"),
    (
        "no-assignment-and-no-angles",
        0,
        "edges_assignment: is missing, and so is edges_foldAngle: nothing drives the sheet",
    ),
    ("no-assignment", 0, "edges_assignment: is missing; the letters follow from the fold angles"),
    ("no-coordinates", 1, "vertices_coords: no frame has this key"),
    ("no-edges-and-no-faces", 1, "edges_vertices: is missing or empty, and so is faces_vertices"),
    ("no-edges", 0, "edges_assignment: is missing, and so is edges_foldAngle: nothing drives the sheet"),
    ("no-faces", 0, "faces_vertices: is missing; built from the lines: 2 faces, 0 holes"),
    ("no-keys", 1, "vertices_coords: no frame has this key"),
    ("no-paper", 1, "edges_vertices: the lines enclose no paper, and there is no faces_vertices"),
    ("not-an-object", 1, "line 1 column 0: invalid type: sequence, expected a FOLD file, that is one JSON object"),
    ("not-json", 1, "line 1 column 1: not JSON: expected value"),
    ("not-utf8", 1, "line 2 column 15: not UTF-8"),
    ("overflow", 1, "vertices_coords[2][0]: the number is too large"),
    ("pattern-in-a-later-frame", 0, ""),
    ("self-crossing-face", 0, "faces_vertices[0]: contradicts the lines; the faces were found anew from the lines: 2"),
    ("slit", 0, "edges_assignment[6]: B with paper on both sides; the sheet is cut there"),
    ("sliver", 0, "faces_vertices[1]: thinner than 1e-6 of the sheet's radius; its springs are left out"),
    ("spec-1-0", 0, "edges_foldAngles: FOLD 1.0's name; read as edges_foldAngle"),
    ("stiffness-negative", 1, "edges_origami:k_crease[4]: is -1"),
    ("stiffness-not-a-number", 1, "edges_origami:ea[4]: is \"stiff\""),
    ("three-faces-at-an-edge", 1, "edges_vertices[4]: the line is a side of faces_vertices 0, 1 and 2"),
    ("trailing-text", 1, "line 9 column 1: not JSON: trailing characters"),
    ("truncated", 1, "edges_vertices: not JSON: EOF while parsing a list"),
    ("two-sheets", 0, ""),
    ("unknown-letter", 0, "edges_assignment[4]: \"X\" is none of B, M, V, F, U, C and J; taken as U"),
    ("vertex-on-edge", 0, "edges_vertices[0]: vertex 4 lies on it; the line is split there (and 1 more)"),
    ("vertices-at-one-place", 0, "vertices_coords[4]: lies on another vertex; the two are one"),
    ("vertices-empty", 1, "vertices_coords: is missing or empty"),
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/broken")
}

#[test]
fn every_file_folds_or_is_refused_as_it_should() {
    let place = tempfile::tempdir().unwrap();
    let output = place.path().join("a.fold");
    for (name, code, words) in CASES {
        std::fs::write(&output, "as it was").unwrap();
        let mut command = Command::cargo_bin("origami").unwrap();
        command.current_dir(folder()).args(["fold", &format!("{name}.fold"), "-o"]).arg(&output);
        let ran = command.output().unwrap();
        let stderr = String::from_utf8(ran.stderr).unwrap();
        assert_eq!(ran.status.code(), Some(*code), "{name}: {stderr}");
        assert!(stderr.contains(words), "{name}: expected {words:?} in {stderr:?}");
        assert_eq!(stderr.is_empty(), words.is_empty(), "{name}: {stderr}");
        let mut lines: Vec<&str> = stderr.lines().collect();
        if *code == 1 {
            let last = lines.pop().unwrap_or_default();
            assert!(last.starts_with(&format!("error: {name}.fold: ")), "{name}: {stderr}");
        }
        assert!(lines.iter().all(|line| line.starts_with("warning: ")), "{name}: {stderr}");
        let kept = std::fs::read_to_string(&output).unwrap() == "as it was";
        assert_eq!(kept, *code == 1, "{name}: an older output stays where the file is refused");
    }
}

#[test]
fn info_refuses_what_fold_refuses() {
    for (name, code, words) in CASES {
        let mut command = Command::cargo_bin("origami").unwrap();
        let ran = command.current_dir(folder()).args(["info", &format!("{name}.fold")]).output().unwrap();
        assert_eq!(ran.status.code(), Some(*code), "{name}");
        let told = if *code == 1 { ran.stderr } else { ran.stdout };
        assert!(String::from_utf8(told).unwrap().contains(words), "{name}");
    }
}

#[test]
fn every_file_is_in_the_table_once() {
    let names = std::fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path());
    let files: BTreeSet<String> = names.map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    let table: BTreeSet<String> = CASES.iter().map(|(name, _, _)| (*name).to_owned()).collect();
    assert_eq!(files, table);
    assert_eq!(table.len(), CASES.len());
}
