// Areas at rest, for the passes over all triangles: from the sides (Heron). What rounding could add is left off, so that
// nothing pulls at a thin triangle at rest.

fn doubled_area_at_rest(f: u32, own: Face, rest: vec3<f32>) -> f32 {
    let high = f32(own.rest_high[0] + own.rest_high[2] - own.rest_high[1]) * (QUANTUM * QUANTUM);
    let dot_at_rest = 0.5 * (high + (own.rest_low[0] + own.rest_low[2] - own.rest_low[1]));
    let product = rest.x * rest.z;
    let square = product * product * (1.0 - 1e-6) - dot_at_rest * dot_at_rest;
    return sqrt(max(square, 0.0));
}
