//! Folded sheets as FOLD documents.

use std::f64::consts::PI;

use glam::DVec3;
use origami_core::CreasePattern;
use origami_core::export::{Pose, animation, crease_pattern_document, folded_form};
use origami_core::fold::Document;
use origami_core::ids::{EdgeId, VertexId};
use origami_core::pattern::{Assignment, PatternEdge};
use serde_json::json;

/// A square with a mountain on its diagonal, and a copy of that with another letter.
const SOURCE: &str = r#"{
    "file_spec": 1.1, "file_creator": "someone", "file_author": "a person", "file_classes": ["multiModel", "x:y"],
    "frame_title": "square", "frame_classes": ["creasePattern"], "frame_attributes": ["2D", "orientable"],
    "vertices_coords": [[0,0],[2,0],[2,1],[0,1]],
    "edges_vertices": [[0,1],[1,2],[2,3],[3,0],[0,2],[2,0]],
    "edges_assignment": ["B","B","B","B","m","V"],
    "edges_foldAngle": [0,0,0,0,-60,60],
    "faces_vertices": [[0,1,2],[0,2,3]],
    "vertices_vertices": [[1,2,3],[0,2],[0,1,3],[0,2]],
    "faces_edges": [[0,1,4],[4,2,3]],
    "faceOrders": [],
    "edges_origami:ea": [null,null,null,null,5,5],
    "edges_a:b": [0,1,2,3,4,5],
    "file_frames": [{"frame_parent": 0, "frame_inherit": true, "frame_title": "other"}]
}"#;

fn edge(ends: [u32; 2], assignment: Assignment, degrees: Option<f64>) -> PatternEdge {
    PatternEdge {
        vertices: ends.map(VertexId),
        assignment,
        fold_angle: degrees.map(f64::to_radians),
        k_crease: None,
        ea: None,
        alias_of: None,
    }
}

fn square() -> CreasePattern {
    let mut edges: Vec<_> =
        [[0, 1], [1, 2], [2, 3], [3, 0]].map(|ends| edge(ends, Assignment::Boundary, None)).to_vec();
    edges.push(PatternEdge { ea: Some(5.0), ..edge([0, 2], Assignment::Mountain, Some(-60.0)) });
    edges.push(PatternEdge { alias_of: Some(EdgeId(4)), ..edge([2, 0], Assignment::Valley, Some(60.0)) });
    CreasePattern {
        vertices: [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec(),
        alias_of: vec![None; 4],
        edges,
        faces: vec![[0, 1, 2].map(VertexId).to_vec(), [0, 2, 3].map(VertexId).to_vec()],
        vertices_in_file: 4,
        edges_in_file: 6,
        ..CreasePattern::default()
    }
}

fn pose(pattern: &CreasePattern, percent: f64, degrees: f64) -> Pose {
    Pose {
        step: None,
        percent: Some(percent),
        positions: pattern.vertices.iter().map(|p| DVec3::new(p.x, p.y, p.x * percent / 100.0)).collect(),
        fold_angles: pattern.edges.iter().map(|edge| edge.fold_angle.map(|_| degrees.to_radians())).collect(),
    }
}

fn source() -> Document {
    Document::from_slice(SOURCE.as_bytes()).expect("FOLD")
}

/// As a program that opens the file sees it.
fn reread(document: &Document) -> Document {
    let again = Document::from_slice(document.to_string().expect("written").as_bytes()).expect("FOLD");
    assert_eq!(&again, document);
    again
}

#[test]
fn the_folded_form_keeps_what_the_source_says() {
    let pattern = square();
    let document = reread(&folded_form(&source(), 0, &pattern, &pose(&pattern, 50.0, -29.5)).expect("a document"));
    assert_eq!(document.spec, Some(json!(1.2)));
    assert_eq!(document.metadata["file_creator"], concat!("origami ", env!("CARGO_PKG_VERSION")));
    assert_eq!(document.metadata["file_author"], "a person");
    assert_eq!(document.classes, ["x:y"]);
    assert!(document.frames.is_empty());

    let frame = document.key_frame;
    assert_eq!(frame.classes, Some(vec!["foldedForm".to_owned()]));
    assert_eq!(frame.extra["frame_attributes"], json!(["orientable", "3D"]));
    assert_eq!(frame.extra["frame_title"], "square");
    assert_eq!(frame.extra["origami:percent"], json!(50));
    assert_eq!(frame.extra["edges_a:b"], json!([0, 1, 2, 3, 4, 5]));
    assert_eq!(frame.extra["edges_origami:ea"], json!([null, null, null, null, 5, 5]));
    let points = frame.vertices_coords.expect("coordinates");
    assert!(points.iter().all(|point| point.dimension == 3));
    assert_eq!(points[1].position, DVec3::new(2.0, 0.0, 1.0));
    assert_eq!(frame.edges_vertices, source().key_frame.edges_vertices);
    assert_eq!(frame.faces_vertices, source().key_frame.faces_vertices);
    assert_eq!(frame.edges_assignment.expect("letters"), ["B", "B", "B", "B", "M", "M"]);
    let angles = [0.0, 0.0, 0.0, 0.0, -29.5, -29.5].map(Some);
    assert_eq!(frame.edges_fold_angle.expect("angles"), angles);
    assert!(!frame.extra.contains_key("edges_origami:foldAngle"));
    for key in ["vertices_vertices", "faces_edges", "faceOrders"] {
        assert_eq!(frame.extra[key], source().key_frame.extra[key], "{key}");
    }
}

#[test]
fn arrays_that_no_longer_hold_are_dropped() {
    let mut pattern = square();
    pattern.faces[0].reverse();
    let document = folded_form(&source(), 0, &pattern, &pose(&pattern, 50.0, 0.0)).expect("a document");
    let keys = |document: &Document| {
        let has = |key: &&str| document.key_frame.extra.contains_key(*key);
        ["vertices_vertices", "faces_edges", "faceOrders", "edges_a:b"].into_iter().filter(has).collect::<Vec<_>>()
    };
    assert_eq!(keys(&document), ["vertices_vertices", "edges_a:b"], "faces turned round");

    pattern.vertices.push(DVec3::X);
    pattern.alias_of.push(None);
    pattern.fixed = vec![VertexId(4)];
    let document = folded_form(&source(), 0, &pattern, &pose(&pattern, 50.0, 0.0)).expect("a document");
    assert_eq!(keys(&document), ["edges_a:b"], "a vertex added");
    assert_eq!(document.key_frame.extra["vertices_origami:fixed"], json!([false, false, false, false, true]));
}

/// Two lines that cross: four pieces, each with the place of the line that it is a piece of.
#[test]
fn pieces_of_a_line_keep_where_it_was_written() {
    let text = r#"{"vertices_coords": [[0,0],[4,0],[4,4],[0,4]], "edges_vertices": [[0,1],[1,2],[2,3],[3,0],[0,2],[1,3]],
        "edges_assignment": ["B","B","B","B","M","V"],
        "edges_origami:source": ["line 1","line 2","line 3","line 4","line 15","line 16"]}"#;
    let source = Document::from_slice(text.as_bytes()).expect("FOLD");
    let pattern = CreasePattern::from_document(&source, 0).expect("a pattern");
    let frame = reread(&folded_form(&source, 0, &pattern, &pose(&pattern, 50.0, 0.0)).expect("a document")).key_frame;
    let sources = frame.extra["edges_origami:source"].as_array().expect("a list");
    let letters = frame.edges_assignment.expect("letters");
    assert_eq!((sources.len(), letters.len()), (8, 8));
    for (letter, line) in [("M", "line 15"), ("V", "line 16")] {
        let of_letter = letters.iter().zip(sources).filter(|(own, _)| *own == letter);
        assert_eq!(of_letter.map(|(_, source)| source).collect::<Vec<_>>(), [line, line]);
    }
}

#[test]
fn merged_vertices_are_where_their_stand_in_is() {
    let mut pattern = square();
    pattern.vertices.push(pattern.vertices[2]);
    pattern.alias_of.push(Some(VertexId(2)));
    let mut pose = pose(&pattern, 10.0, 0.0);
    pose.positions[4] = DVec3::splat(9.0);
    let document = folded_form(&source(), 0, &pattern, &pose).expect("a document");
    let points = document.key_frame.vertices_coords.expect("coordinates");
    assert_eq!(points[4], points[2]);
}

#[test]
fn angles_beyond_180_degrees_are_kept_apart() {
    let pattern = square();
    let document = folded_form(&source(), 0, &pattern, &pose(&pattern, 100.0, -190.0)).expect("a document");
    assert_eq!(document.key_frame.edges_fold_angle.expect("angles")[4], Some(-180.0));
    assert_eq!(document.key_frame.extra["edges_origami:foldAngle"], json!([0, 0, 0, 0, -190, -190]));

    // Exactly 180 degrees are not beyond.
    let mut flat = pose(&pattern, 100.0, 0.0);
    flat.fold_angles[4] = Some(-PI);
    let document = folded_form(&source(), 0, &pattern, &flat).expect("a document");
    assert!(!document.key_frame.extra.contains_key("edges_origami:foldAngle"));
    assert_eq!(document.key_frame.edges_fold_angle.expect("angles")[4], Some(-180.0));
}

#[test]
fn another_frame_becomes_the_key_frame() {
    let pattern = square();
    let document = folded_form(&source(), 1, &pattern, &pose(&pattern, 0.0, 0.0)).expect("a document");
    assert_eq!(document.key_frame.extra["frame_title"], "other");
    assert_eq!((document.key_frame.parent, document.key_frame.inherit), (None, false));
    assert!(folded_form(&source(), 2, &pattern, &pose(&pattern, 0.0, 0.0)).is_err());
}

#[test]
fn an_animation_inherits_from_the_crease_pattern() {
    let pattern = square();
    let poses = [pose(&pattern, 25.0, -15.0), pose(&pattern, 62.5, -200.0)];
    let document = reread(&animation(&source(), 0, &pattern, &poses).expect("a document"));
    assert_eq!(document.classes, ["x:y", "animation"]);
    assert_eq!(document.frame_count(), 3);
    let rest = &document.key_frame;
    assert_eq!(rest.classes, Some(vec!["creasePattern".to_owned()]));
    assert_eq!(rest.vertices_coords, source().key_frame.vertices_coords);
    assert_eq!(rest.edges_fold_angle, Some([0.0, 0.0, 0.0, 0.0, -60.0, -60.0].map(Some).to_vec()));
    assert_eq!(rest.extra["frame_attributes"], json!(["2D", "orientable"]));

    for (index, pose) in (1..).zip(&poses) {
        let written = &document.frames[index - 1];
        assert_eq!((written.parent, written.inherit), (Some(0), true));
        assert_eq!((&written.edges_vertices, &written.faces_vertices), (&None, &None));
        // A frame of the animation says the same as the single folded form.
        let frame = document.frame(index).expect("a frame");
        let alone = folded_form(&source(), 0, &pattern, pose).expect("a document").key_frame;
        assert_eq!(frame.vertices_coords, alone.vertices_coords);
        assert_eq!(frame.edges_fold_angle, alone.edges_fold_angle);
        assert_eq!(frame.edges_assignment, alone.edges_assignment);
        assert_eq!(frame.classes, alone.classes);
        for key in ["frame_attributes", "origami:percent", "edges_origami:foldAngle", "faces_edges"] {
            assert_eq!(frame.extra.get(key), alone.extra.get(key), "{key} of frame {index}");
        }
    }
    let titles: Vec<_> = document.frames.iter().map(|frame| &frame.extra["frame_title"]).collect();
    assert_eq!(titles, ["25 %", "62.5 %"]);
}

#[test]
fn a_pose_without_a_percentage_claims_none() {
    let pattern = square();
    let mut source = source();
    source.key_frame.extra.insert("origami:percent".into(), json!(30));
    let unknown = Pose { percent: None, ..pose(&pattern, 50.0, -15.0) };
    let alone = folded_form(&source, 0, &pattern, &unknown).expect("a document");
    assert_eq!(alone.key_frame.extra.get("origami:percent"), None);
    let poses = [pose(&pattern, 50.0, -15.0), unknown];
    let document = reread(&animation(&source, 0, &pattern, &poses).expect("a document"));
    let told = [1, 2].map(|i| document.frame(i).expect("a frame").extra["origami:percent"].clone());
    assert_eq!(told, [json!(50), json!(null)], "what the source says is not inherited");
    assert_eq!(document.frames[1].extra["frame_title"], "pose 2");
}

#[test]
fn a_frame_does_not_inherit_targets_beyond_180_as_angles_reached() {
    let mut pattern = square();
    pattern.edges[4].fold_angle = Some(270f64.to_radians());
    let document = animation(&source(), 0, &pattern, &[pose(&pattern, 50.0, 90.0)]).expect("a document");
    assert_eq!(document.key_frame.extra["edges_origami:foldAngle"][4], json!(270));
    assert_eq!(document.frame(1).expect("a frame").extra["edges_origami:foldAngle"][4], json!(90));
}

#[test]
fn poses_must_fit_the_pattern() {
    let pattern = square();
    let mut short = pose(&pattern, 50.0, 0.0);
    short.positions.pop();
    let error = folded_form(&source(), 0, &pattern, &short).expect_err("too short").to_string();
    assert!(error.starts_with("pose at 50 %: 3 positions for 4 vertices"), "{error}");
    let mut short = pose(&pattern, 50.0, 0.0);
    short.fold_angles.pop();
    assert!(animation(&source(), 0, &pattern, &[short]).is_err());
}

#[test]
fn a_pattern_without_a_source() {
    let mut pattern = square();
    pattern.edges[4].k_crease = Some(0.5);
    pattern.edges.push(edge([1, 3], Assignment::Unassigned, None));
    pattern.edges.push(edge([1, 3], Assignment::Join, Some(0.0)));
    pattern.edges.push(edge([1, 3], Assignment::Flat, Some(0.0)));
    let document = reread(&crease_pattern_document(&pattern, "my square"));
    let frame = &document.key_frame;
    assert_eq!(document.classes, ["singleModel"]);
    assert_eq!(frame.extra["frame_title"], "my square");
    assert_eq!(frame.extra["frame_attributes"], json!(["2D"]));
    assert_eq!(frame.vertices_coords, source().key_frame.vertices_coords);
    assert_eq!(frame.edges_assignment.as_ref().expect("letters")[4..], ["M", "M", "U", "J", "F"]);
    assert_eq!(
        frame.edges_fold_angle.as_ref().expect("angles")[4..],
        [Some(-60.0), Some(-60.0), None, Some(0.0), Some(0.0)]
    );
    assert_eq!(frame.extra["edges_origami:k_crease"], json!([null, null, null, null, 0.5, 0.5, null, null, null]));

    pattern.vertices[3].z = 1.0;
    let frame = crease_pattern_document(&pattern, "").key_frame;
    assert_eq!(frame.extra["frame_attributes"], json!(["3D"]));
    assert!(frame.vertices_coords.expect("coordinates").iter().all(|point| point.dimension == 3));
}

#[test]
fn angles_survive_the_way_to_radians_and_back() {
    let pattern = square();
    for tenths in -1800..=1800 {
        let degrees = f64::from(tenths) / 10.0;
        let document = folded_form(&source(), 0, &pattern, &pose(&pattern, 50.0, degrees)).expect("a document");
        assert_eq!(document.key_frame.edges_fold_angle.expect("angles")[4], Some(degrees));
    }
}
