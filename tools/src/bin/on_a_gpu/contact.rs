//! Sheets that cannot go through themselves: whether the GPU comes to what the processor comes to, and how long either takes.

use std::error::Error;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::time::Instant;

use origami::contact::Crossings;
use origami::scene::Scene;
use origami::solve::{ContactRelax, Stop, Touching};
use origami::{Folded, Model, Relax, State};

use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::{self, Named};

/// Folded flat, where layers touch; the last have thousands of pairs that may.
const PATTERNS: [Named; 6] = [
    ("bird-base", &[]),
    ("square-twist", &[]),
    ("crane", &[]),
    ("miura", &[]),
    ("waterbomb", &[]),
    ("miura", &[("columns", 30.0), ("rows", 30.0)]),
];

/// Folds every pattern flat under contact, on the GPU and on the processor.
///
/// # Errors
/// If a sheet cannot be folded or a figure not be written.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let patterns = if place.rehearse { &PATTERNS[..1] } else { &PATTERNS[..] };
    for named in patterns {
        let model = sheets::model(*named)?;
        let on_gpu = place.gpu.with_contact(ContactRelax::default());
        let Some(own) = fold(place, (named.0, &model), "GPU", &on_gpu)? else { return Ok(Ended::Cut) };
        let all = ContactRelax::default();
        let one = ContactRelax {
            relax: Relax { threads: Some(NonZeroUsize::MIN), ..Relax::default() },
            ..ContactRelax::default()
        };
        let Some(reference) = fold(place, (named.0, &model), "CPU, one thread", &one)? else { return Ok(Ended::Cut) };
        if fold(place, (named.0, &model), "CPU, all threads", &all)?.is_none() {
            return Ok(Ended::Cut);
        }
        let angles = own.state.fold_angles.iter().zip(&reference.state.fold_angles);
        let apart = angles.map(|(a, b)| (a - b).abs().to_degrees()).fold(0.0, f64::max);
        row(place, (named.0, &model), "GPU", "fold angles from the CPU's, degrees", apart)?;
    }
    Ok(Ended::Whole)
}

/// `None` where the time is over before it has ended.
fn fold(
    place: &Place,
    (sheet, model): (&str, &Model),
    by: &str,
    solver: &dyn Touching,
) -> Result<Option<Folded>, Box<dyn Error>> {
    let mut until_over = |_| if place.is_over() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let began = Instant::now();
    let (folded, touch) =
        solver.fold_touching(model, &State::at_rest(model), &Scene::percent(100.0), &mut until_over)?;
    let seconds = began.elapsed().as_secs_f64();
    if folded.stop == Stop::Cancelled {
        return Ok(None);
    }
    let crossings = Crossings::of(&model.mesh, &folded.state.positions).all.len();
    for (quantity, value) in [
        ("seconds until it is at rest", seconds),
        ("evaluations", folded.steps as f64),
        ("blocked", f64::from(u8::from(folded.stop == Stop::Blocked))),
        ("crossings", crossings as f64),
        ("most pairs", touch.most_pairs as f64),
    ] {
        row(place, (sheet, model), by, quantity, value)?;
    }
    Ok(Some(folded))
}

fn row(
    place: &Place,
    (sheet, model): (&str, &Model),
    by: &str,
    quantity: &str,
    value: f64,
) -> Result<(), Box<dyn Error>> {
    let (sheet, by, quantity) = (sheet.to_owned(), by.to_owned(), quantity.to_owned());
    let vertices = model.node_count();
    place.add(Row { sheet, vertices, sheets: 1, solver: "contact".into(), by, quantity, value, ..Row::default() })
}
