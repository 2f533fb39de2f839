//! Holds the claims of `relax` against tighter solutions and the paper's scheme, and prints a Markdown table.
//!
//! `cargo run --release -p origami-tools --bin convergence -- FILE.fold ...`
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

use origami::scene::Scene;
use origami::solve::unwatched;
use std::error::Error;

use origami::measure::align;
use origami::{CreasePattern, Dynamics, Folded, Material, Model, Relax, Solver, State};

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| pattern | vertices | % | evaluations | converged | estimate | moved to 1e-6 | energy | paper's scheme |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for path in std::env::args().skip(1) {
        let model = Model::new(&CreasePattern::read(&path)?, &Material::default())?;
        let name = std::path::Path::new(&path).file_stem().map(|s| s.to_string_lossy().into_owned());
        for percent in [60.0, 100.0] {
            println!("| {} {}", name.as_deref().unwrap_or(&path), row(&model, percent)?);
        }
    }
    Ok(())
}

fn row(model: &Model, percent: f64) -> Result<String, Box<dyn Error>> {
    let fold =
        |solver: &dyn Solver| solver.fold(model, &State::at_rest(model), &Scene::percent(percent), &mut unwatched);
    let energy = |folded: &Folded| folded.state.energy(model).total();
    let claim = fold(&Relax::default())?;
    let tight = fold(&Relax { tolerance: 1e-6, ..Relax::default() })?;
    let paper = match fold(&Dynamics { ramp: 1000, steps: Some(3000), ..Dynamics::default() }) {
        Ok(paper) => format!("{:.3e}", energy(&paper)),
        Err(_) => "diverged".to_owned(),
    };
    Ok(format!(
        "| {} | {percent} | {} | {} | {:.0e} | {:.0e} | {:.3e} | {paper} |",
        model.node_count(),
        claim.steps,
        if claim.converged() { "yes" } else { "no" },
        claim.distance,
        align(&claim.state.positions, &tight.state.positions).max,
        energy(&claim),
    ))
}
