//! What the FOLD reader accepts, and where it says that a file is wrong.

use origami_core::Error;
use origami_core::fold::Document;

fn read(text: &str) -> Document {
    Document::from_slice(text.as_bytes()).unwrap_or_else(|error| panic!("{error}"))
}

/// The message for a file that must be refused.
fn refusal(bytes: &[u8]) -> String {
    match Document::from_slice(bytes) {
        Err(error @ Error::Syntax { .. }) => error.to_string(),
        other => panic!("{:?} gave {other:?}", String::from_utf8_lossy(bytes)),
    }
}

#[test]
fn errors_name_the_place_and_what_was_expected() {
    let two31 = "4294967296";
    for (text, place, expected) in [
        (r#"{"edges_vertices": [[0,1],[1,2],[2,3],["x",0]]}"#.to_owned(), "edges_vertices[3][0]", "an index"),
        (r#"{"edges_vertices": [[0,1],[1,-2]]}"#.into(), "edges_vertices[1][1]", "an index"),
        (r#"{"edges_vertices": [[0,1.5]]}"#.into(), "edges_vertices[0][1]", "an index"),
        (format!(r#"{{"edges_vertices": [[{two31},0]]}}"#), "edges_vertices[0][0]", "an index"),
        (r#"{"edges_vertices": [[0]]}"#.into(), "edges_vertices[0]", "two vertex indices"),
        (r#"{"edges_vertices": [[0,1,2]]}"#.into(), "edges_vertices[0]", "two vertex indices"),
        (r#"{"edges_vertices": 7}"#.into(), "edges_vertices", "an array of pairs of vertex indices"),
        (r#"{"edges_assignment": ["M", 3]}"#.into(), "edges_assignment[1]", "a string"),
        (r#"{"edges_assignment": "MV"}"#.into(), "edges_assignment", "an array of letters"),
        (r#"{"edges_foldAngle": [0, null, "90"]}"#.into(), "edges_foldAngle[2]", "a number"),
        (r#"{"edges_foldAngle": [1e999]}"#.into(), "edges_foldAngle[0]", "finite"),
        (r#"{"edges_foldAngles": [true]}"#.into(), "edges_foldAngles[0]", "a number"),
        (r#"{"faces_vertices": [[0,1,2],[0,null,2]]}"#.into(), "faces_vertices[1][1]", "an index"),
        (r#"{"vertices_coords": [[0,0],[1]]}"#.into(), "vertices_coords[1]", "two or three coordinates"),
        (r#"{"vertices_coords": [[]]}"#.into(), "vertices_coords[0]", "two or three coordinates"),
        (r#"{"vertices_coords": [[0,0,0,0.5]]}"#.into(), "vertices_coords[0]", "at most x, y and z"),
        (r#"{"vertices_coords": [[0,0],null]}"#.into(), "vertices_coords[1]", "two or three coordinates"),
        (r#"{"vertices_coords": [[0,null]]}"#.into(), "vertices_coords[0][1]", "a number"),
        (r#"{"vertices_coords": [[0,NaN]]}"#.into(), "vertices_coords[0][1]", "expected value"),
        (r#"{"vertices_coords": [[0,-Infinity]]}"#.into(), "vertices_coords[0][1]", "invalid number"),
        (r#"{"vertices_coords": {"0": [0,0]}}"#.into(), "vertices_coords", "an array of coordinates"),
        (r#"{"file_frames": [{}, {"frame_parent": "0"}]}"#.into(), "file_frames[1].frame_parent", "an index"),
        (r#"{"file_frames": [{}, 3]}"#.into(), "file_frames[1]", "a frame"),
        (r#"{"file_frames": [null]}"#.into(), "file_frames[0]", "a frame"),
        (r#"{"frame_inherit": 1}"#.into(), "frame_inherit", "a boolean"),
        (r#"{"file_classes": "animation"}"#.into(), "file_classes", "an array of strings"),
        (r#"{"frame_title": "a", "frame_title": "b"}"#.into(), "frame_title", "expected once"),
        (r#"{"edges_vertices": [], "edges_vertices": []}"#.into(), "edges_vertices", "expected once"),
        (r#"{"edges_vertices": null, "edges_vertices": []}"#.into(), "edges_vertices", "expected once"),
        (r#"{"file_x": {"a": [{"b": 1, "b": 2}]}}"#.into(), "file_x.a[0].b", "expected once"),
        (r#"{"file_frames": [{"x:y": 1, "x:y": 1}]}"#.into(), "file_frames[0].x:y", "expected once"),
        ("[1, 2]".into(), "line 1", "one JSON object"),
        ("3".into(), "line 1", "one JSON object"),
        ("null".into(), "line 1", "one JSON object"),
        ("{\n\"file_spec\": 1\n}\n}".into(), "line 4 column 1", "not JSON"),
        ("{\n\"file_spec\": 1,\n}".into(), "line 3 column 1", "not JSON"),
        (r#"{"vertices_coords": [[0,"#.into(), "vertices_coords[0]", "not JSON"),
        ("".into(), "line 1", "one JSON object"),
        (" \n ".into(), "line 1", "one JSON object"),
        ("<svg/>".into(), "line 1", "not JSON"),
    ] {
        let message = refusal(text.as_bytes());
        assert!(message.starts_with(place), "{text}\nplace {place} not in: {message}");
        let rest = &message[place.len()..];
        assert!(rest.starts_with(':') || place.starts_with("line"), "{text}\nplace {place} is not all of: {message}");
        assert!(message.contains(expected), "{text}\n{expected:?} not in: {message}");
    }
}

#[test]
fn depth_encoding_and_size_do_not_panic() {
    let deep = format!("{{\"a\": {}1{}}}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(refusal(deep.as_bytes()).contains("nested too deeply"));
    let deep = format!("{}1{}", "{\"a\":".repeat(100_000), "}".repeat(100_000));
    assert!(refusal(deep.as_bytes()).contains("nested too deeply"));
    assert!(refusal(b"{\n\"frame_title\": \"\xff\"}").starts_with("line 2 column 17: not UTF-8"));
    assert!(refusal(b"\xff\xfe{\0}\0").contains("not UTF-8"));
    assert!(refusal(br#"{"frame_title": "\ud800"}"#).starts_with("frame_title: not JSON"));
}

#[test]
fn messages_are_fit_for_a_terminal() {
    let message = refusal(format!(r#"{{"edges_vertices": "{}"}}"#, "long ".repeat(100_000)).as_bytes());
    assert!(message.starts_with("edges_vertices: invalid type: string \"long long"), "{message}");
    assert!(message.contains("expected an array of pairs") && message.len() < 400, "{message}");
    let message = refusal(br#"{"a\u001b[31m": {"b": 1, "b": 2}}"#);
    assert!(message.starts_with("a\u{fffd}[31m.b: "), "{message:?}");
}

#[test]
fn a_byte_order_mark_is_skipped() {
    let document = read("\u{feff}{\"frame_title\": \"é\"}");
    assert_eq!(document.key_frame.extra["frame_title"], "é");
    assert!(refusal("\u{feff}".as_bytes()).contains("empty"));
}

#[test]
fn null_is_absent_where_a_key_is_optional() {
    let document = read(
        r#"{"file_spec": null, "file_classes": null, "file_frames": null, "frame_parent": null, "frame_inherit": null,
        "frame_classes": null, "vertices_coords": null, "edges_vertices": null, "edges_assignment": null,
        "edges_foldAngle": null, "edges_foldAngles": null, "faces_vertices": null}"#,
    );
    assert_eq!(document, Document::default());
}

#[test]
fn coordinates_keep_their_dimension() {
    let frame = read(r#"{"vertices_coords": [[1,2],[1,2,3],[1.5,2,3,0,0.0]]}"#).key_frame;
    let points = frame.vertices_coords.expect("coordinates");
    let read: Vec<_> = points.iter().map(|point| (point.position.to_array(), point.dimension)).collect();
    assert_eq!(read, [([1.0, 2.0, 0.0], 2), ([1.0, 2.0, 3.0], 3), ([1.5, 2.0, 3.0], 3)]);
}

#[test]
fn whole_numbers_are_indices_however_they_are_written() {
    let frame = read(r#"{"edges_vertices": [[0.0, 3e0]], "faces_vertices": [[-0, 4294967295]]}"#).key_frame;
    assert_eq!(frame.edges_vertices, Some(vec![[0, 3]]));
    assert_eq!(frame.faces_vertices, Some(vec![vec![0, u32::MAX]]));
}

#[test]
fn letters_are_kept_as_written() {
    let letters = read(r#"{"edges_assignment": ["m", "M", "", "mountain"]}"#).key_frame.edges_assignment;
    assert_eq!(letters, Some(["m", "M", "", "mountain"].map(Into::into).to_vec()));
}

#[test]
fn fold_1_0_wrote_fold_angles() {
    let old = read(r#"{"file_frames": [{"edges_foldAngles": [90, null]}]}"#);
    assert_eq!(old.frames[0].edges_fold_angle, Some(vec![Some(90.0), None]));
    assert_eq!(old.warnings.len(), 1);
    assert_eq!(old.warnings[0].place.to_string(), "file_frames[0].edges_foldAngles");

    for both in
        [r#"{"edges_foldAngle": [1], "edges_foldAngles": [2]}"#, r#"{"edges_foldAngles": [2], "edges_foldAngle": [1]}"#]
    {
        let document = read(both);
        assert_eq!(document.key_frame.edges_fold_angle, Some(vec![Some(1.0)]));
        assert!(document.warnings[0].message.contains("ignored"), "{:?}", document.warnings);
    }
    assert_eq!(read(r#"{"edges_foldAngle": [1]}"#).warnings, []);
}

#[test]
fn files_and_streams_are_read_alike() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("one.fold");
    let text = r#"{"vertices_coords": [[0,1]]}"#;
    std::fs::write(&path, text).expect("written");
    assert_eq!(Document::read(&path).expect("read"), read(text));
    assert_eq!(Document::from_reader(text.as_bytes()).expect("read"), read(text));
    let error = Document::read(folder.path().join("none.fold")).expect_err("there is no such file");
    assert!(error.to_string().contains("none.fold"), "{error}");
    assert!(matches!(Document::read(folder.path()), Err(Error::Io { .. })));
}
