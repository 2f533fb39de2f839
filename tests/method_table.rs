//! Holds the tables *Where it is* of `docs/METHOD.md` against the code: every file that they name exists and defines the
//! function or type by which it is linked.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

const DOCS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs");

/// A link of the tables: the name of a function or type, and the file that defines it, seen from `docs`.
#[derive(Debug, PartialEq)]
struct Link {
    name: String,
    path: String,
}

/// The section *Where it is*.
fn section(text: &str) -> &str {
    let (_, after) = text.split_once("\n## Where it is\n").expect("the section");
    after.split("\n## ").next().unwrap_or(after)
}

/// The links ``[`name`](path)`` of a line.
fn links(line: &str) -> Vec<Link> {
    let parts = line.split("[`").skip(1).filter_map(|part| part.split_once("`]("));
    let link = |(name, rest): (&str, &str)| {
        let (path, _) = rest.split_once(')')?;
        Some(Link { name: name.to_owned(), path: path.to_owned() })
    };
    parts.filter_map(link).collect()
}

/// Whether a text of Rust or WGSL defines `name`.
fn defines(text: &str, name: &str) -> bool {
    let begins = |keyword: &str| {
        text.match_indices(&format!("{keyword} {name}")).any(|(at, found)| {
            let next = text[at + found.len()..].chars().next();
            !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
        })
    };
    begins("fn") || begins("struct")
}

/// Why a link is wrong, if it is.
fn fault(link: &Link) -> Option<String> {
    let Link { name, path } = link;
    match fs::read_to_string(Path::new(DOCS).join(path)) {
        Err(error) => Some(format!("{path}: {error}")),
        Ok(text) if !defines(&text, name) => Some(format!("{path} does not define {name}")),
        Ok(_) => None,
    }
}

fn method() -> String {
    fs::read_to_string(Path::new(DOCS).join("METHOD.md")).expect("it is there")
}

/// The rows of the tables, without their heads.
fn rows(section: &str) -> impl Iterator<Item = &str> {
    section.lines().filter(|line| line.starts_with("| ") && line.contains("]("))
}

#[test]
fn each_link_leads_to_the_code_that_it_names() {
    let method = method();
    let all: Vec<Link> = rows(section(&method)).flat_map(links).collect();
    assert!(all.len() > 40, "{} links", all.len());
    let faults: Vec<String> = all.iter().filter_map(fault).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn each_formula_has_a_plain_form_a_kernel_and_a_test() {
    let method = method();
    for row in rows(section(&method)) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').collect();
        let (plain, gpu, test) = (cells[1], cells[3], cells[cells.len() - 1]);
        for (what, cell) in [("a plain form", plain), ("a shader", gpu), ("a test", test)] {
            assert!(!links(cell).is_empty(), "{}: {what} is missing", cells[0].trim());
        }
        assert!(links(gpu).iter().all(|link| link.path.ends_with(".wgsl")), "{row}");
    }
}

/// Every pass of the fused step and every kernel of the paper's five is in a table.
#[test]
fn each_pass_is_in_a_table() {
    let method = method();
    let named: BTreeSet<String> = rows(section(&method)).flat_map(links).map(|link| link.path).collect();
    // Those that do what several others do, and those that only keep the time or copy.
    let blocks = ["block_forces", "block_dynamics", "block_relax", "block_clock", "bring_home"];
    let of_several = [&["workgroup_dynamics", "workgroup_relax", "mod"], &blocks[..]].concat();
    let mut passes = 0;
    for (rust, shaders) in [("kernels", ""), ("paper", "paper/")] {
        let folder = Path::new(DOCS).join("../crates/origami-gpu/src").join(rust);
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let stem = path.file_stem().expect("a name").to_str().expect("UTF-8");
            let is_pass = fs::read_to_string(&path).is_ok_and(|text| text.contains("const KERNEL: Kernel"));
            if !is_pass || of_several.contains(&stem) {
                continue;
            }
            passes += 1;
            // These are parts of several kernels.
            let shader = match stem {
                "reduce_forces" | "fire_move" => "fire",
                "integrate" if shaders.is_empty() => "motion",
                "loose_beams" => "loose_beam",
                _ => stem,
            };
            let wanted = format!("../shaders/src/{shaders}{shader}.wgsl");
            assert!(named.contains(&wanted), "{wanted} is in no table");
        }
    }
    assert!(passes > 15, "{passes} passes");
}

#[test]
fn a_wrong_link_is_found() {
    let link = |name: &str, path: &str| Link { name: name.to_owned(), path: path.to_owned() };
    let there = links("| beam | [`force`](../a.rs), [`tension`](../b.wgsl) | |");
    assert_eq!(there, [link("force", "../a.rs"), link("tension", "../b.wgsl")]);
    let beams = "../crates/origami-core/src/forces/beams.rs";
    assert_eq!(fault(&link("force", beams)), None);
    assert!(fault(&link("forc", beams)).is_some_and(|text| text.contains("does not define forc")), "part of a name");
    assert!(fault(&link("force", "../no/such/file.rs")).is_some());
    assert!(defines("pub struct Fire {", "Fire") && !defines("struct FireMove;", "Fire"));
    assert_eq!(section("a\n## Where it is\n| one |\n## Next\n| two |"), "| one |");
}
