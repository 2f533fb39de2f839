//! Sheets that nothing touches: contact changes nothing of them.

use origami_core::contact::Contact;
use origami_core::generate::catalog;
use origami_core::glam::DVec3;
use origami_core::measure::align;
use origami_core::solve::{ContactRelax, Touching, unwatched};
use origami_core::{Material, Model, Relax, Scene, Solver, State};

use super::asked::Asked;
use super::found::Found;
use super::watched::relax;
use crate::StudyError;
use crate::table::{Column, Table, column};

/// Patterns, and percentages at which nothing is near anything.
const CASES: [(&str, f64); 4] = [("miura", 60.0), ("miura", 90.0), ("degree-4", 70.0), ("hypar", 100.0)];
/// Evaluations of both.
const STEPS: u64 = 3000;

const COLUMNS: &[Column] = &[
    column("pattern", "pattern", "its name"),
    column("percent", "%", "that it was folded to"),
    column("limited", "limited", "evaluations in which contact shortened a move"),
    column(
        "apart",
        "apart (radii)",
        "the largest distance of a vertex with contact from where it lies without, after the best rigid motion",
    ),
    column("moved", "moved (radii)", "the largest distance of a vertex from where it was at rest"),
];

pub(super) fn study(quick: bool) -> Result<Found, StudyError> {
    let mut table = Table::new(COLUMNS);
    let mut largest = 0.0_f64;
    for (name, percent) in CASES.iter().take(if quick { 3 } else { CASES.len() }) {
        let model = Model::new(&catalog::generate(name, &[])?, &Material::default())?;
        let (start, scene) = (State::at_rest(&model), Scene::percent(*percent));
        // The same method: the material's own stiffness, each node for itself, and one attempt.
        let relax = Relax { softening: None, near: 0.0, steps: Some(STEPS), ..relax() };
        let free = relax.fold(&model, &start, &scene, &mut unwatched);
        let solver = ContactRelax { relax, contact: Contact::default() };
        let held = solver.fold_touching(&model, &start, &scene, &mut unwatched);
        let (Ok(free), Ok((held, touch))) = (free, held) else { continue };
        let farthest = |from: &[DVec3]| align(&held.state.positions, from).max;
        let (apart, moved) = (farthest(&free.state.positions), farthest(&model.rest));
        largest = largest.max(apart);
        table.push(vec![(*name).into(), (*percent).into(), touch.limited.into(), apart.into(), moved.into()]);
    }
    let asked = vec![Asked::at_most("where nothing touches: apart from without contact (radii)", 1e-12, largest)];
    Ok(Found::one("Where nothing touches", ABOUT, ("contact-untouched", table), asked))
}

const ABOUT: &str = "Sheets on which nothing is near anything, after 3000 evaluations with contact and without (`relax` as stiff as the \
    material, each node for itself).";
