//! Time of one step on the CPU, on one thread and on all: Miura sheets of about 100 to 100 000 nodes on their way to 60 %,
//! default material. All start 200 steps after the jump from flat, in which creases turn so fast that angles cost more.
//!
//! Measured: [`Dynamics`] (springs, damping, Euler) and [`Relax`] (springs, the sums and moves of FIRE, its masses every 50
//! steps), in f64 and mixed, with what the processor's best instructions are; and, for comparison in the same run, two scalar
//! steps: `printed`, the paper's formulas as they stand there, each beam, crease and corner angle by itself with an arc
//! tangent for every angle; and `plain`, those of [`origami::forces`], which share what they can and keep to short series. What is named after a number of threads is shared
//! out among them, as far as that is faster: `RAYON_NUM_THREADS` sets their number. Criterion's `elem/s` are nodes times
//! steps per second; 1 / that is the time per node and step. The group `build` measures what comes before the first step,
//! per node. Reading and writing files is not measured.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use origami::export::crease_pattern_document;
use origami::fold::Frame;
use origami::forces::{Forces, damping};
use origami::scene::{Scene, Targets};
use origami::solve::{BareKernel, NODES_A_THREAD, Precision, Simulation, time_step, unwatched};
use origami::{CreasePattern, Dynamics, Material, Model, Relax, Solver, State, generate};

#[path = "../tests/common/printed.rs"]
mod printed;

use printed::Printed;

fn cpu_step(c: &mut Criterion) {
    let mut group = c.benchmark_group("cpu_step");
    group.sample_size(10).warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(4));
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let threads = rayon::current_num_threads();
    for panels in [9, 31, 99, 315] {
        let pattern = generate::miura(panels, panels).expect("valid");
        let model = Model::new(&pattern, &Material::default()).expect("a generated pattern");
        let to_start = Dynamics { steps: Some(200), ..Dynamics::default() };
        let start =
            to_start.fold(&model, &State::at_rest(&model), &Scene::percent(60.0), &mut unwatched).expect("holds").state;
        let nodes = model.node_count() as u64;
        // So many that copying the start and allocating do not count.
        let steps = (2_000_000 / nodes).max(100);
        group.throughput(Throughput::Elements(nodes * steps));
        group.bench_function(BenchmarkId::new("printed", nodes), |b| {
            b.iter(|| black_box(printed_steps(&model, &start, steps)));
        });
        group.bench_function(BenchmarkId::new("plain", nodes), |b| {
            b.iter(|| black_box(plain_steps(&model, &start, steps)));
        });
        for precision in [Precision::F64, Precision::Mixed] {
            let solvers: [(&str, Box<dyn Solver>); 2] = [
                ("dynamics", Box::new(Dynamics { precision, steps: Some(steps), ..Dynamics::default() })),
                ("relax", Box::new(Relax { precision, steps: Some(steps), ramp: Some(0), ..Relax::default() })),
            ];
            for (name, solver) in solvers {
                let name = format!("{name}/{}", precision.name());
                let fold = || solver.fold(&model, &start, &Scene::percent(60.0), &mut unwatched).expect("holds");
                group.bench_function(BenchmarkId::new(&name, nodes), |b| {
                    alone.install(|| b.iter(|| black_box(fold())));
                });
                // Smaller ones have one thread anyway.
                if threads > 1 && nodes >= 2 * NODES_A_THREAD as u64 {
                    let name = format!("{name}/{threads} threads");
                    group.bench_function(BenchmarkId::new(name, nodes), |b| b.iter(|| black_box(fold())));
                }
            }
        }
    }
    group.finish();
}

/// The steps of [`Dynamics`] by the printed formulas.
fn printed_steps(model: &Model, start: &State, steps: u64) -> State {
    let mut state = start.clone();
    let targets = model.targets(60.0);
    let mut printed = Printed::new(model);
    let dt = time_step::paper(model);
    for _ in 0..steps {
        printed.step(&mut state, &targets, dt);
    }
    state
}

/// The same by the plain formulas.
fn plain_steps(model: &Model, start: &State, steps: u64) -> State {
    let mut state = start.clone();
    let targets = model.targets(60.0);
    let mut forces = Forces::new(model);
    let coefficients = damping::coefficients(model);
    let dt = time_step::paper(model);
    for _ in 0..steps {
        let values = forces.evaluate(&state.positions, &targets, &mut state.fold_angles);
        for (beam, c) in model.beams.iter().zip(&coefficients) {
            let [i, j] = beam.nodes.map(|n| n.index());
            let force = (state.velocities[j] - state.velocities[i]) * *c;
            values[i] += force;
            values[j] -= force;
        }
        for ((x, v), f) in state.positions.iter_mut().zip(&mut state.velocities).zip(values) {
            *v += *f * dt;
            *x += *v * dt;
        }
    }
    state
}

/// What a sheet costs before its first step: the pattern from a file's frame, with faces and with faces to be found among
/// the lines; then triangulation, topology and springs.
fn build(c: &mut Criterion) {
    let mut group = c.benchmark_group("build");
    group.sample_size(10).measurement_time(Duration::from_secs(4));
    for panels in [31, 315] {
        let pattern = generate::miura(panels, panels).expect("valid");
        let vertices = pattern.vertices.len() as u64;
        group.throughput(Throughput::Elements(vertices));
        group.bench_function(BenchmarkId::new("model", vertices), |b| {
            b.iter(|| black_box(Model::new(&pattern, &Material::default()).expect("a generated pattern")));
        });
        let with_faces = crease_pattern_document(&pattern, "miura").key_frame;
        let lines = Frame { faces_vertices: None, ..with_faces.clone() };
        for (name, frame) in [("pattern", with_faces), ("pattern_of_lines", lines)] {
            group.bench_function(BenchmarkId::new(name, vertices), |b| {
                b.iter(|| black_box(CreasePattern::from_frame(&frame).expect("a generated pattern")));
            });
        }
    }
    group.finish();
}

/// What it costs to step a sheet from outside: `bare` is the three passes of the paper's scheme and nothing else, `step(1)` a
/// [`Simulation`] that is asked for one step at a time, `step(100)` for a hundred.
fn simulation_step(c: &mut Criterion) {
    let mut group = c.benchmark_group("simulation_step");
    group.sample_size(10).warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(3));
    for panels in [9, 99, 315] {
        let pattern = generate::miura(panels, panels).expect("valid");
        let model = Model::new(&pattern, &Material::default()).expect("a generated pattern");
        let (scene, rest) = (Scene::percent(60.0), State::at_rest(&model));
        let to_start = Dynamics { steps: Some(200), ..Dynamics::default() };
        let start = to_start.fold(&model, &rest, &scene, &mut unwatched).expect("holds").state;
        let (nodes, portion) = (model.node_count() as u64, 100);
        group.throughput(Throughput::Elements(nodes * portion));
        let one = std::num::NonZeroUsize::new(1);
        let dynamics = Dynamics { threads: one, ..Dynamics::default() };
        let mut bare = BareKernel::new(&model, &start, &model.targets(60.0));
        let dt = time_step::paper(&model);
        group.bench_function(BenchmarkId::new("bare", nodes), |b| b.iter(|| (0..portion).for_each(|_| bare.step(dt))));
        let mut simulation = Simulation::in_scene(model, dynamics, &scene, start).expect("it runs");
        simulation.set_targets(Targets::percent(60.0)).expect("the same");
        group.bench_function(BenchmarkId::new("step(1)", nodes), |b| {
            b.iter(|| (0..portion).all(|_| simulation.step(1).is_ok()));
        });
        group.bench_function(BenchmarkId::new("step(100)", nodes), |b| {
            b.iter(|| simulation.step(portion).expect("holds"));
        });
    }
    group.finish();
}

criterion_group!(benches, cpu_step, simulation_step, build);
criterion_main!(benches);
