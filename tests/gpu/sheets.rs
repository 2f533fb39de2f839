//! The sheets that are compared, and by how much what they come to may differ.

use origami::generate::{BirdBase, Fan, Kresling, Miura, Waterbomb};
use origami::glam::DVec3;
use origami::gpu::Dispatch;
use origami::ids::VertexId;
use origami::pattern::Assignment;
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::solve::{Integrator, TimeStep};
use origami::{CreasePattern, Dynamics, Folded, Material, Model, Relax, Solver, State};

use crate::common::{self, largest_distance};

/// How far trajectories of 300 steps may be apart, in radii. Forces come in single precision, 1e-7 of their size each, and
/// positions are kept to 1e-11: 1e-7 of a motion of 1 with damping, some 1e-6 without, where nothing forgets an error.
pub(crate) const TRAJECTORY: f64 = 5e-6;

/// And their velocities: an error vibrates with the frequency of a short beam, sqrt(2 EA / l), here some 10.
pub(crate) const VELOCITY: f64 = 10.0 * TRAJECTORY;

/// How far equilibria may be apart, in radii: both solvers stop within 1e-4 of it, where soft directions count for more.
pub(crate) const EQUILIBRIUM: f64 = 1e-3;

/// By how much their energies may differ, relative to the energy to be released.
pub(crate) const ENERGY: f64 = 1e-4;

/// How far a position is from the one that buffers hold, in radii.
pub(crate) const HELD: f64 = 1e-11;

pub(crate) const STEPS: u64 = 300;

pub(crate) const WAYS: &[Dispatch] = Dispatch::WAYS;

/// What shaders have of it: neither clusters of near nodes nor the search for saddles nor Newton's method.
pub(crate) fn relax() -> Relax {
    Relax { near: 0.0, saddle_search: 0.0, hand_over: None, ..Relax::default() }
}

pub(crate) fn built(pattern: &CreasePattern, material: Material) -> Model {
    Model::new(pattern, &material).expect("a model")
}

pub(crate) fn miura(columns: usize, rows: usize) -> CreasePattern {
    Miura { columns, rows, ..Miura::default() }.pattern().expect("a pattern")
}

/// A square grid of which two neighbouring inner edges are cut.
pub(crate) fn with_slit() -> CreasePattern {
    let side = 5_u32;
    let (mut edges, mut letters) = (Vec::new(), Vec::new());
    for here in 0..side * side {
        let (row, column) = (here / side, here % side);
        if column + 1 < side {
            let cut = row == 2 && (column == 1 || column == 2);
            let inner = row > 0 && row + 1 < side;
            edges.push(format!("[{here},{}]", here + 1));
            letters.push(if cut {
                "C"
            } else if !inner {
                "B"
            } else if (row + column) % 2 == 0 {
                "M"
            } else {
                "V"
            });
        }
        if row + 1 < side {
            let inner = column > 0 && column + 1 < side;
            edges.push(format!("[{here},{}]", here + side));
            letters.push(if !inner {
                "B"
            } else if column % 2 == 0 {
                "M"
            } else {
                "V"
            });
        }
    }
    let points: Vec<String> = (0..side * side).map(|i| format!("[{},{}]", i % side, i / side)).collect();
    let text = format!(
        r#"{{"vertices_coords":[{}],"edges_vertices":[{}],"edges_assignment":["{}"]}}"#,
        points.join(","),
        edges.join(","),
        letters.join("\",\"")
    );
    let document = origami::fold::Document::from_slice(text.as_bytes()).expect("a document");
    CreasePattern::from_document(&document, 0).expect("a pattern")
}

/// A Miura with two beams to a point outside any face, one of its own rigidity.
pub(crate) fn with_loose_beams() -> CreasePattern {
    let mut pattern = miura(3, 3);
    let out = pattern.vertices.len() as u32;
    let apart = DVec3::new(-0.7, -0.4, 0.3);
    pattern.vertices.push(pattern.vertices[0] + apart);
    let mut edges = [(0, out), (1, out)].map(|(a, b)| common::edge(a, b, Assignment::Boundary, None));
    edges[1].ea = Some(5.0);
    pattern.edges.extend(edges);
    common::pattern(pattern.vertices, pattern.edges, &[]).with_faces(pattern.faces)
}

trait WithFaces {
    fn with_faces(self, faces: Vec<Vec<VertexId>>) -> Self;
}

impl WithFaces for CreasePattern {
    fn with_faces(self, faces: Vec<Vec<VertexId>>) -> Self {
        Self { faces, ..self }
    }
}

/// Fixed vertices, stiffnesses of edges' own, and creases that nothing drives.
pub(crate) fn with_own_springs() -> CreasePattern {
    let mut pattern = miura(4, 4);
    pattern.fixed = vec![VertexId(0), VertexId(6)];
    for (i, edge) in pattern.edges.iter_mut().enumerate() {
        match i % 4 {
            0 => edge.k_crease = Some(2.0),
            1 => edge.ea = Some(35.0),
            2 => edge.fold_angle = None,
            _ => {}
        }
    }
    pattern
}

/// What is compared: a sheet of every kind that the pipelines are built for.
pub(crate) fn sheets() -> Vec<(&'static str, Model)> {
    let plain = Material::default();
    vec![
        ("miura", built(&miura(5, 4), plain)),
        ("bird base", built(&BirdBase::default().pattern().expect("a pattern"), plain)),
        ("kresling", built(&Kresling::default().pattern().expect("a pattern"), plain)),
        ("waterbomb", built(&Waterbomb::default().pattern().expect("a pattern"), plain)),
        ("fan", built(&Fan::default().pattern().expect("a pattern"), plain)),
        ("slit", built(&with_slit(), plain)),
        ("loose beams", built(&with_loose_beams(), plain)),
        ("own springs", built(&with_own_springs(), plain)),
        ("k_face 0", built(&miura(4, 3), Material { k_face: 0.0, ..plain })),
        ("k_fold 0", built(&Kresling::default().pattern().expect("a pattern"), Material { k_fold: 0.0, ..plain })),
        ("zeta 0", built(&miura(3, 4), Material { zeta: 0.0, ..plain })),
    ]
}

pub(crate) fn sheet(wanted: &str) -> Model {
    sheets().into_iter().find(|(name, _)| *name == wanted).expect("one of this name").1
}

/// Off the plane, so that every force is at work from the first step.
pub(crate) fn start(model: &Model) -> State {
    let mut state = State::perturbed(model, 1e-2, 3);
    for node in &model.fixed {
        state.positions[node.index()] = model.rest[node.index()];
    }
    state
}

pub(crate) fn folded(solver: &dyn Solver, model: &Model, percent: f64) -> Folded {
    solver.fold(model, &start(model), &Scene::percent(percent), &mut unwatched).expect("it holds")
}

pub(crate) fn apart(a: &State, b: &State) -> f64 {
    largest_distance(&a.positions, &b.positions)
}

/// Ways to step through time. The paper's step does not hold on every sheet: where it does not, the safe one is taken.
pub(crate) fn ways() -> [(Dynamics, Dispatch); 7] {
    let (steps, plain) = (Some(STEPS), Dynamics::default());
    let (safe, verlet) = (TimeStep::Safe, Integrator::Verlet);
    [
        (Dynamics { steps, ..plain.clone() }, Dispatch::Passes),
        (Dynamics { steps, time_step: safe, ramp: 90, ..plain.clone() }, Dispatch::Workgroup),
        (Dynamics { steps, time_step: safe, integrator: verlet, ..plain.clone() }, Dispatch::Passes),
        (Dynamics { steps, time_step: safe, integrator: verlet, ramp: 130, ..plain.clone() }, Dispatch::Workgroup),
        (Dynamics { steps, ..plain.clone() }, Dispatch::Blocks),
        (Dynamics { steps, time_step: safe, ramp: 90, ..plain.clone() }, Dispatch::Blocks),
        (Dynamics { steps, time_step: safe, integrator: verlet, ramp: 130, ..plain }, Dispatch::Blocks),
    ]
}
