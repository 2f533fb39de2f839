// The energy of a gap: nothing from a width on, and without bound towards 0 (Li et al., Incremental Potential Contact, ACM
// Trans. Graph. 39, 2020). As `barrier.rs` of the core.

override CONTACT_STIFFNESS: f32;

struct Barrier {
    energy: f32,
    // By the gap; not above 0.
    slope: f32,
    // The second derivative; not below 0.
    curvature: f32,
}

// Of a gap above 0.
fn barrier(gap: f32, width: f32) -> Barrier {
    if (gap >= width) {
        return Barrier(0.0, 0.0, 0.0);
    }
    let less = gap - width;
    let logarithm = log(gap / width);
    let ratio = less / gap;
    return Barrier(
        -CONTACT_STIFFNESS * less * less * logarithm,
        -CONTACT_STIFFNESS * less * (2.0 * logarithm + ratio),
        -CONTACT_STIFFNESS * (2.0 * logarithm + 4.0 * ratio - ratio * ratio),
    );
}

// A factor from 0 to 1 for edges that are nearly parallel, where their nearest points jump.
struct Eased {
    factor: f32,
    // Its gradient by the end of either edge; by the start it is the opposite.
    by_first: vec3<f32>,
    by_second: vec3<f32>,
}

// Of the edges u and v with the cross product `normal`; `least` is the square of that from which it is 1.
fn mollifier(u: vec3<f32>, v: vec3<f32>, normal: vec3<f32>, least: f32) -> Eased {
    let x = dot(normal, normal) / least;
    if (x >= 1.0) {
        return Eased(1.0, vec3<f32>(0.0), vec3<f32>(0.0));
    }
    let slope = 2.0 * (2.0 - 2.0 * x) / least;
    return Eased((2.0 - x) * x, slope * cross(v, normal), slope * cross(normal, u));
}
