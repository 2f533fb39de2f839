//! What contact costs: folds of Miura sheets with it, and beside them without it, on one thread and on two.
//!
//! Open sheets are folded to 60 %, where nothing touches; stacked ones to 100 %. Criterion's `elem/s` are evaluations per
//! second; the time of an evaluation with contact over that of one without is what contact costs. `stacked` is the whole fold,
//! most of which is open; `pressed` the evaluations of a sheet that lies folded and presses on itself.

use std::hint::black_box;
use std::num::NonZeroUsize;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use origami::scene::Scene;
use origami::solve::{ContactRelax, unwatched};
use origami::{Material, Model, Relax, Solver, State, generate};

/// Panels along each side.
const SIDES: [usize; 2] = [10, 40];
/// Evaluations of a sheet that is pressed.
const PRESSED: u64 = 100;

fn model(side: usize) -> Model {
    Model::new(&generate::miura(side, side).expect("valid"), &Material::default()).expect("a generated pattern")
}

/// Free, and under contact on one thread and on two.
fn solvers(relax: &Relax) -> [(&'static str, Box<dyn Solver>); 3] {
    let on = |threads| Relax { threads: NonZeroUsize::new(threads), ..relax.clone() };
    let contact = |threads| Box::new(ContactRelax { relax: on(threads), ..ContactRelax::default() });
    [("free", Box::new(on(1))), ("contact", contact(1)), ("contact, 2 threads", contact(2))]
}

fn contact(c: &mut Criterion) {
    let mut group = c.benchmark_group("contact");
    group.sample_size(10).warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(5));
    for side in SIDES {
        let model = model(side);
        let triangles = model.mesh.triangles.len();
        let rest = State::at_rest(&model);
        let mut bench = |what: &str, start: &State, percent: f64, relax: &Relax| {
            for (name, solver) in solvers(relax) {
                let fold = || solver.fold(&model, start, &Scene::percent(percent), &mut unwatched).expect("it folds");
                group.throughput(Throughput::Elements(fold().steps));
                group.bench_function(BenchmarkId::new(format!("{what}/{name}"), triangles), |b| {
                    b.iter(|| black_box(fold()));
                });
            }
        };
        bench("open", &rest, 60.0, &Relax::default());
        bench("stacked", &rest, 100.0, &Relax::default());
        let folded = ContactRelax::default().fold_from_rest(&model, 100.0).expect("it folds").state;
        bench("pressed", &folded, 100.0, &Relax { steps: Some(PRESSED), ramp: Some(0), ..Relax::default() });
    }
    group.finish();
}

criterion_group!(benches, contact);
criterion_main!(benches);
