//! Patterns written and read again: every crease with its letter, its ends and, where the format can, its angle.

use std::collections::BTreeMap;

use glam::DVec2;
use origami_core::error::WarningCode;
use origami_core::generate::{SingleCrease, catalog};
use origami_core::ids::VertexId;
use origami_core::pattern::Assignment;
use origami_core::{CreasePattern, Error, Warning};
use origami_formats::write::{self, Kind, Options};
use origami_formats::{Format, read};

type Writer = fn(&CreasePattern, &Options, &mut Vec<u8>) -> Result<Vec<Warning>, Error>;
const CP: Writer = |pattern, options, bytes| write::cp(pattern, options, bytes);
const SVG: Writer = |pattern, options, bytes| write::svg(pattern, options, bytes);
const DXF: Writer = |pattern, options, bytes| write::dxf(pattern, options, bytes);

fn written(writer: Writer, pattern: &CreasePattern, options: &Options) -> (String, Vec<String>) {
    let mut bytes = Vec::new();
    let warnings = writer(pattern, options, &mut bytes).expect("written");
    assert!(warnings.iter().all(|warning| warning.code == WarningCode::Fallback));
    (String::from_utf8(bytes).expect("text"), warnings.iter().map(ToString::to_string).collect())
}

fn again(text: &str) -> CreasePattern {
    let document = read(text.as_bytes(), None, &origami_formats::Options::default()).expect("a file");
    CreasePattern::from_document(&document, 0).expect("a pattern")
}

fn options(set: impl FnOnce(&mut Options)) -> Options {
    let mut options = Options::default();
    set(&mut options);
    options
}

/// Patterns on a plane: all that are generated, which have whole numbers, roots and sines for coordinates.
fn patterns() -> Vec<(&'static str, CreasePattern)> {
    let all = catalog::names().iter().map(|name| (*name, catalog::generate(name, &[]).expect("a pattern")));
    all.filter(|(_, pattern)| pattern.is_flat()).collect()
}

/// A crease as it is compared: its ends in order, its letter, its angle.
type Crease = ([DVec2; 2], &'static str, Option<f64>);

/// Where a point lies, but for rounding, which must not decide on an order.
fn key(p: DVec2) -> [i64; 2] {
    [p.x, p.y].map(|x| (x * 1e6).round() as i64)
}

/// All of a pattern's edges; facets are `F`, whatever drew them.
fn creases(pattern: &CreasePattern) -> Vec<Crease> {
    let own = pattern.edges.iter().filter(|edge| edge.alias_of.is_none());
    let mut creases: Vec<Crease> = own
        .map(|edge| {
            let mut ends = edge.vertices.map(|v| pattern.vertices[v.index()].truncate());
            ends.sort_by_key(|p| key(*p));
            let letter = if edge.assignment == Assignment::Join { "F" } else { edge.assignment.letter() };
            (ends, letter, edge.fold_angle)
        })
        .collect();
    creases.sort_by_key(|crease| crease.0.map(key));
    creases
}

/// The farthest that an end of one is from that of the other; they have the same letters in the same places.
fn compare(name: &str, before: &CreasePattern, after: &CreasePattern, angles: bool) -> f64 {
    let (old, new) = (creases(before), creases(after));
    assert_eq!(old.len(), new.len(), "{name}: so many creases");
    let mut farthest = 0.0_f64;
    for (old, new) in old.iter().zip(&new) {
        assert_eq!(old.1, new.1, "{name}: {old:?} {new:?}");
        for (a, b) in old.0.iter().zip(&new.0) {
            farthest = farthest.max(a.distance(*b) / before.size());
        }
        if angles && matches!(old.1, "M" | "V") {
            let (Some(a), Some(b)) = (old.2, new.2) else { panic!("{name}: {old:?} {new:?}") };
            assert!((a - b).abs() < 1e-12, "{name}: {a} {b}");
        }
    }
    farthest
}

#[test]
fn cp_svg_and_dxf_keep_every_crease() {
    let mut compared = 0;
    for (name, pattern) in patterns() {
        for joined in [false, true] {
            let options = options(|options| options.joined = Some(joined));
            for (writer, angles) in [(CP, false), (SVG, true), (DXF, false)] {
                let (text, _) = written(writer, &pattern, &options);
                let farthest = compare(name, &pattern, &again(&text), angles);
                assert!(farthest < 1e-12, "{name}: {farthest:e}");
                compared += 1;
            }
        }
    }
    assert!(compared > 30, "{compared}");
}

#[test]
fn content_says_what_was_written() {
    let pattern = catalog::generate("miura", &[]).expect("a pattern");
    for (writer, format) in [(CP, Format::Cp), (SVG, Format::Svg), (DXF, Format::Dxf)] {
        let (text, warnings) = written(writer, &pattern, &Options::default());
        assert_eq!(Format::of(text.as_bytes(), None).expect("known"), format);
        assert_eq!(warnings, [""; 0]);
    }
}

/// A miura's long creases run over many panels: one line each.
#[test]
fn pieces_of_one_line_are_one_line() {
    let pattern = catalog::generate("miura", &[]).expect("a pattern");
    let count = |options: &Options| written(SVG, &pattern, options).0.matches("<line").count();
    assert_eq!(count(&options(|o| o.joined = Some(false))), pattern.edges.len());
    let strokes = write::strokes(&pattern, Some(write::STRAIGHT)).expect("flat");
    assert_eq!(count(&Options::default()), strokes.len());
    assert!(strokes.len() < pattern.edges.len());
    // Nothing is added, lost or written twice: the lengths of each kind are what they were.
    let lengths = |strokes: &[write::Stroke]| {
        let mut lengths: BTreeMap<Kind, f64> = BTreeMap::new();
        strokes.iter().for_each(|s| *lengths.entry(s.kind).or_default() += s.ends[0].distance(s.ends[1]));
        lengths
    };
    let pieces = lengths(&write::strokes(&pattern, None).expect("flat"));
    for (kind, length) in lengths(&strokes) {
        assert!((length - pieces[&kind]).abs() < 1e-9, "{kind:?}");
    }
}

/// A row of three pieces, the second joint a little off.
#[test]
fn what_is_nearly_straight_is_joined_where_that_is_asked_for() {
    let pattern = again(
        "3 0 0 1 0\n3 1 0 2 1e-3\n3 2 1e-3 3 0\n2 3 0 4 0\n\
         1 0 0 0 3\n1 0 3 4 3\n1 4 3 4 0\n1 0 0 0 -1\n1 0 -1 4 -1\n1 4 -1 4 0",
    );
    let valleys = |straight: Option<f64>| {
        let strokes = write::strokes(&pattern, straight).expect("flat");
        strokes.iter().filter(|stroke| stroke.kind == Kind::Valley).count()
    };
    // The joints are 1e-3 and less of 4 off the line.
    assert_eq!([None, Some(write::STRAIGHT), Some(1e-5), Some(2.5e-4)].map(valleys), [3, 3, 3, 1]);
}

#[test]
fn angles_that_are_lost_are_counted() {
    let single = SingleCrease { angle: 90.0_f64.to_radians(), ..SingleCrease::default() };
    let pattern = single.pattern().expect("a pattern");
    let (_, warnings) = written(CP, &pattern, &Options::default());
    assert_eq!(warnings.len(), 1);
    assert!(warnings[0].starts_with("CP: 1 line loses its fold angle"), "{warnings:?}");
    assert!(written(DXF, &pattern, &Options::default()).1[0].starts_with("DXF: 1 line loses its fold angle"));
    assert_eq!(written(SVG, &pattern, &Options::default()).1, [""; 0]);

    let mut odd = pattern.clone();
    let crease = odd.edges.iter().position(|edge| edge.fold_angle.is_some()).expect("a crease");
    for angle in [Some(-0.5), Some(4.0), None] {
        odd.edges[crease].fold_angle = angle;
        let (text, warnings) = written(SVG, &odd, &Options::default());
        assert!(warnings[0].starts_with("SVG: 1 line loses its fold angle"), "{angle:?}: {warnings:?}");
        assert!(!text.contains("stroke-opacity"));
    }
    odd.edges[crease].fold_angle = Some(0.25);
    odd.edges[crease].k_crease = Some(2.0);
    odd.fixed = vec![VertexId(0), VertexId(1)];
    let (_, warnings) = written(SVG, &odd, &Options::default());
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    assert!(warnings[0].contains("1 edge loses its own stiffness"), "{warnings:?}");
    assert!(warnings[1].contains("2 vertices are no longer fixed"), "{warnings:?}");
}

/// A slit from the border to the middle: both of its lips are one line of its own kind, and read again a cut.
#[test]
fn cuts_are_written_once() {
    let text = r#"{"vertices_coords": [[0,0],[1,0],[2,0],[2,1],[1,1],[0,1],[1,0.5]],
        "edges_vertices": [[0,1],[1,2],[2,3],[3,4],[4,5],[5,0],[1,6],[6,4]],
        "edges_assignment": ["B","B","B","B","B","B","C","V"]}"#;
    let pattern = again(text);
    let (svg, warnings) = written(SVG, &pattern, &Options::default());
    assert_eq!(warnings, [""; 0]);
    let cut = svg.split("id=\"cut\"").nth(1).expect("a layer").split("</g>").next().expect("its end");
    assert_eq!(cut.matches("<line").count(), 1);
    assert!(compare("a cut", &pattern, &again(&svg), true) < 1e-12);
    let (cp, warnings) = written(CP, &pattern, &Options::default());
    assert!(warnings[0].contains("1 cut is written as borders"), "{warnings:?}");
    assert_eq!(cp.lines().count(), 8);
}

#[test]
fn what_is_not_flat_is_refused() {
    let mut pattern = catalog::generate("miura", &[]).expect("a pattern");
    pattern.vertices[3].z = 0.5;
    for writer in [CP, SVG, DXF] {
        let mut bytes = Vec::new();
        let error = writer(&pattern, &Options::default(), &mut bytes).expect_err("bent").to_string();
        assert!(error.contains("not flat") && bytes.is_empty(), "{error}");
    }
}

/// The numbers of an attribute of the root.
fn numbers(svg: &str, name: &str) -> Vec<f64> {
    let value = svg.split(&format!(" {name}=\"")).nth(1).expect("it is there").split('"').next().expect("its end");
    value.trim_end_matches("cm").split(' ').map(|number| number.parse().expect("a number")).collect()
}

#[test]
fn svg_is_as_wide_as_asked_for() {
    let mut pattern = catalog::generate("single-crease", &[]).expect("a pattern");
    let size = pattern.size();
    pattern.vertices.iter_mut().for_each(|p| *p *= 20.0 / size);
    let (text, _) = written(SVG, &pattern, &options(|o| o.width = Some("10cm".parse().expect("a length"))));
    let (view, width, height) = (numbers(&text, "viewBox"), numbers(&text, "width")[0], numbers(&text, "height")[0]);
    let across = {
        let low = pattern.vertices.iter().copied().reduce(glam::DVec3::min).expect("vertices");
        pattern.vertices.iter().copied().reduce(glam::DVec3::max).expect("vertices") - low
    };
    // One unit is as long on paper across as down, and the sheet has the width.
    assert!((width / view[2] - height / view[3]).abs() < 1e-12);
    assert!((across.x * width / view[2] - 10.0).abs() < 1e-9, "{view:?} {width}");
    assert!(view[2] > across.x && view[3] > across.y && view[2] < 1.1 * across.x);
    assert!(compare("wide", &pattern, &again(&text), true) < 1e-12);
}

/// The items of a DXF file: the number of a group and its value.
fn items(text: &str) -> Vec<(u8, &str)> {
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len() % 2, 0);
    lines.chunks(2).map(|pair| (pair[0].parse().expect("a group"), pair[1])).collect()
}

/// Groups that begin and end, a table of layers, four numbers a line.
#[test]
fn dxf_holds_every_line_on_its_layer() {
    let pattern = catalog::generate("miura", &[]).expect("a pattern");
    let (text, _) = written(DXF, &pattern, &Options::default());
    let all = items(&text);
    assert_eq!(all.last(), Some(&(0, "EOF")));
    let count = |item: (u8, &str)| all.iter().filter(|own| **own == item).count();
    assert_eq!((count((0, "SECTION")), count((0, "ENDSEC"))), (3, 3));
    for kind in Kind::ALL {
        assert!(all.windows(2).any(|two| two == [(0, "LAYER"), (2, kind.name())]), "{kind:?}");
    }
    let strokes = write::strokes(&pattern, Some(write::STRAIGHT)).expect("flat");
    let entities = all.iter().position(|item| *item == (2, "ENTITIES")).expect("lines");
    let found: Vec<_> = all[entities + 1..all.len() - 2].chunks(8).collect();
    assert_eq!(found.len(), strokes.len());
    for (item, stroke) in found.iter().zip(&strokes) {
        let groups: Vec<u8> = item.iter().map(|(group, _)| *group).collect();
        assert_eq!(groups, [0, 8, 10, 20, 30, 11, 21, 31]);
        assert_eq!((item[0].1, item[1].1), ("LINE", stroke.kind.name()));
        let number = |i: usize| item[i].1.parse::<f64>().expect("a number");
        let [a, b] = stroke.ends;
        assert_eq!([number(2), number(3), number(5), number(6)], [a.x, a.y, b.x, b.y]);
    }
    let (text, _) = written(DXF, &pattern, &options(|o| o.width = Some("100mm".parse().expect("a length"))));
    let xs = || items(&text).into_iter().filter(|(group, _)| [10, 11].contains(group));
    let xs: Vec<f64> = xs().map(|(_, x)| x.parse().expect("a number")).collect();
    let width = xs.iter().copied().fold(f64::MIN, f64::max) - xs.iter().copied().fold(f64::MAX, f64::min);
    assert!((width - 100.0).abs() < 1e-9, "{width}");
}
