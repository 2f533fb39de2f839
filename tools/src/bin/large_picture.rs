//! What a picture of 100 000 triangles costs in processor time, on a GPU (or a software adapter) and without one:
//! `cargo run --release -p origami-tools --bin large_picture -- OUT.png`. Processor time is told on Linux alone.

#![expect(clippy::print_stdout, reason = "it is there to tell")]

use std::error::Error;
use std::fs::File;
use std::time::Instant;

use origami::gpu::render::GpuRenderer;
use origami::gpu::{AdapterChoice, Gpu};
use origami::picture::{Figure, Line, LineKind, LineSet, Picture, Processor, Renderer};

/// A wavy sheet of 2 x `side` x `side` triangles with all its lines.
fn waves(side: u32) -> Figure {
    let node = |x: u32, y: u32| y * (side + 1) + x;
    let all = |count: u32| (0..count).flat_map(move |y| (0..count).map(move |x| (x, y)));
    let place = |(x, y): (u32, u32)| {
        let [u, v] = [x, y].map(|i| i as f32 / side as f32 * 2.0 - 1.0);
        [u, v, 0.15 * (9.0 * u).sin() * (7.0 * v).cos()]
    };
    let face = |(x, y): (u32, u32)| {
        [[node(x, y), node(x + 1, y), node(x + 1, y + 1)], [node(x, y), node(x + 1, y + 1), node(x, y + 1)]]
    };
    let line = |nodes: [u32; 2], kind, triangles| Line { nodes, along: [0.0, 1.0], kind, triangles };
    let lines = |(x, y): (u32, u32)| {
        let first = 2 * (y * side + x);
        let below = y.checked_sub(1).map(|y| 2 * (y * side + x) + 1);
        let before = x.checked_sub(1).map(|x| 2 * (y * side + x));
        [
            line([node(x, y), node(x + 1, y)], LineKind::Mountain, [Some(first), below]),
            line([node(x, y), node(x, y + 1)], LineKind::Valley, [Some(first + 1), before]),
            line([node(x, y), node(x + 1, y + 1)], LineKind::Facet, [Some(first), Some(first + 1)]),
        ]
    };
    Figure {
        positions: all(side + 1).map(place).collect(),
        triangles: all(side).flat_map(face).collect(),
        lines: all(side).flat_map(lines).collect(),
        ..Figure::default()
    }
}

/// Seconds of processor time of this process so far, all threads together.
fn processor_time() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<f64> =
        stat.rsplit(") ").next().unwrap_or("").split(' ').map(|field| field.parse().unwrap_or(0.0)).collect();
    fields.get(11..13).map_or(0.0, |times| (times[0] + times[1]) / 100.0)
}

fn timed<T>(what: &str, f: impl FnOnce() -> T) -> T {
    let (clock, processor) = (Instant::now(), processor_time());
    let done = f();
    println!("{what}: {:.2} s, of processors {:.2} s", clock.elapsed().as_secs_f64(), processor_time() - processor);
    done
}

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::args().nth(1).unwrap_or_else(|| "large.png".to_owned());
    let gpu = timed("opening the adapter", || Gpu::open(&AdapterChoice::from_env()))?;
    let renderer = timed("making the pipelines", || GpuRenderer::new(&gpu))?;
    let mut figure = waves(224);
    let shown = figure.lines.iter().filter(|line| LineSet::default().has(line.kind)).count();
    println!("{}: {} triangles, {shown} lines", gpu.adapter(), figure.triangles.len());
    timed("soft shading", || figure.shade());
    for samples in [4, 16] {
        let picture = Picture { samples, ..Picture::default() };
        for run in ["first", "second", "third"] {
            let image = timed(&format!("{samples} samples, {run} picture"), || renderer.draw(&picture, &figure))?;
            image.write_png(File::create(&out)?)?;
        }
        timed(&format!("{samples} samples, without a GPU"), || Processor.draw(&picture, &figure))?;
        let bare = Picture { edges: LineSet::NONE, ..picture };
        timed(&format!("{samples} samples, no lines"), || renderer.draw(&bare, &figure))?;
    }
    Ok(())
}
