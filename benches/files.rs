//! Time from a FOLD file's text to the text of the folded one, by part, without the solving: sheets as they come from
//! programs, and scenes at which a careless loop takes the square of their size.
//!
//! Measured per vertex of the file: `read` (text to document), `pattern` (document to crease pattern), `model`
//! (triangulation, topology, springs), `write` (document of the folded form and its text). Each scene comes in two sizes;
//! the time per vertex may grow as a logarithm does. Disks are not measured.

mod scenes;

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use origami::export::{Pose, folded_form};
use origami::fold::Document;
use origami::solve::{Folded, Stop};
use origami::{CreasePattern, Material, Model, State};

const SIZES: [usize; 2] = [1000, 10_000];

fn files(c: &mut Criterion) {
    for (name, scene) in scenes::ALL {
        let mut group = c.benchmark_group(format!("files/{name}"));
        group.sample_size(10).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(1));
        for size in SIZES {
            let document = scene(size);
            let text = document.to_string().expect("finite numbers");
            let frame = document.frame_count() - 1;
            let pattern = CreasePattern::from_document(&document, frame).expect("a sheet");
            let model = Model::new(&pattern, &Material::default()).expect("a sheet");
            let folded = at_rest(&model);

            let vertices = document.frame(frame).expect("the last").vertices_coords.map_or(0, |v| v.len());
            group.throughput(Throughput::Elements((vertices + document.frames.len()) as u64));
            group.bench_function(BenchmarkId::new("read", size), |b| {
                b.iter(|| black_box(Document::from_slice(text.as_bytes()).expect("a FOLD file")));
            });
            group.bench_function(BenchmarkId::new("pattern", size), |b| {
                b.iter(|| black_box(CreasePattern::from_document(&document, frame).expect("a sheet")));
            });
            group.bench_function(BenchmarkId::new("model", size), |b| {
                b.iter(|| black_box(Model::new(&pattern, &Material::default()).expect("a sheet")));
            });
            group.bench_function(BenchmarkId::new("write", size), |b| {
                b.iter(|| {
                    let pose = Pose::of(&model, &pattern, &folded);
                    let folded = folded_form(&document, frame, &pattern, &pose).expect("a pose of this sheet");
                    black_box(folded.to_string().expect("finite numbers"))
                });
            });
        }
        group.finish();
    }
}

/// As a solver would hand it out that had nothing to do.
fn at_rest(model: &Model) -> Folded {
    Folded {
        state: State::at_rest(model),
        targets: origami::Targets::percent(0.0),
        saddles: 0,
        reactions: Vec::new(),
        stop: Stop::StepsDone,
        steps: 0,
        time_step: 0.0,
        residual: 0.0,
        distance: 0.0,
        attempts: 1,
        factorisations: 0,
    }
}

criterion_group!(benches, files);
criterion_main!(benches);
