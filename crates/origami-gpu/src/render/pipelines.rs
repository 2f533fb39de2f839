//! The two pipelines that draw: paper, then lines.

use origami_picture::shade::{AMBIENT, KEY, SHADE, SKY};
use origami_shaders::render::{FACES, LINES, SCENE};

use crate::device::Gpu;

/// Light, premultiplied: halves keep 11 bits, more than a picture shows.
pub(super) const LIGHT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// What every adapter has, and as fine as the processor's.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Samples of a pixel that is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sampling {
    /// One sample a pixel, in the pixel's middle.
    Single,
    /// Four, as every adapter has them.
    Four,
}

impl Sampling {
    pub(super) fn count(self) -> u32 {
        match self {
            Self::Single => 1,
            Self::Four => 4,
        }
    }
}

/// The text of a shader that draws. A fragment with one sample needs no capability to look at it.
pub(super) fn source(own: &str, sampling: Sampling) -> String {
    let text = [SCENE, own].join("\n");
    match sampling {
        Sampling::Single => text.replace("(linear, sample)", "(linear)"),
        Sampling::Four => text,
    }
}

/// What is drawn with so many samples.
#[derive(Debug)]
pub(super) struct Pipelines {
    pub(super) sampling: Sampling,
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) faces: wgpu::RenderPipeline,
    pub(super) lines: wgpu::RenderPipeline,
}

impl Pipelines {
    /// Where they are refused, wgpu says so to the error scope that this is called in.
    pub(super) fn new(gpu: &Gpu, sampling: Sampling) -> Self {
        let layout = bindings(gpu);
        let pipelines = gpu.device().create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("figure"),
            bind_group_layouts: &[Some(&layout)],
            ..Default::default()
        });
        let pipeline = |own, [vertex, fragment]: [&str; 2]| {
            let module = gpu.device().create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(vertex),
                source: wgpu::ShaderSource::Wgsl(source(own, sampling).into()),
            });
            let light = [("AMBIENT", AMBIENT), ("KEY", KEY), ("SKY", SKY), ("SHADE", SHADE)];
            let light = light.map(|(name, x)| (name, f64::from(x)));
            let compilation_options = wgpu::PipelineCompilationOptions { constants: &light, ..Default::default() };
            gpu.device().create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(vertex),
                layout: Some(&pipelines),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some(vertex),
                    compilation_options: compilation_options.clone(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                // Of equal depths the later wins, as on the processor.
                depth_stencil: Some(wgpu::DepthStencilState {
                    format: DEPTH,
                    depth_write_enabled: Some(true),
                    depth_compare: Some(wgpu::CompareFunction::LessEqual),
                    stencil: wgpu::StencilState::default(),
                    bias: wgpu::DepthBiasState::default(),
                }),
                multisample: wgpu::MultisampleState { count: sampling.count(), ..Default::default() },
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some(fragment),
                    compilation_options,
                    targets: &[Some(LIGHT.into())],
                }),
                multiview_mask: None,
                cache: None,
            })
        };
        Self {
            sampling,
            faces: pipeline(FACES, ["face_corner", "face_colour"]),
            lines: pipeline(LINES, ["line_corner", "line_colour"]),
            layout,
        }
    }
}

/// Whether a binding is a uniform, and where it is used.
pub(super) const BINDINGS: [(bool, wgpu::ShaderStages); 8] = [
    (true, wgpu::ShaderStages::VERTEX_FRAGMENT),
    (true, wgpu::ShaderStages::VERTEX),
    (false, wgpu::ShaderStages::VERTEX),
    (false, wgpu::ShaderStages::VERTEX),
    (false, wgpu::ShaderStages::VERTEX),
    (false, wgpu::ShaderStages::VERTEX),
    (true, wgpu::ShaderStages::VERTEX_FRAGMENT),
    (false, wgpu::ShaderStages::FRAGMENT),
];

fn bindings(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let entry = |(binding, (uniform, visibility)): (u32, (bool, wgpu::ShaderStages))| wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: if uniform {
                wgpu::BufferBindingType::Uniform
            } else {
                wgpu::BufferBindingType::Storage { read_only: true }
            },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    };
    let entries: Vec<_> = (0..).zip(BINDINGS).map(entry).collect();
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: Some("figure"), entries: &entries };
    gpu.device().create_bind_group_layout(&descriptor)
}
