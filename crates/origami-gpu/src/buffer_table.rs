//! Holds the tables of buffers in `shaders/README.md` against the shaders.

use std::collections::{BTreeMap, BTreeSet};

use origami_core::generate::miura;
use origami_core::{Material, Model};

use crate::kernels::{
    Kernel, Per, block_clock, block_dynamics, block_forces, block_relax, bring_home, checkpoint, contact_aim,
    contact_clock, contact_move, contact_reduce, fire_move, fire_update, fold_angles, integrate, loose_beams,
    pair_forces, pair_limits, reduce_forces, row_sums, safe_time_step, settle_decide, settle_windows, state_bounds,
    stiffness_max, triangle_forces, workgroup_dynamics, workgroup_relax,
};
use crate::paper::PASSES;
use crate::shader_checks::{Checked, accesses, checked};
use crate::sheet_arrays::SheetArrays;
use crate::testing::variants;
use crate::variant::{Scheme, Variant};

const KERNELS: [&Kernel; 27] = [
    &fold_angles::KERNEL,
    &triangle_forces::KERNEL,
    &loose_beams::KERNEL,
    &integrate::KERNEL,
    &row_sums::KERNEL,
    &stiffness_max::KERNEL,
    &safe_time_step::KERNEL,
    &reduce_forces::KERNEL,
    &fire_update::KERNEL,
    &fire_move::KERNEL,
    &settle_windows::KERNEL,
    &settle_decide::KERNEL,
    &state_bounds::KERNEL,
    &checkpoint::KERNEL,
    &workgroup_dynamics::KERNEL,
    &workgroup_relax::KERNEL,
    &block_forces::KERNEL,
    &block_clock::KERNEL,
    &block_dynamics::KERNEL,
    &bring_home::KERNEL,
    &block_relax::KERNEL,
    &pair_forces::KERNEL,
    &contact_reduce::KERNEL,
    &contact_aim::KERNEL,
    &pair_limits::KERNEL,
    &contact_move::KERNEL,
    &contact_clock::KERNEL,
];

/// By binding: the buffer's name, the kernels that write it and those that read it.
type Table = BTreeMap<u32, (String, BTreeSet<String>, BTreeSet<String>)>;

/// The rows below a heading, up to the next. *All* is every kernel, and the host is no kernel.
fn table(text: &str, heading: &str, all: &[&str]) -> Table {
    let (_, part) = text.split_once(&format!("\n## {heading}\n")).expect("the heading");
    let rows = part.split("\n## ").next().expect("a part").lines().filter_map(|line| line.strip_prefix("| "));
    let name = |cell: &str| cell.trim().trim_matches('`').to_owned();
    let kernels = |cell: &str| -> BTreeSet<String> {
        let names = cell.split(',').map(name).filter(|kernel| kernel != "host" && !kernel.is_empty());
        let every = |kernel: String| if kernel == "all" { all.iter().map(|k| name(k)).collect() } else { vec![kernel] };
        names.flat_map(every).collect()
    };
    let row = |row: &str| {
        let cells: Vec<&str> = row.trim_end_matches('|').split('|').collect();
        let binding = cells[0].trim().parse().ok()?;
        assert_eq!(cells.len(), 7, "{row}");
        Some((binding, (name(cells[1]), kernels(cells[5]), kernels(cells[6]))))
    };
    rows.filter_map(row).collect()
}

/// The same as the shaders have it.
fn found(kernels: impl IntoIterator<Item = (&'static str, &'static str, Checked)>) -> Table {
    let mut found = Table::new();
    for (name, entry, shader) in kernels {
        let names = shader.buffers();
        for (binding, (reads, writes)) in accesses(&shader, entry) {
            let row =
                found.entry(binding).or_insert_with(|| (names[&binding].clone(), BTreeSet::new(), BTreeSet::new()));
            assert_eq!(row.0, names[&binding], "one name for binding {binding}");
            if writes {
                row.1.insert(name.to_owned());
            }
            if reads {
                row.2.insert(name.to_owned());
            }
        }
    }
    found
}

/// In the program, so that it runs on a machine that has not the source.
const README: &str = include_str!("../../../shaders/README.md");

fn assert_same(reported: &Table, there: &Table) {
    assert!(!there.is_empty());
    for binding in reported.keys().chain(there.keys()) {
        assert_eq!(reported.get(binding), there.get(binding), "binding {binding}: in README.md, in the shaders");
    }
}

#[test]
fn the_pipeline_has_the_buffers_that_the_table_tells() {
    let model = Model::new(&miura(2, 2).expect("valid"), &Material::default()).expect("a generated pattern");
    let variant = Variant::new(&SheetArrays::new(&model), Scheme::Relax, Some(Material::default()));
    // With and without what a sheet may have.
    let several = |k: &&&Kernel| !k.name.starts_with("workgroup") && k.springs;
    let blocks = |k: &&&Kernel| k.per == Per::Block || k.name == "checkpoint" || k.name.starts_with("workgroup");
    let in_blocks = Variant { blocks: Some(variants::extent()), loads: true, ..variant.clone() };
    let plain = KERNELS
        .iter()
        .filter(|k| k.per != Per::Block && !k.name.starts_with("workgroup"))
        .map(|k| (*k, variant.clone()));
    let rich = KERNELS.iter().filter(several).filter(|k| k.per != Per::Block);
    let rich = rich.map(|k| (*k, Variant { rigidities: true, softens: true, ..variant.clone() }));
    let blocks = KERNELS.iter().filter(blocks).map(|k| (*k, in_blocks.clone()));
    let settling = [(&settle_windows::KERNEL, variants::in_contact(false))];
    let there = found(
        plain
            .chain(rich)
            .chain(blocks)
            .chain(settling)
            .map(|(k, variant)| (k.name, k.entry, checked(k.name, &k.source(&variant)))),
    );
    let reported = table(README, "The pipeline", &KERNELS.map(|k| k.name));
    assert_same(&reported, &there);
}

#[test]
fn the_papers_passes_have_the_buffers_that_the_table_tells() {
    let variant = variants::plain();
    let there = found(PASSES.iter().map(|pass| (pass.name, pass.entry, checked(pass.name, &pass.source(&variant)))));
    assert_same(&table(README, "The paper's five passes", &[]), &there);
}

#[test]
fn a_wrong_table_is_found() {
    let text = "\n## A\n\n| binding | buffer |\n|---|---|\n| 3 | `sums` | a | b | c | host, `one` | all |\n\n## B\n| 4 | `x` |";
    let reported = table(text, "A", &["one", "two"]);
    let names = |names: &[&str]| names.iter().map(ToString::to_string).collect::<BTreeSet<String>>();
    let there = Table::from([(3, ("sums".to_owned(), names(&["one"]), names(&["one", "two"])))]);
    assert_same(&reported, &there);
    let differs = |other: Table| std::panic::catch_unwind(|| assert_same(&reported, &other)).is_err();
    let row = &there[&3];
    assert!(differs(Table::from([(3, ("total".to_owned(), row.1.clone(), row.2.clone()))])), "name");
    assert!(differs(Table::from([(2, row.clone())])), "binding");
    assert!(differs(Table::from([(3, row.clone()), (4, row.clone())])), "a buffer that is not reported");
    assert!(differs(Table::from([(3, (row.0.clone(), names(&[]), row.2.clone()))])), "who writes");
}
