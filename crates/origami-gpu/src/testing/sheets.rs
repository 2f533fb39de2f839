//! Sheets with what [`crate::testing::cases::cases`] do not have.

use glam::DVec3;
use origami_core::generate::Miura;
use origami_core::ids::VertexId;
use origami_core::pattern::{Assignment, CreasePattern, PatternEdge};
use origami_core::{Material, Model, State};

use crate::testing::cases::{Case, Random, cases};

fn edge(a: u32, b: u32, ea: Option<f64>) -> PatternEdge {
    let vertices = [a, b].map(VertexId);
    PatternEdge { vertices, assignment: Assignment::Boundary, fold_angle: None, k_crease: None, ea, alias_of: None }
}

fn model(mut pattern: CreasePattern, material: &Material) -> Model {
    pattern.alias_of = vec![None; pattern.vertices.len()];
    (pattern.vertices_in_file, pattern.edges_in_file) = (pattern.vertices.len(), pattern.edges.len());
    Model::new(&pattern, material).expect("a model")
}

/// A Miura with three beams outside any face, one of them of its own rigidity: two to a point of their own.
pub(crate) fn loose_beams() -> Model {
    let mut pattern = Miura { columns: 3, rows: 3, ..Miura::default() }.pattern().expect("a pattern");
    let (corner, out) = (pattern.vertices[0], pattern.vertices.len() as u32);
    pattern.vertices.push(corner + DVec3::new(-0.7, -0.4, 0.3));
    pattern.edges.extend([edge(0, out, None), edge(1, out, Some(3.0)), edge(0, out - 1, None)]);
    model(pattern, &Material::paper())
}

/// Each node moved at random, with velocities.
fn moved(name: &'static str, model: Model) -> Case {
    let mut random = Random(name.len() as u64);
    let mut state = State::at_rest(&model);
    state.positions.iter_mut().for_each(|p| *p += random.vector(0.03));
    state.velocities.iter_mut().for_each(|v| *v = random.vector(0.5).as_vec3().as_dvec3());
    let single = |angles: Vec<f64>| angles.into_iter().map(|a| f64::from(a as f32)).collect();
    state.fold_angles = single(state.fold_angles);
    state.targets = single(model.targets(60.0));
    Case { name, model, state }
}

/// The same of a sheet that is squeezed, so that most triangles have less than a fifth of their area.
fn squeezed(name: &'static str, model: Model) -> Case {
    let mut case = moved(name, model);
    for (position, rest) in case.state.positions.iter_mut().zip(&case.model.rest) {
        *position = DVec3::new(rest.x, 0.1 * rest.y, rest.z) + 0.1 * (*position - *rest);
    }
    case
}

/// Loose beams, and sheets without damping, corner angles, creases, or with two stiffnesses.
pub(crate) fn special() -> Vec<Case> {
    let miura = |material: Material| {
        let pattern = Miura { columns: 3, rows: 4, ..Miura::default() }.pattern().expect("a pattern");
        Model::new(&pattern, &material).expect("a model")
    };
    let plain = Material::paper();
    vec![
        moved("loose beams", loose_beams()),
        moved("no damping", miura(Material { zeta: 0.0, ..plain })),
        moved("no corner angles", miura(Material { k_face: 0.0, ..plain })),
        moved("no folds", miura(Material { k_fold: 0.0, ..plain })),
        moved("no springs but beams", miura(Material { k_fold: 0.0, k_facet: 0.0, k_face: 0.0, ..plain })),
        moved("two stiffnesses", miura(Material { k_fold: 3.0, k_facet: 0.2, ..plain })),
        squeezed("areas", miura(Material::default())),
        squeezed("areas without corner angles", miura(Material { k_face: 0.0, collapse: 0.5, ..Material::default() })),
        beam(DVec3::new(0.7, 0.1, -0.3), DVec3::new(-0.2, 0.4, 0.6)),
    ]
}

/// All cases with creases that resist: others are never soft.
pub(crate) fn creased() -> impl Iterator<Item = Case> {
    cases().into_iter().chain(special()).filter(|case| case.model.stiffest_crease > 0.0)
}

/// Which of the beams of [`beam`] is the long one.
pub(crate) const BEAM: usize = 0;

fn beam_pattern() -> CreasePattern {
    let vertices = vec![DVec3::new(-1.0, 0.0, 0.0), DVec3::new(0.111_222_333, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0)];
    CreasePattern { vertices, edges: vec![edge(0, 1, None), edge(1, 2, None)], ..CreasePattern::default() }
}

/// The rest length of the beam of [`beam`].
pub(crate) fn beam_length() -> f64 {
    model(beam_pattern(), &Material::paper()).beams[BEAM].rest_length
}

/// Two beams in a row, no face; the ends of the first at `from` and `to`, the second at its rest length.
pub(crate) fn beam(from: DVec3, to: DVec3) -> Case {
    let model = model(beam_pattern(), &Material::paper());
    let mut state = State::at_rest(&model);
    state.positions = vec![from, to, to + DVec3::Z * model.beams[1].rest_length];
    state.velocities = vec![DVec3::new(0.25, -0.5, 0.0), DVec3::new(-0.125, 0.0, 0.375), DVec3::ZERO];
    Case { name: "beams alone", model, state }
}
