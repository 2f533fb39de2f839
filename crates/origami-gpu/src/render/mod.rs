//! Pictures drawn on the GPU: those of [`origami_picture`], by the same figures, cameras and themes.
//!
//! They are drawn offscreen, with no window and no display, and agree with the processor's to what an eye can tell. Light
//! is averaged over 4 samples a pixel; for [`Picture::samples`] above 4, over 2 x 2 times as many. What is larger than the
//! adapter's textures, or than a bounded amount of memory, is drawn in tiles.
//!
//! Of triangles that lie upon each other in a circle ([`Figure::circles`]) no account is taken beyond what
//! [`Figure::layers`] say of them.
//!
//! ```no_run
//! use origami_gpu::render::GpuRenderer;
//! use origami_gpu::{AdapterChoice, Gpu};
//! # use origami_core::{Material, Model, Relax, Solver, generate::BirdBase};
//! use origami_picture::{Figure, Picture, Renderer};
//!
//! # let pattern = BirdBase::default().pattern()?;
//! # let model = Model::new(&pattern, &Material::default())?;
//! # let folded = Relax::default().fold_from_rest(&model, 60.0)?;
//! let renderer = GpuRenderer::new(&Gpu::open(&AdapterChoice::Any)?)?;
//! let figure = Figure::new(&pattern, &model, &folded.state.positions);
//! let image = renderer.draw(&Picture::default(), &figure)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod extremes;
mod layout;
mod node_positions;
mod pipelines;
mod resolve;
mod targets;
#[cfg(test)]
mod tests;
mod tiles;
mod upload;

use std::sync::{Mutex, PoisonError};

use origami_core::Error;
use origami_picture::{DrawError, Figure, Image, Picture, Renderer, View};

use crate::device::Gpu;
use crate::engine::Engine;
use crate::error::GpuError;
use crate::simulation::GpuEngine;
use crate::solver::OnModel;
use extremes::Extremes;
use pipelines::{Pipelines, Sampling};
use resolve::Resolver;
use targets::Targets;
use upload::{Shot, Uploaded};

/// Samples a side of the largest tile: 4 million samples' pixels, some 240 MB with four samples in each.
const LARGEST_TILE: u32 = 2048;

impl From<GpuError> for DrawError {
    fn from(error: GpuError) -> Self {
        Self::Device(Box::new(error))
    }
}

/// Draws pictures on a GPU. Its pipelines are made once, for all pictures; its textures stay from one picture to the next
/// of the same size.
#[derive(Debug)]
pub struct GpuRenderer {
    gpu: Gpu,
    /// By how many samples a pixel has.
    plain: Pipelines,
    multisampled: Option<Pipelines>,
    resolver: Resolver,
    extremes: Extremes,
    /// Pixels a side of a tile, of the finer picture that is averaged in the end.
    tile: u32,
    targets: Mutex<Option<Targets>>,
}

impl GpuRenderer {
    /// Makes all that does not depend on the picture.
    ///
    /// # Errors
    /// [`GpuError`] with what the device says.
    pub fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        Self::with(gpu, LARGEST_TILE, gpu.has_sample_shading())
    }

    /// With tiles of at most this many pixels a side, and with or without multisampling.
    fn with(gpu: &Gpu, tile: u32, multisampled: bool) -> Result<Self, GpuError> {
        gpu.scoped(|| Self {
            gpu: gpu.clone(),
            plain: Pipelines::new(gpu, Sampling::Single),
            multisampled: multisampled.then(|| Pipelines::new(gpu, Sampling::Four)),
            resolver: Resolver::new(gpu),
            extremes: Extremes::new(gpu),
            tile: tile.min(gpu.limits().max_texture_dimension_2d),
            targets: Mutex::default(),
        })
    }

    /// Draws a sheet where a simulation's session has left it, from the simulation's own memory: positions do not pass
    /// through the processor.
    ///
    /// Everything but positions is the figure's: its triangles and lines, its map, its layers and its openness. The last two
    /// belong to the positions that the figure has; take them away where the sheet has moved since. Without a `view` the sheet fills the
    /// picture, for which its outermost nodes are read: with an orthographic camera exactly, with a perspective one it may
    /// reach into the margins.
    ///
    /// # Errors
    /// [`DrawError::Invalid`] for a size, camera or figure that makes no sense, or a figure of another sheet;
    /// [`DrawError::Device`] with [`GpuError::Refused`] for a session on another GPU, or with whatever the device says.
    pub fn draw_session<S>(
        &self,
        picture: &Picture,
        figure: &Figure,
        session: &OnModel<'_, S>,
        view: Option<&View>,
    ) -> Result<Image, DrawError> {
        figure.check()?;
        self.draw_engine(picture, figure, session.engine()?, view)
    }

    /// The same where a simulation is now: `simulation.engine()`.
    ///
    /// # Errors
    /// As [`GpuRenderer::draw_session`].
    pub fn draw_simulation(
        &self,
        picture: &Picture,
        figure: &Figure,
        simulation: &GpuEngine,
        view: Option<&View>,
    ) -> Result<Image, DrawError> {
        figure.check()?;
        self.draw_engine(picture, figure, simulation.engine(), view)
    }

    /// Draws the first sheet of an engine by a figure that has been checked.
    fn draw_engine(
        &self,
        picture: &Picture,
        figure: &Figure,
        engine: &Engine,
        view: Option<&View>,
    ) -> Result<Image, DrawError> {
        if figure.positions.len() != engine.variant.nodes {
            let problem = format!("has {} nodes", figure.positions.len());
            return Err(
                Error::invalid("figure", problem, format!("the simulated sheet's {}", engine.variant.nodes)).into()
            );
        }
        if !engine.gpu.is(&self.gpu) {
            let adapters = format!("the sheet is on another device than the renderer, {}", self.gpu.adapter());
            return Err(GpuError::Refused(adapters).into());
        }
        let positions = node_positions::positions(engine)?;
        match view {
            Some(view) => self.draw_positions(picture, figure, view, &positions),
            None => {
                let outermost = self.extremes.of(&self.gpu, picture, &positions, figure.positions.len())?;
                let view = picture.view(figure, outermost.into_iter())?;
                self.draw_positions(picture, figure, &view, &positions)
            }
        }
    }

    /// Draws a figure that has been checked, with its nodes at `positions`.
    fn draw_positions(
        &self,
        picture: &Picture,
        figure: &Figure,
        view: &View,
        positions: &wgpu::Buffer,
    ) -> Result<Image, DrawError> {
        let mut image = Image::new(picture.width, picture.height, picture.theme.background)?;
        let (pipelines, factor) = self.sampling(picture.samples)?;
        let shot = Shot { picture, figure, view, factor };
        let uploaded = Uploaded::new(&self.gpu, pipelines, &shot, positions)?;
        let tiles = tiles::Tiles::new(picture, self.tile, factor);
        let mut kept = self.targets.lock().unwrap_or_else(PoisonError::into_inner);
        let targets = Targets::at_least(&self.gpu, kept.take(), pipelines.sampling, tiles.largest())?;
        for tile in tiles.all() {
            let pixels = self.draw_tile(pipelines, &uploaded, &targets, &tile)?;
            image.place(&Image { width: tile.width, height: tile.height, pixels }, tile.left, tile.top);
        }
        *kept = Some(targets);
        picture.annotate(figure, &mut image);
        Ok(image)
    }

    /// The pipelines for so many samples a pixel, and how many pixels a side are drawn for each of the picture's.
    fn sampling(&self, samples: u32) -> Result<(&Pipelines, u32), Error> {
        let finer = match samples {
            1 => return Ok((&self.plain, 1)),
            4 => 1,
            8 | 16 => 2,
            other => return Err(Error::invalid("samples", other.to_string(), "1, 4, 8 or 16")),
        };
        Ok(match &self.multisampled {
            Some(pipelines) => (pipelines, finer),
            // As many samples, on a plain grid.
            None => (&self.plain, 2 * finer),
        })
    }
}

/// What the device says is a [`GpuError`] in [`DrawError::Device`].
impl Renderer for GpuRenderer {
    fn draw_from(&self, picture: &Picture, figure: &Figure, view: &View) -> Result<Image, DrawError> {
        figure.check()?;
        let positions = self.gpu.scoped(|| upload::positions(&self.gpu, &figure.positions))?;
        self.draw_positions(picture, figure, view, &positions)
    }
}
