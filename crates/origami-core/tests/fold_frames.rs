//! What frames inherit.

use origami_core::fold::Document;

fn read(text: &str) -> Document {
    Document::from_slice(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

const FAMILY: &str = r#"{
    "file_creator": "someone", "frame_title": "flat", "x:y": [1],
    "vertices_coords": [[0,0],[1,0],[0,1]], "edges_vertices": [[0,1]], "edges_assignment": ["B"],
    "edges_foldAngle": [0], "faces_vertices": [[0,1,2]], "frame_classes": ["creasePattern"],
    "file_frames": [
        {"frame_parent": 0, "frame_inherit": true, "vertices_coords": [[0,0,1],[1,0,0],[0,1,0]], "frame_title": "up"},
        {"frame_parent": 1, "frame_inherit": true, "edges_foldAngle": [5], "file_creator": "nobody"},
        {"frame_parent": 0, "edges_vertices": [[1,2]]},
        {"frame_inherit": true, "x:z": 2}
    ]
}"#;

#[test]
fn what_is_not_overridden_is_inherited_from_all_ancestors() {
    let document = read(FAMILY);
    let grandchild = document.frame(2).expect("frame 2");
    assert_eq!(grandchild.vertices_coords, document.frames[0].vertices_coords);
    assert_eq!(grandchild.edges_fold_angle, Some(vec![Some(5.0)]));
    assert_eq!(grandchild.edges_vertices, document.key_frame.edges_vertices);
    assert_eq!(grandchild.edges_assignment, document.key_frame.edges_assignment);
    assert_eq!(grandchild.faces_vertices, document.key_frame.faces_vertices);
    assert_eq!(grandchild.classes, document.key_frame.classes);
    assert_eq!(grandchild.extra["frame_title"], "up");
    assert_eq!(grandchild.extra["x:y"], document.key_frame.extra["x:y"]);
    assert!(!grandchild.extra.contains_key("file_creator"));
    assert_eq!((grandchild.parent, grandchild.inherit), (None, false));
}

#[test]
fn a_parent_alone_is_no_inheritance() {
    let orphan = read(FAMILY).frame(3).expect("frame 3");
    assert_eq!(orphan.vertices_coords, None);
    assert_eq!(orphan.edges_vertices, Some(vec![[1, 2]]));
}

#[test]
fn inheritance_without_a_parent_is_from_the_key_frame_and_warned_of() {
    let document = read(FAMILY);
    assert_eq!(document.frame(4).expect("frame 4").vertices_coords, document.key_frame.vertices_coords);
    let places: Vec<_> = document.warnings.iter().map(|warning| warning.place.to_string()).collect();
    assert_eq!(places, ["file_frames[3].frame_inherit"]);
}

#[test]
fn frames_resolve_to_themselves_after_that() {
    let mut document = read(FAMILY);
    document.key_frame = document.frame(2).expect("frame 2");
    assert_eq!(document.frame(0).expect("frame 0"), document.key_frame);
}

#[test]
fn circles_and_missing_frames_are_refused_by_name() {
    let document = read(
        r#"{"frame_parent": 1, "frame_inherit": true, "file_frames": [
            {"frame_parent": 2, "frame_inherit": true},
            {"frame_parent": 1, "frame_inherit": true},
            {"frame_parent": 3, "frame_inherit": true},
            {"frame_parent": 9, "frame_inherit": true},
            {"frame_parent": 4, "frame_inherit": true}]}"#,
    );
    for (index, start) in [
        (1, "file_frames[0].frame_parent: the frame inherits from itself"),
        (2, "file_frames[1].frame_parent: the frame inherits from itself"),
        (3, "file_frames[2].frame_parent: the frame inherits from itself"),
        (4, "file_frames[3].frame_parent: there is no frame 9; expected a frame from 0 to 5"),
        (5, "file_frames[3].frame_parent: there is no frame 9"),
        (6, "frame 6: there is no such frame; expected a frame from 0 to 5"),
        (usize::MAX, "frame "),
    ] {
        let message = document.frame(index).expect_err("not a frame").to_string();
        assert!(message.starts_with(start), "frame {index}: {message}");
    }
    assert!(document.frame(0).is_ok(), "the key frame never inherits");
    assert!(document.pattern_frame().is_err());
}

#[test]
fn the_longest_chain_is_no_circle() {
    let count = 50;
    let frames: Vec<_> = (0..count).map(|i| format!(r#"{{"frame_parent": {i}, "frame_inherit": true}}"#)).collect();
    let text = format!(r#"{{"vertices_coords": [[7,8]], "file_frames": [{}]}}"#, frames.join(","));
    let document = read(&text);
    assert_eq!(document.frame(count).expect("the last").vertices_coords, document.key_frame.vertices_coords);
}

#[test]
fn the_frame_to_fold_is_the_first_with_coordinates() {
    for (text, expected) in [
        (FAMILY, Some(0)),
        (r#"{"file_frames": [{}, {"vertices_coords": [[0,0]]}]}"#, Some(2)),
        (
            r#"{"file_frames": [{"frame_parent": 3, "frame_inherit": true}, {"vertices_coords": [[0,0]]},
                {"frame_parent": 2, "frame_inherit": true}]}"#,
            Some(1),
        ),
        (
            r#"{"file_frames": [{"frame_parent": 1, "frame_inherit": true}, {"frame_parent": 8, "frame_inherit": true},
                {"vertices_coords": []}]}"#,
            Some(3),
        ),
        (r#"{"file_frames": [{"frame_parent": 1}]}"#, None),
        ("{}", None),
    ] {
        let found = read(text).pattern_frame();
        match expected {
            Some(index) => assert_eq!(found.expect(text), index, "{text}"),
            None => assert!(found.expect_err(text).to_string().starts_with("vertices_coords: "), "{text}"),
        }
    }
}
