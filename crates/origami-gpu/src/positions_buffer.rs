//! Where the positions of a simulation lie on the device, for whoever draws from there.

use std::mem::offset_of;

use crate::layout::{Node, QUANTUM};

/// A buffer with the positions of a simulation's nodes, to be read by shaders of one's own on the same device: as a storage
/// buffer, or vertex by vertex with the formats `Sint32x3` at [`high`](Self::high) and `Float32x3` at [`low`](Self::low).
///
/// Node `i` is at `high * quantum + low`, in radii of the sheet about its centre: the two parts keep more digits than an f32
/// has. In WGSL:
///
/// ```wgsl
/// struct Node { high: vec3<i32>, held: u32, low: vec3<f32>, mass: f32, others: array<vec4<f32>, 2> }
/// @group(0) @binding(0) var<storage, read> nodes: array<Node>;
///
/// fn position(i: u32) -> vec3<f32> {
///     return vec3<f32>(nodes[i].high) * 0.000244140625 + nodes[i].low;
/// }
/// ```
///
/// It is to be read, not written. When a call that takes steps returns, they are done; what is submitted after it reads the
/// state that it left, and what is submitted later changes it.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct PositionsBuffer<'a> {
    /// The buffer. Its usages are `STORAGE`, `VERTEX`, `COPY_SRC` and `COPY_DST`.
    pub buffer: &'a wgpu::Buffer,
    /// How many nodes there are, in the order of the model's.
    pub nodes: usize,
    /// Bytes from one node to the next.
    pub stride: u64,
    /// The byte of a node at which its three integers begin.
    pub high: u64,
    /// The byte at which its three f32 begin.
    pub low: u64,
    /// The length of one unit of the integers, in radii: 2^-12.
    pub quantum: f64,
}

impl<'a> PositionsBuffer<'a> {
    pub(crate) fn of(buffer: &'a wgpu::Buffer, nodes: usize) -> Self {
        let [stride, high, low] = [size_of::<Node>(), offset_of!(Node, high), offset_of!(Node, low)].map(|n| n as u64);
        Self { buffer, nodes, stride, high, low, quantum: QUANTUM }
    }
}
