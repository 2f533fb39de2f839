//! A small rasteriser on the processor: depth buffer, several samples a pixel, flat shading, lines of constant width.
//!
//! The picture is cut into tiles; each is drawn by itself, so that memory beyond the picture's own stays small and threads
//! cannot change the result.

mod circles;
mod line;
mod samples;
mod tile;
mod triangle;

use origami_core::csr::Csr;
use rayon::prelude::*;

use crate::camera::View;
use crate::figure::Figure;
use crate::image::Image;
use crate::layers::LAYER;
use crate::picture::Picture;
use crate::renderer::{DrawError, Renderer};
use circles::Circles;
use line::Stroke;
pub use line::{EDGE_ON, ORDER, STEEP, bias, style};
use tile::{SIZE, Tile};
use triangle::{Facet, Paint};
pub use triangle::{lift, strength};

/// How far lines lie before the paper that they are drawn on, in radii: less than a layer, so that lines of the layer
/// below stay hidden.
pub const BIAS: f64 = 0.3 * LAYER;

/// The renderer that needs no GPU. It uses the threads of the pool that it is called in; their number changes no bit.
#[derive(Clone, Copy, Debug, Default)]
pub struct Processor;

impl Renderer for Processor {
    fn draw_from(&self, picture: &Picture, figure: &Figure, view: &View) -> Result<Image, DrawError> {
        figure.check()?;
        let pattern = samples::pattern(picture.samples)?;
        let mut image = Image::new(picture.width, picture.height, picture.theme.background)?;
        let screen = Screen::new(picture, view);
        let corners: Vec<Option<Corner>> = figure.positions.iter().map(|p| screen.corner(*p)).collect();
        let facets: Vec<Option<Facet>> = triangle::facets(picture, figure, view, &corners);
        let circles = Circles::new(figure, view);
        let strokes: Vec<Stroke> = line::strokes(picture, figure, view, &corners, &facets, &circles);

        let paint = Paint::new(picture, figure);
        let columns = (picture.width as usize).div_ceil(SIZE);
        let rows = (picture.height as usize).div_ceil(SIZE);
        let facets_at = Bins::new(columns, rows, facets.iter().map(|f| f.as_ref().map(|f| f.bounds)));
        let strokes_at = Bins::new(columns, rows, strokes.iter().map(|s| Some(s.bounds)));
        let width = picture.width as usize;
        image.pixels.par_chunks_mut(4 * width * SIZE).enumerate().for_each(|(row, band)| {
            let mut tile = Tile::new(pattern, picture.theme.background, &circles);
            for column in 0..columns {
                tile.clear(column, row);
                for f in facets_at.of(column, row) {
                    if let Some(Some(facet)) = facets.get(*f as usize) {
                        tile.facet(*f, facet, &paint);
                    }
                }
                for s in strokes_at.of(column, row) {
                    if let Some(stroke) = strokes.get(*s as usize) {
                        tile.stroke(stroke);
                    }
                }
                tile.resolve(band, width);
            }
        });
        picture.annotate(figure, &mut image);
        Ok(image)
    }
}

/// A node in the picture.
#[derive(Clone, Copy, Debug)]
struct Corner {
    /// Pixels to the right and down.
    x: f64,
    y: f64,
    /// Clip depth, 0 near to 1 far.
    z: f64,
    /// One over clip w.
    inverse_w: f64,
}

/// From positions to pixels.
struct Screen {
    matrix: [[f64; 4]; 4],
    half: [f64; 2],
}

impl Screen {
    fn new(picture: &Picture, view: &View) -> Self {
        let half = [picture.width, picture.height].map(|side| 0.5 * f64::from(side));
        Self { matrix: view.matrix.map(|column| column.map(f64::from)), half }
    }

    /// `None` behind the viewer.
    fn corner(&self, p: [f32; 3]) -> Option<Corner> {
        let row = |r: usize| (0..3).map(|c| self.matrix[c][r] * f64::from(p[c])).sum::<f64>() + self.matrix[3][r];
        let w = row(3);
        let inverse_w = 1.0 / w;
        // Edges are drawn exactly and without gaps where corners lie on a grid that doubles can multiply out.
        let snap = |x: f64| (x * 256.0).round() / 256.0;
        let x = snap((1.0 + row(0) * inverse_w) * self.half[0]);
        let y = snap((1.0 - row(1) * inverse_w) * self.half[1]);
        let z = row(2) * inverse_w;
        (w > 1e-9 && [x, y, z].iter().all(|c| c.abs() < 1e9)).then_some(Corner { x, y, z, inverse_w })
    }
}

/// A depth over the picture: `at + dx x + dy y`.
#[derive(Clone, Copy, Debug, Default)]
struct Plane {
    at: f64,
    dx: f64,
    dy: f64,
}

impl Plane {
    fn of(&self, x: f64, y: f64) -> f64 {
        self.at + self.dx * x + self.dy * y
    }
}

/// A rectangle of pixels: left, top, right, bottom, the last two outside.
type Bounds = [f64; 4];

/// What touches each tile, in the order given.
struct Bins {
    columns: usize,
    by_tile: Csr<u32>,
}

impl Bins {
    fn new(columns: usize, rows: usize, bounds: impl Iterator<Item = Option<Bounds>> + Clone) -> Self {
        let range = |low: f64, high: f64, most: usize| {
            let tile = |x: f64| (x / SIZE as f64).floor().clamp(-1.0, most as f64);
            let (low, high) = (tile(low).max(0.0) as usize, (tile(high) + 1.0).max(0.0) as usize);
            low..high.min(most)
        };
        let touched = |[left, top, right, bottom]: Bounds| {
            let across = range(left, right, columns);
            range(top, bottom, rows).flat_map(move |row| across.clone().map(move |column| row * columns + column))
        };
        let entries = (0_u32..)
            .zip(bounds)
            .flat_map(move |(item, bounds)| bounds.into_iter().flat_map(touched).map(move |tile| (tile, item)));
        Self { columns, by_tile: Csr::from_entries(columns * rows, entries) }
    }

    fn of(&self, column: usize, row: usize) -> &[u32] {
        self.by_tile.row(row * self.columns + column)
    }
}
