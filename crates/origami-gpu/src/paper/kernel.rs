//! A pass as a kernel.

use origami_core::model::DEGENERATE;
use origami_core::twins::state_bounds::{FARTHEST, LONGEST_MOVE};
use origami_shaders::{ANGLE, paper::SHEET};

use super::layout::Slot;
use crate::Gpu;

/// Invocations in a workgroup.
pub(super) const WORKGROUP: u32 = 64;

/// What a kernel does once each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Each {
    Triangle,
    Crease,
    Node,
}

/// One pass.
#[derive(Debug)]
pub(crate) struct Kernel {
    /// The entry point.
    pub(crate) name: &'static str,
    /// Its own part of the shader.
    pub(super) own: &'static str,
    /// What it reads and writes.
    pub(super) slots: &'static [Slot],
    pub(super) each: Each,
}

impl Kernel {
    /// The whole shader.
    pub(crate) fn text(&self) -> String {
        [SHEET, ANGLE, self.own].concat()
    }

    /// Compiles it, and binds the buffers, which are in the order of their bindings.
    pub(super) fn bound(&self, gpu: &Gpu, buffers: &[wgpu::Buffer]) -> Pass {
        let device = gpu.device();
        let entry = |slot: &Slot| wgpu::BindGroupLayoutEntry {
            binding: *slot as u32,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer {
                ty: slot.binding_type(),
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let entries: Vec<_> = self.slots.iter().map(entry).collect();
        let label = Some(self.name);
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label, entries: &entries });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label,
            bind_group_layouts: &[Some(&layout)],
            ..Default::default()
        });
        let source = wgpu::ShaderSource::Wgsl(self.text().into());
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source });
        let constants = [
            ("WORKGROUP", f64::from(WORKGROUP)),
            ("DEGENERATE", DEGENERATE),
            ("FARTHEST", FARTHEST),
            ("LONGEST_MOVE", LONGEST_MOVE),
        ];
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label,
            layout: Some(&pipeline_layout),
            module: &module,
            entry_point: label,
            compilation_options: wgpu::PipelineCompilationOptions { constants: &constants, ..Default::default() },
            cache: None,
        });
        let bind = |slot: &Slot| wgpu::BindGroupEntry {
            binding: *slot as u32,
            resource: buffers[*slot as usize].as_entire_binding(),
        };
        let entries: Vec<_> = self.slots.iter().map(bind).collect();
        let bindings =
            device.create_bind_group(&wgpu::BindGroupDescriptor { label, layout: &layout, entries: &entries });
        Pass { pipeline, bindings }
    }
}

/// A kernel that can run.
#[derive(Debug)]
pub(super) struct Pass {
    pub(super) pipeline: wgpu::ComputePipeline,
    pub(super) bindings: wgpu::BindGroup,
}
