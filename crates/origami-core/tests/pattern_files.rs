//! Real files, where there are some: `ORIGAMI_PATTERNS` names a folder of FOLD files. And large sheets.

mod pattern_support;

use std::collections::BTreeSet;
use std::path::Path;

use glam::DVec3;
use origami_core::fold::{Coordinates, Frame};
use pattern_support::{build, flat, triangles};
use serde_json::Value;

fn read(path: &Path) -> Frame {
    let file: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("a readable FOLD file"))
        .expect("a readable FOLD file");
    let list = |key: &str| file[key].as_array().cloned();
    let numbers = |value: &Value| -> Vec<u32> {
        value
            .as_array()
            .expect("a readable FOLD file")
            .iter()
            .map(|n| n.as_u64().expect("a readable FOLD file") as u32)
            .collect()
    };
    let coords = |value: &Value| {
        let at = |i: usize| value[i].as_f64().unwrap_or(0.0);
        Coordinates { position: DVec3::new(at(0), at(1), at(2)), dimension: 2 }
    };
    Frame {
        vertices_coords: list("vertices_coords").map(|all| all.iter().map(coords).collect()),
        edges_vertices: list("edges_vertices").map(|all| all.iter().map(|e| [numbers(e)[0], numbers(e)[1]]).collect()),
        edges_assignment: list("edges_assignment")
            .map(|all| all.iter().map(|l| l.as_str().expect("a readable FOLD file").to_owned().into()).collect()),
        edges_fold_angle: list("edges_foldAngle").map(|all| all.iter().map(Value::as_f64).collect()),
        faces_vertices: list("faces_vertices").map(|all| all.iter().map(numbers).collect()),
        ..Frame::default()
    }
}

/// Faces as sets of corners.
fn corner_sets(faces: impl Iterator<Item = Vec<u32>>) -> BTreeSet<Vec<u32>> {
    faces
        .map(|mut face| {
            face.sort_unstable();
            face
        })
        .collect()
}

#[test]
fn every_file_builds_with_its_faces_and_without() {
    let Some(folder) = std::env::var_os("ORIGAMI_PATTERNS") else { return };
    let paths = std::fs::read_dir(folder)
        .expect("a readable FOLD file")
        .map(|entry| entry.expect("a readable FOLD file").path());
    let mut count = 0;
    for path in paths.filter(|path| path.extension().is_some_and(|end| end == "fold")) {
        let mut frame = read(&path);
        let given = build(&frame);
        // Some have mountains on the contour; one has boundary letters inside, which would be cuts without faces.
        let odd = |words: &str| given.warnings.iter().filter(|w| w.message.contains(words)).count();
        let expected = ["on the contour", "between two faces", "is missing", "runs clockwise", "ignored"];
        let known: usize = expected.into_iter().map(odd).sum();
        assert_eq!(known, given.warnings.len(), "{:?}", given.warnings);
        triangles(&given);
        // Slits that are already split into two lips would be merged.
        let places: BTreeSet<_> =
            given.vertices.iter().map(|v| v.to_array().map(|c| (c * 1e6).round() as i64)).collect();
        if places.len() == given.vertices.len() && odd("between two faces") == 0 {
            frame.faces_vertices = None;
            let built = build(&frame);
            triangles(&built);
            let ids = |pattern: &origami_core::CreasePattern| {
                corner_sets(pattern.faces.iter().map(|face| face.iter().map(|v| v.0).collect()))
            };
            assert_eq!(ids(&built), ids(&given), "{}", path.display());
            assert_eq!(built.faces.len(), given.faces.len(), "{}", path.display());
            assert_eq!(built.edges, given.edges, "{}", path.display());
        }
        count += 1;
    }
    assert!(count > 0, "no FOLD files in the folder that ORIGAMI_PATTERNS names");
}

/// A sheet of `nx` by `ny` parallelograms.
fn sheet(nx: u32, ny: u32) -> Frame {
    let at = |x: u32, y: u32| x + (nx + 1) * y;
    let coords: Vec<_> = (0..=ny)
        .flat_map(|y| (0..=nx).map(move |x| [f64::from(x), f64::from(y) + if x % 2 == 0 { 0.0 } else { 0.4 }]))
        .collect();
    let mut edges = Vec::new();
    let mut letters = String::new();
    for (x, y) in (0..=ny).flat_map(|y| (0..=nx).map(move |x| (x, y))) {
        if x < nx {
            edges.push([at(x, y), at(x + 1, y)]);
            letters.push(if y == 0 || y == ny { 'B' } else { ['M', 'V'][(x % 2) as usize] });
        }
        if y < ny {
            edges.push([at(x, y), at(x, y + 1)]);
            letters.push(if x == 0 || x == nx { 'B' } else { ['M', 'V'][(y % 2) as usize] });
        }
    }
    let faces: Vec<[u32; 4]> = (0..nx * ny)
        .map(|i| (i % nx, i / nx))
        .map(|(x, y)| [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)])
        .collect();
    let faces: Vec<&[u32]> = faces.iter().map(<[u32; 4]>::as_slice).collect();
    flat(&coords, &edges, &letters, &faces)
}

#[test]
fn a_large_sheet_has_the_same_faces_when_built() {
    let mut frame = sheet(40, 50);
    let given = build(&frame);
    frame.faces_vertices = None;
    let built = build(&frame);
    let ids = |pattern: &origami_core::CreasePattern| {
        corner_sets(pattern.faces.iter().map(|face| face.iter().map(|v| v.0).collect()))
    };
    assert_eq!(ids(&given), ids(&built));
    assert_eq!(given.edges, built.edges);
}
