//! The energy of a state, its first derivatives and its second ones, as data for a program of one's own.
//!
//! `cargo run --release --example gradients`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::generate::Miura;
use origami::glam::DVec3;
use origami::scene::Scene;
use origami::{Material, Model, Relax, Solver};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::new(&Miura::default().pattern()?, &Material::default())?;
    // On the way, where forces still act.
    let scene = Scene::percent(60.0);
    let state = Relax { steps: Some(200), ..Relax::default() }.fold_from_rest(&model, 60.0)?.state;

    let energy = state.energy_in(&model, &scene).total();
    let gradient: Vec<DVec3> = state.gradient(&model, &scene);
    let hessian = state.hessian(&model, &scene).ok_or("springs have second derivatives")?;
    println!("energy {energy:.3e}, {} unknowns, {} entries of the Hessian", hessian.size(), hessian.values.len());

    // A small move in the direction in which the energy falls most, and what the derivatives say of it.
    let step: Vec<DVec3> = gradient.iter().map(|g| *g * -1e-4).collect();
    let column: Vec<f64> = step.iter().flat_map(|s| s.to_array()).collect();
    let slope: f64 = gradient.iter().zip(&step).map(|(g, s)| g.dot(*s)).sum();
    let curvature: f64 = hessian.times(&column).iter().zip(&column).map(|(h, s)| h * s).sum();

    let moved = state.moved_to(&model, state.positions.iter().zip(&step).map(|(x, s)| *x + *s).collect());
    let change = moved.energy_in(&model, &scene).total() - energy;
    println!("the energy changes by {change:.6e}; the derivatives say {:.6e}", slope + 0.5 * curvature);
    Ok(())
}
