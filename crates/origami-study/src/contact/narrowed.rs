//! The narrowed bird base, which a crane begins with: at once, and its legs after its base.

use origami_core::contact::Contact;
use origami_core::generate::BirdBase;
use origami_core::glam::DVec2;
use origami_core::model::Crease;
use origami_core::scene::Targets;
use origami_core::{CreasePattern, Material, Model, Relax, Scene};

use super::asked::Asked;
use super::found::Found;
use super::watched::{Watched, solver, watched};
use crate::StudyError;
use crate::table::{Column, Table, column};

const COLUMNS: &[Column] = &[
    column("way", "way", "in how many steps"),
    column("end", "end", "of the last step"),
    column("crossings", "crossings", "at the end of each step and at every tenth evaluation, added up"),
    column("evaluations", "evaluations", "of all steps"),
    column("strain", "strain", "largest of a beam"),
    column("off_deg", "off (degrees)", "the largest difference of an angle from its target"),
];

/// Whether a line lies on a crease of a pattern.
fn lies_on_crease(pattern: &CreasePattern, [p, q]: [DVec2; 2]) -> bool {
    pattern.edges.iter().any(|edge| {
        let [a, b] = edge.vertices.map(|v| pattern.vertices[v.index()].truncate());
        let along = (b - a).normalize();
        let is_beside = |point: DVec2| along.perp_dot(point - a).abs() < 1e-9;
        let place = along.dot(0.5 * (p + q) - a);
        is_beside(p) && is_beside(q) && place > 0.0 && place < a.distance(b)
    })
}

/// The sheet; what is asked of all its creases, and of those of the bird base alone.
fn sheet() -> Result<(Model, [Scene; 2]), StudyError> {
    let base = BirdBase::default().pattern()?;
    let pattern = BirdBase { narrowed: true, ..BirdBase::default() }.pattern()?;
    let model = Model::new(&pattern, &Material::default())?;
    let is_of_base = |crease: &Crease| {
        let edge = model.mesh.sides[crease.side.index()].edge;
        let ends =
            edge.map(|edge| pattern.edges[edge.index()].vertices.map(|v| pattern.vertices[v.index()].truncate()));
        ends.is_some_and(|ends| lies_on_crease(&base, ends))
    };
    let target = |crease: &Crease| if is_of_base(crease) { crease.full_target } else { 0.0 };
    let base_alone = Scene::new(Targets::angles(model.creases.iter().map(target).collect::<Vec<f64>>()));
    Ok((model, [Scene::percent(100.0), base_alone]))
}

pub(super) fn study(_: bool) -> Result<Found, StudyError> {
    let (model, [all, base]) = sheet()?;
    let solver = solver(Relax::default().perturbation, Contact::default());
    let mut table = Table::new(COLUMNS);
    let mut fold = |way: &str, stages: &[Scene]| {
        let came = watched(&model, &solver, stages).ok()?;
        table.push(vec![
            way.into(),
            came.stop().into(),
            came.crossings.into(),
            came.evaluations.into(),
            came.strain.into(),
            came.off.into(),
        ]);
        Some(came)
    };
    let at_once = fold("all creases at once", &[all.clone()]);
    let in_order = fold("the base, then its legs", &[base, all]);
    let crossings = |came: &Option<Watched>| came.as_ref().map_or(usize::MAX, |came| came.crossings);
    let strain = in_order.as_ref().map_or(f64::NAN, |came| came.strain);
    let crossed = crossings(&at_once).max(crossings(&in_order));
    let asked = vec![
        Asked::that("narrowed bird base: crossings", "none", crossed.to_string(), crossed == 0),
        Asked::at_most("narrowed bird base by sequence: strain (%)", 6.0, 100.0 * strain),
    ];
    Ok(Found::one("The narrowed bird base", ABOUT, ("contact-narrowed", table), asked))
}

const ABOUT: &str = "A bird base of which the outer edges of the two legs are folded to their middle, as a crane begins \
    (`origami pattern bird-base --set narrowed=1`).";
