//! Bytes that a step moves and memory that a sheet takes, counted from the buffers; needs no GPU. Prints Markdown.
//!
//! `cargo run --release --features gpu --example traffic [NODES ...]`
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use std::error::Error;

use origami::gpu::Traffic;
use origami::{Dynamics, Material, Model, generate};

/// The part of a buffer that every adapter can show to a kernel (`wgpu::Limits::default()`).
const BINDING: f64 = (128 << 20) as f64;
/// Bytes a second.
const BANDWIDTHS: [f64; 3] = [100e9, 500e9, 2000e9];

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<usize> = std::env::args().skip(1).map(|arg| arg.parse()).collect::<Result<_, _>>()?;
    for nodes in if asked.is_empty() { vec![100, 1024, 10_000, 99_856, 1_000_000] } else { asked } {
        let panels = nodes.isqrt().saturating_sub(1);
        let model = Model::new(&generate::miura(panels, panels)?, &Material::default())?;
        let of_dynamics = Traffic::of_dynamics(&model, &Dynamics::default());
        println!("\n## Miura sheet of {} nodes\n", of_dynamics.nodes);
        println!("| | bytes a node and step | memory, bytes a node | largest buffer | of 128 MiB |{}", heads());
        println!("|---|---|---|---|---|{}", "---|".repeat(BANDWIDTHS.len()));
        for (name, traffic) in [
            ("dynamics", of_dynamics),
            ("relax", Traffic::of_relax(&model)),
            ("paper's five passes", Traffic::of_paper(&model)),
        ] {
            row(name, &traffic);
        }
    }
    Ok(())
}

fn heads() -> String {
    BANDWIDTHS.map(|b| format!(" 1e9 node-steps/s at most at {} GB/s |", b / 1e9)).concat()
}

fn row(name: &str, traffic: &Traffic) {
    let Some(largest) = traffic.buffers.iter().max_by_key(|buffer| buffer.bytes) else { return };
    let most = BANDWIDTHS.map(|b| format!(" {:.2} |", traffic.most_node_steps_per_second(b) / 1e9)).concat();
    println!(
        "| {name} | {:.0} | {:.0} | {}, {:.1} MiB | {:.0} % |{most}",
        traffic.bytes_per_node_and_step(),
        traffic.memory() as f64 / traffic.nodes as f64,
        largest.what,
        largest.bytes as f64 / (1 << 20) as f64,
        100.0 * largest.bytes as f64 / BINDING,
    );
    for pass in &traffic.passes {
        println!(
            "<!-- {name}: {} x {}: reads {:.1}, writes {:.1} bytes a node -->",
            pass.name,
            pass.per_step,
            pass.read as f64 / traffic.nodes as f64,
            pass.written as f64 / traffic.nodes as f64
        );
    }
}
