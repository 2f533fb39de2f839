//! Whether threads ever cost: the same steps on one thread and on all, beside other work that holds none, one or all of the
//! cores. `cargo run --release -p origami-tools --bin neighbours`
//!
//! Miura sheets on their way to 60 %; nanoseconds per vertex and step, means over rounds that take turns. The gain is the time
//! of one thread over that of all.

#![expect(clippy::print_stdout, reason = "its table is what it is for")]

use origami::scene::Scene;
use origami::solve::unwatched;
use std::hint::black_box;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use origami::solve::Precision;
use origami::{Dynamics, Material, Model, Relax, Solver, State, generate};

const SIDES: [usize; 3] = [55, 99, 315];
const ROUNDS: u32 = 5;
/// Long against the slices of time that the system gives to each process.
const ROUND: Duration = Duration::from_millis(800);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    let cores = std::thread::available_parallelism()?.get();
    println!("| vertices | solver | busy neighbours | one thread | {cores} threads | gain |");
    println!("|---|---|---|---|---|---|");
    for side in SIDES {
        let model = Model::new(&generate::miura(side, side)?, &Material::default())?;
        let steps = (4_000_000 / model.node_count() as u64).max(200);
        let precision = Precision::F64;
        let solvers: [(&str, Box<dyn Solver>); 2] = [
            ("dynamics", Box::new(Dynamics { steps: Some(steps), precision, ..Dynamics::default() })),
            ("relax", Box::new(Relax { steps: Some(steps), ramp: Some(0), precision, ..Relax::default() })),
        ];
        for (name, solver) in &solvers {
            let fold =
                || drop(black_box(solver.fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut unwatched)));
            for neighbours in [0, 1, cores] {
                let [alone, all] = beside(neighbours, || {
                    let mut sums = [0.0; 2];
                    for _ in 0..ROUNDS {
                        sums[0] += one.install(|| each(fold));
                        sums[1] += each(fold);
                    }
                    sums.map(|sum| 1e9 * sum / f64::from(ROUNDS) / (steps as f64 * model.node_count() as f64))
                });
                let nodes = model.node_count();
                println!("| {nodes} | {name} | {neighbours} | {alone:.0} | {all:.0} | {:.2} |", alone / all);
            }
        }
    }
    Ok(())
}

/// Seconds that `work` takes, on average over a round.
fn each(work: impl Fn()) -> f64 {
    let (start, mut times) = (Instant::now(), 0);
    while start.elapsed() < ROUND {
        work();
        times += 1;
    }
    start.elapsed().as_secs_f64() / f64::from(times)
}

/// Does `work` while so many other threads do something else without rest.
fn beside<T>(neighbours: usize, work: impl FnOnce() -> T) -> T {
    let done = AtomicBool::new(false);
    std::thread::scope(|scope| {
        for _ in 0..neighbours {
            scope.spawn(|| {
                let mut x = 1_u64;
                while !done.load(Ordering::Relaxed) {
                    x = black_box(x.wrapping_mul(3));
                }
            });
        }
        let result = work();
        done.store(true, Ordering::Relaxed);
        result
    })
}
