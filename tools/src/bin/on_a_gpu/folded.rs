//! The time from the sheet at rest to the folded state, with all that is built before it.

use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;

use origami::gpu::Dispatch;
use origami::scene::Scene;
use origami::solve::Precision;
use origami::{Model, Relax, Solver, State};

use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::{PERCENT, Processor, on, square, ways};

/// Panels along both sides; the GPU first, since the processor may not come to the end.
const PANELS: [usize; 4] = [315, 99, 31, 9];
const REHEARSED: [usize; 1] = [9];

/// Folds Miura sheets, first all on the GPU.
///
/// # Errors
/// If a sheet cannot be built or a figure not be written.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let sizes = if place.rehearse { &REHEARSED[..] } else { &PANELS[..] };
    let models: Vec<Model> = sizes.iter().map(|panels| square(*panels)).collect::<Result<_, _>>()?;
    for model in &models {
        let mut all = vec![("GPU, auto".to_owned(), Dispatch::Auto)];
        all.extend(ways(&place.gpu, &Relax::default(), model));
        for (by, way) in all {
            fold(place, model, &by, &*on(&place.gpu, Relax::default(), way))?;
        }
    }
    let [one, all] = [true, false].map(|one_thread| Processor { precision: Precision::F64, one_thread });
    let mixed = Processor { precision: Precision::Mixed, one_thread: false };
    // The largest last: one thread may take all the time that is left.
    for model in models.iter().rev() {
        for processor in [all, mixed, one] {
            fold(place, model, &processor.name(), &processor.relax(Relax::default()))?;
        }
    }
    Ok(if place.is_over() { Ended::Cut } else { Ended::Whole })
}

fn fold(place: &Place, model: &Model, by: &str, solver: &dyn Solver) -> Result<(), Box<dyn Error>> {
    if place.is_over() {
        return Ok(());
    }
    let (start, began) = (State::at_rest(model), Instant::now());
    let mut evaluations = 0;
    let result = solver.fold(model, &start, &Scene::percent(PERCENT), &mut |progress| {
        evaluations = progress.step;
        if place.is_over() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let seconds = began.elapsed().as_secs_f64();
    let row = |quantity: &str, value: f64| {
        let (by, quantity, vertices) = (by.to_owned(), quantity.to_owned(), model.node_count());
        place.add(Row {
            sheet: "miura".into(),
            vertices,
            sheets: 1,
            solver: "relax".into(),
            by,
            quantity,
            value,
            ..Row::default()
        })
    };
    match result {
        Err(error) => println!("{} vertices, {by}: {error}", model.node_count()),
        Ok(folded) if folded.converged() => {
            row("seconds until it is folded", seconds)?;
            row("evaluations", folded.steps as f64)?;
        }
        // How long it took at least.
        Ok(_) => {
            row("seconds without being folded", seconds)?;
            row("evaluations", evaluations as f64)?;
        }
    }
    Ok(())
}
