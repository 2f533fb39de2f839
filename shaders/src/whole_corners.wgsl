// Where the passes over all triangles find their corner angles at rest.

// Cosine and sine of the first two angles at rest; zeros where the triangle is too thin to have springs.
@group(0) @binding(7) var<storage, read> corners: array<vec4<f32>>;

fn rest_corners(f: u32) -> vec4<f32> {
    return corners[f];
}
