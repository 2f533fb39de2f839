//! Textures that are drawn into, and the buffer in which a finished tile is read.

use super::pipelines::{DEPTH, LIGHT, Sampling};
use crate::device::Gpu;
use crate::error::GpuError;

/// For tiles up to a size.
#[derive(Debug)]
pub(super) struct Targets {
    sampling: Sampling,
    /// In pixels that are drawn.
    pub(super) size: [u32; 2],
    /// One sample a pixel: what is drawn, or what the samples come to.
    pub(super) light: wgpu::TextureView,
    pub(super) samples: Option<wgpu::TextureView>,
    pub(super) depth: wgpu::TextureView,
}

impl Targets {
    /// Those at hand if they are of this size, else new ones.
    pub(super) fn at_least(
        gpu: &Gpu,
        at_hand: Option<Self>,
        sampling: Sampling,
        size: [u32; 2],
    ) -> Result<Self, GpuError> {
        if let Some(fits) = at_hand.filter(|t| t.sampling == sampling && t.size == size) {
            return Ok(fits);
        }
        let texture = |format, count, usage| {
            let texture = gpu.device().create_texture(&wgpu::TextureDescriptor {
                label: Some("picture"),
                size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: count,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            });
            texture.create_view(&wgpu::TextureViewDescriptor::default())
        };
        let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
        gpu.scoped(|| Self {
            sampling,
            size,
            light: texture(LIGHT, 1, drawn | wgpu::TextureUsages::TEXTURE_BINDING),
            samples: (sampling != Sampling::Single).then(|| texture(LIGHT, sampling.count(), drawn)),
            depth: texture(DEPTH, sampling.count(), drawn),
        })
    }
}
