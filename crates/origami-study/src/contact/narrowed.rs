//! The narrowed bird base, which a crane begins with: at once, and its legs after its base.

use origami_core::contact::Contact;
use origami_core::generate::BirdBase;
use origami_core::glam::DVec2;
use origami_core::model::Crease;
use origami_core::scene::Targets;
use origami_core::{CreasePattern, Material, Model, Relax, Scene};

use super::asked::Asked;
use super::found::Found;
use super::watched::{solver, watched};
use crate::StudyError;
use crate::table::{Column, Table, column};

/// A gap that is large enough for what is narrow here: with the default legs jam.
const WIDE: f64 = 5e-3;

const COLUMNS: &[Column] = &[
    column("way", "way", "in how many steps"),
    column("gap", "gap (radii)", "from which on layers push"),
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

pub(super) fn study(quick: bool) -> Result<Found, StudyError> {
    let (model, [all, base]) = sheet()?;
    let mut table = Table::new(COLUMNS);
    let mut fold = |way: &str, gap: f64, stages: &[Scene]| {
        let solver = solver(Relax::default().perturbation, Contact { gap, ..Contact::default() });
        let came = watched(&model, &solver, stages).ok()?;
        table.push(vec![
            way.into(),
            gap.into(),
            came.stop().into(),
            came.crossings.into(),
            came.evaluations.into(),
            came.strain.into(),
            came.off.into(),
        ]);
        Some(came)
    };
    let (at_once, in_order) = ([all.clone()], [base, all]);
    let mut ended = Vec::new();
    for gap in if quick { vec![WIDE] } else { vec![Contact::default().gap, WIDE] } {
        ended.push(fold("all creases at once", gap, &at_once));
        ended.push(fold("the base, then its legs", gap, &in_order));
    }
    let crossed = ended.iter().map(|came| came.as_ref().map_or(1, |came| came.crossings)).sum::<usize>();
    // The last is in order, and with the wider gap.
    let last = ended.pop().flatten().filter(|came| came.stop() == "converged");
    let strain = last.map_or(f64::NAN, |came| 100.0 * came.strain);
    let asked = vec![
        Asked::that("narrowed bird base: crossings", "none", crossed.to_string(), crossed == 0),
        Asked::at_most("narrowed bird base by sequence, gap 5e-3: strain where it converges (%)", 6.0, strain),
    ];
    Ok(Found::one("The narrowed bird base", ABOUT, ("contact-narrowed", table), asked))
}

const ABOUT: &str = "A bird base of which the outer edges of the two legs are folded to their middle, as a crane begins \
    (`origami pattern bird-base --set narrowed=1`).";
