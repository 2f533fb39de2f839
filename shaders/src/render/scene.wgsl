// What the sheet and its lines have in common: the scene, and where it is seen.
//
// All lengths in pixels are those of the finer picture that is averaged in the end. Depth is clip depth, z over w.

// Light, as the processor has it.
override AMBIENT: f32 = 0.0;
override KEY: f32 = 0.0;
override SKY: f32 = 0.0;
override SHADE: f32 = 0.0;

const NONE: u32 = 0xffffffffu;
// What values are of.
const NODES: u32 = 1u;
const TRIANGLES: u32 = 2u;

// How lines of one kind are drawn.
struct Style {
    // Linear light.
    colour: vec3<f32>,
    // Half the width in pixels.
    half_width: f32,
    // Dashes in radii on the flat sheet; drawn through where `on` is 0.
    on: f32,
    off: f32,
    dot_length: f32,
    // How much nearer than its faces it is drawn.
    bias: f32,
}

struct Frame {
    // From positions to clip space.
    matrix: mat4x4<f32>,
    // Linear light of both sides of the paper.
    front: vec3<f32>,
    shading: f32,
    back: vec3<f32>,
    // What values are of, or 0.
    mapped: u32,
    // Unit vectors.
    light: vec3<f32>,
    // How much depth changes over a radius, and over the length of a pixel, at the middle of the sheet.
    depth_of_radius: f32,
    up: vec3<f32>,
    depth_of_pixel: f32,
    // The whole picture, in pixels.
    size: vec2<f32>,
    // Corners of triangles lie on a grid with so many lines a pixel.
    grid: f32,
    // A face that falls away by more than this, in depth_of_pixel a pixel, is seen edge-on and says nothing about its line.
    edge_on: f32,
    // A steep face brings its line no nearer than this, in half widths of the line.
    steep: f32,
    unused: f32,
    // By kind of line.
    styles: array<Style, 6>,
}

// The part of the picture that is drawn: its upper left corner and its size, in pixels.
struct Tile {
    origin: vec2<f32>,
    size: vec2<f32>,
}

struct Triangle {
    nodes: vec3<u32>,
    // Where its values of openness begin.
    start: u32,
    // How much nearer each of its corners is drawn.
    lifts: vec3<f32>,
    // Into how many parts its sides are cut for these; 0: all is open.
    parts: u32,
}

struct Line {
    nodes: vec2<u32>,
    // The triangles beside it, or NONE.
    triangles: vec2<u32>,
    // How far along its chain each end lies, in radii.
    along: vec2<f32>,
    kind: u32,
    unused: u32,
}

@group(0) @binding(0) var<uniform> frame: Frame;
@group(0) @binding(1) var<uniform> tile: Tile;
// Of each node; w is not used.
@group(0) @binding(2) var<storage, read> positions: array<vec4<f32>>;
@group(0) @binding(3) var<storage, read> triangles: array<Triangle>;
@group(0) @binding(4) var<storage, read> lines: array<Line>;
// Shares of the colour map, by node or by triangle.
@group(0) @binding(5) var<storage, read> shares: array<f32>;
// The colour map as linear light.
@group(0) @binding(6) var<uniform> table: array<vec4<f32>, 256>;
// How much of the light from all around reaches the front and the back of each place.
@group(0) @binding(7) var<storage, read> openness: array<vec2<f32>>;

// A node in the picture.
struct Corner {
    // Pixels to the right and down, on the grid.
    place: vec2<f32>,
    depth: f32,
    w: f32,
}

fn corner(node: u32) -> Corner {
    let p = frame.matrix * vec4<f32>(positions[node].xyz, 1.0);
    let seen = p.xyz / p.w;
    let place = vec2<f32>(1.0 + seen.x, 1.0 - seen.y) * 0.5 * frame.size;
    return Corner(round(place * frame.grid) / frame.grid, seen.z, p.w);
}

fn behind_the_viewer(c: Corner) -> bool {
    return !(c.w > 1e-9);
}

// Room in depth before and behind what is expected: nothing is clipped there.
fn stored_depth(depth: f32) -> f32 {
    return 0.25 + 0.5 * depth;
}

// A place in the picture in the clip space of the tile.
fn in_tile(place: vec2<f32>, depth: f32, w: f32) -> vec4<f32> {
    let p = 2.0 * (place - tile.origin) / tile.size - 1.0;
    return vec4<f32>(p.x * w, -p.y * w, stored_depth(depth) * w, w);
}

// Outside of every picture.
fn nowhere() -> vec4<f32> {
    return vec4<f32>(0.0, 0.0, 2.0, 1.0);
}

// Twice the area of a triangle in the picture; with y down, one that is seen from its front has a negative one.
fn doubled_area(a: vec2<f32>, b: vec2<f32>, c: vec2<f32>) -> f32 {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

fn map_colour(share: f32) -> vec3<f32> {
    return table[u32(clamp(share, 0.0, 1.0) * 255.0 + 0.5)].xyz;
}
