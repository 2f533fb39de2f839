//! Sheets drawn from a simulation's own memory.

use origami_core::glam::DVec3;
use origami_core::scene::{Scene, Targets};
use origami_core::solve::{Session, Simulation, unwatched};
use origami_picture::{Camera, Projection};

use super::super::DrawError;
use super::*;
use crate::{AdapterChoice, Gpu, GpuError};

#[test]
fn a_sheet_is_drawn_where_the_session_left_it() {
    let Some(renderer) = renderer() else { return };
    let pattern = catalog::generate("miura", &[]).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let solver = renderer.gpu.with(Relax::default());
    let mut session = solver.on(&model);
    let rest = State::at_rest(&model);
    let folded = session.fold(&rest, &Scene::percent(50.0), &mut unwatched).unwrap();
    // The session's positions count, not the figure's.
    let flat = Figure::new(&pattern, &model, &rest.positions);
    let figure = Figure::new(&pattern, &model, &folded.state.positions);
    let view = small().view(&figure, figure.positions.iter().copied()).unwrap();
    let should_be = renderer.draw(&small(), &figure).unwrap();
    let given = renderer.draw_session(&small(), &flat, &session, Some(&view)).unwrap();
    check("session", &given, &should_be);
    let fitted = renderer.draw_session(&small(), &flat, &session, None).unwrap();
    check("session-fitted", &fitted, &should_be);
    check("session-and-processor", &fitted, &Processor.draw(&small(), &figure).unwrap());
    assert!(!differ(&renderer.draw_from(&small(), &flat, &view).unwrap(), &should_be).within(&TOLERANCE));
}

#[test]
fn a_simulation_is_drawn_where_it_is_now() {
    let Some(renderer) = renderer() else { return };
    let pattern = catalog::generate("miura", &[]).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let mut simulation = Simulation::new(model.clone(), renderer.gpu.with(Relax::default())).unwrap();
    simulation.set_targets(Targets::percent(50.0)).unwrap();
    let flat = Figure::new(&pattern, &model, &model.rest);
    let mut pictures = Vec::new();
    for _ in 0..2 {
        simulation.step(150).unwrap();
        pictures.push(renderer.draw_simulation(&small(), &flat, simulation.engine(), None).unwrap());
        let positions: Vec<DVec3> = simulation.positions().unwrap().iter().collect();
        let should_be = renderer.draw(&small(), &Figure::new(&pattern, &model, &positions)).unwrap();
        check("simulation", pictures.last().unwrap(), &should_be);
    }
    assert!(!differ(&pictures[0], &pictures[1]).within(&TOLERANCE), "it has moved on");
}

#[test]
fn with_perspective_all_of_the_sheet_is_seen() {
    let Some(renderer) = renderer() else { return };
    let pattern = catalog::generate("kresling", &[]).unwrap();
    let model = Model::new(&pattern, &Material::default()).unwrap();
    let solver = renderer.gpu.with(Relax::default());
    let mut session = solver.on(&model);
    let folded = session.fold(&State::at_rest(&model), &Scene::percent(60.0), &mut unwatched).unwrap();
    let figure = Figure::new(&pattern, &model, &folded.state.positions);
    let camera = Camera { projection: Projection::Perspective(60.0), roll: 20.0, ..Camera::default() };
    let picture = Picture { camera, ..small() };
    let fitted = renderer.draw_session(&picture, &figure, &session, None).unwrap();
    check("session-perspective", &fitted, &renderer.draw(&picture, &figure).unwrap());
    let ground = picture.theme.background.unwrap();
    let bare = |x: u32, y: u32| fitted.pixel(x, y) == [ground.0, ground.1, ground.2, 255];
    assert!((0..400).all(|x| bare(x, 2) && bare(x, 317)) && (0..320).all(|y| bare(2, y) && bare(397, y)));
}

#[test]
fn a_figure_of_another_sheet_and_a_session_elsewhere_are_refused() {
    let Some(renderer) = renderer() else { return };
    let model = Model::new(&catalog::generate("miura", &[]).unwrap(), &Material::default()).unwrap();
    let solver = renderer.gpu.with(Relax::default());
    let session = solver.on(&model);
    let error = renderer.draw_session(&small(), &figure("hypar", 10.0), &session, None).unwrap_err();
    assert!(matches!(&error, DrawError::Invalid(_)) && error.to_string().contains("nodes; expected"), "{error}");

    let other = Gpu::open(&AdapterChoice::Named(renderer.gpu.adapter().to_string())).unwrap();
    let solver = other.with(Relax::default());
    let error = renderer.draw_session(&small(), &figure("miura", 10.0), &solver.on(&model), None).unwrap_err();
    let DrawError::Device(device) = &error else { panic!("{error}") };
    assert!(matches!(device.downcast_ref(), Some(GpuError::Refused(_))), "{error}");
}
