//! Each kind of error and warning, met where a program finds it: by its code, at its typed place. The files are those of
//! `tests/broken` at the root of the repository, each wrong in one way.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use origami_core::error::{CreasePlace, ErrorCode, Place, WarningCode};
use origami_core::fold::Document;
use origami_core::generate::{Hypar, SingleCrease};
use origami_core::ids::{EdgeId, FaceId, VertexId};
use origami_core::measure::{folded_warnings, scene_warnings, single_precision, strained_at_rest, touching_lips};
use origami_core::{CreasePattern, Error, Material, Model, Relax, Solver, Warning};

fn broken(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/broken").join(name).with_extension("fold")
}

fn model(pattern: &CreasePattern) -> Result<Model, Error> {
    Model::new(pattern, &Material::default())
}

/// A file of `tests/cases`.
fn case(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/cases").join(name).with_extension("fold")
}

/// Why the file `name` is refused.
fn refusal(name: &str) -> Error {
    let built = CreasePattern::read(broken(name)).and_then(|pattern| model(&pattern));
    built.map(drop).expect_err(name)
}

/// Reads the pattern of a unit square with corners 0 to 3 and whatever `rest` says of its edges and faces.
fn square(rest: &str) -> Result<CreasePattern, Error> {
    let text = format!(r#"{{"vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1]], {rest}}}"#);
    let document = Document::from_slice(text.as_bytes())?;
    CreasePattern::from_document(&document, 0)
}

const DIAGONAL: &str = r#""edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]"#;

fn key(key: &'static str) -> Place {
    Place::key(key)
}

fn entry(key: &'static str, index: usize) -> Place {
    Place::entry(key, index)
}

#[test]
fn every_kind_of_error_has_its_code_and_its_place() {
    use ErrorCode::*;
    let of_files = [
        ("not-utf8", NotUtf8, Place::Line { line: 2, column: Some(15) }),
        ("blank", EmptyFile, Place::Line { line: 1, column: None }),
        ("not-json", NotJson, Place::Line { line: 1, column: Some(1) }),
        ("truncated", NotJson, key("edges_vertices").in_frame(0)),
        ("edge-of-three", WrongType, entry("edges_vertices", 4).in_frame(0)),
        ("frame-is-null", WrongType, entry("file_frames", 0)),
        ("key-twice", KeyTwice, key("vertices_coords").in_frame(0)),
        ("frame-parent-missing", NoSuchFrame, key("frame_parent").in_frame(1)),
        ("frames-in-a-circle", FramesInACircle, key("frame_parent").in_frame(1)),
        ("no-keys", MissingKey, key("vertices_coords")),
        ("folded-form-without-faces", MissingKey, key("faces_vertices")),
        ("angles-too-long", WrongLength, key("edges_foldAngle")),
        ("stiffness-negative", WrongValue, entry("edges_origami:k_crease", 4)),
        ("edge-out-of-range", NoSuchVertex, entry("edges_vertices", 4)),
        ("face-out-of-range", NoSuchVertex, entry("faces_vertices", 1)),
        ("all-at-one-place", SheetSize, key("vertices_coords")),
        ("edge-of-one-vertex", EdgeWithoutLength, entry("edges_vertices", 4)),
        ("three-faces-at-an-edge", EdgeOfManyFaces, entry("edges_vertices", 4)),
        ("moebius-strip", OneSided, entry("edges_vertices", 5)),
        ("face-of-two-corners", FaceOfFewCorners, entry("faces_vertices", 1)),
        ("face-with-a-corner-twice", FaceWithoutArea, entry("faces_vertices", 1)),
        ("no-paper", NoPaper, key("edges_vertices")),
    ];
    let mut errors: Vec<(Error, ErrorCode, Place)> =
        of_files.into_iter().map(|(name, code, place)| (refusal(name), code, place)).collect();

    // Single coordinates are named by vertex and path.
    for (name, code, path) in [("overflow", NumberTooLarge, "[0]"), ("coordinates-are-text", WrongType, "[0]")] {
        let error = refusal(name);
        let Place::Key { within, .. } = error.place() else { panic!("{error}") };
        assert_eq!((error.place().vertex(), &*within), (Some(VertexId(2)), path), "{error}");
        let place = error.place();
        errors.push((error, code, place));
    }
    let deep = refusal("nested-deeply-in-an-own-key");
    assert!(matches!(deep.place(), Place::Key { frame: Some(0), index: Some(0), .. }), "{deep}");
    let place = deep.place();
    errors.push((deep, NestedTooDeeply, place));

    let missing = CreasePattern::read("no such file.fold").expect_err("no file");
    errors.push((missing, Io, Place::File("no such file.fold".into())));
    let text = r#"{"vertices_coords": [[0, 0], [1, 0]]}"#;
    let mut document = Document::from_slice(text.as_bytes()).expect("a document");
    errors.push((document.frame(7).expect_err("one frame"), NoSuchFrame, Place::Frame(7)));
    let points = document.key_frame.vertices_coords.as_mut().expect("two points");
    points[1].position.y = f64::INFINITY;
    let refused = document.to_string().expect_err("JSON has no infinity");
    errors.push((refused, NotFinite, entry("vertices_coords", 1).in_frame(0)));
    let crossing = square(r#""faces_vertices": [[0, 1, 3, 2]]"#).and_then(|pattern| model(&pattern));
    errors.push((crossing.map(drop).expect_err("a bow tie"), FaceNotSimple, entry("faces_vertices", 0)));
    let corner = square(r#""faces_vertices": [[0, 0, 1, 2]]"#).expect_err("a corner twice");
    errors.push((corner, CornerTwice, entry("faces_vertices", 0)));
    let mut twice = SingleCrease::default().pattern().expect("a crease");
    twice.edges.push(twice.edges[0].clone());
    let ends = twice.edges[0].vertices;
    let mesh = model(&twice).expect_err("an edge twice");
    errors.push((mesh, EdgeTwice, Place::Vertices(vec![ends[0].min(ends[1]), ends[0].max(ends[1])])));
    let pit = r#"{"vertices_coords": [[0, 0], [4, 0], [4, 4], [3, 2], [1, 2], [0, 4], [2, 0], [2, 1.5]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [4, 5], [0, 5], [6, 7]],
        "edges_assignment": ["B", "B", "B", "B", "B", "V"]}"#;
    let pit = Document::from_slice(pit.as_bytes()).expect("a document");
    let open = CreasePattern::from_document(&pit, 0).expect_err("an open border");
    errors.push((open, BorderOpen, entry("edges_vertices", 2)));
    let material = Material { ea: -1.0, ..Material::default() }.check().expect_err("a negative rigidity");
    errors.push((material, Setting, Place::from("material ea")));

    for (error, code, place) in &errors {
        assert_eq!((error.code(), &error.place()), (*code, place), "{error}");
        assert!(error.to_string().starts_with(&place.to_string()), "{error}: text and place differ");
    }
    let met: BTreeSet<&str> = errors.iter().map(|(_, code, _)| code.name()).collect();
    let unmet: Vec<&str> = ErrorCode::ALL.iter().map(|code| code.name()).filter(|name| !met.contains(name)).collect();
    // Those of other formats, arrays of 2^27 entries, and as many crossings as take seconds to find.
    let of_formats = ["not-xml", "not-a-pattern", "input-too-large", "damaged", "no-lines"];
    assert_eq!(unmet, [&of_formats[..], &["too-many-entries", "lines-too-dense"]].concat());
}

#[test]
fn every_kind_of_warning_has_its_code_and_its_place() {
    use WarningCode::*;
    let of_files = [
        ("spec-1-0", OldKey, key("edges_foldAngles").in_frame(0)),
        ("coordinates-mixed", MixedDimensions, entry("vertices_coords", 1)),
        ("vertices-at-one-place", VerticesMerged, entry("vertices_coords", 4)),
        ("isolated-vertex", IsolatedVertex, entry("vertices_coords", 4)),
        ("vertex-on-edge", VertexOnEdge, entry("edges_vertices", 0)),
        ("crossing-edges", EdgesCross, entry("edges_vertices", 4)),
        ("edge-of-no-length", EdgeWithoutLength, entry("edges_vertices", 5)),
        ("edge-twice-same-letter", EdgeTwice, entry("edges_vertices", 5)),
        ("edge-twice-other-letter", EdgeTwiceLetters, entry("edges_assignment", 5)),
        ("contour-open", BorderClosed, entry("edges_vertices", 2)),
        ("../cases/open_border", BorderJoined, entry("vertices_coords", 2)),
        ("../cases/gap_1e-05", NearMissJoined, entry("vertices_coords", 4)),
        ("../cases/tjunction", FacesRepaired, entry("faces_vertices", 0)),
        ("../cases/frame_around", CreaseInHole, entry("edges_vertices", 8)),
        ("../cases/radians", Radians, key("edges_foldAngle")),
        ("../cases/typo_assignments", UnknownKey, key("edges_assignments").in_frame(0)),
        ("../cases/folded_first_cp_second", OtherFrame, Place::Frame(0)),
        ("face-without-its-edge", UnlistedSide, entry("faces_vertices", 0)),
        ("no-faces", FacesBuilt, key("faces_vertices")),
        ("mixed-faces", FaceTurned, entry("faces_vertices", 1)),
        ("clockwise-faces", FaceClockwise, entry("faces_vertices", 0)),
        ("face-of-no-area", FaceWithoutArea, entry("faces_vertices", 0)),
        ("sliver", ThinFace, entry("faces_vertices", 1)),
        ("no-assignment", MissingLetters, key("edges_assignment")),
        ("no-angles", MissingAngles, key("edges_foldAngle")),
        ("lower-case", LowerCase, entry("edges_assignment", 0)),
        ("unknown-letter", UnknownLetter, entry("edges_assignment", 4)),
        ("mountain-on-contour", LetterOnContour, entry("edges_assignment", 0)),
        ("boundary-inside", BoundaryInside, entry("edges_assignment", 4)),
        ("slit", BoundaryCut, entry("edges_assignment", 6)),
        ("boundary-with-angle", AngleOnBoundary, entry("edges_foldAngle", 1)),
        ("angle-null", NullAngle, entry("edges_foldAngle", 4)),
        ("unknown-letter", AngleOnUnassigned, entry("edges_assignment", 4)),
        ("angle-too-large", AnglePastFlat, entry("edges_foldAngle", 4)),
        ("angle-of-opposite-sign", OppositeSigns, entry("edges_foldAngle", 4)),
    ];
    let mut warnings: Vec<(Vec<Warning>, WarningCode, Place)> = Vec::new();
    for (name, code, place) in of_files {
        warnings.push((CreasePattern::read(broken(name)).expect(name).warnings, code, place));
    }
    let frames = r#""frame_inherit": true, "file_frames": [{"frame_inherit": true}]"#;
    let inherits = square(&format!("{DIAGONAL}, {frames}")).expect("a square").warnings;
    warnings.push((inherits.clone(), KeyFrameInherits, key("frame_inherit").in_frame(0)));
    warnings.push((inherits, NoParent, key("frame_inherit").in_frame(1)));
    let faces = r#""faces_vertices": [[0, 1, 2], [0, 2, 3]], "edges_assignment": ["B", "B", "B", "B", "F"]"#;
    let angles = r#""edges_foldAngle": [null, null, null, null, 30]"#;
    let flat = square(&format!("{DIAGONAL}, {faces}, {angles}")).expect("a square").warnings;
    warnings.push((flat, AngleOnFlat, entry("edges_assignment", 4)));
    let tilted = r#"{"vertices_coords": [[0, 0, 0], [1, 0, 1], [1, 1, 1], [0, 1, 0]], "faces_vertices": [[0, 1, 2], [0, 2, 3]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]], "edges_assignment": ["B", "B", "B", "B", "V"]}"#;
    let tilted = Document::from_slice(tilted.as_bytes()).expect("a document");
    let tilted = CreasePattern::from_document(&tilted, 0).expect("a square in space").warnings;
    warnings.push((tilted, TiltedPlane, key("vertices_coords")));
    let outside = r#"{"vertices_coords": [[0, 0], [1, 0], [1, 1], [0, 1], [2, 2], [3, 3], [0.5, 0], [0.5, 0.97]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [6, 7]],
        "edges_assignment": ["B", "B", "B", "B", "F", "V"]}"#;
    let outside = Document::from_slice(outside.as_bytes()).expect("a document");
    let outside = CreasePattern::from_document(&outside, 0).expect("a square and a line").warnings;
    warnings.push((outside.clone(), EdgeOutside, entry("edges_vertices", 4)));
    warnings.push((outside.clone(), PaperLost, key("edges_vertices")));
    warnings.push((outside, NearMiss, entry("vertices_coords", 7)));
    let cut = r#"{"vertices_coords": [[0, 0], [3, 0], [3, 3], [0, 3], [1, 1], [2, 2]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [4, 5], [5, 2]],
        "edges_assignment": ["B", "B", "B", "B", "V", "C", "V"]}"#;
    let cut = Document::from_slice(cut.as_bytes()).expect("a document");
    let cut = CreasePattern::from_document(&cut, 0).expect("a square with a cut").warnings;
    warnings.push((cut, ClosedCut, entry("edges_assignment", 5)));

    let pattern = SingleCrease::default().pattern().expect("a crease");
    let crease = pattern.edges.iter().position(|edge| edge.fold_angle.is_some()).expect("a crease");
    let one = model(&pattern).expect("a model");
    let mut ends = pattern.edges[crease].vertices;
    let told = scene_warnings(&one, &[1000.0]);
    if let Some(Place::Creases(creases)) = told.first().map(|warning| &warning.place) {
        // In the direction of its first triangle.
        if creases[0].vertices != ends {
            ends.reverse();
        }
    }
    let place = Place::Creases(vec![CreasePlace::new(ends, Some(EdgeId::new(crease)))]);
    warnings.push((told, OverFolding, place));
    let mut thin = pattern.clone();
    let [near, far] = [pattern.faces[0][0], pattern.faces[0][1]].map(|v| pattern.vertices[v.index()]);
    thin.vertices[pattern.faces[0][0].index()] = far + 1e-3 * (near - far);
    let told = scene_warnings(&model(&thin).expect("a model"), &[]);
    let place = told[0].place.clone();
    assert!(matches!(&place, Place::Triangles(all) if all[0].contains(&pattern.faces[0][0])), "{place}");
    warnings.push((told, Slivers, place));
    let told: Vec<Warning> = single_precision(&one, 1e-12).into_iter().collect();
    let place = told[0].place.clone();
    assert!(matches!(&place, Place::Vertices(one) if one.len() == 1), "{place}");
    warnings.push((told, SinglePrecision, place));
    let slit = r#"{"vertices_coords": [[0, 0], [1, 0], [2, 0], [2, 1], [1, 1], [0, 1], [1, 0.5]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 6], [6, 4]],
        "edges_assignment": ["B", "B", "B", "B", "B", "B", "C", "V"]}"#;
    let slit = Document::from_slice(slit.as_bytes()).and_then(|document| CreasePattern::from_document(&document, 0));
    let told: Vec<Warning> = touching_lips(&model(&slit.expect("a slit")).expect("a model")).into_iter().collect();
    let place = told[0].place.clone();
    assert!(matches!(&place, Place::Vertices(both) if both.contains(&VertexId(1)) && both.len() == 2), "{place}");
    warnings.push((told, TouchingLips, place));
    assert_eq!(touching_lips(&one), None);
    let hypar = model(&Hypar::default().pattern().expect("a hypar")).expect("a model");
    let folded = Relax::default().fold_from_rest(&hypar, 100.0).expect("it folds");
    let told = strained_at_rest(&hypar, &folded).into_iter().collect();
    warnings.push((told, StrainedAtRest, Place::Sheet { percent: Some(100.0) }));
    let of_state = |pattern: &CreasePattern, percent: f64| {
        let model = model(pattern).expect("a model");
        folded_warnings(pattern, &model, &Relax::default().fold_from_rest(&model, percent).expect("it folds"))
    };
    let told = of_state(&CreasePattern::read(case("spur_valley")).expect("a pattern"), 100.0);
    let spur = CreasePlace::new([VertexId(0), VertexId(6)], Some(EdgeId(7)));
    warnings.push((told, OpenCrease, Place::Creases(vec![spur])));
    // As if something had kept it from its angle by 0.2.
    let mut folded = Relax::default().fold_from_rest(&one, 100.0).expect("it folds");
    folded.state.fold_angles[0] -= 0.2;
    let mut ends = pattern.edges[crease].vertices;
    ends.sort_unstable();
    let place = Place::Creases(vec![CreasePlace::new(ends, Some(EdgeId::new(crease)))]);
    warnings.push((folded_warnings(&pattern, &one, &folded), CreaseOffTarget, place));
    let vertex5 = CreasePattern::read(case("vertex5_cannot_close")).expect("a pattern");
    let triangle = Place::Triangles(vec![[VertexId(0), VertexId(1), VertexId(5)]]);
    let paper = Model::new(&vertex5, &Material::paper()).expect("a model");
    let folded = Relax::default().fold_from_rest(&paper, 90.0).expect("it folds");
    warnings.push((folded_warnings(&vertex5, &paper, &folded), CrushedTriangle, triangle.clone()));
    warnings.push((of_state(&vertex5, 90.0), SqueezedTriangle, triangle));

    for (told, code, place) in &warnings {
        let found = told.iter().any(|warning| (warning.code, &warning.place) == (*code, place));
        assert!(found, "no {code} at {place} in {told:#?}");
        // Near misses are named one by one.
        let once = told.iter().filter(|warning| !matches!(warning.code, NearMissJoined | BorderJoined | BorderClosed));
        let once: Vec<&str> = once.map(|warning| warning.code.name()).collect();
        let codes: BTreeSet<&str> = once.iter().copied().collect();
        assert_eq!(codes.len(), once.len(), "each kind once: {told:#?}");
    }
    let met: BTreeSet<&str> = warnings.iter().map(|(_, code, _)| code.name()).collect();
    let unmet: Vec<&str> = WarningCode::ALL.iter().map(|code| code.name()).filter(|name| !met.contains(name)).collect();
    let of_formats = ["left-out", "other-format", "odd-number", "colour"];
    assert_eq!(unmet, [&of_formats[..], &["fallback"]].concat(), "programs fall back, libraries do not");
}

#[test]
fn an_editor_can_jump_to_an_element_and_mute_a_kind() {
    let pattern = CreasePattern::read(broken("angle-of-opposite-sign")).expect("a pattern");
    let edges: Vec<EdgeId> = pattern.warnings.iter().filter_map(|warning| warning.place.edge()).collect();
    assert_eq!(edges, [EdgeId(4)]);
    let faces = refusal("face-out-of-range").place().face();
    assert_eq!(faces, Some(FaceId(1)));
    let mut left = CreasePattern::read(broken("edge-of-no-length")).expect("a pattern").warnings;
    let before = left.len();
    left.retain(|warning| warning.code != WarningCode::FacesBuilt);
    assert_eq!(left.len(), before - 1);
}
