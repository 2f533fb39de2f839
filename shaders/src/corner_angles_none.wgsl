// A sheet without corner angles: k_face is 0.

fn corner_pulls(instance: u32, f: u32, doubled_area: f32, squares: vec3<f32>, dots: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(0.0);
}

fn has_corners(f: u32) -> bool {
    return false;
}
