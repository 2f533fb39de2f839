//! A step allocates nothing, whatever the sheet is asked for.

use origami_core::generate::catalog;
use origami_core::glam::DVec3;
use origami_core::ids::NodeId;
use origami_core::scene::{Load, Scene, Support, Targets};
use origami_core::solve::{Integrator, Method, Precision, Simulation, TimeStep, Units};
use origami_core::{Dynamics, Material, Model, Relax, State};

/// Steps during which memory is touched for the first time: windows of the stopping rule, the first copy of a good state, and
/// the end of the ramp, where a soft sheet becomes as stiff as its material.
const WARM_UP: u64 = 605;

fn allocations(method: impl Method, scene: &Scene) -> u64 {
    let pattern = catalog::generate("miura", &[]).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let start = State::at_rest(&model);
    let mut vertices = vec![0.0_f32; 3 * model.node_count()];
    let mut simulation = Simulation::in_scene(model, method, scene, start).expect("it runs");
    simulation.set_targets(Targets::percent(60.0)).expect("targets");
    simulation.step(WARM_UP).expect("holds");
    let counted = allocation_counter::measure(|| {
        for _ in 0..1000 {
            simulation.step(1).expect("holds");
            simulation.positions().expect("a view").write_f32(Units::File, &mut vertices);
        }
    });
    counted.count_total
}

#[test]
fn nothing_is_allocated_by_a_step() {
    let scene = Scene::default()
        .with_support(Support::fixed(NodeId(0)))
        .with_load(Load { node: NodeId(5), force: 1e-3 * DVec3::Z });
    for scene in [Scene::default(), scene] {
        for precision in [Precision::F64, Precision::Mixed] {
            let (euler, verlet) = (Integrator::Euler, Integrator::Verlet);
            // Verlet does not hold with the paper's step.
            for (integrator, time_step) in [(euler, TimeStep::Paper), (euler, TimeStep::Safe), (verlet, TimeStep::Safe)]
            {
                let dynamics = Dynamics { precision, integrator, time_step, ..Dynamics::default() };
                assert_eq!(allocations(dynamics.clone(), &scene), 0, "{dynamics:?}");
            }
            let relax = Relax { precision, ..Relax::default() };
            assert_eq!(allocations(relax, &scene), 0, "relax, {precision:?}");
        }
    }
}

#[test]
fn an_allocation_is_counted() {
    let counted = allocation_counter::measure(|| drop(std::hint::black_box(vec![1_u8; 100])));
    assert_eq!(counted.count_total, 1);
}
