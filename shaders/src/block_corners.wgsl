// Corner angles at rest, from the squares of the sides: their cosines and sines in proportion.

fn rest_corners(f: u32) -> vec4<f32> {
    let w = word(block.at_faces + 3u * f);
    if ((w & 0x40000000u) == 0u) {
        return vec4<f32>(0.0);
    }
    let packed = word(block.at_faces + 3u * f + 1u);
    let area = bitcast<f32>(word(block.at_faces + 3u * f + 2u));
    let sides = vec3<u32>(packed, packed >> 10u, packed >> 20u) & vec3<u32>(0x3ffu);
    let high = vec3<i32>(rest_high_of(sides.x), rest_high_of(sides.y), rest_high_of(sides.z));
    let low = vec3<f32>(rest_low_of(sides.x), rest_low_of(sides.y), rest_low_of(sides.z));
    // The product of the two sides at a corner is half of what their squares exceed that of the third by.
    let first = f32(high.x + high.z - high.y) * (QUANTUM * QUANTUM) + (low.x + low.z - low.y);
    let second = f32(high.x + high.y - high.z) * (QUANTUM * QUANTUM) + (low.x + low.y - low.z);
    return vec4<f32>(0.5 * first, area, 0.5 * second, area);
}
