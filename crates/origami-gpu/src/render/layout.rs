//! The structs that lie in buffers, as `shaders/src/render` declares them. A test compares every offset with the shaders'.

use bytemuck::{Pod, Zeroable};

/// The index that stands for no triangle.
pub(super) const NONE: u32 = u32::MAX;
/// What the values of a map are of.
pub(super) const NODES: u32 = 1;
pub(super) const TRIANGLES: u32 = 2;

/// How lines of one kind are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Style {
    pub(super) colour: [f32; 3],
    pub(super) half_width: f32,
    pub(super) on: f32,
    pub(super) off: f32,
    pub(super) dot_length: f32,
    pub(super) bias: f32,
}

/// What is the same for the whole picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Frame {
    pub(super) matrix: [[f32; 4]; 4],
    pub(super) front: [f32; 3],
    pub(super) shading: f32,
    pub(super) back: [f32; 3],
    pub(super) mapped: u32,
    pub(super) light: [f32; 3],
    pub(super) depth_of_radius: f32,
    pub(super) up: [f32; 3],
    pub(super) depth_of_pixel: f32,
    pub(super) size: [f32; 2],
    pub(super) grid: f32,
    pub(super) edge_on: f32,
    pub(super) steep: f32,
    pub(super) unused: [f32; 3],
    pub(super) styles: [Style; 6],
}

/// A part of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Tile {
    pub(super) origin: [f32; 2],
    pub(super) size: [f32; 2],
}

/// A triangle as shaders read it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Triangle {
    pub(super) nodes: [u32; 3],
    pub(super) start: u32,
    pub(super) lifts: [f32; 3],
    pub(super) parts: u32,
}

/// A line as shaders read it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Line {
    pub(super) nodes: [u32; 2],
    pub(super) triangles: [u32; 2],
    pub(super) along: [f32; 2],
    pub(super) kind: u32,
    pub(super) unused: u32,
}

/// What the averaging of samples needs to know: from light to bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Resolve {
    pub(super) ground: [f32; 3],
    pub(super) factor: u32,
    pub(super) size: [u32; 2],
    pub(super) bare: u32,
    pub(super) unused: u32,
}

/// What extremes are looked for among.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Search {
    pub(super) count: u32,
}
