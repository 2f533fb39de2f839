//! Turning of results: one shape, one attitude.

use std::ops::ControlFlow;

use origami_core::generate::{Crane, Miura, SingleCrease, catalog};
use origami_core::glam::{DQuat, DVec3, EulerRot};
use origami_core::ids::{FaceId, NodeId, VertexId};
use origami_core::measure::attitude::{Hold, Motion, motion, turned};
use origami_core::solve::fold_path;
use origami_core::{CreasePattern, Material, Model, Relax, Solver, State, glam};

fn model(pattern: &CreasePattern) -> Model {
    Model::new(pattern, &Material::default()).expect("a sheet")
}

fn folded(model: &Model, percent: f64) -> State {
    Relax { tolerance: 1e-7, ..Relax::default() }.fold_from_rest(model, percent).expect("folds").state
}

fn moved(state: &State, rotation: DQuat, by: DVec3) -> State {
    let positions = state.positions.iter().map(|p| rotation * *p + by).collect();
    State { positions, ..state.clone() }
}

fn motions() -> impl Iterator<Item = (DQuat, DVec3)> {
    (0..12).map(f64::from).map(|i| {
        let rotation = DQuat::from_euler(EulerRot::XYZ, 0.9 * i, 1.7 * i + 0.3, 2.9 * i - 1.0);
        (rotation, DVec3::new(0.3 * i, -2.0, 5.0 - i))
    })
}

/// The farthest that a node of one lies from that of the other.
fn apart(a: &State, b: &State) -> f64 {
    a.positions.iter().zip(&b.positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

/// Every pattern, open, half folded and folded flat: shapes that tell their attitude, and shapes that leave it open.
#[test]
fn a_shape_ends_in_one_place_however_it_lies() {
    for name in catalog::names() {
        let model = model(&catalog::generate(name, &[]).unwrap());
        for percent in [0.0, 30.0, 60.0, 95.0, 100.0] {
            let state = folded(&model, percent);
            for hold in [Hold::Sheet, Hold::Face(FaceId(0))] {
                let first = turned(&model, &state, hold).unwrap();
                for (rotation, by) in motions() {
                    let again = turned(&model, &moved(&state, rotation, by), hold).unwrap();
                    assert!(apart(&first, &again) < 1e-9, "{name} at {percent} %, {hold:?}: {}", apart(&first, &again));
                }
            }
        }
    }
}

/// The mean square distance from the sheet before folding, by points strewn over each triangle: nothing of the integrals.
fn distance(model: &Model, state: &State, motion: &Motion) -> f64 {
    const PARTS: usize = 8;
    let (mut sum, mut area) = (0.0, 0.0);
    for nodes in &model.mesh.triangles {
        let at = |points: &[DVec3], i: usize, j: usize| {
            let [a, b, c] = nodes.map(|n| points[n.index()]);
            a + (b - a) * ((i as f64 + 1.0 / 3.0) / PARTS as f64) + (c - a) * ((j as f64 + 1.0 / 3.0) / PARTS as f64)
        };
        let [a, b, c] = nodes.map(|n| model.rest[n.index()]);
        let own = (b - a).cross(c - a).length();
        let inside = (0..PARTS).flat_map(|i| (0..PARTS - i).map(move |j| (i, j)));
        for (i, j) in inside {
            sum += own * motion.apply(at(&state.positions, i, j)).distance_squared(at(&model.rest, i, j));
            area += own;
        }
    }
    sum / area
}

#[test]
fn no_motion_lays_it_nearer() {
    for pattern in [Miura::default().pattern(), Crane::default().pattern(), catalog::generate("kresling", &[])] {
        let model = model(&pattern.unwrap());
        let state = folded(&model, 40.0);
        let best = motion(&model, &state.positions, Hold::Sheet).unwrap();
        let least = distance(&model, &state, &best);
        let centre = state.positions.iter().sum::<DVec3>() / state.positions.len() as f64;
        for step in [0.03, 0.3, 2.0] {
            for (axis, by) in
                [(DVec3::X, DVec3::Y), (DVec3::Y, DVec3::Z), (DVec3::Z, DVec3::X), (DVec3::ONE, DVec3::NEG_X)]
            {
                for sign in [-1.0, 1.0] {
                    let more = glam::DMat3::from_axis_angle(axis.normalize(), sign * step);
                    let rotation = best.rotation * more;
                    let translation = best.apply(centre) - rotation * centre + by * (0.01 * step);
                    let other = Motion { rotation, translation };
                    assert!(distance(&model, &state, &other) > least, "{step} {axis}");
                }
            }
        }
    }
}

/// Its two faces stand alike, each turned by half the angle, and its middle stays where it was.
#[test]
fn a_sheet_with_one_fold_stands_like_a_roof() {
    let model = model(&SingleCrease::default().pattern().unwrap());
    for percent in [20.0, 50.0, 70.0] {
        let state = turned(&model, &folded(&model, percent), Hold::Sheet).unwrap();
        let half = (percent * 1.8_f64 / 2.0).to_radians();
        for (now, before) in state.positions.iter().zip(&model.rest) {
            let height = (before.x.abs() - model.rest[0].x.abs() / 3.0) * half.sin();
            let expected = DVec3::new(before.x * half.cos(), before.y, height);
            assert!(now.distance(expected) < 1e-5, "{percent} %: {now} for {expected}");
        }
    }
}

#[test]
fn what_is_folded_flat_lies_flat() {
    for name in ["single-crease", "miura", "waterbomb", "square-twist", "bird-base", "strip"] {
        let model = model(&catalog::generate(name, &[]).unwrap());
        for (rotation, by) in motions().take(3) {
            let state = turned(&model, &moved(&folded(&model, 100.0), rotation, by), Hold::Sheet).unwrap();
            let height = state.positions.iter().map(|p| p.z.abs()).fold(0.0, f64::max);
            assert!(height < 1e-4, "{name}: {height}");
        }
    }
}

/// From step to step of 2.5 % nothing turns over, though some of these end folded flat.
#[test]
fn neighbouring_shapes_lie_alike() {
    for name in
        ["single-crease", "miura", "waterbomb", "bird-base", "square-twist", "yoshimura", "kresling", "degree-4"]
    {
        let model = model(&catalog::generate(name, &[]).unwrap());
        let percents: Vec<f64> = (0..=40).map(|i| 2.5 * f64::from(i)).collect();
        let folded = fold_path(&model, &Relax::default(), &percents, &mut |_, _| ControlFlow::Continue(())).unwrap();
        let states: Vec<State> = folded.iter().map(|f| turned(&model, &f.state, Hold::Sheet).unwrap()).collect();
        for (percent, two) in percents.iter().zip(states.windows(2)) {
            assert!(apart(&two[0], &two[1]) < 0.55, "{name} after {percent} %: {}", apart(&two[0], &two[1]));
        }
    }
}

#[test]
fn a_face_that_is_held_lies_where_it_lay() {
    let model = model(&Miura::default().pattern().unwrap());
    let state = folded(&model, 50.0);
    let of = |face: u32| -> Vec<NodeId> {
        let triangles = model.mesh.triangles.iter().zip(&model.mesh.face_of_triangle);
        triangles.filter(|(_, of)| of.0 == face).flat_map(|(nodes, _)| *nodes).collect()
    };
    for face in [0, 3] {
        let held = turned(&model, &state, Hold::Face(FaceId(face))).unwrap();
        for node in of(face) {
            let moved = held.positions[node.index()].distance(model.rest[node.index()]);
            assert!(moved < 3e-3, "face {face}: {moved}");
        }
        assert!(apart(&held, &State::at_rest(&model)) > 0.3, "the others fold");
    }
    let error = turned(&model, &state, Hold::Face(FaceId(999))).unwrap_err();
    assert!(error.to_string().contains("999"), "{error}");
}

#[test]
fn what_must_not_be_turned_is_not() {
    let mut pattern = Miura::default().pattern().unwrap();
    let free = model(&pattern);
    pattern.fixed = vec![VertexId(0)];
    let fixed = model(&pattern);
    let state = moved(&folded(&free, 60.0), DQuat::from_rotation_x(1.0), DVec3::ONE);
    assert_eq!(turned(&fixed, &state, Hold::Sheet).unwrap(), state, "a fixed vertex holds it");
    assert_eq!(turned(&free, &state, Hold::Nothing).unwrap(), state);
    let mut lost = state.clone();
    lost.positions[1].y = f64::NAN;
    assert_eq!(motion(&free, &lost.positions, Hold::Sheet).unwrap(), Motion::NONE);
    // Every bit of a sheet that was not folded.
    let rest = State::at_rest(&free);
    assert_eq!(turned(&free, &rest, Hold::Sheet).unwrap(), rest);
}

#[test]
fn velocities_turn_along() {
    let model = model(&Miura::default().pattern().unwrap());
    let mut state = moved(&State::at_rest(&model), DQuat::from_rotation_y(0.5), DVec3::X);
    state.velocities = state.positions.iter().map(|p| *p - DVec3::X).collect();
    let back = turned(&model, &state, Hold::Sheet).unwrap();
    let off = back.velocities.iter().zip(&model.rest).map(|(v, p)| v.distance(*p)).fold(0.0, f64::max);
    assert!(off < 1e-12, "{off}");
}
