//! Forces of one's own, against closed forms and finite differences; and what lacks something is refused.

use origami_core::generate::catalog;
use origami_core::glam::{DMat3, DVec3};
use origami_core::ids::NodeId;
use origami_core::model::Built;
use origami_core::scene::{Force, Load, Scene};
use origami_core::solve::{Simulation, TimeStep, unwatched};
use origami_core::{Dynamics, Material, Model, Relax, Solver, State};

/// A spring from each node to where it is at rest, and one of another stiffness between nodes 0 and 1, of rest length 0.
#[derive(Debug)]
struct Springs {
    to_ground: f64,
    between: f64,
    rest: Vec<DVec3>,
}

impl Force for Springs {
    fn inventory(&self) -> Built {
        Built { what: "springs to the ground", count: self.rest.len() + 1 }
    }

    fn add_forces(&self, positions: &[DVec3], _: &[DVec3], forces: &mut [DVec3]) {
        for ((x, rest), force) in positions.iter().zip(&self.rest).zip(forces.iter_mut()) {
            *force -= self.to_ground * (*x - *rest);
        }
        let pull = self.between * (positions[1] - positions[0]);
        forces[0] += pull;
        forces[1] -= pull;
    }

    fn energy(&self, positions: &[DVec3]) -> Option<f64> {
        let ground: f64 = positions.iter().zip(&self.rest).map(|(x, rest)| (*x - *rest).length_squared()).sum();
        Some(0.5 * self.to_ground * ground + 0.5 * self.between * (positions[1] - positions[0]).length_squared())
    }

    fn add_row_sums(&self, _: &[DVec3], sums: &mut [f64]) -> bool {
        sums.iter_mut().for_each(|sum| *sum += self.to_ground);
        sums[0] += 2.0 * self.between;
        sums[1] += 2.0 * self.between;
        true
    }

    fn add_hessian(&self, _: &[DVec3], add: &mut dyn FnMut(NodeId, NodeId, DMat3)) -> bool {
        for node in 0..self.rest.len() {
            add(NodeId::new(node), NodeId::new(node), DMat3::from_diagonal(DVec3::splat(self.to_ground)));
        }
        let block = DMat3::from_diagonal(DVec3::splat(self.between));
        add(NodeId(0), NodeId(0), block);
        add(NodeId(1), NodeId(1), block);
        add(NodeId(0), NodeId(1), -block);
        true
    }

    fn pairs(&self) -> Vec<[NodeId; 2]> {
        vec![[NodeId(0), NodeId(1)]]
    }
}

/// Has forces and nothing else.
#[derive(Debug)]
struct Wind(DVec3);

impl Force for Wind {
    fn inventory(&self) -> Built {
        Built { what: "wind", count: 1 }
    }

    fn add_forces(&self, _: &[DVec3], _: &[DVec3], forces: &mut [DVec3]) {
        forces.iter_mut().for_each(|force| *force += self.0);
    }
}

fn model(name: &str) -> Model {
    Model::new(&catalog::generate(name, &[]).expect("a pattern"), &Material::default()).expect("a model")
}

fn springs(model: &Model, to_ground: f64, between: f64) -> Springs {
    Springs { to_ground, between, rest: model.rest.clone() }
}

/// A load on every node of a flat sheet on springs: it sinks as a rigid plate, by load over stiffness.
#[test]
fn a_loaded_sheet_on_springs_sinks_as_hooke_says() {
    let model = model("bird-base");
    let (load, stiffness) = (-1e-3, 0.05);
    let mut scene = Scene::default().with_force(springs(&model, stiffness, 0.0));
    for node in 0..model.node_count() {
        scene = scene.with_load(Load { node: NodeId::new(node), force: load * DVec3::Z });
    }
    let rest = State::at_rest(&model);
    let relax = Relax { tolerance: 1e-7, perturbation: 0.0, ..Relax::default() };
    let mut ends = vec![relax.fold(&model, &rest, &scene, &mut unwatched).expect("holds")];
    let dynamics = Dynamics { time_step: TimeStep::Safe, tolerance: 1e-6, max_steps: 1_000_000, ..Dynamics::default() };
    // Undamped as a whole, it goes up and down for ever: its mean is what counts.
    let mut simulation = Simulation::in_scene(model.clone(), dynamics, &scene, rest.clone()).expect("it runs");
    let (mut mean, steps) = (0.0, 20_000);
    for _ in 0..steps {
        simulation.step(1).expect("holds");
        mean += simulation.positions().expect("read").iter().next().expect("a node").z / f64::from(steps);
    }
    assert!((mean / (load / stiffness) - 1.0).abs() < 0.05, "{mean} in the mean");
    #[cfg(feature = "newton")]
    ends.push(origami_core::Newton::default().fold(&model, &rest, &scene, &mut unwatched).expect("holds"));
    for folded in ends.drain(..) {
        assert!(folded.converged());
        for (p, rest) in folded.state.positions.iter().zip(&model.rest) {
            assert!(
                (*p - *rest - load / stiffness * DVec3::Z).length() < 1e-6,
                "{} is not {}",
                *p - *rest,
                load / stiffness
            );
        }
        let energy = folded.state.energy_in(&model, &scene);
        let (count, sunk) = (model.node_count() as f64, load / stiffness);
        assert!((energy.loads + count * load * sunk).abs() < 1e-8, "loads: {}", energy.loads);
        assert!((energy.own_forces - 0.5 * count * stiffness * sunk * sunk).abs() < 1e-8, "{}", energy.own_forces);
    }
}

/// A state away from rest, in a scene with everything.
fn odd(model: &Model) -> (State, Scene) {
    let scene = Scene::percent(40.0)
        .with_force(springs(model, 0.03, 0.4))
        .with_load(Load { node: NodeId(2), force: DVec3::new(0.1, -0.2, 0.3) });
    let state = State { targets: model.targets(40.0), ..State::perturbed(model, 0.1, 5) };
    (state.moved_to(model, state.positions.clone()), scene)
}

#[test]
fn gradient_and_hessian_are_those_of_finite_differences() {
    for name in ["single-crease", "bird-base"] {
        let model = model(name);
        let (state, scene) = odd(&model);
        let gradient = state.gradient(&model, &scene);
        let hessian = state.hessian(&model, &scene).expect("all have one");
        assert_eq!(hessian.size(), 3 * model.node_count());
        let h = 1e-5;
        let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
        for node in 0..model.node_count() {
            for axis in 0..3 {
                let at = |far: f64| {
                    let mut positions = state.positions.clone();
                    positions[node][axis] += far;
                    state.moved_to(&model, positions)
                };
                let (before, after) = (at(-h), at(h));
                let slope =
                    (after.energy_in(&model, &scene).total() - before.energy_in(&model, &scene).total()) / (2.0 * h);
                assert!((slope - gradient[node][axis]).abs() < 1e-6, "{name}: {slope} is not {}", gradient[node][axis]);
                let (before, after) = (before.gradient(&model, &scene), after.gradient(&model, &scene));
                let mut unit = vec![0.0; hessian.size()];
                unit[3 * node + axis] = 1.0;
                let column = hessian.times(&unit);
                for (i, entry) in column.iter().enumerate() {
                    let difference = (after[i / 3][i % 3] - before[i / 3][i % 3]) / (2.0 * h);
                    worst = worst.max((difference - entry).abs());
                    largest = largest.max(entry.abs());
                }
            }
        }
        assert!(worst < 1e-4 * largest && largest > 1.0, "{name}: {worst} of {largest}");
    }
}

#[test]
fn columns_of_the_hessian_are_in_order_and_symmetric() {
    let model = model("bird-base");
    let (state, scene) = odd(&model);
    let hessian = state.hessian(&model, &scene).expect("all have one");
    let entry = |row: usize, column: usize| {
        let own = hessian.starts[column]..hessian.starts[column + 1];
        let at = hessian.rows[own.clone()].binary_search(&row).ok()?;
        Some(hessian.values[own.start + at])
    };
    let mut off = 0;
    for column in 0..hessian.size() {
        let rows = &hessian.rows[hessian.starts[column]..hessian.starts[column + 1]];
        assert!(rows.windows(2).all(|pair| pair[0] < pair[1]));
        for row in rows {
            let (one, other) = (entry(*row, column).expect("it is there"), entry(column, *row).expect("so is that"));
            assert!((one - other).abs() < 1e-9, "({row}, {column})");
            off += usize::from(*row != column && one != 0.0);
        }
    }
    assert!(off > 100);
}

#[test]
fn relaxation_ends_where_newton_ends() {
    let model = model("bird-base");
    let scene = Scene::percent(30.0).with_force(springs(&model, 0.05, 0.5));
    let rest = State::at_rest(&model);
    let relaxed =
        Relax { tolerance: 1e-7, ..Relax::default() }.fold(&model, &rest, &scene, &mut unwatched).expect("holds");
    assert!(relaxed.converged() && relaxed.residual < 1e-5);
    let plain = Relax::default().fold_from_rest(&model, 30.0).expect("holds");
    let far =
        |a: &State, b: &State| a.positions.iter().zip(&b.positions).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    assert!(far(&relaxed.state, &plain.state) > 1e-3, "the springs do something");
    #[cfg(feature = "newton")]
    {
        let newton = origami_core::Newton::default().fold(&model, &rest, &scene, &mut unwatched).expect("holds");
        assert!(newton.converged() && newton.residual < 1e-9);
        let far = far(&relaxed.state, &newton.state);
        assert!(far < 1e-5, "{far} radii apart");
    }
}

#[test]
fn a_solver_that_needs_what_a_force_lacks_says_what() {
    let model = model("single-crease");
    let rest = State::at_rest(&model);
    let scene = Scene::percent(10.0).with_force(Wind(1e-3 * DVec3::X));
    let refused =
        |solver: &dyn Solver| solver.fold(&model, &rest, &scene, &mut unwatched).expect_err("refused").to_string();
    let relax = refused(&Relax::default());
    assert!(relax.starts_with("force `wind`: it has no bound on its row sums, which relax needs;"), "{relax}");
    let safe = refused(&Dynamics { time_step: TimeStep::Safe, ..Dynamics::default() });
    assert!(safe.contains("the safe time step needs") && safe.contains("a fixed time step"), "{safe}");
    #[cfg(feature = "newton")]
    {
        let newton = refused(&origami_core::Newton::default());
        assert!(newton.starts_with("force `wind`: it has no energy, which newton needs;"), "{newton}");
    }
    assert!(
        Relax::default().fold(&model, &rest, &Scene::percent(10.0), &mut unwatched).is_ok(),
        "without it all is well"
    );
    let state = State { targets: model.targets(10.0), ..rest.clone() };
    assert_eq!(state.hessian(&model, &scene), None);
}

/// In the paper's scheme a constant force on all nodes moves the sheet as a stone falls: x = f t^2 / 2.
#[test]
fn wind_on_a_free_sheet_moves_it_as_a_stone_falls() {
    let model = model("bird-base");
    let force = DVec3::new(1e-3, 2e-3, -3e-3);
    let scene = Scene::default().with_force(Wind(force));
    let (dt, steps) = (1e-2, 1000);
    let dynamics = Dynamics { time_step: TimeStep::Fixed(dt), ..Dynamics::default() };
    let mut simulation =
        Simulation::in_scene(model.clone(), dynamics, &scene, State::at_rest(&model)).expect("it runs");
    simulation.step(steps).expect("holds");
    // Semi-implicit Euler: the sum of the first n numbers.
    let n = steps as f64;
    let fallen = force * (dt * dt * n * (n + 1.0) / 2.0);
    for (p, rest) in simulation.positions().expect("read").iter().zip(&model.rest) {
        assert!((p - *rest - fallen).length() < 1e-12, "{} is not {fallen}", p - *rest);
    }
    assert_eq!(scene.inventory(&model).built.last().map(|b| b.what), Some("wind"));
}

/// Drags each node back by its velocity.
#[derive(Debug)]
struct Drag(f64);

impl Force for Drag {
    fn inventory(&self) -> Built {
        Built { what: "drag", count: 1 }
    }

    fn add_forces(&self, _: &[DVec3], velocities: &[DVec3], forces: &mut [DVec3]) {
        velocities.iter().zip(forces).for_each(|(v, force)| *force -= self.0 * *v);
    }
}

/// Without any damping of its own a sheet that falls under drag reaches the speed at which both are equal.
#[test]
fn drag_is_told_the_velocities_of_an_undamped_sheet() {
    for zeta in [0.0, 0.45] {
        let material = Material { zeta, ..Material::default() };
        let model = Model::new(&catalog::generate("bird-base", &[]).expect("a pattern"), &material).expect("a model");
        let (weight, drag) = (-2e-3 * DVec3::Z, 0.5);
        let scene = Scene::default().with_force(Wind(weight)).with_force(Drag(drag));
        let dynamics = Dynamics { time_step: TimeStep::Fixed(1e-2), ..Dynamics::default() };
        let rest = State::at_rest(&model);
        let mut simulation = Simulation::in_scene(model, dynamics, &scene, rest).expect("it runs");
        simulation.step(5000).expect("holds");
        for v in simulation.state().expect("read").velocities {
            assert!((v - weight / drag).length() < 1e-9, "zeta {zeta}: {v} is not {}", weight / drag);
        }
    }
}
