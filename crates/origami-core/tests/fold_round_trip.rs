//! What is written reads back as it was, and no bytes make the reader panic.

use std::borrow::Cow;

use glam::DVec3;
use origami_core::fold::{Coordinates, Document, Frame};
use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use serde_json::{Map, Value, json};

fn read(text: &str) -> Document {
    Document::from_slice(text.as_bytes()).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

const EXAMPLE: &str = r#"{
"file_spec": 1.2,
"file_creator": "a person",
"file_classes": ["singleModel"],
"file_z:y": {"b":1,"a":[1.0,2,-3,1e+300,0.1,"ä\n\"",null,true]},
"frame_title": "square",
"frame_attributes": ["2D"],
"frame_classes": ["creasePattern"],
"vertices_coords": [[0,0],[1,0],[0.1,-1.5e-9],[0,1,2]],
"edges_vertices": [[0,1],[1,2],[2,3],[3,0],[0,2]],
"edges_assignment": ["B","b","B","B","M"],
"edges_foldAngle": [0,0,null,0,-179.5],
"faces_vertices": [[0,1,2],[0,2,3]],
"zebra:1": 18446744073709551615,
"apple:2": -5.0,
"edges_mango:3": [],
"file_frames": [
  {
  "frame_title": "folded",
  "frame_parent": 0,
  "frame_inherit": true,
  "vertices_coords": [[0,0,0],[1,0,0],[1,1,0],[0,1,0.30000000000000004]],
  "note:x": {}
  },
  {
  }
]
}
"#;

#[test]
fn a_file_in_the_writers_own_style_comes_back_to_the_byte() {
    assert_eq!(read(EXAMPLE).to_string().expect("written"), EXAMPLE);
}

#[test]
fn unknown_keys_keep_their_order_and_their_values() {
    let document = read(EXAMPLE);
    let again = read(&document.to_string().expect("written"));
    assert_eq!(again, document);
    let keys = |map: &Map<String, Value>| map.keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&again.key_frame.extra), keys(&document.key_frame.extra));
    assert_eq!(again.metadata["file_z:y"].to_string(), document.metadata["file_z:y"].to_string());
    assert!(again.key_frame.extra["zebra:1"].is_u64() && again.key_frame.extra["apple:2"].is_f64());
}

#[test]
fn one_line_a_key() {
    let text = read(EXAMPLE).to_string().expect("written");
    let starts: Vec<_> = text.lines().filter_map(|line| line.split('"').nth(1)).collect();
    assert_eq!(starts[..4], ["file_spec", "file_creator", "file_classes", "file_z:y"]);
    assert_eq!(text.lines().filter(|line| line.contains("edges_vertices")).count(), 1);
    assert!(text.contains(r#""vertices_coords": [[0,0],[1,0],[0.1,-1.5e-9],[0,1,2]],"#), "{text}");
}

#[test]
fn what_json_cannot_hold_is_refused_by_name() {
    let mut document = read(EXAMPLE);
    document.frames[0].edges_fold_angle = Some(vec![Some(1.0), None, Some(f64::NAN)]);
    let message = document.to_string().expect_err("NaN").to_string();
    assert!(message.starts_with("file_frames[0].edges_foldAngle[2]: "), "{message}");
    document.key_frame.vertices_coords = Some(vec![Coordinates::planar(DVec3::new(0.0, f64::INFINITY, 0.0))]);
    let message = document.to_string().expect_err("infinite").to_string();
    assert!(message.starts_with("vertices_coords[0]: "), "{message}");
}

#[test]
fn a_key_that_has_a_field_is_written_once() {
    let mut document = read(r#"{"file_spec": 1.2, "vertices_coords": [[0,0]]}"#);
    let expected = document.clone();
    for key in ["vertices_coords", "edges_foldAngles", "file_spec", "file_author"] {
        document.key_frame.extra.insert(key.into(), json!(3));
    }
    for key in ["file_spec", "file_frames", "file_classes", "vertices_coords"] {
        document.metadata.insert(key.into(), json!(3));
    }
    assert_eq!(read(&document.to_string().expect("written")), expected);
}

#[test]
fn a_flat_point_off_the_plane_is_not_flattened() {
    let point = Coordinates { position: DVec3::new(1.0, 2.0, 3.0), dimension: 2 };
    let frame = Frame { vertices_coords: Some(vec![point]), ..Frame::default() };
    let text = Document { key_frame: frame, ..Document::default() }.to_string().expect("written");
    assert!(text.contains("[[1,2,3]]"), "{text}");
}

#[test]
fn a_writer_that_fails_is_an_error() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::StorageFull.into())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let error = read(EXAMPLE).write_to(Full).expect_err("full");
    let origami_core::Error::Io { source, .. } = error else { panic!("{error:?}") };
    assert_eq!(source.kind(), std::io::ErrorKind::StorageFull);
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1000i32..1000).prop_map(f64::from),
        any::<f64>().prop_filter("finite", |number| number.is_finite()),
        Just(-0.0),
        Just(9_007_199_254_740_993.0),
        Just(f64::MAX),
        Just(5e-324),
    ]
}

fn value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<u64>().prop_map(Value::from),
        number().prop_map(Value::from),
        ".{0,6}".prop_map(Value::from),
    ];
    leaf.prop_recursive(3, 12, 3, |inner| {
        prop_oneof![
            vec(inner.clone(), 0..3).prop_map(Value::from),
            vec((".{0,3}", inner), 0..3).prop_map(|entries| Value::Object(entries.into_iter().collect())),
        ]
    })
}

fn map(prefix: &'static str) -> impl Strategy<Value = Map<String, Value>> {
    vec(("[a-c]{1,2}", value()), 0..4)
        .prop_map(move |entries| entries.into_iter().map(|(key, value)| (format!("{prefix}:{key}"), value)).collect())
}

fn coordinates() -> impl Strategy<Value = Coordinates> {
    (number(), number(), number(), any::<bool>()).prop_map(|(x, y, z, planar)| {
        if planar { Coordinates::planar(DVec3::new(x, y, 0.0)) } else { Coordinates::spatial(DVec3::new(x, y, z)) }
    })
}

prop_compose! {
    fn frame()(
        parent in of(any::<u32>()),
        inherit in any::<bool>(),
        classes in of(vec(".{0,3}", 0..3)),
        vertices_coords in of(vec(coordinates(), 0..5)),
        edges_vertices in of(vec(any::<[u32; 2]>(), 0..5)),
        edges_assignment in of(vec("[BMVFUCJa]|.{0,2}".prop_map(Cow::Owned), 0..5)),
        edges_fold_angle in of(vec(of(number()), 0..5)),
        faces_vertices in of(vec(vec(any::<u32>(), 0..5), 0..5)),
        extra in map("frame_x"),
    ) -> Frame {
        Frame {
            parent, inherit, classes, vertices_coords, edges_vertices, edges_assignment, edges_fold_angle,
            faces_vertices, extra,
        }
    }
}

prop_compose! {
    fn document()(
        spec in of(number().prop_map(Value::from)),
        classes in vec(".{0,3}", 0..3),
        metadata in map("file_x"),
        key_frame in frame(),
        frames in vec(frame(), 0..3),
    ) -> Document {
        Document { spec, classes, metadata, key_frame, frames, ..Document::default() }
    }
}

proptest! {
    #[test]
    fn any_document_reads_back_as_it_was(document in document()) {
        let text = document.to_string().expect("written");
        let mut again = read(&text);
        again.warnings.clear();
        prop_assert_eq!(&again, &document);
        prop_assert_eq!(again.to_string().expect("written again"), text);
    }

    #[test]
    fn no_mutation_makes_the_reader_panic(
        changes in vec((0..EXAMPLE.len(), any::<u8>()), 1..4),
        cut in of(0..EXAMPLE.len()),
    ) {
        let mut bytes = EXAMPLE.as_bytes().to_vec();
        for (at, byte) in changes {
            bytes[at] = byte;
        }
        bytes.truncate(cut.unwrap_or(bytes.len()));
        exercise(&bytes);
    }

    /// Swapped tokens stay JSON far more often than random bytes do.
    #[test]
    fn no_replaced_token_makes_the_reader_panic(
        at in 0..EXAMPLE.len(),
        length in 0usize..6,
        token in prop::sample::select(vec![
            "null", "[", "]", "{}", "1e999", "-1", "0.5", "\"x\"", "true", ",", ":", "NaN", "[[]]", "frame_parent", "7",
        ]),
    ) {
        let bytes = EXAMPLE.as_bytes();
        let end = (at + length).min(bytes.len());
        exercise(&[&bytes[..at], token.as_bytes(), &bytes[end..]].concat());
    }
}

/// All that is done with a file before it is interpreted.
fn exercise(bytes: &[u8]) {
    match Document::from_slice(bytes) {
        Ok(document) => {
            let _ = document.pattern_frame();
            for index in 0..document.frame_count() + 1 {
                let _ = document.frame(index);
            }
            let mut again = read(&document.to_string().expect("written"));
            again.warnings.clone_from(&document.warnings);
            assert_eq!(again, document);
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}
