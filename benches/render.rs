//! Seconds for a picture of 1000 x 800 pixels, on a GPU and on the processor:
//! `cargo bench --features gpu,render --bench render`. `ORIGAMI_ADAPTER` names the adapter; without one only the processor
//! draws. Start-up is measured apart.

use criterion::{Criterion, criterion_group, criterion_main};
use origami::generate::catalog;
use origami::gpu::render::GpuRenderer;
use origami::gpu::{AdapterChoice, Gpu};
use origami::picture::{Figure, Picture, Processor, Renderer};
use origami::{Material, Model, Relax, Solver};

/// A pattern folded in part, with parameters by name.
fn figure(name: &str, settings: &[(&str, f64)], percent: f64, steps: Option<u64>) -> Figure {
    let settings: Vec<(String, f64)> = settings.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    let pattern = catalog::generate(name, &settings).expect("a pattern of the catalogue");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let folded = Relax { steps, ..Relax::default() }.fold_from_rest(&model, percent).expect("it folds");
    Figure::new(&pattern, &model, &folded.state.positions)
}

fn pictures(criterion: &mut Criterion) {
    let gpu = Gpu::open(&AdapterChoice::from_env());
    let renderer = gpu.as_ref().ok().map(|gpu| GpuRenderer::new(gpu).expect("every adapter draws"));
    match &gpu {
        Ok(gpu) => eprintln!("pictures on {}", gpu.adapter()),
        Err(error) => eprintln!("pictures on the processor alone: {error}"),
    }
    let large = [("rows", 224.0), ("columns", 224.0)];
    for (name, figure) in
        [("crane", figure("crane", &[], 90.0, None)), ("large", figure("miura", &large, 50.0, Some(300)))]
    {
        let mut group = criterion.benchmark_group(format!("picture/{name}/{} triangles", figure.triangles.len()));
        group.sample_size(10);
        for samples in [4, 16] {
            let picture = Picture { samples, ..Picture::default() };
            group.bench_function(format!("processor, {samples} samples"), |b| {
                b.iter(|| Processor.draw(&picture, &figure));
            });
            if let Some(renderer) = &renderer {
                group
                    .bench_function(format!("gpu, {samples} samples"), |b| b.iter(|| renderer.draw(&picture, &figure)));
            }
        }
    }
    if let Ok(gpu) = &gpu {
        criterion.bench_function("picture/start-up of a renderer", |b| b.iter(|| GpuRenderer::new(gpu)));
    }
}

criterion_group!(benches, pictures);
criterion_main!(benches);
