//! What structural analysis takes, on one thread: MERLIN's path of a Miura sheet that is popped through, from beginning to end,
//! and single points of paths of larger sheets.

use std::hint::black_box;
use std::ops::ControlFlow;
use std::path::Path;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use origami::analysis::job::{Job, Setup};
use origami::analysis::{self, Start, Structure};
use origami::fold::Document;
use origami::glam::DVec3;
use origami::ids::NodeId;
use origami::scene::Axes;
use origami::{CreasePattern, Material, Model, generate};

/// An example with its job.
fn example(name: &str) -> Setup {
    let path = |extension| {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/analysis").join(name).with_extension(extension)
    };
    let document = Document::read(path("fold")).expect("FOLD");
    let frame = document.frame(0).expect("a frame");
    let pattern = CreasePattern::from_frame(&frame).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let job = Job::from_slice(&std::fs::read(path("json")).expect("a file")).expect("a job");
    job.setup(&frame, &pattern, &model).expect("a structure")
}

fn paths(c: &mut Criterion) {
    let mut group = c.benchmark_group("path");
    group.sample_size(10);
    for name in ["kresling", "miura-pop-through"] {
        let Setup { structure, path, .. } = example(name);
        group.bench_function(name, |b| {
            b.iter(|| structure.trace(&Start::default(), &path, &mut |_| ControlFlow::Continue(())).expect("a path"));
        });
    }
    group.finish();
}

/// A Miura sheet with bumps, without stress, held along one side and pressed in the middle.
fn sheet(panels: usize) -> Structure {
    let pattern = generate::miura(panels, panels).expect("a pattern");
    let model = Model::new(&pattern, &Material::default()).expect("a model");
    let mut structure = Structure::of(&model);
    structure.corners.clear();
    let step = 1.0 / panels as f64;
    let bump = |(i, p): (usize, &DVec3)| *p + DVec3::Z * (0.3 * step * (1.0 + 7.0 * i as f64).sin());
    structure = structure.redrawn(structure.nodes.iter().enumerate().map(bump).collect());
    let left = structure.nodes.iter().map(|p| p.x).fold(f64::INFINITY, f64::min);
    for i in 0..structure.nodes.len() {
        if structure.nodes[i].x < left + step {
            structure.hold(NodeId::new(i), Axes::ALL);
        }
    }
    let distances = structure.nodes.iter().map(|p| p.length()).enumerate();
    let middle = distances.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(i, _)| i);
    structure.loads.points = vec![(NodeId::new(middle), -DVec3::Z * 1e-3)];
    structure
}

/// Each iteration is a path of so many points, the first included.
fn points(c: &mut Criterion) {
    const POINTS: usize = 5;
    let mut group = c.benchmark_group("points");
    group.sample_size(10).throughput(Throughput::Elements(POINTS as u64));
    for panels in [17, 57] {
        let structure = sheet(panels);
        let path = analysis::Path { step: 0.002, longest: 0.002, ..analysis::Path::steps(POINTS) };
        group.bench_function(BenchmarkId::from_parameter(structure.unknowns()), |b| {
            b.iter(|| {
                let mut seen = 0;
                let mut count = |point: &analysis::Point| {
                    seen += 1;
                    black_box(point);
                    ControlFlow::Continue(())
                };
                structure.trace(&Start::default(), &path, &mut count).expect("a path");
                assert_eq!(seen, POINTS);
            });
        });
    }
    group.finish();
}

criterion_group!(benches, paths, points);
criterion_main!(benches);
