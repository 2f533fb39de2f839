//! Inverse design by gradients: rest angles for which a Miura sheet takes a saddle's shape.
//!
//! `cargo run --release --features analysis --example inverse_design`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::analysis::{Configuration, Effort, Goal, Members, Structure, Variable, Watched};
use origami::glam::DVec3;
use origami::ids::NodeId;
use origami::scene::Axes;
use origami::{Material, Model, Relax, Solver, generate};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::new(&generate::miura(4, 4)?, &Material::default())?;
    let folded = Relax::default().fold_from_rest(&model, 60.0)?;

    // The folded sheet, without stress, held so that it cannot move as a whole.
    let mut structure = Structure::of(&model);
    structure.nodes = folded.state.positions.clone();
    let drawn = Configuration { positions: folded.state.positions, fold_angles: folded.state.fold_angles };
    structure.hinges.iter_mut().zip(&drawn.fold_angles).for_each(|(hinge, angle)| hinge.rest_angle = *angle);
    let farthest = |way: DVec3| {
        let along = drawn.positions.iter().map(|p| p.dot(way)).enumerate();
        NodeId::new(along.max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(i, _)| i))
    };
    structure.hold(farthest(DVec3::NEG_ONE), Axes::ALL);
    structure.hold(farthest(DVec3::X), Axes { x: false, y: true, z: true });
    structure.hold(farthest(DVec3::Y), Axes::Z);

    // The same sheet upon a saddle.
    let target: Vec<DVec3> = drawn.positions.iter().map(|p| *p + DVec3::Z * 0.2 * (p.x * p.x - p.y * p.y)).collect();
    let goal = Goal::Shape(target.iter().enumerate().map(|(i, place)| (NodeId::new(i), *place)).collect());
    let before = goal.measure(&structure, std::slice::from_ref(&drawn), 0.0);

    // Every crease may be at rest at an angle of its own.
    let each = |i| Variable { members: Members::RestAngles(vec![i]), bounds: [-3.0, 3.0] };
    let variables: Vec<Variable> = (0..structure.hinges.len()).map(each).collect();
    let watched = [Watched { start: drawn, load_factor: 0.0 }];
    let mut judge = |own: &Structure, states: &[Configuration]| goal.judge(own, states, 0.0);
    let found = structure.design(&watched, &variables, &Effort::default(), &mut judge)?;

    let after = goal.measure(&found.structure, &found.states, 0.0);
    println!("{} rest angles, {} equilibria", variables.len(), found.evaluations);
    println!("vertices are {after:.4} radii from the saddle, {before:.4} before");
    Ok(())
}
