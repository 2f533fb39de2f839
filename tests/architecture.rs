//! Holds `ARCHITECTURE.md` against the repository: the paths that it names exist, the core's modules use only those that
//! it allows, and in no crate do files use each other in a circle.

#[path = "architecture/circles.rs"]
mod circles;
#[path = "architecture/uses.rs"]
mod uses;

use std::fs;
use std::path::{Path, PathBuf};

use uses::Modules;

const CORE: &str = "crates/origami-core/src";
const GPU: &str = "crates/origami-gpu/src";
const SHADERS: &str = "shaders/src";
const SESSION: &str = "crates/origami-session/src";
const STUDY: &str = "crates/origami-study/src";

/// Each module of the core, and those that it may use.
const MAY_USE: [(&str, &[&str]); 22] = [
    ("csr", &[]),
    ("ids", &[]),
    ("error", &["ids"]),
    ("fold", &["error"]),
    ("pattern", &["csr", "error", "fold", "ids"]),
    ("flat", &["csr", "ids", "pattern"]),
    ("parallel", &[]),
    ("rigid", &[]),
    ("twins", &[]),
    ("generate", &["error", "ids", "pattern", "rigid"]),
    ("mesh", &["csr", "error", "ids", "pattern"]),
    ("model", &["error", "ids", "mesh", "parallel", "pattern"]),
    ("contact", &["ids", "mesh", "parallel"]),
    ("layers", &["contact", "ids", "model"]),
    ("scene", &["ids", "model"]),
    ("sequence", &["error", "fold", "ids", "model", "pattern"]),
    ("forces", &["ids", "model", "scene"]),
    ("kernel", &["csr", "forces", "ids", "model", "parallel", "scene", "twins"]),
    (
        "solve",
        &[
            "contact", "csr", "error", "flat", "forces", "ids", "kernel", "layers", "mesh", "model", "parallel",
            "scene", "sequence", "twins",
        ],
    ),
    ("analysis", &["error", "fold", "forces", "ids", "mesh", "model", "pattern", "scene", "solve"]),
    ("measure", &["contact", "error", "flat", "forces", "ids", "mesh", "model", "pattern", "rigid", "scene", "solve"]),
    ("export", &["error", "fold", "ids", "measure", "model", "pattern", "scene", "sequence", "solve"]),
];

/// The workspace's crates: where each has its sources, and the file of its root module.
const CRATES: [(&str, &str); 12] = [
    (CORE, "lib.rs"),
    ("crates/origami-formats/src", "lib.rs"),
    (GPU, "lib.rs"),
    ("crates/origami-picture/src", "lib.rs"),
    (STUDY, "lib.rs"),
    ("crates/origami-cli/src", "main.rs"),
    (SHADERS, "lib.rs"),
    (SESSION, "lib.rs"),
    ("web/src", "lib.rs"),
    ("web/worker/src", "lib.rs"),
    ("bindings/python/src", "lib.rs"),
    ("src", "lib.rs"),
];

/// Circles of files that are still there, by crate, in order. One that is gone must leave this list, and none may be added.
const KNOWN: [(&str, &[&str]); 0] = [];

/// Text that no line of code in a folder may hold, and why.
const NOT_IN: [(&str, &str, &str); 26] = [
    (CORE, "wgpu", "the core knows no GPU"),
    (CORE, "naga", "the core knows no GPU"),
    (GPU, "clap", "the GPU's package knows no command line"),
    (GPU, "indicatif", "the GPU's package knows no terminal"),
    (GPU, "println!", "a library does not print"),
    (GPU, "HashMap", "the order of a hash map is not the same in every run"),
    (CORE, "clap", "the core knows no command line"),
    (CORE, "indicatif", "the core knows no terminal"),
    (CORE, "println!", "a library does not print"),
    ("crates/origami-core/src/solve", "HashMap", "the order of a hash map is not the same in every run"),
    ("crates/origami-core/src/analysis", "HashMap", "the order of a hash map is not the same in every run"),
    ("crates/origami-core/src/forces", "acos(", "its slope is infinite at 0 and pi, and rounding makes it NaN"),
    ("crates/origami-core/src/forces", "asin(", "its slope is infinite at -1 and 1"),
    ("crates/origami-picture/src", "wgpu", "pictures need no GPU"),
    ("crates/origami-picture/src", "clap", "pictures know no command line"),
    ("crates/origami-picture/src", "HashMap", "the order of a hash map is not the same in every run"),
    (SESSION, "HashMap", "the order of a hash map is not the same in every run"),
    (SESSION, "println!", "a library does not print"),
    (SESSION, "std::net", "a session does not know what carries its messages"),
    (SESSION, "std::thread", "a session runs where there are no threads"),
    (SESSION, "Instant", "a session runs where there is no clock"),
    (STUDY, "clap", "studies know no command line"),
    (STUDY, "indicatif", "studies know no terminal"),
    (STUDY, "println!", "a library does not print"),
    (STUDY, "HashMap", "the order of a hash map is not the same in every run"),
    ("crates/origami-core/src/mesh/sides.rs", "DVec3", "topology knows no positions"),
];

/// Text that stands in no file of the core but those, which are left out without a feature.
const ONLY_IN: [(&str, &[&str]); 5] = [
    ("rayon", &["parallel/pool.rs"]),
    ("std::thread", &[]),
    ("Instant", &["kernel/parallelism.rs"]),
    ("std::fs", &["export/atomic.rs", "fold/read.rs"]),
    ("tempfile", &["export/atomic.rs"]),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All Rust files at or below `path`, in order.
fn sources(path: &Path) -> Vec<PathBuf> {
    files(path, "rs")
}

/// All files with an extension at or below `path`, in order.
fn files(path: &Path, extension: &str) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path.to_owned()];
    }
    let entries = fs::read_dir(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut entries: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    entries.sort();
    let below = entries.iter().flat_map(|e| if e.is_dir() { files(e, extension) } else { vec![e.clone()] });
    below.filter(|file| file.extension().is_some_and(|own| own == extension)).collect()
}

/// Whether a file holds tests alone, which may use what they like.
fn of_tests(file: &Path) -> bool {
    let within = file.strip_prefix(root()).unwrap_or(file);
    file.ends_with("tests.rs") || within.components().any(|part| part.as_os_str() == "tests")
}

/// The lines of code before the tests, without comments.
fn code(text: &str) -> impl Iterator<Item = &str> {
    let code = text.split("\nmod tests {").next().unwrap_or_default();
    code.lines().map(|line| line.split("//").next().unwrap_or_default())
}

/// The modules of a crate of the workspace.
fn modules(sources_of: &str, crate_root: &str) -> Modules {
    let folder = root().join(sources_of);
    let text = |path: PathBuf| {
        let name = path.strip_prefix(&folder).expect("below it").to_str().expect("UTF-8").replace('\\', "/");
        (name, fs::read_to_string(path).expect("UTF-8"))
    };
    Modules::read(&sources(&folder).into_iter().map(text).collect(), crate_root)
}

/// The first part of a path: the module of the crate's root that a file belongs to.
fn module_of(file: &str) -> &str {
    file.split('/').next().unwrap_or_default().trim_end_matches(".rs")
}

/// Uses of one of the core's modules by another that may not.
fn forbidden(core: &Modules) -> Vec<String> {
    let may = |module: &str, used: &str| {
        module == used || MAY_USE.iter().any(|(known, allowed)| *known == module && allowed.contains(&used))
    };
    // The root re-exports what it likes.
    let uses =
        core.uses().into_iter().filter(|tie| tie.from != "lib.rs" && !may(module_of(&tie.from), module_of(&tie.to)));
    uses.map(|tie| format!("{}:{} uses {} of {}", tie.from, tie.line, tie.path, tie.to)).collect()
}

/// What stands in backticks and looks like a path.
fn paths(text: &str) -> Vec<&str> {
    let quoted = text.split('`').skip(1).step_by(2);
    quoted.filter(|p| !p.contains(char::is_whitespace) && (p.contains('/') || p.ends_with(".md"))).collect()
}

#[test]
fn named_paths_exist() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let paths = paths(&text);
    assert!(paths.len() > 20, "only {} paths", paths.len());
    let missing: Vec<&&str> = paths.iter().filter(|path| !root().join(path).exists()).collect();
    assert!(missing.is_empty(), "ARCHITECTURE.md names {missing:?}");
}

#[test]
fn modules_use_what_they_may() {
    let found = forbidden(&modules(CORE, "lib.rs"));
    assert!(found.is_empty(), "MAY_USE does not allow:\n{}", found.join("\n"));
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let mut unknown = String::new();
    let mut gone: Vec<&(&str, &[&str])> = KNOWN.iter().collect();
    for (folder, root) in CRATES {
        for circle in circles::of(&modules(folder, root)) {
            let is_it = |(within, files): &(&str, &[&str])| {
                *within == folder && circle.files.iter().map(String::as_str).eq(files.iter().copied())
            };
            if KNOWN.iter().any(is_it) {
                gone.retain(|known| !is_it(known));
            } else {
                unknown += &format!("{folder}: {circle}");
            }
        }
    }
    assert!(unknown.is_empty(), "circles that are not known:\n{unknown}");
    assert!(gone.is_empty(), "these circles are gone; take them from the list: {gone:?}");
}

#[test]
fn no_module_is_left_out() {
    let text = fs::read_to_string(root().join(CORE).join("lib.rs")).expect("UTF-8");
    let modules = code(&text).filter_map(|line| line.strip_prefix("pub mod ").or_else(|| line.strip_prefix("mod ")));
    let modules: Vec<&str> = modules.map(|name| name.trim_end_matches(';')).collect();
    assert_eq!(modules.len(), MAY_USE.len(), "{modules:?}");
    let unknown: Vec<_> = modules.iter().filter(|name| MAY_USE.iter().all(|(known, _)| known != *name)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

#[test]
fn folders_hold_nothing_that_they_should_not() {
    for (folder, word, why) in NOT_IN {
        for file in sources(&root().join(folder)) {
            let text = fs::read_to_string(&file).expect("UTF-8");
            let line = code(&text).position(|line| line.contains(word));
            assert_eq!(line, None, "{}: {word}: {why}", file.display());
        }
    }
    let manifest = fs::read_to_string(root().join("crates/origami-core/Cargo.toml")).expect("UTF-8");
    let foreign = ["wgpu", "naga", "clap", "indicatif", "origami-gpu"];
    assert!(!foreign.iter().any(|name| manifest.contains(name)), "a dependency of the core");
    let manifest = fs::read_to_string(root().join("crates/origami-gpu/Cargo.toml")).expect("UTF-8");
    assert!(!["clap", "indicatif"].iter().any(|name| manifest.contains(name)), "a dependency of the GPU's package");
    for package in [GPU, SHADERS, SESSION, STUDY] {
        let library = fs::read_to_string(root().join(package).join("lib.rs")).expect("UTF-8");
        assert!(library.contains("#![forbid(unsafe_code)]"), "{package}");
    }
    let library = fs::read_to_string(root().join(CORE).join("lib.rs")).expect("UTF-8");
    assert!(library.contains("#![forbid(unsafe_code)]"));
}

/// Without its features `parallel` and `files` the core shall run where there are no threads, no files and no clock.
#[test]
fn threads_files_and_clocks_stay_behind_their_features() {
    for (word, files) in ONLY_IN {
        let mut found: Vec<String> = Vec::new();
        for file in sources(&root().join(CORE)).iter().filter(|file| !of_tests(file)) {
            if code(&fs::read_to_string(file).expect("UTF-8")).any(|line| line.contains(word)) {
                let within = file.strip_prefix(root().join(CORE)).expect("below it");
                found.push(within.to_str().expect("UTF-8").replace('\\', "/"));
            }
        }
        assert_eq!(found, files, "{word}");
    }
}

/// Names of shaders that call what some adapters are bad at.
fn coarse<'t>(shaders: &[(&'t str, &str)]) -> Vec<&'t str> {
    let calls = |text: &str| code(text).any(|line| line.contains("acos(") || line.contains("asin("));
    shaders.iter().filter(|(_, text)| calls(text)).map(|(name, _)| *name).collect()
}

/// Sections of a manifest that name dependencies.
fn dependencies(manifest: &str) -> Vec<&str> {
    manifest.lines().filter(|line| line.starts_with('[') && line.contains("dependencies")).collect()
}

/// Names of shaders that no line `... = "name";` of the library gives.
fn unregistered<'n>(names: &[&'n str], library: &str) -> Vec<&'n str> {
    names.iter().filter(|name| !library.contains(&format!(" = \"{name}\";"))).copied().collect()
}

/// Every shader, by its path below the folder of shaders.
fn shaders() -> Vec<(String, String)> {
    let folder = root().join(SHADERS);
    let shader = |path: PathBuf| {
        let name = path.strip_prefix(&folder).expect("below it").to_str().expect("UTF-8").replace('\\', "/");
        (name, fs::read_to_string(path).expect("UTF-8"))
    };
    files(&folder, "wgsl").into_iter().map(shader).collect()
}

#[test]
fn shaders_need_nothing_and_are_all_registered() {
    let manifest = fs::read_to_string(root().join("shaders/Cargo.toml")).expect("UTF-8");
    assert!(dependencies(&manifest).is_empty(), "shaders are text alone");
    let shaders = shaders();
    assert!(shaders.len() > 30, "{} shaders", shaders.len());
    let borrowed: Vec<(&str, &str)> = shaders.iter().map(|(name, text)| (name.as_str(), text.as_str())).collect();
    assert!(
        coarse(&borrowed).is_empty(),
        "acos and asin are off by up to 4e-4 on some adapters: {:?}",
        coarse(&borrowed)
    );
    let names: Vec<&str> = borrowed.iter().map(|(name, _)| *name).collect();
    let library = fs::read_to_string(root().join(SHADERS).join("lib.rs")).expect("UTF-8");
    assert!(unregistered(&names, &library).is_empty(), "{:?}", unregistered(&names, &library));
}

/// `kernels` goes with the shaders themselves, `paper` with those of the same folder.
#[test]
fn each_kernel_has_the_shader_of_its_name() {
    let shaders = shaders();
    let entry_points = |(_, text): &&(String, String)| code(text).any(|line| line.starts_with("@compute"));
    for (folder, shaders_in) in [("kernels", ""), ("paper", "paper/")] {
        let mut kernels: Vec<String> = Vec::new();
        for file in sources(&root().join(GPU).join(folder)) {
            let text = fs::read_to_string(&file).expect("UTF-8");
            if code(&text).any(|line| line.contains("const KERNEL: Kernel")) {
                kernels
                    .push(format!("{shaders_in}{}.wgsl", file.file_stem().expect("a name").to_str().expect("UTF-8")));
            }
        }
        let here =
            |(name, _): &&(String, String)| name.strip_prefix(shaders_in).is_some_and(|file| !file.contains('/'));
        let with_entry = shaders.iter().filter(here).filter(entry_points).map(|(name, _)| name.clone());
        assert!(kernels.len() >= 5, "{folder}: {kernels:?}");
        assert_eq!(kernels, with_entry.collect::<Vec<_>>(), "{folder}: kernels in Rust, entry points in WGSL");
    }
}

#[test]
fn the_checks_can_fail() {
    assert_eq!(
        coarse(&[("a", "let x = acos(y);"), ("b", "let x = y; // not asin(y)"), ("c", "asin(1.0)")]),
        ["a", "c"]
    );
    assert_eq!(
        dependencies("[package]\n[dependencies]\na = 1\n[dev-dependencies]"),
        ["[dependencies]", "[dev-dependencies]"]
    );
    assert_eq!(unregistered(&["a.wgsl", "b.wgsl"], "A = \"a.wgsl\";\nAB = \"ab.wgsl\";"), ["b.wgsl"]);
    assert_eq!(code("let a = b.acos(); // why").filter(|line| line.contains("acos(")).count(), 1);
    assert_eq!(paths("see `src/lib.rs`, `a b/c`, `Model::new` and `README.md`"), ["src/lib.rs", "README.md"]);
}

#[test]
fn a_use_that_is_not_allowed_is_found() {
    let core = |mesh: &str| {
        let roots = "pub mod mesh; pub mod model; pub use model::Model;";
        forbidden(&Modules::made_up(&[
            ("lib.rs", roots),
            ("mesh.rs", mesh),
            ("model.rs", "pub struct Model; pub struct Beam;"),
        ]))
    };
    assert_eq!(core("use crate::model::Beam;"), ["mesh.rs:1 uses crate::model::Beam of model.rs"]);
    assert_eq!(core("\nfn f(_: &crate::Model) {}"), ["mesh.rs:2 uses crate::Model of model.rs"]);
    assert_eq!(core("use super::{model as m}; pub struct M(m::Beam);").len(), 1);
    assert!(core("// crate::model\n#[cfg(test)]\nmod tests { use crate::model::Beam; }").is_empty());
}
