//! How far the GPU's arithmetic ends from that of the processor, which computes in f64. Prints Markdown tables.
//!
//! `cargo run --release -p origami-tools --bin precision -- [FILE.fold ...]`; `ORIGAMI_ADAPTER` chooses the adapter.
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

use origami::scene::Scene;
use origami::solve::unwatched;
use std::error::Error;
use std::path::Path;

use origami::gpu::{AdapterChoice, Gpu, PaperDynamics};
use origami::measure::align;
use origami::solve::{Failed, TimeStep};
use origami::{CreasePattern, Dynamics, Folded, Material, Model, Relax, Solver, State};

const PERCENT: f64 = 60.0;
const STEPS: [u64; 3] = [300, 3_000, 20_000];
const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-8];
const PATTERNS: [&str; 8] = ["bird-base", "crane", "curved-pleat", "fan", "hypar", "kresling", "miura", "waterbomb"];

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::open(&AdapterChoice::from_env())?;
    println!("Adapter: {}, {}, driver {}\n", gpu.adapter(), gpu.adapter().kind, gpu.adapter().driver);
    let mut files: Vec<String> = std::env::args().skip(1).collect();
    if files.is_empty() {
        files = PATTERNS.map(|name| format!("examples/patterns/{name}.fold")).into();
    }
    let models = files.iter().map(|file| {
        let name = Path::new(file).file_stem().map_or(file.as_str().into(), |stem| stem.to_string_lossy());
        Ok((name.into_owned(), Model::new(&CreasePattern::read(file)?, &Material::default())?))
    });
    let models: Vec<(String, Model)> = models.collect::<Result<_, Box<dyn Error>>>()?;
    of_dynamics(&gpu, &models);
    of_relax(&gpu, &models);
    Ok(())
}

fn fold(solver: &dyn Solver, model: &Model) -> Result<Folded, Failed> {
    solver.fold(model, &State::at_rest(model), &Scene::percent(PERCENT), &mut unwatched)
}

/// The distance of the vertex that is farthest from where the processor has it, in radii: as it is, and after the best
/// rigid motion (nothing holds a free sheet where it is, nor damps its turning).
fn of_dynamics(gpu: &Gpu, models: &[(String, Model)]) {
    let head = STEPS.map(|steps| format!(" plain f32, {steps} steps | ours, {steps} steps |")).concat();
    println!("| pattern | vertices |{head}\n|---|---|{}", "---|".repeat(2 * STEPS.len()));
    for (name, model) in models {
        let columns = STEPS.map(|steps| {
            let reference = Dynamics { steps: Some(steps), ..Dynamics::default() };
            let plain = PaperDynamics {
                gpu: gpu.clone(),
                time_step: TimeStep::Paper,
                steps,
                read_every: PaperDynamics::READ_EVERY,
            };
            let ours = gpu.with(reference.clone());
            let Ok(reference) = fold(&reference, model) else { return " diverges | diverges |".to_owned() };
            let solvers: [&dyn Solver; 2] = [&plain, &ours];
            let far = solvers.map(|solver| match fold(solver, model) {
                Ok(folded) => {
                    let shape = align(&folded.state.positions, &reference.state.positions).max;
                    format!(" {:.1e}, {shape:.1e} |", farthest(&folded, &reference))
                }
                Err(failed) => format!(" {failed} |"),
            });
            far.concat()
        });
        println!("| {name} | {} |{}", model.node_count(), columns.concat());
    }
}

fn farthest(a: &Folded, b: &Folded) -> f64 {
    let pairs = a.state.positions.iter().zip(&b.state.positions);
    pairs.map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

/// The same of the folded state after the best rigid motion, for smaller and smaller tolerances; the largest force on a
/// vertex.
fn of_relax(gpu: &Gpu, models: &[(String, Model)]) {
    println!("\n| pattern | tolerance | shape | converged, evaluations: CPU | GPU | residual: CPU | GPU |");
    println!("|---|---|---|---|---|---|---|");
    for (name, model) in models {
        for tolerance in TOLERANCES {
            // Enough for the CPU; who has not converged by then has come to the end of its digits.
            let relax = Relax { tolerance, max_steps: 20_000, ..Relax::default() };
            let solvers: [&dyn Solver; 2] = [&relax, &gpu.with(relax.clone())];
            let [cpu, gpu] = solvers.map(|solver| fold(solver, model));
            let (Ok(cpu), Ok(gpu)) = (cpu, gpu) else {
                println!("| {name} | {tolerance:.0e} | diverges | | | | |");
                continue;
            };
            let far = align(&gpu.state.positions, &cpu.state.positions).max;
            let ended =
                |folded: &Folded| format!("{}, {}", if folded.converged() { "yes" } else { "no" }, folded.steps);
            let ends = [ended(&cpu), ended(&gpu)].join(" | ");
            println!("| {name} | {tolerance:.0e} | {far:.1e} | {ends} | {:.1e} | {:.1e} |", cpu.residual, gpu.residual);
        }
    }
}
