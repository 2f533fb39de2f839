//! Inputs of other formats than FOLD.

use crate::place::Place;

/// A square with a diagonal valley.
const CP: &str = "1 0 0 1 0\n1 1 0 1 1\n1 1 1 0 1\n1 0 1 0 0\n3 0 0 1 1\n";

#[cfg(not(feature = "formats"))]
#[test]
fn a_build_without_them_says_so() {
    let place = Place::new();
    place.put("a.cp", CP);
    place
        .run("info a.cp")
        .fails(1, "a.cp: the file: is no FOLD file, and this build was made without the feature `formats`");
    place.run("info a.cp --letters red=V").fails(1, "this build has no feature `formats`");
    place.run("info square.fold").succeeds();
}

#[cfg(feature = "formats")]
mod with {
    use std::io::Write;

    use flate2::Compression;
    use flate2::write::GzEncoder;
    use serde_json::{Value, json};

    use super::*;

    #[test]
    fn they_are_folded_and_told() {
        let place = Place::new();
        place.put("a.cp", CP);
        let ran = place.run("fold a.cp -o a.obj");
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        assert!(place.run("info a.cp").succeeds().contains("  file        CP, 1 frame\n"));
        let facts: Value = serde_json::from_str(place.run("info a.cp --json").succeeds()).unwrap();
        assert_eq!(facts["file"]["format"], "CP");
        assert_eq!(facts["pattern"]["letters"], json!({"B": 4, "V": 1}));
        // What was written comes back.
        place.run("fold a.cp --percent 50 -o b.obj --quiet").succeeds();
        let facts: Value = serde_json::from_str(&place.run("info b.obj --json").stdout).unwrap();
        assert_eq!((&facts["file"]["format"], &facts["pattern"]["flat"]), (&json!("OBJ"), &json!(true)));
        assert_eq!(facts["pattern"]["letters"], json!({"B": 4, "V": 1}));
    }

    #[test]
    fn gzip_and_standard_input_are_read() {
        let place = Place::new();
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(CP.as_bytes()).unwrap();
        std::fs::write(place.path("a.cp.gz"), encoder.finish().unwrap()).unwrap();
        assert!(place.run("info a.cp.gz").succeeds().contains("file        CP, compressed by gzip, 1 frame"));
        place.run("fold a.cp.gz -o out/ --format obj --quiet").succeeds();
        assert!(place.has("out/a.obj"), "{:?}", place.names());
        place.run_with("fold - -o - --quiet", CP).succeeds();
    }

    #[test]
    fn a_wrong_name_is_told_and_content_decides() {
        let place = Place::new();
        place.put("a.fold", CP);
        let ran = place.run("fold a.fold -o b.fold");
        assert_eq!(ran.code, 0, "{}", ran.stderr);
        assert!(ran.stderr.contains("the file: its name says FOLD, its content is CP; read as CP"), "{}", ran.stderr);
        place.put("b.fold", &CP.replace("3 0 0 1", "3 0 O 1"));
        let ran = place.run("fold b.fold -o c.fold");
        ran.fails(1, "b.fold: line 5: \"O\" is no number; expected a number for y1");
        assert!(!ran.stderr.contains("JSON"), "{}", ran.stderr);
    }

    #[test]
    fn what_is_no_pattern_is_named() {
        let place = Place::new();
        for (name, content, told) in [
            ("a.png", &b"\x89PNG\r\n\x1a\n0000"[..], "is a PNG picture"),
            ("a.zip", b"PK\x03\x04\x14\0", "is a ZIP archive"),
            ("a.fold", b"<!DOCTYPE html>\n<html><body>Sign in", "is an HTML page"),
            ("a.json", b"{\"asset\": {\"version\": \"2.0\"}, \"meshes\": []}", "is a glTF model"),
            ("a.xml", b"<?xml version='1.0'?><gpx></gpx>", "is an XML file with the root element <gpx>"),
            ("a.txt", b"Dear Sir,\nI have a pattern.\n", "is a file of unknown kind"),
            ("a.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "an OBJ file without faces (f) and lines (l)"),
            ("a.cp.gz", b"\x1f\x8b\x08\0\0\0", "is damaged or cut off"),
            ("b.cp", b"", "the file is empty"),
        ] {
            std::fs::write(place.path(name), content).unwrap();
            place.run(&format!("info {name}")).fails(1, told);
        }
    }

    #[test]
    fn lines_are_named_all_the_way() {
        let place = Place::new();
        place.put("a.cp", &format!("{CP}2 0 1 1 0\n"));
        let ran = place.run("fold a.cp -o a.fold --percent 150 --report r.json --steps 1 --ramp 0");
        for told in [
            "line 5, edges_vertices[4]: crosses edges_vertices[5] (line 6); both get a vertex there",
            "warning: creases 4-0 (line 5), 1-4 (line 6), ",
        ] {
            assert!(ran.stderr.contains(told), "expected {told:?} in {}", ran.stderr);
        }
        let report = place.json("r.json");
        let of = |code: &str| {
            let warnings = report["warnings"].as_array().unwrap().iter();
            warnings.clone().find(|warning| warning["code"] == code).unwrap()["at"].clone()
        };
        assert_eq!(of("edges-cross")["source"], "line 5");
        assert_eq!(of("over-folding")["creases"][0]["source"], "line 5");
    }

    #[test]
    fn colours_and_curves_have_options() {
        let place = Place::new();
        place.put(
            "a.svg",
            "<svg xmlns='http://www.w3.org/2000/svg'><path stroke='#000' d='M0 0H2V2H0z'/><path stroke='#123456' d='M0 0L2 2'/></svg>",
        );
        let letters = |words: &str| {
            let facts: Value = serde_json::from_str(&place.run(words).stdout).unwrap();
            facts["pattern"]["letters"].clone()
        };
        assert_eq!(letters("info a.svg --json --letters #123456=M"), json!({"B": 4, "M": 1}));
        place.run("info a.svg --letters #123456=X").fails(1, "--letters: cannot be read: ");
        place.run("info a.svg --curve-tolerance 0").fails(1, "--curve-tolerance");
    }

    #[cfg(unix)]
    #[test]
    fn a_stream_without_end_is_refused() {
        let place = Place::new();
        place.run("info /dev/zero").fails(1, "the file: is larger than 1073741824 bytes, or without end");
    }
}
