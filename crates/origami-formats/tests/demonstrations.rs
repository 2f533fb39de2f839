//! The demonstration files of the reference program against what its own importer makes of them. They are not ours to ship:
//! without the folder there is nothing to do.

use std::path::{Path, PathBuf};

use origami_core::CreasePattern;
use origami_core::mesh::triangulate::triangulate;
use origami_formats::Options;

fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/svg");
    folder.is_dir().then_some(folder)
}

/// A row of the table: file, importer, vertices, faces, triangles; `None` where the importer does not say.
fn rows(folder: &Path) -> Vec<(String, bool, [Option<usize>; 3])> {
    let table = std::fs::read_to_string(folder.join("COUNTS.md")).expect("the table");
    let rows = table.lines().filter(|line| line.starts_with("| s"));
    rows.map(|row| {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let number = |cell: &str| cell.parse().ok();
        (cells[0].to_owned(), cells[1] == "curved", [number(cells[2]), number(cells[3]), number(cells[4])])
    })
    .collect()
}

/// Vertices that something is made of, faces, triangles.
fn counts(pattern: &CreasePattern) -> [usize; 3] {
    let mut used = vec![false; pattern.vertices.len()];
    pattern.faces.iter().flatten().for_each(|vertex| used[vertex.index()] = true);
    let triangles = triangulate(pattern).map_or(0, |all| all.triangles.len());
    [used.iter().filter(|used| **used).count(), pattern.faces.len(), triangles]
}

#[test]
fn all_are_read() {
    let Some(folder) = folder() else { return };
    let mut plain = 0;
    for (file, curved, expected) in rows(&folder) {
        let document = origami_formats::read_file(folder.join(&file), &Options::default()).unwrap();
        match CreasePattern::from_document(&document, 0) {
            Ok(pattern) => {
                let counts = counts(&pattern);
                let same = (0..3).all(|i| expected[i].is_none_or(|count| count == counts[i]));
                plain += usize::from(same && !curved);
                println!(
                    "{file} {} {expected:?} {counts:?} {}",
                    if curved { "curved" } else { "plain" },
                    if same { "same" } else { "" }
                );
            }
            Err(error) => println!("{file} {error}"),
        }
        for warning in document.warnings {
            println!("    {warning}");
        }
    }
    println!("{plain} the same");
}
