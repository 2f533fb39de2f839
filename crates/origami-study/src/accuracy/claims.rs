//! Whether `converged` is true: each claim against the equilibrium that the run was approaching.

use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use origami_core::{Dynamics, Folded, Relax, Solver, State};

use super::cases::Case;
use super::reference::{self, Branch, Equilibrium};
use crate::table::{Cell, Column, Table};

/// Tolerances asked of `relax`, in radii.
const TOLERANCES: [f64; 4] = [1e-3, 1e-4, 1e-5, 1e-6];
/// Steps after which the paper's scheme gives up.
const MOST_STEPS: u64 = 30_000;

pub(super) const COLUMNS: &[Column] = &[
    Column { key: "scene", head: "scene", meaning: "what is folded" },
    Column { key: "percent", head: "%", meaning: "percentage of the pattern's fold angles" },
    Column { key: "start", head: "start", meaning: "a jump, or the default ramp" },
    Column { key: "solver", head: "solver", meaning: "which makes the claim" },
    Column { key: "tolerance", head: "tolerance", meaning: "distance asked for, in radii" },
    Column { key: "evaluations", head: "evaluations", meaning: "force evaluations" },
    Column { key: "converged", head: "converged", meaning: "whether the solver says so" },
    Column { key: "estimate", head: "estimate", meaning: "distance that the solver estimates, in radii" },
    Column { key: "distance", head: "distance", meaning: "largest distance from the equilibrium, in radii" },
    Column { key: "branch", head: "branch", meaning: "whether that equilibrium is the reference" },
    Column { key: "kept", head: "kept", meaning: "whether the distance is within the tolerance, where converged" },
];

/// What solvers claim of their own errors, against the errors.
pub(super) struct Claims {
    pub(super) table: Table,
}

impl Claims {
    pub(super) fn new() -> Self {
        Self { table: Table::new(COLUMNS) }
    }

    /// How many were made, and those that were not kept.
    pub(super) fn missed(&self) -> (usize, Table) {
        let kept = |row: &[Cell], flag: bool| row.last() == Some(&Cell::Flag(flag));
        let rows: Vec<Vec<Cell>> = self.table.rows.iter().filter(|row| kept(row, false)).cloned().collect();
        let made = rows.len() + self.table.rows.iter().filter(|row| kept(row, true)).count();
        (made, Table { columns: COLUMNS, rows })
    }

    /// Asks both solvers on a case.
    pub(super) fn add(&mut self, case: &Case, reference: &Equilibrium) {
        for tolerance in TOLERANCES {
            let relax = Relax { tolerance, ramp: Some(case.ramp), ..Relax::default() };
            self.ask("relax", &relax, tolerance, case, reference);
        }
        let dynamics = Dynamics { ramp: case.ramp, max_steps: MOST_STEPS, ..Dynamics::default() };
        self.ask("dynamics", &dynamics, dynamics.tolerance, case, reference);
    }

    fn ask(&mut self, name: &str, solver: &dyn Solver, tolerance: f64, case: &Case, reference: &Equilibrium) {
        let folded =
            solver.fold(&case.model, &State::at_rest(&case.model), &Scene::percent(case.percent), &mut unwatched);
        let Ok(folded) = folded else { return };
        let (branch, own) = reference::branch(&case.model, &folded.state, reference);
        let distance = reference::error(&folded.state.positions, own.as_ref().unwrap_or(reference)).max;
        self.table.push(row(name, &folded, tolerance, case, branch, distance));
    }
}

fn row(name: &str, folded: &Folded, tolerance: f64, case: &Case, branch: Branch, distance: f64) -> Vec<Cell> {
    vec![
        case.name.as_str().into(),
        case.percent.into(),
        if case.ramp == 0 { "jump" } else { "ramp" }.into(),
        name.into(),
        tolerance.into(),
        folded.steps.into(),
        folded.converged().into(),
        folded.distance.into(),
        distance.into(),
        branch.name().into(),
        folded.converged().then_some(distance <= tolerance).into(),
    ]
}
