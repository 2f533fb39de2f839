//! What a step takes by set of instructions, also those that are not this processor's best, beside each other in one run:
//!
//! `cargo run --release -p origami-tools --bin lanes -- [VERTICES ...]`
//!
//! The three passes of the paper's scheme and nothing else, one thread, Miura sheets on their way to 60 %. All take turns, for ten
//! milliseconds each time; the table has the least and the median of 60 turns, in nanoseconds for each vertex and step.

#![expect(clippy::print_stdout, reason = "its table is what it is for")]

use std::error::Error;
use std::time::{Duration, Instant};

use origami::scene::Scene;
use origami::solve::{BareKernel, Precision, time_step, unwatched};
use origami::{Dynamics, Material, Model, Solver, State, generate};

const TURNS: usize = 60;
const TURN: Duration = Duration::from_millis(10);

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<usize> = std::env::args().skip(1).map(|arg| arg.parse()).collect::<Result<_, _>>()?;
    println!("| vertices | numbers | instructions | least | median |");
    println!("|---|---|---|---|---|");
    for vertices in if asked.is_empty() { vec![100, 1024, 10_000, 99_856] } else { asked } {
        let panels = vertices.isqrt().saturating_sub(1).max(1);
        let model = Model::new(&generate::miura(panels, panels)?, &Material::default())?;
        let to_start = Dynamics { steps: Some(200), ..Dynamics::default() };
        let start = to_start.fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut unwatched)?.state;
        let targets = model.targets(60.0);
        let mut rows = Vec::new();
        for precision in [Precision::F64, Precision::Mixed] {
            for name in BareKernel::instructions() {
                let kernel = BareKernel::by(name, precision, &model, &start, &targets).ok_or(name)?;
                rows.push((precision, name, kernel, Vec::new()));
            }
        }
        let dt = time_step::paper(&model);
        for _ in 0..TURNS {
            for (.., kernel, times) in &mut rows {
                let (began, mut steps) = (Instant::now(), 0.0);
                while began.elapsed() < TURN {
                    kernel.step(dt);
                    steps += 1.0;
                }
                times.push(began.elapsed().as_secs_f64() * 1e9 / (steps * model.node_count() as f64));
            }
        }
        for (precision, name, _, times) in &mut rows {
            times.sort_by(f64::total_cmp);
            let (least, median) = (times[0], times[TURNS / 2]);
            println!("| {} | {} | {name} | {least:.1} | {median:.1} |", model.node_count(), precision.name());
        }
    }
    Ok(())
}
