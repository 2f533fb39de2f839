//! Whether the GPU comes to what the processor comes to in f64, and to the same bits when it is asked again.

use std::error::Error;
use std::ops::ControlFlow;

use origami::glam::DVec3;
use origami::measure::align;
use origami::scene::Scene;
use origami::solve::{Session, Stop};
use origami::{Dynamics, Folded, Model, Relax, Solver, State};

use crate::place::Place;
use crate::results::Row;
use crate::section::Ended;
use crate::sheets::{self, PATTERNS, PERCENT, on, ways};

/// Steps of a trajectory.
const STEPS: u64 = 300;

/// Compares every pattern, on every way that it can go.
///
/// # Errors
/// If a sheet cannot be folded.
pub(crate) fn measure(place: &Place) -> Result<Ended, Box<dyn Error>> {
    let patterns = if place.rehearse { &PATTERNS[..2] } else { &PATTERNS[..] };
    for named in patterns {
        if place.is_over() {
            return Ok(Ended::Cut);
        }
        let model = sheets::model(*named)?;
        let row = |solver: &str, by: &str, quantity: &str, value: f64| {
            let (solver, by, quantity) = (solver.to_owned(), by.to_owned(), quantity.to_owned());
            let (sheet, vertices) = (named.0.to_owned(), model.node_count());
            place.add(Row { sheet, vertices, sheets: 1, solver, by, quantity, value, ..Row::default() })
        };

        let dynamics = Dynamics { steps: Some(STEPS), ..Dynamics::default() };
        let Some(reference) = fold(place, &dynamics, &model)? else { return Ok(Ended::Cut) };
        for (by, way) in ways(&place.gpu, &dynamics, &model) {
            let solver = on(&place.gpu, dynamics.clone(), way);
            let Some([first, second]) = twice(place, &*solver, &model)? else { return Ok(Ended::Cut) };
            let far = farthest(&first.state.positions, &reference.state.positions);
            row("dynamics", &by, "distance from the CPU after 300 steps, radii", far)?;
            row("dynamics", &by, "same bits", yes(same_bits(&first.state, &second.state)))?;
        }

        let relax = Relax::default();
        let Some(reference) = fold(place, &relax, &model)? else { return Ok(Ended::Cut) };
        row("relax", "CPU", "converged", yes(reference.converged()))?;
        row("relax", "CPU", "evaluations", reference.steps as f64)?;
        for (by, way) in ways(&place.gpu, &relax, &model) {
            let solver = on(&place.gpu, relax.clone(), way);
            let Some([first, second]) = twice(place, &*solver, &model)? else { return Ok(Ended::Cut) };
            let far = align(&first.state.positions, &reference.state.positions).max;
            row("relax", &by, "distance from the CPU's equilibrium, radii", far)?;
            row("relax", &by, "converged", yes(first.converged()))?;
            row("relax", &by, "evaluations", first.steps as f64)?;
            row("relax", &by, "same bits", yes(same_bits(&first.state, &second.state)))?;
        }
    }
    Ok(Ended::Whole)
}

/// `None` where the time is over before it has ended.
fn fold(place: &Place, solver: &dyn Solver, model: &Model) -> Result<Option<Folded>, Box<dyn Error>> {
    let mut session = solver.session(model);
    once(place, &mut *session, model)
}

/// Two runs that share their pipelines and nothing else.
fn twice(place: &Place, solver: &dyn Solver, model: &Model) -> Result<Option<[Folded; 2]>, Box<dyn Error>> {
    let mut session = solver.session(model);
    let Some(first) = once(place, &mut *session, model)? else { return Ok(None) };
    Ok(once(place, &mut *session, model)?.map(|second| [first, second]))
}

fn once(place: &Place, session: &mut dyn Session, model: &Model) -> Result<Option<Folded>, Box<dyn Error>> {
    let mut until_over = |_| if place.is_over() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    let folded = session.fold(&State::at_rest(model), &Scene::percent(PERCENT), &mut until_over)?;
    Ok(Some(folded).filter(|folded| folded.stop != Stop::Cancelled))
}

fn yes(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// The largest distance between two vertices of one number; what is no number is infinitely far.
fn farthest(a: &[DVec3], b: &[DVec3]) -> f64 {
    let distances = a.iter().zip(b).map(|(a, b)| a.distance(*b));
    distances.fold(0.0, |most, d| if d.is_nan() { f64::INFINITY } else { most.max(d) })
}

/// Whether all that two states hold is equal; -0 and 0 are not.
fn same_bits(a: &State, b: &State) -> bool {
    let bits = |state: &State| -> Vec<u64> {
        let vectors = state.positions.iter().chain(&state.velocities).flat_map(|v| v.to_array());
        vectors.chain(state.fold_angles.iter().copied()).map(f64::to_bits).collect()
    };
    bits(a) == bits(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comparisons_find_one_wrong_number() {
        let model = sheets::model(("bird-base", &[])).expect("a model");
        let state = State::at_rest(&model);
        assert!(same_bits(&state, &state.clone()) && farthest(&state.positions, &state.positions) == 0.0);
        let mut other = state.clone();
        other.fold_angles[3] = -0.0;
        assert!(!same_bits(&state, &other), "one bit");
        other.positions[2].x += 0.5;
        assert_eq!(farthest(&state.positions, &other.positions), 0.5);
        other.positions[1].y = f64::NAN;
        assert_eq!(farthest(&state.positions, &other.positions), f64::INFINITY);
    }
}
