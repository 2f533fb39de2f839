//! Inverse design: what is found is as wanted, by what is known of it.

use origami_core::analysis::{Axis, Effort, Goal, Judgement, Members, Variable, Watched};
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::Axes;

use crate::kresling::{SIDES, kresling};
use crate::miura::miura;

#[test]
fn a_kresling_has_its_second_state_at_the_height_wanted() {
    // Stress-free at 1.5 and 40 degrees, and again at 1.0321 and 80 degrees: psi2 = pi - 2 pi / N - psi1.
    let first = kresling(1.5, 40_f64.to_radians());
    let second = kresling(1.0320888862379558, 80_f64.to_radians()).as_drawn();
    assert!(first.energies(&second).total() < 1e-25, "{:?}", first.energies(&second));
    let kind = |k: usize| Members::RestLengths((0..SIDES as usize).map(|i| 3 * i + k).collect());
    let variables = [0, 1].map(|k| Variable { members: kind(k), bounds: [1.0, 3.0] });
    let wanted = 0.9;
    let of = (SIDES..2 * SIDES).map(NodeId).collect();
    let goals = [(1.0, Goal::Height { of, above: Vec::new(), axis: Axis::Z, wanted })];
    let effort = Effort { enough: 1e-20, ..Effort::default() };
    let watched = [Watched { start: second, load_factor: 0.0 }];
    let mut judge = |own: &_, states: &[_]| Goal::judge_all(&goals, own, states, 0.0);
    let found = first.design(&watched, &variables, &effort, &mut judge).expect("a design");
    // It never rises, and the history ends with what was found.
    assert!(found.history.windows(2).all(|pair| pair[1].value < pair[0].value), "{:?}", found.history);
    assert_eq!(found.history.last().map(|last| last.value), Some(found.value));
    assert!(found.value <= 1e-20, "{found:?}");
    let top = &found.states[0].positions[SIDES as usize..];
    assert!(top.iter().all(|p| (p.z - wanted).abs() < 1e-9), "{top:?}");
    // It is stress-free there, and so is the first state: its height by the closed form
    // z1^2 = z2^2 - 4 cos(pi / N) cos(psi2 + pi / N).
    assert!(found.structure.energies(&found.states[0]).total() < 1e-20);
    let half = std::f64::consts::PI / f64::from(SIDES);
    let turn = top[0].y.atan2(top[0].x);
    let height = (wanted * wanted - 4.0 * half.cos() * (turn + half).cos()).sqrt();
    let mirrored = kresling(height, std::f64::consts::PI - 2.0 * half - turn);
    for (own, wanted) in found.structure.bars.iter().zip(&mirrored.bars) {
        assert!((own.rest_length - wanted.rest_length).abs() < 1e-9, "{own:?} {wanted:?}");
    }
}

#[test]
fn rest_angles_are_found_that_give_a_shape() {
    // A sheet that was bent by known rest angles is the target: it can be reached.
    let mut flat = miura([2, 2], 60_f64.to_radians(), 50_f64.to_radians(), [1e-2, 1e-2, 10.0]);
    for (node, axes) in [(0, Axes::ALL), (4, Axes { x: true, y: false, z: true }), (20, Axes::Z)] {
        flat.hold(NodeId(node), axes);
    }
    assert_eq!(flat.free_rigid_motions(), 0);
    let mut bent = flat.clone();
    bent.hinges.iter_mut().enumerate().for_each(|(i, hinge)| hinge.rest_angle += 0.1 * (1.0 + i as f64).sin());
    let drawn = flat.as_drawn();
    let target = bent.equilibrium(&drawn, 0.0).expect("an equilibrium").positions;
    let places = target.iter().enumerate().map(|(i, p)| (NodeId::new(i), *p)).collect();
    let goals = [(1.0, Goal::Shape(places))];
    let mut judge = |own: &_, states: &[_]| Goal::judge_all(&goals, own, states, 0.0);
    let start = judge(&flat, std::slice::from_ref(&drawn)).value;
    let each = |i| Variable { members: Members::RestAngles(vec![i]), bounds: [-3.0, 3.0] };
    let variables: Vec<Variable> = (0..flat.hinges.len()).map(each).collect();
    let found = flat
        .design(&[Watched { start: drawn, load_factor: 0.0 }], &variables, &Effort::default(), &mut judge)
        .expect("a design");
    assert!(found.value < 1e-5 * start, "from {start} to {} in {}", found.value, found.evaluations);
}

#[test]
fn a_variable_of_nothing_is_refused() {
    let structure = kresling(1.5, 0.7);
    let watched = [Watched { start: structure.as_drawn(), load_factor: 0.0 }];
    let mut nothing = |_: &_, _: &[_]| Judgement::default();
    let turned = |node| Members::Turned { nodes: vec![NodeId(node)], about: DVec3::ZERO, axis: DVec3::Z };
    let twice = [7, 7].map(|node| Variable { members: turned(node), bounds: [0.0, 1.0] });
    let refused =
        structure.design(&watched, &twice, &Effort::default(), &mut nothing).expect_err("refused").to_string();
    assert!(refused.starts_with("variables[1].members: node 7 is turned by two variables"), "{refused}");
    for (members, bounds, told) in [
        (turned(12), [0.0, 1.0], "variables[0].members: node 12; expected a node of the structure"),
        (Members::RestAngles(vec![0]), [0.0, 1.0], "variables[0].members: member 0; expected a hinge or bar"),
        (Members::RestLengths(Vec::new()), [0.0, 1.0], "variables[0]: 0 members between 0 and 1"),
        (Members::RestLengths(vec![1]), [2.0, 1.0], "variables[0]: 1 members between 2 and 1"),
    ] {
        let variables = [Variable { members, bounds }];
        let refused = structure.design(&watched, &variables, &Effort::default(), &mut nothing).expect_err("refused");
        assert!(refused.to_string().starts_with(told), "{refused}");
    }
}

#[test]
fn a_design_of_a_singular_state_is_refused() {
    use std::ops::ControlFlow;

    use origami_core::analysis::{Event, Path, Refused, Start};
    let mut tube = kresling(1.5, 40_f64.to_radians());
    tube.loads.points = (SIDES..2 * SIDES).map(|i| (NodeId(i), -DVec3::Z)).collect();
    let trace = tube.trace(&Start::default(), &Path::steps(60), &mut |_| ControlFlow::Continue(())).expect("a path");
    let limit = trace.points.iter().find(|p| matches!(p.event, Event::LimitPoint { .. })).expect("a limit");
    let watched = [Watched { start: limit.configuration.clone(), load_factor: limit.load_factor }];
    let variables = [Variable { members: Members::RestLengths(vec![0]), bounds: [1.0, 3.0] }];
    let goals = [(1.0, Goal::Compliance)];
    let mut judge = |own: &_, states: &[_]| Goal::judge_all(&goals, own, states, limit.load_factor);
    let refused = tube.design(&watched, &variables, &Effort::default(), &mut judge).expect_err("refused");
    assert!(matches!(refused, Refused::Singular { .. }), "{refused}");
}
