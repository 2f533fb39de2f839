//! Simulates a sheet on the caller's own GPU device, where a shader of the caller's reads its positions.
#![expect(clippy::print_stdout, reason = "an example prints what it found")]

use origami::generate::BirdBase;
use origami::gpu::{Gpu, wgpu};
use origami::scene::Targets;
use origami::solve::Simulation;
use origami::{Material, Model, Relax};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let Ok(adapter) = pollster::block_on(instance.request_adapter(&Default::default())) else {
        println!("there is no GPU here");
        return Ok(());
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&Default::default()))?;

    // These are handles: the caller goes on with its own.
    let gpu = Gpu::from_device(device.clone(), queue.clone())?;
    let model = Model::new(&BirdBase::default().pattern()?, &Material::default())?;
    let mut simulation = Simulation::new(model, gpu.with(Relax::default()))?;
    simulation.set_targets(Targets::percent(80.0))?;
    for _ in 0..4 {
        let report = simulation.step(100)?;
        let [lowest, highest] = heights(&device, &queue, simulation.engine().positions_buffer().buffer)?;
        println!("step {}: our shader finds heights of {lowest:.6} to {highest:.6} radii", report.steps);
    }
    let highest = simulation.positions()?.iter().map(|position| position.z).fold(f64::NEG_INFINITY, f64::max);
    println!("read back, the highest node is at {highest:.6} radii");
    Ok(())
}

/// Runs the shader over the nodes. All of this is wgpu as usual: the positions are one buffer among others.
fn heights(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    nodes: &wgpu::Buffer,
) -> Result<[f32; 2], Box<dyn std::error::Error>> {
    let buffer = |usage| wgpu::BufferDescriptor { label: None, size: 8, usage, mapped_at_creation: false };
    let found = device.create_buffer(&buffer(wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC));
    let copy = device.create_buffer(&buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST));
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &device.create_shader_module(wgpu::include_wgsl!("share_a_device.wgsl")),
        entry_point: None,
        compilation_options: Default::default(),
        cache: None,
    });
    let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: nodes.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: found.as_entire_binding() },
        ],
    });
    let mut encoder = device.create_command_encoder(&Default::default());
    {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bindings, &[]);
        pass.dispatch_workgroups(1, 1, 1);
    }
    encoder.copy_buffer_to_buffer(&found, 0, &copy, 0, 8);
    queue.submit([encoder.finish()]);
    copy.map_async(wgpu::MapMode::Read, .., |_| {});
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let bytes = copy.get_mapped_range(..)?;
    Ok([0, 4].map(|i| f32::from_le_bytes([bytes[i], bytes[i + 1], bytes[i + 2], bytes[i + 3]])))
}
