//! Files of other programs, where they are at hand: they are not ours to ship.

use std::collections::BTreeMap;
use std::path::PathBuf;

use origami_core::CreasePattern;
use origami_core::fold::Document;
use origami_formats::{Format, Options, open};

/// The folder with them; `ORIGAMI_FORMATS` names another.
fn folder() -> PathBuf {
    let beside = || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/formats"));
    std::env::var_os("ORIGAMI_FORMATS").map_or_else(beside, PathBuf::from)
}

fn read(name: &str) -> Option<(Document, Format)> {
    let bytes = std::fs::read(folder().join(name)).ok()?;
    let opened =
        open(&bytes, Some(name.as_ref()), &Options::default()).unwrap_or_else(|error| panic!("{name}: {error}"));
    Some((opened.document, opened.format))
}

/// How many lines of each letter.
fn letters(document: &Document) -> String {
    let mut counts = BTreeMap::new();
    document.key_frame.edges_assignment.iter().flatten().for_each(|letter| *counts.entry(&**letter).or_insert(0) += 1);
    counts.iter().map(|(letter, count)| format!("{letter}{count} ")).collect::<String>().trim_end().to_owned()
}

/// Counted in the files by their text: types of CP, properties of OPX, colours of ORI.
#[test]
fn files_of_other_programs_have_the_lines_that_are_counted_in_their_text() {
    for (name, format, expected) in [
        ("a.cp", Format::Cp, "B8 M4 V8"),
        ("b.cp", Format::Cp, "B8 M12 V6"),
        ("c.cp", Format::Cp, "B16 M12 V16"),
        ("a.opx", Format::Opx, "B8 F8 M4 V8"),
        ("b.opx", Format::Opx, "B4 M12 V4"),
        ("c.opx", Format::Opx, "B8 M4 V8"),
        ("a.ori", Format::Ori, "B5 F1 M1 V1"),
        ("b.ori", Format::Ori, "B5 F1 M1 V1"),
    ] {
        let Some((document, found)) = read(name) else {
            println!("{name}: not at hand, skipped");
            continue;
        };
        assert_eq!(found, format, "{name}");
        println!(
            "{name}: {} {:?}",
            letters(&document),
            document.warnings.iter().map(ToString::to_string).collect::<Vec<_>>()
        );
        assert_eq!(letters(&document), expected, "{name}");
        match CreasePattern::from_document(&document, 0) {
            Ok(pattern) => println!(
                "  {} faces, {:?}",
                pattern.faces.len(),
                pattern.warnings.iter().map(ToString::to_string).collect::<Vec<_>>()
            ),
            Err(error) => println!("  {error}"),
        }
    }
}

/// Border, mountains and valleys, each line by its ends in order.
fn creases(document: &Document) -> BTreeMap<String, usize> {
    let frame = &document.key_frame;
    let at = |v: u32| frame.vertices_coords.as_ref().expect("vertices")[v as usize].position.truncate().to_array();
    let lines = frame.edges_vertices.iter().flatten().zip(frame.edges_assignment.iter().flatten());
    let mut counts = BTreeMap::new();
    for ([a, b], letter) in lines.filter(|(_, letter)| *letter != "F") {
        let mut ends = [format!("{:?}", at(*a)), format!("{:?}", at(*b))];
        ends.sort();
        *counts.entry(format!("{letter} {}", ends.join(" "))).or_insert(0) += 1;
    }
    counts
}

/// ORIPA's CP has the same creases as its OPX, less the auxiliary lines.
#[test]
fn one_pattern_has_the_same_creases_as_cp_and_as_opx() {
    let (Some((cp, _)), Some((opx, _))) = (read("a.cp"), read("a.opx")) else { return };
    assert_eq!(creases(&cp), creases(&opx));
    assert_eq!(creases(&cp).values().sum::<usize>(), 20);
}
