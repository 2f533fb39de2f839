//! Vibrations of a free Miura sheet: rigid motions, the one in which it folds, those in which its facets bend.
//!
//! `cargo run --release --features analysis --example modes`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::analysis::{Configuration, ModeKind, Structure};
use origami::{Material, Model, Relax, Solver, generate};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pattern = generate::miura(4, 4)?;
    // Facets a hundred times stiffer than creases.
    let material = Material { ea: 1e3, k_fold: 1e-4, k_facet: 1e-2, k_face: 10.0, ..Material::default() };
    let model = Model::new(&pattern, &material)?;
    let folded = Relax { tolerance: 1e-8, ..Relax::default() }.fold_from_rest(&model, 60.0)?;

    // At rest where it is folded to.
    let mut structure = Structure::of(&model);
    structure.nodes = folded.state.positions.clone();
    let at = Configuration { positions: folded.state.positions, fold_angles: folded.state.fold_angles };
    structure.hinges.iter_mut().zip(&at.fold_angles).for_each(|(hinge, angle)| hinge.rest_angle = *angle);

    let modes = structure.modes(&at, 0.0, 12)?;
    for (i, mode) in modes.iter().enumerate() {
        println!(
            "{i:>2}  {:>10.3e}  {}",
            mode.eigenvalue,
            match mode.kind {
                ModeKind::Free => "moves as one",
                ModeKind::Creases => "folds",
                ModeKind::Facets => "bends its facets",
                ModeKind::Bars => "is stretched or sheared",
            }
        );
    }
    Ok(())
}
