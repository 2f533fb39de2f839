//! From a kernel and a variant to a pipeline with its buffers bound.

use std::collections::BTreeMap;

use crate::device::Gpu;
use crate::error::GpuError;
use crate::kernels::{Binding, Kernel, Per};
use crate::variant::Variant;

/// The buffers of a sheet.
pub(crate) type Buffers = BTreeMap<Binding, wgpu::Buffer>;

/// A buffer of `size` bytes that begins with `contents`; the rest is zeros.
///
/// # Errors
/// [`GpuError::TooLarge`]. Other refusals go to the error scope that this is called in.
pub(crate) fn buffer(gpu: &Gpu, binding: Binding, size: u64, contents: &[u8]) -> Result<wgpu::Buffer, GpuError> {
    use wgpu::BufferUsages as Usages;

    // An empty binding is not allowed.
    let size = size.max(64);
    gpu.fits(binding.what(), size)?;
    let kind = match binding {
        Binding::Settings => Usages::UNIFORM,
        // Whoever draws a simulation reads the positions where they lie.
        Binding::Nodes => Usages::STORAGE | Usages::VERTEX,
        _ => Usages::STORAGE,
    };
    let buffer = gpu.device().create_buffer(&wgpu::BufferDescriptor {
        label: Some(binding.what()),
        size,
        usage: kind | Usages::COPY_DST | Usages::COPY_SRC,
        mapped_at_creation: false,
    });
    if !contents.is_empty() {
        gpu.queue().write_buffer(&buffer, 0, contents);
    }
    Ok(buffer)
}

/// A kernel that can be dispatched.
#[derive(Debug)]
pub(crate) struct Pass {
    pipeline: wgpu::ComputePipeline,
    bind_group: wgpu::BindGroup,
    groups: u32,
    /// Its buffers.
    bindings: Vec<Binding>,
    /// Of a pass over pairs, of which there may be more or fewer: invocations of a workgroup.
    over_pairs: Option<u32>,
}

impl Pass {
    /// Builds `kernel` for `variant`. Where it is refused, wgpu says so to the error scope that this is called in.
    pub(crate) fn new(gpu: &Gpu, kernel: &Kernel, variant: &Variant, advances_clock: bool, buffers: &Buffers) -> Self {
        let variant = if kernel.per == Per::Block { &variant.of_a_block() } else { variant };
        let source = kernel.source(variant);
        let constants = asked_for(&source, variant.constants(advances_clock));
        let module = gpu.device().create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(kernel.name),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let pipeline = gpu.device().create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(kernel.name),
            layout: None,
            module: &module,
            entry_point: Some(kernel.entry),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants: &constants,
                // Every kernel writes its workgroup's memory before it reads it.
                zero_initialize_workgroup_memory: false,
            },
            cache: None,
        });
        let bindings = kernel.bindings(variant);
        let bind_group = bind_group(gpu, &pipeline, &bindings, buffers);
        let elements = match kernel.per {
            // A workgroup each.
            Per::Block => variant.sums() * variant.workgroup as usize,
            Per::Crease => variant.creases,
            Per::Face => variant.faces,
            // As many as there are in the first list.
            Per::Pair => 0,
            Per::LooseBeam => variant.loose_beams,
            Per::Node => variant.nodes,
            Per::NodeOrCrease => variant.nodes.max(variant.creases),
            Per::Instance => 1,
        };
        // Even a pass without elements may keep the time.
        #[expect(clippy::cast_possible_truncation, reason = "elements are counted in u32")]
        let groups = variant.groups(elements).max(1) as u32;
        let over_pairs = (kernel.per == Per::Pair).then_some(variant.workgroup);
        Self { pipeline, bind_group, groups, bindings, over_pairs }
    }

    /// Binds it to other buffers.
    pub(crate) fn rebind(&mut self, gpu: &Gpu, buffers: &Buffers) {
        self.bind_group = bind_group(gpu, &self.pipeline, &self.bindings, buffers);
    }

    /// From now on there are so many pairs.
    pub(crate) fn set_pairs(&mut self, pairs: u32) {
        if let Some(workgroup) = self.over_pairs {
            self.groups = pairs.div_ceil(workgroup).max(1);
        }
    }

    /// Records one dispatch over `instances`.
    pub(crate) fn record(&self, pass: &mut wgpu::ComputePass<'_>, instances: u32) {
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.bind_group, &[]);
        pass.dispatch_workgroups(self.groups, instances, 1);
    }
}

fn bind_group(gpu: &Gpu, pipeline: &wgpu::ComputePipeline, bindings: &[Binding], buffers: &Buffers) -> wgpu::BindGroup {
    let entry = |b: &Binding| wgpu::BindGroupEntry { binding: *b as u32, resource: buffers[b].as_entire_binding() };
    let entries: Vec<wgpu::BindGroupEntry<'_>> = bindings.iter().map(entry).collect();
    gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &entries,
    })
}

/// Those of the constants that the text declares.
fn asked_for(source: &str, constants: Vec<(&'static str, f64)>) -> Vec<(&'static str, f64)> {
    constants.into_iter().filter(|(name, _)| source.contains(&format!("override {name}:"))).collect()
}
