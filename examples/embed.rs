//! Folds a crease pattern and writes the folded sheet: what the README shows.
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::export::{Pose, folded_form, write_obj, write_whole};
use origami::{CreasePattern, Material, Model, Relax, Solver, fold::Document, measure::Strain};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let document = Document::read("examples/patterns/bird-base.fold")?;
    let frame = document.pattern_frame()?;
    let pattern = CreasePattern::from_document(&document, frame)?;
    let model = Model::new(&pattern, &Material::default())?;
    let folded = Relax::default().fold_from_rest(&model, 90.0)?;
    let strain = Strain::of(&model, &folded.state.positions).beams;
    println!("converged: {}, largest strain {:.2} %", folded.converged(), 100.0 * strain.max);
    let pose = Pose::of(&model, &pattern, &folded);
    write_whole("bird.fold", |file| folded_form(&document, frame, &pattern, &pose)?.write_to(file))?;
    write_whole("bird.obj", |file| write_obj(file, &pattern, &pose.positions))?;
    Ok(())
}
