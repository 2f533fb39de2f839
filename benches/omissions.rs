//! What a scene saves that does without something: the time of a step on the GPU of a Miura sheet with it and without, or
//! as it is and with what few scenes need. 1 024 nodes on a software adapter, whose figures say nothing about GPUs; 99 856
//! on hardware.

mod shared;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use origami::gpu::Dispatch;
use origami::ids::VertexId;
use origami::pattern::{Assignment, PatternEdge};
use origami::scene::Scene;
use origami::solve::{Instance, TimeStep};
use origami::{CreasePattern, Dynamics, Material, Relax, Solver, State, generate};
use shared::{HARDWARE, Place, SOFTWARE, bench_ensemble, bench_session, model, on_the_way, steps};

fn omissions(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    let panels = if place.hardware { 315 } else { 31 };
    let plain = generate::miura(panels, panels).expect("valid");
    let usual = Material::default();
    let count = steps(plain.vertices.len(), if place.hardware { HARDWARE } else { SOFTWARE });
    let relax = Relax { steps: Some(count), ramp: Some(0), ..Relax::default() };
    let relax = place.gpu.with(relax).dispatch(Dispatch::Passes);
    let dynamics = Dynamics { steps: Some(count), ..Dynamics::default() };
    let safe = Dynamics { time_step: TimeStep::Safe, ..dynamics.clone() };
    let [dynamics, safe] = [dynamics, safe].map(|method| place.gpu.with(method).dispatch(Dispatch::Passes));
    let (relax, dynamics, safe): (&dyn Solver, &dyn Solver, &dyn Solver) = (&relax, &dynamics, &safe);

    let scenes: [(&str, &dyn Solver, CreasePattern, Material); 9] = [
        ("relax", relax, plain.clone(), usual),
        ("relax, k_face 0: no corner angles", relax, plain.clone(), Material { k_face: 0.0, ..usual }),
        ("relax, k_facet 0: no creases inside faces", relax, plain.clone(), Material { k_facet: 0.0, ..usual }),
        ("relax, with a beam of its own rigidity", relax, own_rigidity(&plain), usual),
        ("relax, with a beam outside any face", relax, loose_beam(&plain), usual),
        ("relax, with a fixed node", relax, fixed(&plain), usual),
        ("dynamics", dynamics, plain.clone(), usual),
        ("dynamics, zeta 0: no damping", dynamics, plain.clone(), Material { zeta: 0.0, ..usual }),
        ("dynamics, with the safe time step", safe, plain.clone(), usual),
    ];
    let mut group = place.group(c, "omissions");
    for (name, solver, pattern, material) in scenes {
        let model = model(&pattern, &material);
        let (nodes, start) = (model.node_count(), on_the_way(&model));
        bench_session(&mut group, BenchmarkId::new(name, nodes), nodes, solver.session(&model), &start);
    }
    for (name, ea) in [("relax, two sheets of one material", usual.ea), ("relax, two sheets of two materials", 19.0)] {
        let models = [usual, Material { ea, ..usual }].map(|material| model(&plain, &material));
        let instance = |model| Instance { model, start: State::at_rest(model), scene: Scene::percent(60.0) };
        let instances = models.each_ref().map(instance);
        bench_ensemble(&mut group, BenchmarkId::new(name, models[0].node_count()), relax, &instances);
    }
    group.finish();
}

fn own_rigidity(pattern: &CreasePattern) -> CreasePattern {
    let mut pattern = pattern.clone();
    pattern.edges[0].ea = Some(19.0);
    pattern
}

fn fixed(pattern: &CreasePattern) -> CreasePattern {
    CreasePattern { fixed: vec![VertexId(0)], ..pattern.clone() }
}

/// A string between two vertices of one side of the sheet.
fn loose_beam(pattern: &CreasePattern) -> CreasePattern {
    let mut pattern = pattern.clone();
    pattern.edges.push(PatternEdge {
        vertices: [VertexId(0), VertexId(2)],
        assignment: Assignment::Boundary,
        fold_angle: None,
        k_crease: None,
        ea: None,
        alias_of: None,
    });
    pattern
}

criterion_group!(benches, omissions);
criterion_main!(benches);
