//! Closed forms of rigid folding: distances from them are the solver's own error, with no model in between.

use origami_core::scene::Scene;
use origami_core::solve::unwatched;
use std::time::Instant;

use origami_core::generate::{Degree4, Kresling, Miura, SingleCrease, WaterbombVertex, Yoshimura};
use origami_core::glam::DVec3;
use origami_core::measure::{align, closures, edge_fold_angles};
use origami_core::rigid::{Degree4Mode, KreslingFold, YoshimuraFold, degree4, waterbomb_folds, waterbomb_polar};
use origami_core::{CreasePattern, Error, Material, Model, Newton, Relax, Solver, State};

use crate::table::{Cell, Column, Table};

/// A case whose folded state is known.
pub(super) struct Known {
    name: &'static str,
    pattern: CreasePattern,
    model: Model,
    start: State,
    exact: Exact,
}

enum Exact {
    /// By node, in radii, but for a rigid motion.
    Positions(Vec<DVec3>),
    /// Fold angle of the creases from vertex 0 to vertex 1, 2, ..., in radians.
    Spokes(Vec<f64>),
    /// Fold angle of the one crease.
    Angle(f64),
}

impl Known {
    fn new(name: &'static str, pattern: CreasePattern, exact: impl Fn(&Model) -> Exact) -> Result<Self, Error> {
        let model = Model::new(&pattern, &Material::default())?;
        let (start, exact) = (State::at_rest(&model), exact(&model));
        Ok(Self { name, pattern, model, start, exact })
    }

    fn from(mut self, positions: Vec<DVec3>) -> Self {
        self.start = State::at(&self.model, positions);
        self
    }

    /// Distance from the closed form: radii or radians.
    fn error(&self, state: &State) -> f64 {
        match &self.exact {
            Exact::Positions(exact) => align(&state.positions, exact).max,
            Exact::Angle(exact) => state.fold_angles.iter().map(|angle| (angle - exact).abs()).fold(0.0, f64::max),
            Exact::Spokes(exact) => {
                let reached = edge_fold_angles(&self.model, &self.pattern, state);
                let far = |(spoke, exact): (usize, &f64)| {
                    let ends = [0, spoke as u32 + 1];
                    let edge = self.pattern.edges.iter().position(|edge| {
                        let vertices = edge.vertices.map(|v| v.0);
                        vertices == ends || vertices == [ends[1], ends[0]]
                    });
                    edge.and_then(|edge| reached[edge]).map_or(f64::INFINITY, |reached| (reached - exact).abs())
                };
                exact.iter().enumerate().map(far).fold(0.0, f64::max)
            }
        }
    }

    fn unit(&self) -> &'static str {
        if matches!(self.exact, Exact::Positions(_)) { "radii" } else { "radians" }
    }
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", head: "scene", meaning: "what is folded" },
    Column { key: "solver", head: "solver", meaning: "solver with what it was asked for" },
    Column { key: "evaluations", head: "evaluations", meaning: "force evaluations" },
    Column { key: "seconds", head: "seconds", meaning: "of solving" },
    Column { key: "error", head: "error", meaning: "largest distance from the closed form, in `unit`" },
    Column { key: "unit", head: "of", meaning: "radii of the sheet, or radians of fold angle" },
    Column { key: "closure", head: "loop closure", meaning: "of the worst interior vertex: norm of prod Rx Rz - I" },
    Column { key: "converged", head: "converged", meaning: "whether the solver says so" },
];

/// What each solver makes of the closed forms.
pub(super) struct ClosedForms {
    pub(super) table: Table,
    /// Largest error of `newton`, and of `relax` as a multiple of its tolerance.
    pub(super) newton: f64,
    pub(super) relax: f64,
}

pub(super) fn run(mut ran: impl FnMut(&str)) -> Result<ClosedForms, Error> {
    let mut found = ClosedForms { table: Table::new(COLUMNS), newton: 0.0, relax: 0.0 };
    let relax = |tolerance| Relax { tolerance, max_steps: 1_000_000, ..Relax::default() };
    for known in cases()? {
        for (name, solver, tolerance) in [
            ("relax", Box::new(relax(1e-4)) as Box<dyn Solver>, Some(1e-4)),
            ("relax, tolerance 1e-8", Box::new(relax(1e-8)), Some(1e-8)),
            ("newton", Box::new(Newton::default()), None),
        ] {
            let began = Instant::now();
            let folded = solver.fold(&known.model, &known.start, &Scene::percent(100.0), &mut unwatched);
            let seconds = began.elapsed().as_secs_f64();
            let Ok(folded) = folded else {
                found.table.push(vec![
                    known.name.into(),
                    name.into(),
                    Cell::Missing,
                    seconds.into(),
                    Cell::Missing,
                    known.unit().into(),
                    Cell::Missing,
                    false.into(),
                ]);
                continue;
            };
            let error = known.error(&folded.state);
            match tolerance {
                Some(tolerance) => found.relax = found.relax.max(error / tolerance),
                None => found.newton = found.newton.max(error),
            }
            let closure = closures(&known.model, &folded.state.positions).into_iter().map(|(_, c)| c).reduce(f64::max);
            found.table.push(vec![
                known.name.into(),
                name.into(),
                folded.steps.into(),
                seconds.into(),
                error.into(),
                known.unit().into(),
                closure.into(),
                folded.converged().into(),
            ]);
        }
        ran(known.name);
    }
    Ok(found)
}

/// The number of [`cases`].
pub(super) const CASES: usize = 9;

fn cases() -> Result<[Known; CASES], Error> {
    let crease = SingleCrease { angle: 2.5, ..SingleCrease::default() };
    let miura = Miura { columns: 6, rows: 5, a: 1.1, b: 0.8, theta: 0.9, ..Miura::default() };
    let waterbomb = WaterbombVertex { n: 4, polar: 110_f64.to_radians(), radius: 1.0 };
    let yoshimura = Yoshimura { columns: 6, rows: 4, ..Yoshimura::default() };
    Ok([
        Known::new("single crease", crease.pattern()?, |_| Exact::Angle(2.5))?,
        degree_4("degree 4, one crease driven, mode A", Degree4Mode::A)?,
        degree_4("degree 4, one crease driven, mode B", Degree4Mode::B)?,
        Known::new("Miura 7x6", miura.pattern()?, |model| Exact::Positions(miura_at(model, &miura)))?,
        one_driven_miura()?,
        Known::new("waterbomb vertex of 8 creases", waterbomb.pattern()?, |_| {
            let (valley, mountain) = (waterbomb.polar, waterbomb_polar(waterbomb.n, waterbomb.polar, false));
            Exact::Spokes(waterbomb_folds(waterbomb.n, valley, mountain).repeat(waterbomb.n))
        })?,
        kresling("Kresling ring, from near its first state", false)?,
        kresling("Kresling ring, from near its second state", true)?,
        Known::new("Yoshimura strip rolled up", yoshimura.pattern()?, |model| {
            Exact::Positions(cylinder_at(model, &yoshimura))
        })?,
    ])
}

fn degree_4(name: &'static str, mode: Degree4Mode) -> Result<Known, Error> {
    let (a, b) = (60_f64.to_radians(), 80_f64.to_radians());
    // The flat state belongs to both branches: all creases together choose one, and then one drives the others.
    let seed = Degree4 { a, b, mode, angle: 0.8, ..Degree4::default() }.pattern()?;
    let seed_model = Model::new(&seed, &Material::default())?;
    let seeded = Relax::default().fold_from_rest(&seed_model, 100.0);
    let pattern = Degree4 { a, b, mode, angle: 1.5, driven_only: true, ..Degree4::default() }.pattern()?;
    let known = Known::new(name, pattern, |_| Exact::Spokes(degree4(a, b, mode, 1.5).to_vec()))?;
    Ok(match seeded {
        Ok(seeded) => known.from(seeded.state.positions),
        Err(_) => known,
    })
}

fn one_driven_miura() -> Result<Known, Error> {
    let miura = Miura { columns: 4, rows: 3, theta: 0.9, ..Miura::default() };
    let mut pattern = miura.pattern()?;
    let driven = pattern.edges.iter().position(|edge| edge.fold_angle.is_some());
    for (i, edge) in pattern.edges.iter_mut().enumerate() {
        edge.fold_angle = edge.fold_angle.filter(|_| Some(i) == driven);
    }
    let known = Known::new("Miura 5x4, one crease driven", pattern, |model| Exact::Positions(miura_at(model, &miura)))?;
    let nearby = miura_at(&known.model, &Miura { theta: 0.7, ..miura });
    Ok(known.from(nearby))
}

fn kresling(name: &'static str, in_second: bool) -> Result<Known, Error> {
    let kresling = Kresling { rows: 1, height: 1.8, twist: 0.35, ..Kresling::default() };
    let made = kresling.folded();
    let (state, nearby) = match made.second_state() {
        Some(second) if in_second => (second, [1.03, 0.98]),
        _ => (made, [0.97, 1.02]),
    };
    let pattern = kresling.ring(false)?;
    let vertices = pattern.vertices.clone();
    // Vertices of the ring, found by where it was made.
    let at = |model: &Model, fold: &KreslingFold| -> Vec<DVec3> {
        let lattice = |p: DVec3| {
            let mut indices = (0..2).flat_map(|j| (0..kresling.n).map(move |i| (i, j)));
            indices.find(|(i, j)| made.vertex(*i, *j).distance(p) < 1e-9).unwrap_or((0, 0))
        };
        let nodes = model.mesh.vertex_of_node.iter().map(|v| lattice(vertices[v.index()]));
        nodes.map(|(i, j)| fold.vertex(i, j) / model.normalisation.radius).collect()
    };
    let known = Known::new(name, pattern, |model| Exact::Positions(at(model, &state)))?;
    let start = KreslingFold { height: state.height * nearby[0], twist: state.twist * nearby[1], ..state };
    let start = at(&known.model, &start);
    Ok(known.from(start))
}

/// The closed form in radii, by node.
fn miura_at(model: &Model, miura: &Miura) -> Vec<DVec3> {
    let (fold, across) = (miura.folded(), miura.columns + 1);
    let position = |vertex: usize| fold.vertex(vertex % across, vertex / across);
    model.mesh.vertex_of_node.iter().map(|v| position(v.index()) / model.normalisation.radius).collect()
}

fn cylinder_at(model: &Model, yoshimura: &Yoshimura) -> Vec<DVec3> {
    let fold = YoshimuraFold { n: yoshimura.columns, c: yoshimura.c, alpha: yoshimura.alpha };
    // The strip's vertices lie at (c (2 i + j % 2), height j).
    let height = yoshimura.c * yoshimura.alpha.tan();
    let position = |rest: DVec3| {
        let p = model.normalisation.to_file(rest);
        let j = (p.y / height).round();
        let i = ((p.x / yoshimura.c - j % 2.0) / 2.0).round();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small rounded numbers")]
        fold.vertex(i as usize, j as usize)
    };
    model.rest.iter().map(|p| position(*p) / model.normalisation.radius).collect()
}
