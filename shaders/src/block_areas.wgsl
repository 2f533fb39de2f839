// Areas at rest, in a block.

fn doubled_area_at_rest(f: u32, own: Face, rest: vec3<f32>) -> f32 {
    return bitcast<f32>(word(block.at_faces + 3u * f + 2u));
}
