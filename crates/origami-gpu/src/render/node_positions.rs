//! Positions of a simulation's nodes for drawing, without a way through the processor.

use origami_shaders::render::NODE_POSITIONS;
use origami_shaders::{CONTROL, STATE};

use super::resolve::kernel;
use crate::engine::Engine;
use crate::error::GpuError;
use crate::kernels::Binding;

/// The text of the kernel.
pub(super) fn source() -> String {
    [CONTROL, STATE, NODE_POSITIONS].join("\n")
}

/// Positions of the engine's first sheet, as shaders that draw read them.
pub(super) fn positions(engine: &Engine) -> Result<wgpu::Buffer, GpuError> {
    let (gpu, count) = (&engine.gpu, engine.variant.nodes);
    let size = count.max(1) * 16;
    gpu.fits("the positions", size as u64)?;
    gpu.scoped(|| {
        let device = gpu.device();
        let positions = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("positions"),
            size: size as u64,
            usage: wgpu::BufferUsages::STORAGE,
            mapped_at_creation: false,
        });
        let constants = [("NODES", count as f64), ("WORKGROUP", f64::from(engine.variant.workgroup))];
        let pipeline = kernel(gpu, "node_positions", &source(), &constants);
        let bindings = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("positions"),
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry {
                    binding: Binding::Nodes as u32,
                    resource: engine.buffers[&Binding::Nodes].as_entire_binding(),
                },
                wgpu::BindGroupEntry { binding: 14, resource: positions.as_entire_binding() },
            ],
        });
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            #[expect(clippy::cast_possible_truncation, reason = "an engine has at most 65 535 workgroups of nodes")]
            pass.dispatch_workgroups(engine.variant.groups(count).max(1) as u32, 1, 1);
        }
        gpu.queue().submit([encoder.finish()]);
        positions
    })
}
