//! A sheet on the table: a slider folds it, a hand takes a vertex, drags it away and lets it go.
//!
//! `cargo run --release --example interactive`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::generate::Miura;
use origami::glam::DVec3;
use origami::ids::VertexId;
use origami::scene::Targets;
use origami::solve::{Simulation, Units};
use origami::{Dynamics, Material, Model};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pattern = Miura { columns: 6, rows: 6, ..Miura::default() }.pattern()?;
    let model = Model::new(&pattern, &Material::default())?;
    let corner = model.node(VertexId(0)).ok_or("the corner is part of the sheet")?;
    let middle = model.node(VertexId::new(pattern.vertices.len() / 2)).ok_or("so is the middle")?;
    let mut sheet = Simulation::new(model, Dynamics::default())?;
    // What a viewer would draw from: x, y, z of each node, in the units of the pattern.
    let mut vertices = vec![0.0_f32; 3 * sheet.positions()?.len()];

    // A thumb holds the middle: a free sheet would fly on where the hand has thrown it.
    sheet.pin(middle)?;

    // The slider goes from 0 to 60 %; a frame is 40 steps.
    for percent in 1..=60 {
        sheet.set_targets(Targets::percent(f64::from(percent)))?;
        sheet.step(40)?;
        sheet.positions()?.write_f32(Units::File, &mut vertices);
    }
    println!("folded to 60 %: {:?}", sheet.report());

    // The hand takes a corner, lifts it by a fifth of the sheet's radius, and feels what pulls at it.
    let grabbed = sheet.positions()?.get(corner).ok_or("there is such a node")?;
    let pin = sheet.pin(corner)?;
    for frame in 1..=50 {
        sheet.move_pin(pin, grabbed + DVec3::Z * 0.2 * f64::from(frame) / 50.0)?;
        sheet.step(40)?;
    }
    let hand = sheet.reactions()?.into_iter().find(|reaction| reaction.node == corner).ok_or("it is held")?;
    println!("lifted: the hand pulls with a force of {:.2e}", hand.force.length());

    sheet.unpin(pin)?;
    let report = sheet.settle(100_000)?;
    println!("let go: {report:?}");
    let folded = sheet.finish()?;
    println!("converged: {}, residual {:.1e}", folded.converged(), folded.residual);
    Ok(())
}
