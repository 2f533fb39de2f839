//! Bytes that a step moves and memory that a sheet takes, counted from the buffers; needs no GPU. Prints Markdown.
//!
//! `cargo run --release -p origami-tools --bin traffic [NODES ...]`
#![expect(clippy::print_stdout, reason = "a tool prints what it found")]

use std::error::Error;

use origami::gpu::Traffic;
use origami::{Dynamics, Material, Model, generate};

/// The part of a buffer that every adapter can show to a kernel (`wgpu::Limits::default()`).
const BINDING: f64 = (128 << 20) as f64;
/// Bytes a second.
const BANDWIDTHS: [f64; 3] = [100e9, 500e9, 2000e9];

fn main() -> Result<(), Box<dyn Error>> {
    let asked: Vec<usize> = std::env::args().skip(1).map(|arg| arg.parse()).collect::<Result<_, _>>()?;
    let most = BANDWIDTHS.map(|b| format!(" node-steps/s at {} GB/s |", b / 1e9)).concat();
    println!("| nodes | solver | bytes a node and step | memory, bytes a node | largest buffer | of 128 MiB |{most}");
    println!("|---|---|---|---|---|---|{}", "---|".repeat(BANDWIDTHS.len()));
    let mut last = None;
    for nodes in if asked.is_empty() { vec![100, 1024, 10_000, 99_856, 1_000_000] } else { asked } {
        let panels = nodes.isqrt().saturating_sub(1);
        let model = Model::new(&generate::miura(panels, panels)?, &Material::default())?;
        let counted = [
            ("dynamics", Traffic::of_dynamics(&model, &Dynamics::default())),
            ("relax", Traffic::of_relax(&model)),
            ("dynamics, blocks", Traffic::of_dynamics_in_blocks(&model, &Dynamics::default())),
            ("relax, blocks", Traffic::of_relax_in_blocks(&model)),
            ("paper's five passes", Traffic::of_paper(&model)),
        ];
        counted.iter().for_each(|(name, traffic)| row(name, traffic));
        last = Some(counted);
    }
    for (name, traffic) in last.iter().flatten() {
        parts(name, traffic);
    }
    Ok(())
}

fn row(name: &str, traffic: &Traffic) {
    let Some(largest) = traffic.buffers.iter().max_by_key(|buffer| buffer.bytes) else { return };
    let most = BANDWIDTHS.map(|b| format!(" {:.1e} |", traffic.most_node_steps_per_second(b))).concat();
    println!(
        "| {} | {name} | {:.0} | {:.0} | {} | {:.0} % |{most}",
        traffic.nodes,
        traffic.bytes_per_node_and_step(),
        traffic.memory() as f64 / traffic.nodes as f64,
        largest.what,
        100.0 * largest.bytes as f64 / BINDING,
    );
}

/// Buffers and passes of the last sheet.
fn parts(name: &str, traffic: &Traffic) {
    let nodes = traffic.nodes as f64;
    println!("\n{name}, {nodes} nodes:\n\n| buffer | bytes a node | of 128 MiB |\n|---|---|---|");
    for buffer in &traffic.buffers {
        let share = 100.0 * buffer.bytes as f64 / BINDING;
        println!("| {} | {:.1} | {share:.0} % |", buffer.what, buffer.bytes as f64 / nodes);
    }
    println!("\n| pass | times a step | reads, bytes a node | writes |\n|---|---|---|---|");
    for pass in &traffic.passes {
        let (read, written) = (pass.read as f64 / nodes, pass.written as f64 / nodes);
        println!("| {} | {} | {read:.1} | {written:.1} |", pass.name, pass.per_step);
    }
}
