// Fold angles in blocks: each block has copies of its own.

@group(0) @binding(26) var<storage, read_write> angles: array<f32>;

fn angle_of_crease(crease: u32) -> f32 {
    return angles[crease];
}
