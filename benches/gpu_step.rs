//! GPU against CPU: the time of a step, and the time to convergence. Miura sheets of 100 to 1 000 000 nodes and patterns
//! of `examples/patterns`, on the adapter that `ORIGAMI_ADAPTER` names or else the best there is; its name is part of every
//! group's. On a software adapter only smaller sheets are measured, and its figures say nothing about GPUs.
//!
//! The time of a step is taken between looks at a run under way, so it holds neither pipelines nor copies of the state;
//! criterion's `elem/s` are nodes times steps per second. The group `setup` measures what comes before the first step,
//! `converge` all from the state at rest to the folded one in a session that has its pipelines.

mod shared;

use origami::scene::Scene;
use origami::solve::unwatched;
use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use origami::gpu::{AdapterChoice, Dispatch, Gpu, PaperDynamics};
use origami::solve::TimeStep;
use origami::{Dynamics, Material, Model, Relax, Solver, State};
use shared::{CPU, HARDWARE, Place, SOFTWARE, bench_session, bench_steps, on_the_way, patterns, sheet, steps};

const SHEETS: [usize; 5] = [9, 31, 99, 315, 999];
/// Nodes up to which a sheet is given to one workgroup here.
const ONE_WORKGROUP: usize = 1_100;

fn dynamics(steps: u64) -> Dynamics {
    Dynamics { steps: Some(steps), ..Dynamics::default() }
}

fn relax(steps: u64) -> Relax {
    Relax { steps: Some(steps), ramp: Some(0), ..Relax::default() }
}

impl Place {
    fn steps(&self, nodes: usize) -> u64 {
        steps(nodes, if self.hardware { HARDWARE } else { SOFTWARE })
    }
}

/// What there is to do before the first step: opening an adapter, then buffers and pipelines for a sheet.
fn setup(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    let mut group = place.group(c, "setup");
    group.bench_function("open", |b| {
        let name = AdapterChoice::Named(place.gpu.adapter().to_string());
        b.iter(|| black_box(Gpu::open(&name).expect("opened before")));
    });
    for panels in [9, 31, 99] {
        let model = sheet(panels, &Material::default());
        let nodes = model.node_count();
        let (dynamics, relax) = (place.gpu.with(dynamics(1)), place.gpu.with(relax(1)));
        group.bench_function(BenchmarkId::new("dynamics", nodes), |b| b.iter(|| black_box(dynamics.session(&model))));
        group.bench_function(BenchmarkId::new("relax", nodes), |b| b.iter(|| black_box(relax.session(&model))));
    }
    group.finish();
}

/// The time of a step, sheet by sheet.
fn step(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    for panels in place.sizes("step", &SHEETS, 10_000) {
        let model = sheet(panels, &Material::default());
        let (nodes, start) = (model.node_count(), on_the_way(&model));
        let gpu_steps = place.steps(nodes);
        let mut group = place.group(c, "dynamics");
        for (name, dispatch) in ways(nodes) {
            let solver = place.gpu.with(dynamics(gpu_steps)).dispatch(dispatch);
            bench_session(&mut group, BenchmarkId::new(name, nodes), nodes, solver.session(&model), &start);
        }
        let paper = PaperDynamics {
            gpu: place.gpu.clone(),
            time_step: TimeStep::Paper,
            steps: gpu_steps,
            read_every: PaperDynamics::READ_EVERY,
        };
        // One run tells whether its lists, longer than ours, fit into the adapter's buffers.
        match (PaperDynamics { steps: 0, ..paper.clone() }).fold(&model, &start, &Scene::percent(60.0), &mut unwatched)
        {
            Ok(_) => bench_steps(&mut group, BenchmarkId::new("gpu, paper's five passes", nodes), nodes, |looks| {
                paper
                    .fold(&model, &start, &Scene::percent(60.0), &mut |progress| looks.look(progress))
                    .expect("it holds");
            }),
            Err(error) => eprintln!("the paper's five passes over {nodes} nodes are left out: {error}"),
        }
        let solver = dynamics(steps(nodes, CPU));
        bench_session(&mut group, BenchmarkId::new("cpu", nodes), nodes, solver.session(&model), &start);
        group.finish();

        let mut group = place.group(c, "relax");
        for (name, dispatch) in ways(nodes) {
            let solver = place.gpu.with(relax(gpu_steps)).dispatch(dispatch);
            bench_session(&mut group, BenchmarkId::new(name, nodes), nodes, solver.session(&model), &start);
        }
        let solver = relax(steps(nodes, CPU));
        bench_session(&mut group, BenchmarkId::new("cpu", nodes), nodes, solver.session(&model), &start);
        group.finish();
    }
}

fn ways(nodes: usize) -> Vec<(&'static str, Dispatch)> {
    let mut ways = vec![("gpu, passes", Dispatch::Passes)];
    if nodes <= ONE_WORKGROUP {
        ways.push(("gpu, one workgroup", Dispatch::Workgroup));
    }
    ways
}

/// From which size on one workgroup loses to passes over all elements: where `WORKGROUP_NODES` comes from.
fn crossover(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    for panels in [2, 4, 6, 7, 8, 9, 10, 13, 19, 31] {
        let model = sheet(panels, &Material::default());
        let (nodes, start) = (model.node_count(), on_the_way(&model));
        let mut group = place.group(c, "crossover");
        for (name, dispatch) in [("passes", Dispatch::Passes), ("one workgroup", Dispatch::Workgroup)] {
            let steps = place.steps(nodes).min(4_000);
            let by_dynamics = place.gpu.with(dynamics(steps)).dispatch(dispatch);
            let id = BenchmarkId::new(format!("dynamics, {name}"), nodes);
            bench_session(&mut group, id, nodes, by_dynamics.session(&model), &start);
            let by_relax = place.gpu.with(relax(steps)).dispatch(dispatch);
            let id = BenchmarkId::new(format!("relax, {name}"), nodes);
            bench_session(&mut group, id, nodes, by_relax.session(&model), &start);
        }
        group.finish();
    }
}

/// Patterns as people fold them.
fn real(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    for (name, model) in patterns() {
        let (nodes, start) = (model.node_count(), on_the_way(&model));
        let mut group = place.group(c, "patterns");
        let (few, many) = (place.steps(nodes).min(4_000), steps(nodes, CPU));
        let on_gpu: [(&str, Box<dyn Solver>); 2] =
            [("dynamics", Box::new(place.gpu.with(dynamics(few)))), ("relax", Box::new(place.gpu.with(relax(few))))];
        let on_cpu: [(&str, Box<dyn Solver>); 2] =
            [("dynamics", Box::new(dynamics(many))), ("relax", Box::new(relax(many)))];
        for (backend, solvers) in [("gpu", on_gpu), ("cpu", on_cpu)] {
            for (method, solver) in &solvers {
                let id = BenchmarkId::new(format!("{method}, {backend}"), format!("{name}, {nodes} nodes"));
                bench_session(&mut group, id, nodes, solver.session(&model), &start);
            }
        }
        group.finish();
    }
}

/// From rest to convergence at 60 %, in a session that has its pipelines.
fn converge(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    let sheets = place.sizes("converge", &SHEETS[..4], 1_100).into_iter();
    let sheets = sheets.map(|panels| ("miura", sheet(panels, &Material::default())));
    for (name, model) in sheets.chain(patterns()) {
        let mut group = place.group(c, "converge");
        let id = format!("{name}, {} nodes", model.node_count());
        let on_gpu = place.gpu.with(Relax::default());
        time_to_convergence(&mut group, BenchmarkId::new("gpu", &id), &on_gpu, &model);
        // Minutes a run.
        if model.node_count() <= 10_000 {
            time_to_convergence(&mut group, BenchmarkId::new("cpu", &id), &Relax::default(), &model);
        }
        group.finish();
    }
}

fn time_to_convergence(
    group: &mut criterion::BenchmarkGroup<'_, criterion::measurement::WallTime>,
    id: BenchmarkId,
    solver: &dyn Solver,
    model: &Model,
) {
    let (mut session, start) = (solver.session(model), State::at_rest(model));
    group.bench_function(id, |b| {
        b.iter(|| {
            let folded = session.fold(&start, &Scene::percent(60.0), &mut unwatched).expect("it holds");
            assert!(folded.converged(), "what is timed is convergence");
        });
    });
}

criterion_group!(benches, setup, step, crossover, real, converge);
criterion_main!(benches);
