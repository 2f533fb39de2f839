//! Pictures drawn on the GPU, one of them where a simulation's own buffer lies.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::time::Instant;

use origami::generate::catalog;
use origami::gpu::render::GpuRenderer;
use origami::picture::{Figure, Image, Picture, Processor, Renderer};
use origami::scene::Targets;
use origami::solve::Simulation;
use origami::{Material, Model, Relax, Solver};

use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::PERCENT;

/// Draws a crane, a large sheet, and a sheet in motion.
///
/// # Errors
/// If one of them cannot be drawn or a file not be written.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let began = Instant::now();
    let renderer = GpuRenderer::new(&place.gpu)?;
    add(place, "", 0, "GPU", "seconds until the renderer is ready", began.elapsed().as_secs_f64())?;
    in_motion(place, &renderer)?;
    let large = if place.rehearse { 20.0 } else { 224.0 };
    for (name, numbers, steps) in
        [("crane", vec![], None), ("miura", vec![("columns".to_owned(), large), ("rows".to_owned(), large)], Some(300))]
    {
        if place.is_over() {
            return Ok(Ended::Cut);
        }
        let pattern = catalog::generate(name, &numbers)?;
        let model = Model::new(&pattern, &Material::default())?;
        let relax = Relax { steps, ..Relax::default() };
        let folded = place.gpu.with(relax).fold_from_rest(&model, PERCENT)?;
        let figure = Figure::new(&pattern, &model, &folded.state.positions);
        let draw = |by: &str, quantity: &str, renderer: &dyn Renderer| -> Result<Image, Box<dyn Error>> {
            let began = Instant::now();
            let image = renderer.draw(&Picture::default(), &figure)?;
            add(place, name, model.node_count(), by, quantity, began.elapsed().as_secs_f64())?;
            Ok(image)
        };
        draw("GPU", "seconds, first picture", &renderer)?;
        let image = draw("GPU", "seconds, second picture", &renderer)?;
        let reference = draw("CPU", "seconds, first picture", &Processor)?;
        add(place, name, model.node_count(), "GPU", "share of pixels unlike the CPU's", unlike(&image, &reference))?;
        write(place, &image, name)?;
    }
    Ok(Ended::Whole)
}

/// A sheet that is drawn where it lies, and again from positions that were read.
fn in_motion(place: &Place, renderer: &GpuRenderer) -> Result<(), Box<dyn Error>> {
    let pattern = catalog::generate("miura", &[("columns".to_owned(), 30.0), ("rows".to_owned(), 30.0)])?;
    let model = Model::new(&pattern, &Material::default())?;
    let mut figure = Figure::new(&pattern, &model, &model.rest);
    let mut simulation = Simulation::new(model.clone(), place.gpu.with(Relax::default()))?;
    simulation.set_targets(Targets::percent(PERCENT))?;
    simulation.step(if place.rehearse { 100 } else { 1000 })?;
    let began = Instant::now();
    let image = renderer.draw_simulation(&Picture::default(), &figure, simulation.engine(), None)?;
    let vertices = model.node_count();
    add(place, "miura", vertices, "GPU, simulation's buffer", "seconds, first picture", began.elapsed().as_secs_f64())?;
    figure.move_to(&model, &simulation.state()?.positions);
    let read = renderer.draw(&Picture::default(), &figure)?;
    let quantity = "share of pixels unlike those from positions that were read";
    add(place, "miura", vertices, "GPU, simulation's buffer", quantity, unlike(&image, &read))?;
    write(place, &image, "simulation")
}

/// The share of pixels that differ by more than a twentieth in one of their colours; all where the sizes differ.
fn unlike(a: &Image, b: &Image) -> f64 {
    if (a.width, a.height) != (b.width, b.height) {
        return 1.0;
    }
    let pairs = || a.pixels.chunks_exact(4).zip(b.pixels.chunks_exact(4));
    let differ = pairs().filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 12)).count();
    differ as f64 / pairs().count().max(1) as f64
}

fn write(place: &Place, image: &Image, name: &str) -> Result<(), Box<dyn Error>> {
    Ok(image.write_png(BufWriter::new(File::create(place.folder.join(format!("{name}.png")))?))?)
}

fn add(
    place: &Place,
    sheet: &str,
    vertices: usize,
    by: &str,
    quantity: &str,
    value: f64,
) -> Result<(), Box<dyn Error>> {
    let (sheet, by, quantity) = (sheet.to_owned(), by.to_owned(), quantity.to_owned());
    place.add(Row { sheet, vertices, sheets: 1, by, quantity, value, ..Row::default() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_that_differ_are_counted() {
        let image = |red: u8| Image { width: 2, height: 1, pixels: vec![0, 0, 0, 255, red, 0, 0, 255] };
        assert_eq!(unlike(&image(7), &image(9)), 0.0);
        assert_eq!(unlike(&image(7), &image(200)), 0.5);
        assert_eq!(unlike(&image(7), &Image { width: 1, height: 2, ..image(7) }), 1.0);
    }
}
