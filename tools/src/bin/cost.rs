//! Cost of a step against the size of the sheet, as a table and a plot (SVG):
//!
//! `cargo run --release -p origami-tools --bin cost -- docs/accuracy/cost.svg`
//!
//! Miura sheets folded to 60 % and moved on from there; the least of five runs. A step is one evaluation of all forces and one
//! move. The difference of a long and a short run leaves out what is done once.

#![expect(clippy::print_stdout, reason = "its table is what it is for")]

use origami::scene::Scene;
use origami::solve::unwatched;
use std::time::Instant;

use origami::solve::Precision;
use origami::study::{Axis, Mark, Plot, Scale, Series};
use origami::{Dynamics, Material, Model, Relax, Solver, State, generate};

/// Panels along each side.
const SIDES: [usize; 7] = [4, 9, 17, 31, 55, 99, 315];

/// A solver that takes so many steps.
type Steps = Box<dyn Fn(u64) -> Box<dyn Solver>>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("the name of an SVG file is missing")?;
    let dynamics = |precision| {
        move |steps| Box::new(Dynamics { steps: Some(steps), precision, ..Dynamics::default() }) as Box<dyn Solver>
    };
    let relax = |precision| {
        move |steps| {
            Box::new(Relax { steps: Some(steps), ramp: Some(0), precision, ..Relax::default() }) as Box<dyn Solver>
        }
    };
    let solvers: [(&str, Steps); 4] = [
        ("dynamics, f64", Box::new(dynamics(Precision::F64))),
        ("dynamics, mixed", Box::new(dynamics(Precision::Mixed))),
        ("relax, f64", Box::new(relax(Precision::F64))),
        ("relax, mixed", Box::new(relax(Precision::Mixed))),
    ];
    // A fold on one of a pool's threads takes that one alone.
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let mut series = Vec::new();
    println!("| solver | threads | {} |", SIDES.map(|side| ((side + 1) * (side + 1)).to_string()).join(" | "));
    println!("|---|---|{}", "---|".repeat(SIDES.len()));
    for (name, solver) in &solvers {
        for alone in [true, false] {
            let mut points = Vec::new();
            for side in SIDES {
                let model = Model::new(&generate::miura(side, side)?, &Material::default())?;
                let cost = |steps: u64| {
                    let solver = solver(steps);
                    let start = State::at_rest(&model);
                    let once = || {
                        let began = Instant::now();
                        drop(solver.fold(&model, &start, &Scene::percent(60.0), &mut unwatched));
                        began.elapsed().as_secs_f64()
                    };
                    let run = || (0..5).map(|_| once()).fold(f64::INFINITY, f64::min);
                    if alone { one.install(run) } else { run() }
                };
                let nodes = model.node_count() as f64;
                let steps = (2_000_000 / model.node_count() as u64).max(60);
                let nanoseconds = (cost(2 * steps) - cost(steps)) / (steps as f64 * nodes) * 1e9;
                points.push((nodes, nanoseconds));
            }
            let threads = if alone { "one" } else { "all" };
            let row = points.iter().map(|(_, cost)| format!("{cost:.0}")).collect::<Vec<_>>();
            println!("| {name} | {threads} | {} |", row.join(" | "));
            let mark = if alone { Mark::Line } else { Mark::Dashed };
            series.push(Series { label: format!("{name}, {threads}"), mark, points });
        }
    }
    let plot = Plot {
        title: "Cost of a step against the size of the sheet".into(),
        note: "Miura sheets on their way to 60 %; one thread, and dashed as many as there are".into(),
        x: Axis { label: "vertices".into(), scale: Scale::Log },
        y: Axis { label: "nanoseconds per vertex and step".into(), scale: Scale::Log },
        series,
    };
    std::fs::write(path, plot.svg()?)?;
    Ok(())
}
