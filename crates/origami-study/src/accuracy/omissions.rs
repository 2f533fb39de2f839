//! What was left out: what it would cost to build, and what it changes.

use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use std::time::Instant;

use origami_core::generate;
use origami_core::glam::DVec3;
use origami_core::measure::{align, node_strains};
use origami_core::{CreasePattern, Dynamics, Error, Material, Model, Newton, Relax, Solver, State};

use crate::table::{Cell, Column, Table};

/// Steps that are timed, and how often: the least counts.
const STEPS: u64 = 400;
const TIMES: usize = 5;

const COLUMNS: &[Column] = &[
    Column { key: "what", head: "left out", meaning: "what is left out" },
    Column { key: "solver", head: "solver", meaning: "whose step is timed" },
    Column { key: "with", head: "with (ns)", meaning: "nanoseconds per node and step with it" },
    Column { key: "without", head: "without (ns)", meaning: "nanoseconds per node and step without it" },
    Column { key: "saved", head: "saved", meaning: "share of the time that leaving it out saves" },
    Column { key: "error", head: "change (radii)", meaning: "largest distance between the two equilibria, in radii" },
    Column { key: "why", head: "when", meaning: "when it is left out" },
];

/// A Miura sheet at 60 %, with and without each thing.
pub(super) fn run(quick: bool) -> Result<Table, Error> {
    let mut table = Table::new(COLUMNS);
    let panels = if quick { 9 } else { 31 };
    let pattern = generate::miura(panels, panels)?;
    let own = Material::default();
    let model = |material: Material| Model::new(&pattern, &material);
    let whole = model(own)?;
    // From the folded state: in a jump creases turn so fast that it matters which ones there are.
    let folded = Relax::default().fold_from_rest(&whole, 60.0).map(|folded| folded.state);
    let folded = folded.unwrap_or_else(|_| State::at_rest(&whole)).positions;
    let relax = |model: &Model| {
        time(model, &folded, &Relax { steps: Some(STEPS), ramp: Some(0), perturbation: 0.0, ..Relax::default() })
    };
    let dynamics = |model: &Model| time(model, &folded, &Dynamics { steps: Some(STEPS), ..Dynamics::default() });

    // A group that is built without pulling costs what it would cost a case that does not need it.
    let mut pair = |what: &str, solver: &str, with: f64, without: f64, error: Cell, why: &str| {
        let saved = 1.0 - without / with;
        table.push(vec![what.into(), solver.into(), with.into(), without.into(), saved.into(), error, why.into()]);
    };
    let idle = 1e-12;
    let no_corners = model(Material { k_face: 0.0, ..own })?;
    let idle_corners = model(Material { k_face: idle, ..own })?;
    let change = apart(&whole, &no_corners).into();
    pair("corner angles", "relax", relax(&idle_corners), relax(&no_corners), change, "k_face is 0");

    let no_facets = model(Material { k_facet: 0.0, ..own })?;
    let idle_facets = model(Material { k_facet: idle, ..own })?;
    let change = apart(&whole, &no_facets).into();
    pair("springs of facet creases", "relax", relax(&idle_facets), relax(&no_facets), change, "k_facet is 0");

    let undriven = with_every_other_crease(&pattern, None);
    let idle_creases = with_every_other_crease(&pattern, Some(idle));
    let (undriven, idle_creases) = (Model::new(&undriven, &own)?, Model::new(&idle_creases, &own)?);
    let change = apart(&whole, &undriven).into();
    pair("half of the creases", "relax", relax(&idle_creases), relax(&undriven), change, "they are undriven");

    let undamped = model(Material { zeta: 0.0, ..own })?;
    let (with, without) = (dynamics(&whole), dynamics(&undamped));
    pair("damping", "dynamics", with, without, 0.0.into(), "zeta is 0; a relaxation has none");

    let strain = least(|| drop(node_strains(&whole, &folded))) / whole.node_count() as f64;
    let step = relax(&whole);
    pair("strain at every step", "relax", step + strain, step, 0.0.into(), "always: it is measured once, at the end");

    // A mass a node would be one more number to read and a division; all are 1 in the paper's units.
    let velocities = &mut vec![DVec3::ONE; whole.node_count()];
    let masses = vec![1.000_001; whole.node_count()];
    let division = least(|| velocities.iter_mut().zip(&masses).for_each(|(v, m)| *v /= *m)) / whole.node_count() as f64;
    let step = dynamics(&whole);
    pair("a mass for each node", "dynamics", step + division, step, 0.0.into(), "always: masses are 1");
    Ok(table)
}

/// The pattern with every other of its driven creases as free as an undriven one (`None`), or with a stiffness.
fn with_every_other_crease(pattern: &CreasePattern, stiffness: Option<f64>) -> CreasePattern {
    let mut pattern = pattern.clone();
    for edge in pattern.edges.iter_mut().filter(|edge| edge.fold_angle.is_some()).step_by(2) {
        match stiffness {
            Some(k) => edge.k_crease = Some(k),
            None => edge.fold_angle = None,
        }
    }
    pattern
}

/// Nanoseconds per node and step.
fn time(model: &Model, folded: &[DVec3], solver: &dyn Solver) -> f64 {
    let start = State::at(model, folded.to_vec());
    let fold = || drop(solver.fold(model, &start, &Scene::percent(60.0), &mut unwatched));
    least(fold) / (model.node_count() as u64 * STEPS) as f64
}

/// The least of several times, in nanoseconds.
fn least(mut work: impl FnMut()) -> f64 {
    let times = (0..TIMES).map(|_| {
        let began = Instant::now();
        work();
        began.elapsed().as_secs_f64() * 1e9
    });
    times.fold(f64::INFINITY, f64::min)
}

/// How far apart the equilibria of two models of one sheet are at 60 %.
fn apart(one: &Model, other: &Model) -> Option<f64> {
    let equilibrium = |model: &Model| {
        let folded =
            Newton::default().fold(model, &State::at_rest(model), &Scene::percent(60.0), &mut unwatched).ok()?;
        folded.converged().then_some(folded.state.positions)
    };
    Some(align(&equilibrium(one)?, &equilibrium(other)?).max)
}
