//! `examples/patterns/` holds what the generators make, and every one of them folds; the README shows `examples/embed.rs`.
//!
//! `ORIGAMI_UPDATE_EXAMPLES=1 cargo test --test examples` writes the patterns anew.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use origami::export::{crease_pattern_document, write_whole};
use origami::generate::catalog;
use origami::{CreasePattern, Material, Model, Relax, Solver};

/// Parameters that are not the defaults: rings at rest are the more telling with springs along their edges.
const PARAMETERS: [(&str, &[(&str, f64)]); 2] =
    [("yoshimura-ring", &[("driven", 1.0)]), ("kresling-ring", &[("driven", 1.0)])];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn file(name: &str) -> PathBuf {
    root().join("examples/patterns").join(name).with_extension("fold")
}

/// The text that `origami pattern NAME --set ... -o FILE` writes.
fn made(name: &str) -> String {
    let own = PARAMETERS.iter().find(|(known, _)| *known == name).map_or(&[][..], |(_, parameters)| parameters);
    let parameters: Vec<(String, f64)> = own.iter().map(|(key, value)| ((*key).to_owned(), *value)).collect();
    let pattern = catalog::generate(name, &parameters).expect("parameters of this pattern");
    let title = own.iter().fold(name.to_owned(), |title, (key, value)| format!("{title}, {key} {value}"));
    let mut text = Vec::new();
    crease_pattern_document(&pattern, &title).write_to(&mut text).expect("memory");
    String::from_utf8(text).expect("JSON")
}

#[test]
fn each_pattern_is_what_its_generator_makes() {
    for name in catalog::names() {
        let (path, made) = (file(name), made(name));
        if std::env::var_os("ORIGAMI_UPDATE_EXAMPLES").is_some() {
            write_whole(&path, |writer| {
                writer.write_all(made.as_bytes()).map_err(|source| origami::Error::Io { path: "-".into(), source })
            })
            .expect("a folder that can be written");
        }
        // Sines differ in their last digit from one platform to another.
        let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(same(&text, &made), "{name}: not what the generator makes; ORIGAMI_UPDATE_EXAMPLES=1 writes it anew");
    }
}

/// Whether two texts of JSON say the same, numbers to a billionth.
fn same(a: &str, b: &str) -> bool {
    fn equal(a: &serde_json::Value, b: &serde_json::Value) -> bool {
        use serde_json::Value::{Array, Number, Object};
        match (a, b) {
            (Number(a), Number(b)) => a.as_f64().zip(b.as_f64()).is_some_and(|(a, b)| (a - b).abs() < 1e-9),
            (Array(a), Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| equal(a, b)),
            (Object(a), Object(b)) => {
                a.len() == b.len() && a.iter().zip(b).all(|((k, a), (l, b))| k == l && equal(a, b))
            }
            _ => a == b,
        }
    }
    serde_json::from_str(a).ok().zip(serde_json::from_str(b).ok()).is_some_and(|(a, b)| equal(&a, &b))
}

#[test]
fn a_pattern_that_differs_is_seen() {
    let text = made("miura");
    assert!(same(&text, &text));
    assert!(!same(&text, &text.replacen('M', "V", 1)), "another letter");
    assert!(!same(&text, &text.replacen("180", "179", 1)), "another angle");
    assert!(!same(&text, &made("strip")) && !same(&text, &text[1..]));
}

#[test]
fn no_pattern_lacks_a_generator() {
    let files: BTreeSet<String> = { fs::read_dir(file("miura").parent().expect("a folder")).expect("the folder") }
        .map(|entry| entry.expect("an entry").path().file_stem().expect("a name").to_string_lossy().into_owned())
        .collect();
    let names: BTreeSet<String> = catalog::names().iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(files, names);
}

#[test]
fn each_pattern_folds_to_90_percent() {
    for name in catalog::names() {
        let pattern = CreasePattern::read(file(name)).expect("a pattern");
        assert!(pattern.warnings.is_empty(), "{name}: {:?}", pattern.warnings);
        let model = Model::new(&pattern, &Material::default()).expect("a model");
        let folded = Relax::default().fold_from_rest(&model, 90.0).expect("holds");
        let (converged, tangled) = (folded.converged(), folded.state.tangled_creases());
        println!("{name}: converged {converged} in {} evaluations, {tangled} creases tangled", folded.steps);
        assert!(converged && tangled == 0, "{name}: converged {converged}, {tangled} creases tangled");
    }
}

#[test]
fn the_readme_shows_the_example_that_is_compiled() {
    let readme = fs::read_to_string(root().join("README.md")).expect("README.md");
    let example = fs::read_to_string(root().join("examples/embed.rs")).expect("examples/embed.rs");
    let code = example.split_once("\n\n").expect("a line of documentation, then code").1;
    assert!(readme.contains(&format!("```rust\n{code}```\n")), "README.md: not the text of examples/embed.rs");
}
