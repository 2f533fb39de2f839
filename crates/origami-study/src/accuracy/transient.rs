//! The motion itself: error of `dynamics` after a fixed time against a far shorter step, and its order of convergence.

use origami_core::generate::{self, SingleCrease};
use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use origami_core::solve::{Integrator, TimeStep, time_step};
use origami_core::{Dynamics, Error, Material, Model, Solver, State};

use crate::plot::{Axis, Mark, Plot, Scale, Series};
use crate::table::{Cell, Column, Table};

/// Units of model time: a few vibrations of the stiffest beam, and a good part of a crease's.
const TIME: f64 = 2.0;
/// How much shorter the step of the reference is than the shortest that is compared.
const FINER: u64 = 16;

const COLUMNS: &[Column] = &[
    Column { key: "scene", head: "scene", meaning: "what moves" },
    Column { key: "zeta", head: "zeta", meaning: "damping ratio" },
    Column { key: "integrator", head: "integrator", meaning: "euler (semi-implicit) or verlet" },
    Column { key: "step", head: "step", meaning: "length of a step, in units of model time" },
    Column { key: "of_paper", head: "of the paper's", meaning: "the same as a share of the paper's step" },
    Column { key: "error", head: "error", meaning: "largest distance of a vertex after the time, in radii" },
    Column { key: "order", head: "order", meaning: "log2 of the error of the step twice as long over this one" },
];

/// Errors by step, and a plot of them.
pub(super) struct Transient {
    pub(super) table: Table,
    pub(super) plot: Plot,
    /// Least and largest order measured at the shortest step: Euler, Verlet.
    pub(super) orders: [[f64; 2]; 2],
}

pub(super) fn run(quick: bool) -> Result<Transient, Error> {
    let mut table = Table::new(COLUMNS);
    let mut series = Vec::new();
    let mut orders = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let crease = SingleCrease { angle: 1.0, ..SingleCrease::default() }.pattern()?;
    let mut cases = vec![("single crease", crease)];
    if !quick {
        cases.push(("miura 5x5", generate::miura(4, 4)?));
    }
    for (name, pattern) in &cases {
        for zeta in [0.0, 0.45] {
            let model = Model::new(pattern, &Material { zeta, ..Material::default() })?;
            let paper = time_step::paper(&model);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few hundred steps")]
            let coarsest = (TIME / paper).ceil() as u64;
            let finest = coarsest << 5;
            let Some(exact) = after(&model, Integrator::Verlet, FINER * finest) else { continue };
            for (index, integrator) in [Integrator::Euler, Integrator::Verlet].into_iter().enumerate() {
                let label = if integrator == Integrator::Euler { "euler" } else { "verlet" };
                let mut points = Vec::new();
                let mut before: Option<f64> = None;
                for halvings in 0..=5 {
                    let steps = coarsest << halvings;
                    let step = TIME / steps as f64;
                    let error = after(&model, integrator, steps).map(|state| farthest(&state, &exact));
                    let order = before.zip(error).map(|(coarse, fine)| (coarse / fine).log2());
                    table.push(vec![
                        Cell::from(*name),
                        zeta.into(),
                        label.into(),
                        step.into(),
                        (step / paper).into(),
                        error.into(),
                        order.into(),
                    ]);
                    points.extend(error.map(|error| (step, error)));
                    before = error;
                    if let (5, Some(order)) = (halvings, order) {
                        orders[index] = [orders[index][0].min(order), orders[index][1].max(order)];
                    }
                }
                let mark = if zeta == 0.0 { Mark::Dashed } else { Mark::Line };
                series.push(Series { label: format!("{label}, {name}, zeta {zeta}"), mark, points });
            }
        }
    }
    let plot = Plot {
        title: "Error of the motion against the length of a step".into(),
        note: format!("after {TIME} units of time, against Verlet with a step {FINER} times shorter than the shortest"),
        x: Axis { label: "step (model time)".into(), scale: Scale::Log },
        y: Axis { label: "largest error of a vertex (radii)".into(), scale: Scale::Log },
        series,
    };
    Ok(Transient { table, plot, orders })
}

/// The state after [`TIME`] from a jump to 60 %, or none where the step does not hold.
fn after(model: &Model, integrator: Integrator, steps: u64) -> Option<State> {
    let time_step = TimeStep::Fixed(TIME / steps as f64);
    let dynamics = Dynamics { time_step, integrator, steps: Some(steps), ..Dynamics::default() };
    dynamics.fold(model, &State::at_rest(model), &Scene::percent(60.0), &mut unwatched).ok().map(|folded| folded.state)
}

fn farthest(a: &State, b: &State) -> f64 {
    a.positions.iter().zip(&b.positions).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max)
}
