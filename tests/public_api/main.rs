//! The public interface of the core and of the facade is that of `docs/public-api`: whoever changes it sees what they change.
//!
//! `ORIGAMI_UPDATE_GOLDEN=1 cargo test --test public_api` writes the files anew. They are Rust without bodies: what can be
//! named from outside, each item where it is named first, with its implementations below it. A private field shows as
//! `private: _`. Items behind features are all there, with their `#[cfg]`.

mod crate_source;
mod outline;

use std::path::Path;

use crate_source::Source;

/// Libraries and the files that show them.
const SHOWN: [(&str, &str); 3] = [
    ("crates/origami-core/src/lib.rs", "docs/public-api/origami-core.txt"),
    ("crates/origami-formats/src/lib.rs", "docs/public-api/origami-formats.txt"),
    ("src/lib.rs", "docs/public-api/origami.txt"),
];

#[test]
fn the_public_interface_is_the_one_that_is_written_down() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (library, file) in SHOWN {
        let source = Source::read(&root.join(library), &|path| std::fs::read_to_string(path).ok());
        let (found, path) = (outline::outline(&source), root.join(file));
        if std::env::var_os("ORIGAMI_UPDATE_GOLDEN").is_some() {
            std::fs::write(&path, &found).expect("a folder that can be written");
        }
        let expected = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{file}: {error}"));
        let differs = found.lines().zip(expected.lines()).position(|(a, b)| a != b);
        let line = differs.unwrap_or_else(|| found.lines().count().min(expected.lines().count()));
        let at = |text: &str| text.lines().nth(line).unwrap_or("(the end)").to_owned();
        assert!(
            found == expected,
            "{file}:{}: `{}` is now `{}`; if that is meant, ORIGAMI_UPDATE_GOLDEN=1 writes the file anew",
            line + 1,
            at(&expected),
            at(&found)
        );
    }
}

/// The outline of a crate of two files.
fn outline_of(library: &str, inner: &str) -> String {
    let read = |path: &Path| match path.to_str()? {
        "src/lib.rs" => Some(library.to_owned()),
        "src/inner.rs" => Some(inner.to_owned()),
        _ => None,
    };
    outline::outline(&Source::read(Path::new("src/lib.rs"), &read))
}

#[test]
fn what_is_public_shows_and_nothing_else() {
    let inner = "
        /// Documentation is no interface.
        #[derive(Clone)]
        pub struct Sheet { pub radius: f64, nodes: u32 }
        impl Sheet {
            pub fn area(&self) -> f64 { self.radius }
            fn hidden(&self) {}
            #[doc(hidden)]
            pub fn hidden_too(&self) {}
        }
        impl Drop for Sheet { fn drop(&mut self) {} }
        pub struct Unnamed;
        pub(crate) fn helper() {}
    ";
    let shown =
        outline_of("mod inner;\npub use inner::Sheet;\nfn own() {}\n#[doc(hidden)] pub use inner::Unnamed;", inner);
    for part in [
        "#[derive(Clone)]",
        "pub struct Sheet",
        "radius: f64",
        "private: _",
        "fn area(&self) -> f64",
        "impl Drop for Sheet",
    ] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    for part in ["Documentation", "nodes", "hidden", "Unnamed", "helper", "own", "mod inner", "self.radius"] {
        assert!(!shown.contains(part), "{part}: {shown}");
    }
}

#[test]
fn a_changed_signature_is_seen_and_a_changed_body_is_not() {
    let with = |function: &str| outline_of("pub mod inner;", function);
    let before = with("pub fn fold(percent: f64) -> f64 { percent }");
    assert!(before.contains("pub mod inner"), "{before}");
    assert_eq!(before, with("/// New words.\npub fn fold(percent: f64) -> f64 { 2.0 * percent }"));
    assert_ne!(before, with("pub fn fold(percent: f32) -> f64 { percent.into() }"));
    assert_ne!(before, with("fn fold(percent: f64) -> f64 { percent }"));
    assert_ne!(before, with("#[cfg(feature = \"newton\")]\npub fn fold(percent: f64) -> f64 { percent }"));
}

#[test]
fn an_item_of_a_public_module_is_told_once() {
    let shown = outline_of("pub mod inner;\npub use inner::Sheet;", "pub struct Sheet;");
    assert_eq!(shown.matches("struct Sheet").count(), 1, "{shown}");
    assert!(shown.contains("pub use inner::Sheet;"), "{shown}");
}
