//! A force of one's own: a spring from every node to the table, and a wind that has no energy.
//!
//! `cargo run --release --example own_force`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::generate::BirdBase;
use origami::glam::DVec3;
use origami::model::Built;
use origami::scene::{Force, Scene};
use origami::solve::{Simulation, unwatched};
use origami::{Dynamics, Material, Model, Relax, Solver, State};

/// Holds every node softly to the plane z = 0.
#[derive(Debug)]
struct Table {
    stiffness: f64,
}

impl Force for Table {
    fn inventory(&self) -> Built {
        Built { what: "springs to the table", count: 1 }
    }
    fn add_forces(&self, positions: &[DVec3], _velocities: &[DVec3], forces: &mut [DVec3]) {
        positions.iter().zip(forces).for_each(|(x, force)| force.z -= self.stiffness * x.z);
    }
    fn energy(&self, positions: &[DVec3]) -> Option<f64> {
        Some(positions.iter().map(|x| 0.5 * self.stiffness * x.z * x.z).sum())
    }
    fn add_row_sums(&self, _positions: &[DVec3], sums: &mut [f64]) -> bool {
        sums.iter_mut().for_each(|sum| *sum += self.stiffness);
        true
    }
}

/// Blows along x; it has nothing but forces.
#[derive(Debug)]
struct Wind(f64);

impl Force for Wind {
    fn inventory(&self) -> Built {
        Built { what: "wind", count: 1 }
    }
    fn add_forces(&self, _positions: &[DVec3], velocities: &[DVec3], forces: &mut [DVec3]) {
        velocities.iter().zip(forces).for_each(|(v, force)| force.x += self.0 - v.x);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = Model::new(&BirdBase::default().pattern()?, &Material::default())?;
    let rest = State::at_rest(&model);
    let height = |state: &State| state.positions.iter().map(|x| x.z.abs()).fold(0.0, f64::max);

    for stiffness in [0.001, 0.01, 0.1] {
        let scene = Scene::percent(60.0).with_force(Table { stiffness });
        let folded = Relax::default().fold(&model, &rest, &scene, &mut unwatched)?;
        println!(
            "table of stiffness {stiffness}: converged: {}, {:.3} high",
            folded.converged(),
            height(&folded.state)
        );
    }

    // Dynamics needs forces and nothing else; a relaxation says what it misses.
    let wind = Scene::percent(30.0).with_force(Wind(0.01));
    let mut sheet = Simulation::in_scene(model.clone(), Dynamics::default(), &wind, rest.clone())?;
    sheet.step(1000)?;
    println!("blown to x = {:.3}", sheet.state()?.positions[0].x - rest.positions[0].x);
    let refused = Relax::default().fold(&model, &rest, &wind, &mut unwatched).expect_err("wind has no bound");
    println!("relax: {refused}");
    Ok(())
}
