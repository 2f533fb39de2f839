//! From a picture, a figure and a view to buffers.

use bytemuck::Pod;
use origami_picture::map::Values;
use origami_picture::raster::{EDGE_ON, ORDER, STEEP, bias, lift, strength, style};
use origami_picture::{Figure, LineKind, Picture, View};
use wgpu::util::DeviceExt;

use super::layout::{Frame, Line, NODES, NONE, Style, TRIANGLES, Tile, Triangle};
use super::pipelines::Pipelines;
use crate::device::Gpu;
use crate::error::GpuError;

/// Lines of the grid on which corners lie, a pixel of the picture: as on the processor.
const GRID: f32 = 256.0;

/// A figure with the picture and view in which it is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shot<'a> {
    pub(super) picture: &'a Picture,
    /// The figure, which has been checked.
    pub(super) figure: &'a Figure,
    pub(super) view: &'a View,
    /// Pixels a side that are drawn for each of the picture's.
    pub(super) factor: u32,
}

/// Two triangles of four corners.
const RECTANGLE: [u32; 6] = [0, 1, 2, 2, 1, 3];

/// A figure in the GPU's memory.
#[derive(Debug)]
pub(super) struct Uploaded {
    pub(super) bindings: wgpu::BindGroup,
    /// The part of the picture that is drawn next.
    pub(super) tile: wgpu::Buffer,
    /// Corners of all triangles.
    pub(super) face_corners: u32,
    /// Corners of the triangles that make up the rectangles around all lines: four corners each, of which two count twice.
    pub(super) line_corners: u32,
    pub(super) line_indices: wgpu::Buffer,
    /// Linear light of the ground, and whether there is one; red, green, blue and alpha of a pixel that is bare.
    pub(super) ground: [f32; 3],
    pub(super) bare: [u8; 4],
    /// Pixels a side that are drawn for each of the picture's.
    pub(super) factor: u32,
}

impl Uploaded {
    /// With its nodes at `positions`.
    pub(super) fn new(
        gpu: &Gpu,
        pipelines: &Pipelines,
        shot: &Shot<'_>,
        positions: &wgpu::Buffer,
    ) -> Result<Self, GpuError> {
        let Shot { picture, figure, view, factor } = *shot;
        let triangles = triangles(figure, view);
        let lines = lines(picture, figure);
        let counts = (corners(triangles.len(), 3)?, corners(lines.len(), 6)?);
        let line_indices: Vec<u32> = (0..counts.1 / 6).flat_map(|i| RECTANGLE.map(|corner| 4 * i + corner)).collect();
        let (shares, table) = map(figure);
        for (what, size) in [
            ("the triangles", size_of_val(&triangles[..])),
            ("the lines", size_of_val(&lines[..])),
            ("the corners of the lines", size_of_val(&line_indices[..])),
            ("the map", size_of_val(&shares[..])),
            ("the openness", size_of_val(&figure.openness.values[..])),
        ] {
            gpu.fits(what, size as u64)?;
        }
        let background = picture.theme.background;
        gpu.scoped(|| {
            let tile = buffer(gpu, &[Tile::default()], wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST);
            let storage = wgpu::BufferUsages::STORAGE;
            let uniform = wgpu::BufferUsages::UNIFORM;
            let frame = buffer(gpu, &[frame(shot)], uniform);
            let buffers = [
                &frame,
                &tile,
                positions,
                &buffer(gpu, &triangles, storage),
                &buffer(gpu, &lines, storage),
                &buffer(gpu, &shares, storage),
                &buffer(gpu, &table, uniform),
                &buffer(gpu, &figure.openness.values, storage),
            ];
            let bindings = gpu.device().create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("figure"),
                layout: &pipelines.layout,
                entries: &entries(&buffers),
            });
            Self {
                bindings,
                tile,
                face_corners: counts.0,
                line_corners: counts.1,
                line_indices: buffer(gpu, &line_indices, wgpu::BufferUsages::INDEX),
                ground: background.map_or([0.0; 3], |colour| colour.linear()),
                bare: background.map_or([0; 4], |colour| [colour.0, colour.1, colour.2, 255]),
                factor,
            }
        })
    }
}

/// Positions as shaders read them.
pub(super) fn positions(gpu: &Gpu, positions: &[[f32; 3]]) -> wgpu::Buffer {
    let padded: Vec<[f32; 4]> = positions.iter().map(|[x, y, z]| [*x, *y, *z, 0.0]).collect();
    buffer(gpu, &padded, wgpu::BufferUsages::STORAGE)
}

/// A buffer with these contents; an empty one has room for one.
pub(super) fn buffer<T: Pod>(gpu: &Gpu, contents: &[T], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let nothing = [T::zeroed()];
    let contents = if contents.is_empty() { &nothing } else { contents };
    let contents = bytemuck::cast_slice(contents);
    gpu.device().create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents, usage })
}

/// Buffers, each bound by its number.
pub(super) fn entries<'b>(buffers: &[&'b wgpu::Buffer]) -> Vec<wgpu::BindGroupEntry<'b>> {
    let numbered = (0..).zip(buffers);
    numbered.map(|(binding, b)| wgpu::BindGroupEntry { binding, resource: b.as_entire_binding() }).collect()
}

/// Corners are counted in 32 bits.
fn corners(count: usize, each: u32) -> Result<u32, GpuError> {
    let corners = u32::try_from(count).ok().and_then(|count| count.checked_mul(each));
    let allowed = u64::from(u32::MAX / each);
    corners.ok_or(GpuError::TooManyElements { count: count as u64, allowed })
}

fn frame(shot: &Shot<'_>) -> Frame {
    let Shot { picture, figure, view, factor } = *shot;
    let finer = factor as f32;
    let theme = &picture.theme;
    let mapped = match figure.map.as_ref().map(|map| &map.values) {
        None => 0,
        Some(Values::Nodes(_)) => NODES,
        Some(Values::Triangles(_)) => TRIANGLES,
    };
    Frame {
        matrix: view.matrix,
        front: theme.front.linear(),
        shading: strength(picture, figure),
        back: theme.back.linear(),
        mapped,
        light: view.light,
        depth_of_radius: single(view.depth_of_radius()),
        up: view.up,
        depth_of_pixel: view.depth / finer,
        size: [picture.width, picture.height].map(|side| (side * factor) as f32),
        grid: GRID / finer,
        edge_on: single(EDGE_ON),
        steep: single(STEEP),
        unused: [0.0; 3],
        styles: LineKind::ALL.map(|kind| line_style(shot, kind)),
    }
}

/// Widths in pixels of the finer picture; dashes are as long as so many pixels are at the middle of the sheet.
fn line_style(shot: &Shot<'_>, kind: LineKind) -> Style {
    let Shot { picture, figure, view, factor } = *shot;
    let (style, scale) = (style(picture, figure, kind), picture.line_scale());
    let dash = style.dash.map_or([0.0; 3], |dash| [dash.on, dash.off, dash.dot]);
    let [on, off, dot] = dash.map(|length| length * view.pixel * scale);
    let sensible = on > 0.0 && off > 0.0 && dot >= 0.0 && (on + off).is_finite();
    Style {
        colour: style.colour.linear(),
        half_width: 0.5 * style.width * scale * factor as f32,
        on: if sensible { on } else { 0.0 },
        off,
        dot_length: dot.min(off),
        bias: single(bias(kind) * view.depth_of_radius()),
    }
}

fn triangles(figure: &Figure, view: &View) -> Vec<Triangle> {
    let triangle = |(i, nodes): (usize, &[u32; 3])| {
        let [start, parts] = figure.openness.lattices.get(i).copied().unwrap_or_default();
        let lifts = figure.layers.get(i).map_or([0.0; 3], |layer| lift(layer, view).map(single));
        Triangle { nodes: *nodes, start, lifts, parts }
    };
    figure.triangles.iter().enumerate().map(triangle).collect()
}

/// Lines that the picture shows, those first that others may cover.
fn lines(picture: &Picture, figure: &Figure) -> Vec<Line> {
    let mut lines = Vec::new();
    for kind in ORDER {
        let half = 0.5 * style(picture, figure, kind).width * picture.line_scale();
        if !(picture.edges.has(kind) && half > 0.0 && half < 1e4) {
            continue;
        }
        lines.extend(figure.lines.iter().filter(|line| line.kind == kind).map(|line| Line {
            nodes: line.nodes,
            triangles: line.triangles.map(|t| t.unwrap_or(NONE)),
            along: line.along,
            kind: kind as u32,
            unused: 0,
        }));
    }
    lines
}

/// Shares of the colour map, and the map.
fn map(figure: &Figure) -> (Vec<f32>, Vec<[f32; 4]>) {
    let Some(map) = &figure.map else { return (Vec::new(), vec![[0.0; 4]; 256]) };
    let (Values::Nodes(values) | Values::Triangles(values)) = &map.values;
    let shares = values.iter().map(|value| map.scale.share(*value)).collect();
    let table = map.scale.colours.table().into_iter().map(|[r, g, b]| [r, g, b, 1.0]);
    (shares, table.collect())
}

#[expect(clippy::cast_possible_truncation, reason = "to the nearest")]
fn single(x: f64) -> f32 {
    x as f32
}
