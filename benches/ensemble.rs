//! Many bird bases at once, GPU against CPU: 200 evaluations of `relax` for 1 to 1 024 instances that differ in their
//! percentage. On the CPU one instance takes a thread. On a software adapter figures say nothing about GPUs.
//!
//! `gpu` and `cpu` are the whole call, on the GPU with pipelines, buffers and the reading of every state; `gpu, a step` is
//! the time of one evaluation of all instances, taken between looks at the run under way.

mod shared;

use origami::scene::Scene;
use std::hint::black_box;
use std::ops::ControlFlow;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use origami::generate::BirdBase;
use origami::solve::Instance;
use origami::{Material, Relax, Solver, State};
use shared::{Place, bench_ensemble, model};

const COUNTS: [usize; 6] = [1, 4, 16, 64, 256, 1024];
const STEPS: u64 = 200;

fn ensemble(c: &mut Criterion) {
    let Some(place) = Place::open() else { return };
    let bird = model(&BirdBase::default().pattern().expect("valid"), &Material::default());
    let relax = |steps| Relax { steps: Some(steps), ..Relax::default() };
    let mut group = place.group(c, "ensemble of bird bases");
    for count in COUNTS {
        let start = State::at_rest(&bird);
        let percent = |i: usize| 50.0 + 50.0 * i as f64 / count as f64;
        let instances: Vec<Instance<'_>> = (0..count)
            .map(|i| Instance { model: &bird, start: start.clone(), scene: Scene::percent(percent(i)) })
            .collect();
        let fold = |solver: &dyn Solver| {
            let results = solver.fold_all(&instances, &|_, _| ControlFlow::Continue(()));
            assert!(results.iter().all(Result::is_ok), "all hold");
            black_box(results);
        };
        group.throughput(Throughput::Elements((bird.node_count() * count) as u64 * STEPS));
        let on_gpu = place.gpu.with(relax(STEPS));
        group.bench_function(BenchmarkId::new("gpu", count), |b| b.iter(|| fold(&on_gpu)));
        group.bench_function(BenchmarkId::new("cpu", count), |b| b.iter(|| fold(&relax(STEPS))));
        let longer = place.gpu.with(relax(if place.hardware { 5_000 } else { 600 }));
        bench_ensemble(&mut group, BenchmarkId::new("gpu, a step", count), &longer, &instances);
    }
    group.finish();
}

criterion_group!(benches, ensemble);
criterion_main!(benches);
