//! Closed forms of rigid folding, met through the public interface. Where one crease is driven and the others are free,
//! the rigid state has no energy: any distance from it is the solver's error.

mod common;

use common::model;
use origami::generate::{Degree4, Kresling, Miura, SingleCrease, WaterbombVertex, Yoshimura};
use origami::glam::DVec3;
use origami::measure::{align, closures, edge_fold_angles};
use origami::rigid::{Degree4Mode, KreslingFold, YoshimuraFold, degree4, loop_closure, waterbomb_polar};
use origami::scene::Scene;
use origami::solve::unwatched;
use origami::{CreasePattern, Folded, Model, Relax, Solver, State};

/// A solver, and what is asked of it.
struct Method {
    name: &'static str,
    solver: Box<dyn Solver>,
    /// Distance from the closed form, of fold angles in radians and of positions in radii.
    near: f64,
}

fn methods() -> Vec<Method> {
    // Far tighter than the default, so that angles are good to about 1e-8.
    let relax = Relax { tolerance: 1e-10, max_steps: 1_000_000, ..Relax::default() };
    vec![
        Method { name: "relax", solver: Box::new(relax), near: 1e-7 },
        #[cfg(feature = "newton")]
        Method { name: "newton", solver: Box::new(origami::Newton::default()), near: 1e-9 },
        #[cfg(feature = "newton")]
        Method {
            name: "newton in increments",
            solver: Box::new(origami::Newton { relax: None, ..origami::Newton::default() }),
            near: 1e-9,
        },
    ]
}

fn by_each_solver(scene: impl Fn(&Method)) {
    for method in methods() {
        eprintln!("by {}", method.name);
        scene(&method);
    }
}

impl Method {
    fn fold(&self, model: &Model, start: &State) -> Folded {
        let folded = self.solver.fold(model, start, &Scene::percent(100.0), &mut unwatched).expect("holds");
        assert!(folded.converged(), "distance {} after {} steps", folded.distance, folded.steps);
        folded
    }
}

/// The fold angles of the given edges.
fn angles(model: &Model, pattern: &CreasePattern, state: &State, edges: &[[u32; 2]]) -> Vec<f64> {
    let reached = edge_fold_angles(model, pattern, state);
    let edge = |ends: &[u32; 2]| {
        let place = pattern.edges.iter().position(|e| {
            let vertices = e.vertices.map(|v| v.0);
            vertices == *ends || [vertices[1], vertices[0]] == *ends
        });
        reached[place.expect("such an edge")].expect("a fold angle")
    };
    edges.iter().map(edge).collect()
}

#[test]
fn a_single_crease_reaches_its_angle() {
    by_each_solver(|method| {
        for angle in [-3.1, -1.0, 0.3, 2.5] {
            let pattern = SingleCrease { angle, ..SingleCrease::default() }.pattern().expect("valid");
            let model = model(&pattern);
            let folded = method.fold(&model, &State::at_rest(&model));
            assert!((folded.state.fold_angles[0] - angle).abs() < method.near);
            assert!(folded.state.energy(&model).total() < 1e-15, "no strain");
        }
    });
}

#[test]
fn a_driven_vertex_of_degree_4_follows_both_branches() {
    by_each_solver(|method| {
        let spokes: Vec<[u32; 2]> = (1..5).map(|k| [0, k]).collect();
        let (a, b) = (60_f64.to_radians(), 80_f64.to_radians());
        for mode in [Degree4Mode::A, Degree4Mode::B] {
            // The flat state belongs to both branches: all creases together choose one ...
            let seed = Degree4 { a, b, mode, angle: 0.8, ..Degree4::default() }.pattern().expect("valid");
            let seed_model = model(&seed);
            let seeded = method.fold(&seed_model, &State::at_rest(&seed_model)).state;
            // ... and one crease alone then drives the others along it.
            for angle in [0.4, 1.5, 2.6] {
                let pattern =
                    Degree4 { a, b, mode, angle, driven_only: true, ..Degree4::default() }.pattern().expect("valid");
                let model = model(&pattern);
                assert_eq!(model.creases.len(), 1, "three creases are free");
                let folded = method.fold(&model, &State::at(&model, seeded.positions.clone()));
                let reached = angles(&model, &pattern, &folded.state, &spokes);
                let expected = degree4(a, b, mode, angle);
                for (reached, expected) in reached.iter().zip(expected) {
                    assert!(
                        (reached - expected).abs() < method.near,
                        "{mode:?} at {angle}: {reached}, expected {expected}"
                    );
                }
                let sectors = [a, b, std::f64::consts::PI - a, std::f64::consts::PI - b];
                let closure = loop_closure(&reached.iter().copied().zip(sectors).collect::<Vec<_>>());
                assert!(closure < method.near, "the loop around the vertex does not close: {closure}");
            }
        }
    });
}

#[test]
fn a_miura_sheet_takes_its_closed_form() {
    by_each_solver(|method| {
        let miura = Miura { columns: 6, rows: 5, a: 1.1, b: 0.8, theta: 0.9, ..Miura::default() };
        let pattern = miura.pattern().expect("valid");
        let model = model(&pattern);
        let folded = method.fold(&model, &State::at_rest(&model)).state;
        let exact = miura_positions(&model, &miura);
        let distance = align(&folded.positions, &exact).max;
        assert!(distance < method.near, "{distance} from the closed form");
        // The check can fail: another inclination is another shape.
        let other = miura_positions(&model, &Miura { theta: 0.9001, ..miura });
        assert!(align(&folded.positions, &other).max > 100.0 * method.near);
    });
}

#[test]
fn one_driven_crease_folds_a_whole_miura_sheet() {
    by_each_solver(|method| {
        let miura = Miura { columns: 4, rows: 3, theta: 0.9, ..Miura::default() };
        let mut pattern = miura.pattern().expect("valid");
        let driven = pattern.edges.iter().position(|e| e.fold_angle.is_some()).expect("a crease");
        for (i, edge) in pattern.edges.iter_mut().enumerate() {
            edge.fold_angle = edge.fold_angle.filter(|_| i == driven);
        }
        let model = model(&pattern);
        let seed = miura_positions(&model, &Miura { theta: 0.7, ..miura });
        let folded = method.fold(&model, &State::at(&model, seed)).state;
        let distance = align(&folded.positions, &miura_positions(&model, &miura)).max;
        assert!(distance < 10.0 * method.near, "{distance} from the closed form");
    });
}

/// How far the worst interior vertex is from closing.
fn worst_closure(model: &Model, state: &State) -> f64 {
    let all = closures(model, &state.positions);
    assert!(!all.is_empty(), "a sheet with interior vertices");
    all.into_iter().map(|(_, closure)| closure).fold(0.0, f64::max)
}

#[test]
fn loops_close_where_the_fold_is_rigid_and_not_where_it_is_strained() {
    let miura = Miura { columns: 6, rows: 5, theta: 0.9, ..Miura::default() };
    let waterbomb = WaterbombVertex { n: 4, polar: 1.2, radius: 1.0 };
    let yoshimura = Yoshimura { columns: 6, rows: 4, ..Yoshimura::default() };
    let patterns = [miura.pattern(), waterbomb.pattern(), yoshimura.pattern()];
    by_each_solver(|method| {
        for pattern in &patterns {
            let model = model(pattern.as_ref().expect("valid"));
            let folded = method.fold(&model, &State::at_rest(&model)).state;
            let closure = worst_closure(&model, &folded);
            assert!(closure < 10.0 * method.near, "{closure}");
            let halfway = method
                .solver
                .fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut unwatched)
                .expect("holds");
            assert!(worst_closure(&model, &halfway.state) > 1e-4, "at 60 % the sheet is strained");
        }
    });
}

/// The closed form in the model's units, by node.
fn miura_positions(model: &Model, miura: &Miura) -> Vec<DVec3> {
    let fold = miura.folded();
    let points = (0..=miura.rows).flat_map(|j| (0..=miura.columns).map(move |i| fold.vertex(i, j)));
    points.map(|p| p / model.normalisation.radius).collect()
}

#[test]
fn a_waterbomb_vertex_reaches_its_angles_on_both_branches() {
    by_each_solver(|method| {
        for n in [3, 4, 6] {
            for polar in [70_f64.to_radians(), 110_f64.to_radians()] {
                let pattern = WaterbombVertex { n, polar, radius: 1.0 }.pattern().expect("valid");
                let model = model(&pattern);
                let folded = method.fold(&model, &State::at_rest(&model)).state;
                assert!(folded.energy(&model).total() < 1e-14, "a rigid state has no energy");
                // Valley and mountain creases end at the polar angles of the closed form.
                let spoke = |k: usize| folded.positions[k] - folded.positions[0];
                let axis: DVec3 = (1..=n).map(|k| spoke(2 * k - 1).cross(spoke((2 * k) % (2 * n) + 1))).sum();
                let reached = |k: usize| spoke(k).angle_between(axis);
                let other = waterbomb_polar(n, polar, false);
                assert!((reached(1) - polar).abs() < method.near, "n {n}: {} is not {polar}", reached(1));
                assert!((reached(2) - other).abs() < method.near, "n {n}: {} is not {other}", reached(2));
            }
        }
    });
}

#[test]
fn three_free_valleys_of_a_waterbomb_vertex_follow_three_driven_mountains() {
    by_each_solver(|method| {
        let polar = 70_f64.to_radians();
        let mut pattern = WaterbombVertex { n: 3, polar, radius: 1.0 }.pattern().expect("valid");
        let all: Vec<[u32; 2]> = (1..7).map(|k| [0, k]).collect();
        let seed_model = model(&pattern);
        let seed = method.fold(&seed_model, &State::at_rest(&seed_model)).state;
        let expected = angles(&seed_model, &pattern, &seed, &all);
        for edge in &mut pattern.edges {
            edge.fold_angle = edge.fold_angle.filter(|angle| *angle < 0.0);
        }
        let model = model(&pattern);
        let mut start = State::at(&model, seed.positions.clone());
        start.positions[0].z += 0.01;
        let folded = method.fold(&model, &start).state;
        for (reached, expected) in angles(&model, &pattern, &folded, &all).iter().zip(expected) {
            assert!((reached - expected).abs() < method.near, "{reached} is not {expected}");
        }
    });
}

#[test]
fn a_kresling_ring_snaps_into_its_second_state() {
    by_each_solver(|method| {
        let kresling = Kresling { rows: 1, height: 1.8, twist: 0.35, ..Kresling::default() };
        let second = kresling.folded().second_state().expect("bistable");
        // METHOD's figures for n 6, R 1.
        assert!((second.height - 1.007_868_188_7).abs() < 1e-9 && (second.twist - 1.744_395_102_4).abs() < 1e-9);
        let pattern = kresling.ring(false).expect("valid");
        let model = model(&pattern);
        assert!(model.creases.is_empty(), "all hinges are free");

        for (state, nearby) in [(kresling.folded(), [0.97, 1.02]), (second, [1.03, 0.98])] {
            let start = KreslingFold { height: state.height * nearby[0], twist: state.twist * nearby[1], ..state };
            let start = State::at(&model, kresling_positions(&model, &pattern, &kresling, &start));
            assert!(start.energy(&model).total() > 1e-4, "away from both states bars are strained");
            let folded = method.fold(&model, &start).state;
            assert!(folded.energy(&model).total() < 1e-15);
            let distance = align(&folded.positions, &kresling_positions(&model, &pattern, &kresling, &state)).max;
            assert!(distance < method.near, "{distance} from the state of height {}", state.height);
        }
    });
}

/// The nodes of a ring made for `kresling` when it has the shape `fold`, in the model's units.
fn kresling_positions(model: &Model, pattern: &CreasePattern, kresling: &Kresling, fold: &KreslingFold) -> Vec<DVec3> {
    let made = kresling.folded();
    lattice_positions(model, pattern, [kresling.n, 1], |i, j| made.vertex(i, j), |i, j| fold.vertex(i, j))
}

/// Finds the lattice place of each node in the shape `made` and puts it there in the shape `wanted`.
fn lattice_positions(
    model: &Model,
    pattern: &CreasePattern,
    [columns, rows]: [usize; 2],
    made: impl Fn(usize, usize) -> DVec3,
    wanted: impl Fn(usize, usize) -> DVec3,
) -> Vec<DVec3> {
    let places: Vec<[usize; 2]> = (0..=rows).flat_map(|j| (0..columns).map(move |i| [i, j])).collect();
    let place = |p: DVec3| places.iter().find(|[i, j]| made(*i, *j).distance(p) < 1e-9).expect("a vertex of the ring");
    let nodes = model.mesh.vertex_of_node.iter().map(|v| place(pattern.vertices[v.index()]));
    nodes.map(|[i, j]| wanted(*i, *j) / model.normalisation.radius).collect()
}

#[test]
fn a_yoshimura_strip_rolls_up_into_its_cylinder() {
    by_each_solver(|method| {
        let yoshimura = Yoshimura { columns: 6, rows: 4, ..Yoshimura::default() };
        let fold = YoshimuraFold { n: 6, c: yoshimura.c, alpha: yoshimura.alpha };
        let pattern = yoshimura.pattern().expect("valid");
        let model = model(&pattern);
        let folded = method.fold(&model, &State::at_rest(&model)).state;
        assert!(folded.energy(&model).total() < 1e-14);
        // The strip's vertices lie at (c (2 i + j % 2), height j).
        let height = yoshimura.c * yoshimura.alpha.tan();
        let cylinder = model.mesh.vertex_of_node.iter().map(|v| {
            let p = pattern.vertices[v.index()];
            let j = (p.y / height).round();
            let i = ((p.x / yoshimura.c - j % 2.0) / 2.0).round();
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small rounded numbers")]
            let place = [i as usize, j as usize];
            fold.vertex(place[0], place[1]) / model.normalisation.radius
        });
        let distance = align(&folded.positions, &cylinder.collect::<Vec<_>>()).max;
        assert!(distance < 10.0 * method.near, "{distance} from the cylinder");
    });
}

#[test]
fn a_dented_yoshimura_ring_comes_back_to_its_radius_and_height() {
    by_each_solver(|method| {
        let yoshimura = Yoshimura { columns: 6, rows: 3, ..Yoshimura::default() };
        let fold = YoshimuraFold { n: 6, c: yoshimura.c, alpha: yoshimura.alpha };
        let pattern = yoshimura.ring(true).expect("valid");
        let model = model(&pattern);
        let exact = lattice_positions(&model, &pattern, [6, 3], |i, j| fold.vertex(i, j), |i, j| fold.vertex(i, j));
        let mut start = State::at_rest(&model);
        for (i, p) in start.positions.iter_mut().enumerate() {
            let i = i as f64;
            *p += 0.03 * DVec3::new((1.7 * i).sin(), (2.9 * i).cos(), (4.1 * i).sin());
        }
        let folded = method.fold(&model, &start).state;
        let distance = align(&folded.positions, &exact).max;
        assert!(distance < method.near, "{distance} from the cylinder");
    });
}
