//! From light to bytes, on the GPU, and from there to the processor.

use origami_shaders::render::RESOLVE;

use super::layout::Resolve;
use super::upload::buffer;
use crate::device::Gpu;
use crate::mapped::Reading;

/// The kernel that finishes tiles.
#[derive(Debug)]
pub(super) struct Resolver {
    pipeline: wgpu::ComputePipeline,
}

impl Resolver {
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self { pipeline: kernel(gpu, "resolve", RESOLVE, &[]) }
    }

    /// Records the finishing of a tile after what `encoder` has recorded, submits it all and begins to read.
    pub(super) fn read(
        &self,
        gpu: &Gpu,
        mut encoder: wgpu::CommandEncoder,
        light: &wgpu::TextureView,
        settings: &Resolve,
    ) -> Reading<u8> {
        let [width, height] = settings.size;
        let size = 4 * u64::from(width) * u64::from(height);
        let pixels = gpu.device().create_buffer(&wgpu::BufferDescriptor {
            label: Some("pixels"),
            size,
            usage: wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC,
            mapped_at_creation: false,
        });
        let settings = buffer(gpu, &[*settings], wgpu::BufferUsages::UNIFORM);
        let bindings = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("resolve"),
            layout: &self.pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(light) },
                wgpu::BindGroupEntry { binding: 1, resource: settings.as_entire_binding() },
                wgpu::BindGroupEntry { binding: 2, resource: pixels.as_entire_binding() },
            ],
        });
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(0, &bindings, &[]);
            pass.dispatch_workgroups(width.div_ceil(8), height.div_ceil(8), 1);
        }
        Reading::new(gpu, encoder, &pixels, &[0], size as usize, "the picture")
    }
}

/// A compute pipeline, bound as its text says, with its constants.
pub(super) fn kernel(gpu: &Gpu, entry: &str, text: &str, constants: &[(&str, f64)]) -> wgpu::ComputePipeline {
    let module = gpu.device().create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(entry),
        source: wgpu::ShaderSource::Wgsl(text.into()),
    });
    gpu.device().create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some(entry),
        layout: None,
        module: &module,
        entry_point: Some(entry),
        compilation_options: wgpu::PipelineCompilationOptions { constants, ..Default::default() },
        cache: None,
    })
}
