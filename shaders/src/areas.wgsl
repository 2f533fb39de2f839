// Areas of triangles, kept from collapse: the energy is k (1/r - 2 + r) where r, the area over THRESHOLD of that at rest, is
// below 1. With D twice the area and T twice the threshold, its slope by D is k (1/T - T/D^2), its curvature 2 k T/D^3.

override THRESHOLD: f32;

// How strongly its area pulls the corners of a triangle along the normal, times the side opposite to each; and the curvature.
fn area_spring(instance: u32, f: u32, own: Face, doubled_area: f32) -> vec2<f32> {
    let rest = vec3<f32>(
        rest_length(own.rest_high[0], own.rest_low[0]),
        rest_length(own.rest_high[1], own.rest_low[1]),
        rest_length(own.rest_high[2], own.rest_low[2]),
    );
    let threshold = THRESHOLD * doubled_area_at_rest(f, own, rest);
    // What has shrunk to nothing has no direction, and so no force.
    if (doubled_area == 0.0 || doubled_area >= threshold) {
        return vec2<f32>(0.0);
    }
    let stiffness = control[instance].k_area * (rest.x + rest.y + rest.z);
    let share = threshold / doubled_area;
    return vec2<f32>(
        stiffness * (share / doubled_area - 1.0 / threshold) / doubled_area,
        2.0 * stiffness * share / (doubled_area * doubled_area),
    );
}
