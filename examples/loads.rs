//! A folded sheet as a bridge: supports at its corners, a weight in the middle, and what the supports carry.
//!
//! `cargo run --release --example loads`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::generate::Miura;
use origami::glam::DVec3;
use origami::ids::NodeId;
use origami::scene::{Axes, Load, Scene, Support};
use origami::solve::unwatched;
use origami::{Material, Model, Relax, Solver};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::new(&Miura { columns: 4, rows: 4, ..Miura::default() }.pattern()?, &Material::default())?;
    let folded = Relax::default().fold_from_rest(&model, 40.0)?;
    let nodes = || (0..model.node_count()).map(NodeId::new);
    let nearest = |x: f64, y: f64| {
        let distance = |node: &NodeId| folded.state.positions[node.index()].truncate().distance_squared((x, y).into());
        nodes().min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a sheet has nodes")
    };

    // One corner is fixed, the others stand on the table or slide along one axis: the sheet can still breathe.
    let [fixed, along_x, standing, also_standing] =
        [(-9.0, -9.0), (9.0, -9.0), (9.0, 9.0), (-9.0, 9.0)].map(|(x, y)| nearest(x, y));
    let (middle, weight) = (nearest(0.0, 0.0), -1e-3 * DVec3::Z);
    let scene = Scene::percent(40.0)
        .with_support(Support::fixed(fixed))
        .with_support(Support::along(along_x, Axes::Y | Axes::Z))
        .with_support(Support::along(standing, Axes::Z))
        .with_support(Support::along(also_standing, Axes::Z))
        .with_load(Load { node: middle, force: weight });
    let loaded = Relax { tolerance: 1e-6, ..Relax::default() }.fold(&model, &folded.state, &scene, &mut unwatched)?;

    let moved = loaded.state.positions[middle.index()] - folded.state.positions[middle.index()];
    println!("converged: {}; the middle sinks by {:.2e} radii", loaded.converged(), -moved.z);
    let mut total = weight;
    let mut moment = loaded.state.positions[middle.index()].cross(weight);
    for reaction in &loaded.reactions {
        println!("node {:2} carries {:.5}", reaction.node.0, reaction.force);
        total += reaction.force;
        moment += loaded.state.positions[reaction.node.index()].cross(reaction.force);
    }
    println!("left over: force {:.1e}, moment {:.1e}", total.length(), moment.length());
    Ok(())
}
