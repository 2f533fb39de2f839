//! A square of pixels with several samples each.

use super::circles::Circles;
use super::line::Stroke;
use super::samples::Pattern;
use super::triangle::{Facet, Paint};
use crate::colour::Rgb;

/// The owner of a sample that no triangle covers.
const NOBODY: u32 = u32::MAX;

/// Pixels along a side of a tile.
pub(super) const SIZE: usize = 32;

/// Depth and colour of each sample.
pub(super) struct Tile<'a> {
    pattern: Pattern,
    circles: &'a Circles,
    background: Option<[f32; 3]>,
    /// Its place among the tiles.
    column: usize,
    row: usize,
    depths: Vec<f32>,
    /// The triangle that is seen, where some lie upon each other in a circle; else empty.
    owners: Vec<u32>,
    /// Its depth without layers.
    bare: Vec<f64>,
    /// Linear light; nothing has been drawn where the depth is infinite.
    colours: Vec<[f32; 3]>,
}

impl<'a> Tile<'a> {
    pub(super) fn new(pattern: Pattern, background: Option<Rgb>, circles: &'a Circles) -> Self {
        let count = SIZE * SIZE * pattern.len();
        Self {
            pattern,
            circles,
            background: background.map(Rgb::linear),
            column: 0,
            row: 0,
            depths: vec![f32::INFINITY; count],
            owners: vec![NOBODY; if circles.is_empty() { 0 } else { count }],
            bare: vec![0.0; if circles.is_empty() { 0 } else { count }],
            colours: vec![[0.0; 3]; count],
        }
    }

    pub(super) fn clear(&mut self, column: usize, row: usize) {
        (self.column, self.row) = (column, row);
        self.depths.fill(f32::INFINITY);
        self.owners.fill(NOBODY);
    }

    /// Pixels of this tile that the rectangle touches, by rows: `(x, y)` in the picture and the place of the first sample.
    fn pixels(&self, [left, top, right, bottom]: [f64; 4]) -> impl Iterator<Item = (f64, f64, usize)> + use<> {
        let (x0, y0) = ((self.column * SIZE) as f64, (self.row * SIZE) as f64);
        let range = |low: f64, high: f64, start: f64| {
            let place = |x: f64| (x - start).clamp(0.0, SIZE as f64);
            place(low.floor()) as usize..place(high.floor() + 1.0) as usize
        };
        let (across, samples) = (range(left, right, x0), self.pattern.len());
        range(top, bottom, y0)
            .flat_map(move |y| across.clone().map(move |x| (x0 + x as f64, y0 + y as f64, (y * SIZE + x) * samples)))
    }

    pub(super) fn facet(&mut self, name: u32, facet: &Facet, paint: &Paint<'_>) {
        let pattern = self.pattern;
        for (x, y, first) in self.pixels(facet.bounds) {
            // The farthest corner of the pixel is outside of one edge: so are all its samples.
            let outside = facet
                .edges
                .iter()
                .any(|edge| edge.plane.of(x + 0.5, y + 0.5) + 0.5 * (edge.plane.dx.abs() + edge.plane.dy.abs()) < 0.0);
            if outside {
                continue;
            }
            let colour = paint.at(name, facet, x + 0.5, y + 0.5);
            for (i, [dx, dy]) in pattern.iter().enumerate() {
                let (sx, sy) = (x + dx, y + dy);
                if facet.edges.iter().all(|edge| edge.holds(sx, sy)) {
                    let depth = facet.depth.of(sx, sy).clamp(facet.range[0], facet.range[1]);
                    let here = [depth, facet.bare.of(sx, sy)];
                    let in_front =
                        self.owner(first + i).and_then(|(o, bare)| self.circles.in_front([name, o], [here[1], bare]));
                    self.put(first + i, here, colour, in_front, Some(name));
                }
            }
        }
    }

    pub(super) fn stroke(&mut self, stroke: &Stroke) {
        let pattern = self.pattern;
        let [ax, ay] = stroke.along;
        let length = ax.hypot(ay).max(1e-9);
        for (x, y, first) in self.pixels(stroke.bounds) {
            let (cx, cy) = (x + 0.5 - stroke.from[0], y + 0.5 - stroke.from[1]);
            if ((cx * ay - cy * ax) / length).abs() > stroke.half + 0.71 && length > 1e-6 {
                continue;
            }
            for (i, [dx, dy]) in pattern.iter().enumerate() {
                if let Some(here) = stroke.cover(x + dx, y + dy) {
                    let in_front = self
                        .owner(first + i)
                        .and_then(|(o, bare)| self.circles.line_in_front(stroke.triangles, o, [here[1], bare]));
                    self.put(first + i, here, stroke.colour, in_front, stroke.triangles[0]);
                }
            }
        }
    }

    /// The triangle that is seen in a sample and its depth without layers, where that matters.
    #[inline(always)]
    fn owner(&self, sample: usize) -> Option<(u32, f64)> {
        let owner = self.owners.get(sample).copied().filter(|owner| *owner != NOBODY)?;
        Some((owner, *self.bare.get(sample)?))
    }

    /// Of equal depths the later wins: lines of one kind that meet. Where it is known whether this is `in_front`,
    /// depth does not count.
    #[inline(always)]
    fn put(&mut self, sample: usize, here: [f64; 2], colour: [f32; 3], in_front: Option<bool>, owner: Option<u32>) {
        let depth = here[0] as f32;
        if in_front.unwrap_or(depth <= self.depths[sample]) {
            self.depths[sample] = depth;
            self.colours[sample] = colour;
            if let (Some(place), Some(bare)) = (self.owners.get_mut(sample), self.bare.get_mut(sample)) {
                *place = owner.unwrap_or(NOBODY);
                *bare = here[1];
            }
        }
    }

    /// Writes the mean of each pixel's samples into a band of the picture's rows, the one that this tile lies in.
    pub(super) fn resolve(&self, band: &mut [u8], width: usize) {
        let samples = self.pattern.len();
        let left = self.column * SIZE;
        let columns = SIZE.min(width.saturating_sub(left));
        for (y, row) in band.chunks_exact_mut(4 * width).enumerate() {
            let pixels = row.chunks_exact_mut(4).skip(left).take(columns);
            for (x, pixel) in pixels.enumerate() {
                let first = (y * SIZE + x) * samples;
                self.resolve_pixel(first..first + samples, pixel);
            }
        }
    }

    fn resolve_pixel(&self, samples: std::ops::Range<usize>, pixel: &mut [u8]) {
        let count = samples.len() as f32;
        let (mut light, mut drawn) = ([0.0; 3], 0.0);
        for sample in samples {
            let here = self.depths[sample] < f32::INFINITY;
            let colour = if here { Some(self.colours[sample]) } else { self.background };
            if here {
                drawn += 1.0;
            }
            if let Some(colour) = colour {
                light = [0, 1, 2].map(|c| light[c] + colour[c]);
            }
        }
        // Nothing to do where the ground is bare: the picture was made with it.
        if drawn > 0.0 {
            let by = if self.background.is_some() { count } else { drawn };
            let Rgb(r, g, b) = Rgb::from_linear(light.map(|c| c / by));
            let alpha = if self.background.is_some() { 255.0 } else { 255.0 * drawn / count };
            pixel.copy_from_slice(&[r, g, b, (alpha + 0.5) as u8]);
        }
    }
}
