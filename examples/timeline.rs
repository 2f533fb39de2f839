//! A folding order: first one half of the creases, then the other, and a film of it.
//!
//! `cargo run --release --example timeline`, which writes `timeline.fold`.
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::export::{Pose, animation, write_whole};
use origami::fold::Document;
use origami::ids::EdgeId;
use origami::scene::Timeline;
use origami::solve::Simulation;
use origami::{CreasePattern, Material, Model, Relax};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let document = Document::read("examples/patterns/miura.fold")?;
    let frame = document.pattern_frame()?;
    let pattern = CreasePattern::from_document(&document, frame)?;
    let model = Model::new(&pattern, &Material::default())?;

    // Mountains fold in the first half of the time, valleys in the second. All else goes straight from flat to folded.
    let mut order = Timeline::new(&model);
    for (i, edge) in pattern.edges.iter().enumerate() {
        match edge.fold_angle {
            Some(angle) if angle < 0.0 => order.set(EdgeId::new(i), [(0.0, 0.0), (0.5, angle)])?,
            Some(angle) if angle > 0.0 => order.set(EdgeId::new(i), [(0.5, 0.0), (1.0, angle)])?,
            _ => continue,
        };
    }

    let mut sheet = Simulation::new(model.clone(), Relax::default())?;
    let mut poses = Vec::new();
    for frame in 0..=20 {
        let share = f64::from(frame) / 20.0;
        sheet.set_targets(order.at(share).labelled(&model, 100.0 * share))?;
        let report = sheet.settle(100_000)?;
        let folded = sheet.clone().finish()?;
        println!("{:3.0} % of the time: {} steps, settled: {}", 100.0 * share, report.steps, report.settled);
        poses.push(Pose::of(&model, &pattern, &folded));
    }
    write_whole("timeline.fold", |file| animation(&document, frame, &pattern, &poses)?.write_to(file))?;
    Ok(())
}
