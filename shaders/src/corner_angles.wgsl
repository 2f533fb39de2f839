// Corner angles (paper 2.4) of one triangle.

// The angle at a corner less that at rest, by turning its cosine and sine back. Any numbers in their proportion will do.
fn deviation(cosine: f32, sine: f32, doubled_area: f32, along: f32) -> f32 {
    return angle_of(doubled_area * cosine - along * sine, along * cosine + doubled_area * sine);
}

// The three deviations; `dots` are the products of the two sides at each corner.
fn deviations(f: u32, doubled_area: f32, dots: vec3<f32>) -> vec3<f32> {
    let rest = rest_corners(f);
    let first = deviation(rest.x, rest.y, doubled_area, dots.x);
    let second = deviation(rest.z, rest.w, doubled_area, dots.y);
    return vec3<f32>(first, second, -(first + second));
}

// For each side, how strongly the two corners on it pull along `normal x side`.
fn corner_pulls(instance: u32, f: u32, doubled_area: f32, squares: vec3<f32>, dots: vec3<f32>) -> vec3<f32> {
    if (doubled_area == 0.0) {
        return vec3<f32>(0.0);
    }
    let moments = -corner_share(instance) * k_face(instance) * deviations(f, doubled_area, dots);
    return (moments - moments.yzx) / (doubled_area * squares);
}

fn has_corners(f: u32) -> bool {
    let rest = rest_corners(f);
    return rest.x != 0.0 || rest.y != 0.0;
}
