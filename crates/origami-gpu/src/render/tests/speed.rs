//! How long a large picture takes: `cargo test -p origami-gpu --features render a_large_picture -- --ignored --nocapture`.

use std::time::Instant;

use origami_picture::{Line, LineKind};

use super::*;

/// A wavy sheet of 2 x `side` x `side` triangles with all its lines.
pub(super) fn waves(side: u32) -> Scene {
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
    Scene {
        positions: all(side + 1).map(place).collect(),
        triangles: all(side).flat_map(face).collect(),
        lines: all(side).flat_map(lines).collect(),
        ..Scene::default()
    }
}

/// Seconds of processor time of this process so far, all threads together.
fn processor_time() -> f64 {
    let stat = fs::read_to_string("/proc/self/stat").unwrap_or_default();
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

#[test]
#[ignore = "takes time; prints what the benchmarks report"]
fn a_large_picture() {
    let Some(gpu) = timed("opening the adapter", gpu) else { return };
    let scene = waves(224);
    println!("{}: {} triangles, {} lines", gpu.adapter(), scene.triangles.len(), scene.lines.len());
    let renderer = timed("making the pipelines", || Renderer::new(&gpu).unwrap());
    for samples in [4, 16] {
        let picture = Picture { samples, ..Picture::default() };
        for run in ["first", "second", "third"] {
            let image =
                timed(&format!("{samples} samples, {run} picture"), || renderer.draw(&picture, &scene).unwrap());
            write(&format!("waves-{samples}"), &image);
        }
        timed("on the processor", || picture.draw(&scene).unwrap());
        let bare = Picture { edges: origami_picture::LineSet::NONE, ..picture };
        timed("without lines", || renderer.draw(&bare, &scene).unwrap());
    }
}
