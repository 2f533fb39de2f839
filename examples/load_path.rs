//! Presses a Kresling tube until it snaps, and through: where the load turns back, and what it takes to get over.
//!
//! `cargo run --release --features analysis --example load_path`, or with the path of another pair of a FOLD file and a job,
//! without extension: `-- examples/analysis/miura-pop-through`.
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use std::ops::ControlFlow;
use std::time::Instant;

use origami::analysis::job::Job;
use origami::analysis::{Event, Path, Start};
use origami::fold::Document;
use origami::{CreasePattern, Material, Model};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).unwrap_or_else(|| "examples/analysis/kresling".to_owned());
    let document = Document::read(format!("{name}.fold"))?;
    let frame = document.frame(document.pattern_frame()?)?;
    let pattern = CreasePattern::from_frame(&frame)?;
    let model = Model::new(&pattern, &Material::default())?;
    let setup = Job::from_slice(&std::fs::read(format!("{name}.json"))?)?.setup(&frame, &pattern, &model)?;
    // A structure is plain data: what the job does not say can be changed here.
    let structure = &setup.structure;
    let path = Path { tolerance: 1e-11, ..setup.path.clone() };

    let top = setup.monitors[0].1;
    let clock = Instant::now();
    let trace = structure.trace(&Start::default(), &path, &mut |_| ControlFlow::Continue(()))?;
    let seconds = clock.elapsed().as_secs_f64();
    for point in trace.events() {
        let height = point.displacement(&structure.nodes, top);
        let what = match &point.event {
            Event::LimitPoint { .. } => "the load turns back",
            Event::Bifurcation { modes, .. } if modes.len() == 1 => "another path branches off",
            Event::Bifurcation { .. } => "several paths branch off",
            _ => "nothing acts",
        };
        println!("at {height:+.4} load factor {:+.6}, {} negative: {what}", point.load_factor, point.negative);
    }
    for state in trace.equilibria() {
        match state.barrier {
            Some(barrier) => println!("state of energy {:.6}: a barrier of {barrier:.6} to the next", state.energy),
            None => println!("state of energy {:.6}, index {}: no barrier known", state.energy, state.index),
        }
    }
    let (points, unknowns) = (trace.points.len(), structure.unknowns());
    println!("{points} points of {unknowns} unknowns in {seconds:.2} s, ended: {:?}", trace.ended);
    Ok(())
}
