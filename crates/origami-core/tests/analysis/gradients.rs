//! Gradients by the adjoint against differences of equilibria, each found anew.

use origami_core::analysis::{Configuration, Gradient, HingeLaw, Refused, Structure};
use origami_core::glam::DVec3;

use crate::case::case;

/// Half the square of the distance of a node from where it is wanted.
fn result(at: &Configuration, node: usize, target: DVec3) -> f64 {
    0.5 * (at.positions[node] - target).length_squared()
}

struct Problem {
    structure: Structure,
    at: Configuration,
    node: usize,
    target: DVec3,
    gradient: Gradient,
    load: f64,
}

impl Problem {
    fn new(structure: Structure, load: f64, node: usize) -> Self {
        // Up in steps: the first state is far from the loaded one.
        let mut at = structure.as_drawn();
        for i in 1..=50 {
            at = structure.equilibrium(&at, load * f64::from(i) / 50.0).expect("an equilibrium");
        }
        let target = at.positions[node] + DVec3::new(0.0, 0.0, 0.3);
        let mut by_positions = vec![DVec3::ZERO; structure.nodes.len()];
        by_positions[node] = at.positions[node] - target;
        let gradient = structure.gradient(&at, load, &by_positions).expect("a regular state");
        Self { structure, at, node, target, gradient, load }
    }

    /// The result where the structure is changed.
    fn with(&self, change: impl Fn(&mut Structure)) -> f64 {
        let mut changed = self.structure.clone();
        change(&mut changed);
        let at = changed.equilibrium(&self.at, self.load).expect("an equilibrium");
        result(&at, self.node, self.target)
    }

    /// Compares the gradient with central differences by `step` at the 20 largest entries.
    fn agrees(
        &self,
        what: &str,
        gradient: &[f64],
        step: impl Fn(usize) -> f64,
        set: impl Fn(&mut Structure, usize, f64),
    ) {
        let mut order: Vec<usize> = (0..gradient.len()).collect();
        order.sort_by(|a, b| gradient[*b].abs().total_cmp(&gradient[*a].abs()));
        let largest = gradient[order[0]].abs();
        assert!(largest > 0.0, "{what}");
        for i in order.into_iter().take(20) {
            // Richardson: what is left is of the fourth order.
            let difference = |h: f64| (self.with(|s| set(s, i, h)) - self.with(|s| set(s, i, -h))) / (2.0 * h);
            let h = step(i);
            let slope = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
            let error = (slope - gradient[i]).abs();
            assert!(error < 1e-6 * largest, "{what} {i}: {} is not {slope}, of {largest}", gradient[i]);
        }
    }
}

fn compare(problem: &Problem) {
    let Problem { structure, gradient, .. } = problem;
    problem.agrees("rest angle", &gradient.rest_angles, |_| 1e-3, |s, i, h| s.hinges[i].rest_angle += h);
    let stiffness = |i: usize| 1e-2 * structure.hinges[i].stiffness;
    problem.agrees("stiffness", &gradient.hinge_stiffnesses, stiffness, |s, i, h| s.hinges[i].stiffness += h);
    let length = |i: usize| 1e-5 * structure.bars[i].rest_length;
    problem.agrees("rest length", &gradient.rest_lengths, length, |s, i, h| s.bars[i].rest_length += h);
    let rigidity = |i: usize| 1e-2 * structure.bars[i].rigidity;
    problem.agrees("rigidity", &gradient.rigidities, rigidity, |s, i, h| s.bars[i].rigidity += h);
    let loads: Vec<f64> = gradient.loads.iter().flat_map(|f| f.to_array()).collect();
    problem.agrees(
        "load",
        &loads,
        |_| 1e-3,
        |s, i, h| {
            let mut force = DVec3::ZERO;
            force[i % 3] = h;
            s.loads.points.push((origami_core::ids::NodeId::new(i / 3), force));
        },
    );
}

#[test]
fn of_merlins_bent_miura_they_are_those_of_differences() {
    let problem = Problem::new(case(include_str!("cases/merlin1_miura_bending.json")), 0.5, 60);
    compare(&problem);
    // What the independent program has.
    let Gradient { rest_angles, rest_lengths, .. } = &problem.gradient;
    for (got, wanted) in [
        (rest_angles[275].abs(), 0.05671126384400963),
        (rest_angles[184].abs(), 0.03900573170273352),
        (rest_lengths[194], -0.31445880334635146),
        (rest_lengths[178], 0.23156888788397478),
    ] {
        assert!((got - wanted).abs() < 1e-6, "{got} is not {wanted}");
    }
}

#[test]
fn by_positions_and_with_a_power_law() {
    let mut structure = case(include_str!("cases/merlin1_kresling.json"));
    for (i, hinge) in structure.hinges.iter_mut().enumerate() {
        hinge.law = [HingeLaw::Power { exponent: 1.5 }, HingeLaw::Linear][i % 2];
        hinge.rest_angle += 0.05;
        hinge.stiffness *= 100.0;
    }
    structure.loads.points.iter_mut().enumerate().for_each(|(i, (_, f))| *f *= 0.3 + 0.05 * i as f64);
    let problem = Problem::new(structure, 0.5, 9);
    compare(&problem);
    let drawn = problem.gradient.by_drawn_positions(&problem.structure).expect("bars and hinges");
    let by_position: Vec<f64> = drawn.iter().flat_map(|g| g.to_array()).collect();
    // As the gradient has it: what is drawn says lengths, angles and supports, and stiffnesses are per length.
    problem.agrees(
        "position",
        &by_position,
        |_| 1e-4,
        |s, i, h| {
            let before = s.clone();
            let angles = |s: &Structure| s.fold_angles(&s.nodes, &vec![0.0; s.hinges.len()]);
            let length = |s: &Structure, nodes: [origami_core::ids::NodeId; 2]| {
                s.nodes[nodes[0].index()].distance(s.nodes[nodes[1].index()])
            };
            s.nodes[i / 3][i % 3] += h;
            let turned: Vec<f64> = angles(s).iter().zip(angles(&before)).map(|(new, old)| new - old).collect();
            for (bar, old) in s.clone().bars.iter().zip(&before.bars).enumerate().map(|(k, (_, old))| (k, old)) {
                s.bars[bar].rest_length += length(s, old.nodes) - length(&before, old.nodes);
            }
            for (k, old) in before.hinges.iter().enumerate() {
                let line = [old.nodes[2], old.nodes[3]];
                s.hinges[k].rest_angle += turned[k];
                s.hinges[k].stiffness *= length(s, line) / length(&before, line);
            }
        },
    );
}

#[test]
fn the_remainder_falls_as_the_square_of_the_step() {
    let problem = Problem::new(case(include_str!("cases/merlin1_kresling.json")), 0.3, 9);
    let way = |i: usize| (1.0 + i as f64).sin();
    let slope: f64 = problem.gradient.rest_lengths.iter().enumerate().map(|(i, g)| g * way(i)).sum();
    let value = result(&problem.at, problem.node, problem.target);
    let remainder = |h: f64| {
        let moved = problem.with(|s| s.bars.iter_mut().enumerate().for_each(|(i, bar)| bar.rest_length += h * way(i)));
        (moved - value - h * slope).abs()
    };
    let steps = [1e-4, 1e-5, 1e-6, 1e-7];
    let remainders = steps.map(remainder);
    for pair in remainders.windows(2) {
        let order = (pair[0] / pair[1]).log10();
        assert!((1.9..2.1).contains(&order), "order {order} of {remainders:?}");
    }
}

#[test]
fn none_is_given_at_a_limit_point() {
    use std::ops::ControlFlow;

    use origami_core::analysis::{Event, Path, Start};
    let structure = case(include_str!("cases/simfast_kresling.json"));
    let trace =
        structure.trace(&Start::default(), &Path::steps(30), &mut |_| ControlFlow::Continue(())).expect("a path");
    let limit = trace.points.iter().find(|p| matches!(p.event, Event::LimitPoint { .. })).expect("a limit");
    let by_positions = vec![DVec3::Z; structure.nodes.len()];
    let refused = structure.gradient(&limit.configuration, limit.load_factor, &by_positions);
    assert!(matches!(refused, Err(Refused::Singular { .. })), "{refused:?}");
    let few = structure.gradient(&limit.configuration, limit.load_factor, &[]).expect_err("too few");
    assert!(few.to_string().starts_with("by_positions: 0 entries; expected one for each of the 12 nodes"));
}
