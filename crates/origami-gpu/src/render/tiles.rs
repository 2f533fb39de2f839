//! A picture in tiles: what no texture holds is drawn part by part. Corners lie on a grid that is the picture's, not the
//! tile's, so that no seam is seen.

use origami_picture::Picture;

use super::GpuRenderer;
use super::layout::{Resolve, Tile as TileUniform};
use super::pipelines::Pipelines;
use super::targets::Targets;
use super::upload::Uploaded;
use crate::error::GpuError;

/// A part of the picture, in its pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Tile {
    pub(super) left: u32,
    pub(super) top: u32,
    pub(super) width: u32,
    pub(super) height: u32,
}

/// The tiles into which a picture is cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tiles {
    picture: [u32; 2],
    /// Pixels of the picture in a tile, across and down; those at the right and at the bottom may be smaller.
    size: [u32; 2],
    factor: u32,
}

impl Tiles {
    /// Of at most `most` pixels a side that are drawn, `factor` of them for each of the picture's.
    pub(super) fn new(picture: &Picture, most: u32, factor: u32) -> Self {
        let sides = [picture.width, picture.height];
        let most = (most / factor).max(1);
        // All about equally large.
        let size = sides.map(|side| side.div_ceil(side.div_ceil(most).max(1)).max(1));
        Self { picture: sides, size, factor }
    }

    /// The largest tile, in pixels that are drawn.
    pub(super) fn largest(&self) -> [u32; 2] {
        self.size.map(|side| side * self.factor)
    }

    /// All tiles, row by row.
    pub(super) fn all(self) -> impl Iterator<Item = Tile> {
        let starts = move |axis: usize| (0..self.picture[axis]).step_by(self.size[axis] as usize);
        let tile = move |left: u32, top: u32| Tile {
            left,
            top,
            width: self.size[0].min(self.picture[0] - left),
            height: self.size[1].min(self.picture[1] - top),
        };
        starts(1).flat_map(move |top| starts(0).map(move |left| tile(left, top)))
    }
}

impl GpuRenderer {
    /// The finished pixels of a tile: red, green, blue and alpha, row by row.
    pub(super) fn draw_tile(
        &self,
        pipelines: &Pipelines,
        figure: &Uploaded,
        targets: &Targets,
        tile: &Tile,
    ) -> Result<Vec<u8>, GpuError> {
        let origin = [tile.left, tile.top].map(|x| (x * figure.factor) as f32);
        let place = TileUniform { origin, size: targets.size.map(|side| side as f32) };
        let settings = Resolve {
            ground: figure.ground,
            factor: figure.factor,
            size: [tile.width, tile.height],
            bare: u32::from_le_bytes(figure.bare),
            unused: 0,
        };
        let reading = self.gpu.scoped(|| {
            self.gpu.queue().write_buffer(&figure.tile, 0, bytemuck::bytes_of(&place));
            let mut encoder = self.gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            record(&mut encoder, pipelines, figure, targets);
            self.resolver.read(&self.gpu, encoder, &targets.light, &settings)
        })?;
        reading.wait(&self.gpu)
    }
}

/// Paper, then the lines on it.
fn record(encoder: &mut wgpu::CommandEncoder, pipelines: &Pipelines, figure: &Uploaded, targets: &Targets) {
    let (view, resolve_target) = match &targets.samples {
        Some(samples) => (samples, Some(&targets.light)),
        None => (&targets.light, None),
    };
    let store = if resolve_target.is_some() { wgpu::StoreOp::Discard } else { wgpu::StoreOp::Store };
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("picture"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT), store },
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &targets.depth,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Discard }),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    pass.set_bind_group(0, &figure.bindings, &[]);
    if figure.face_corners > 0 {
        pass.set_pipeline(&pipelines.faces);
        pass.draw(0..figure.face_corners, 0..1);
    }
    if figure.line_corners > 0 {
        pass.set_pipeline(&pipelines.lines);
        pass.set_index_buffer(figure.line_indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..figure.line_corners, 0, 0..1);
    }
}
