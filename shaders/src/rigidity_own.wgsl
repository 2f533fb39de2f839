// Beams with a rigidity of their own; 0 stands for the material's.

@group(0) @binding(9) var<storage, read> rigidities: array<f32>;

// k = EA / l0 (paper 2.2) of side `side` of face `f`.
fn side_stiffness(instance: u32, f: u32, side: u32, rest: f32) -> f32 {
    let own = rigidities[3u * f + side];
    return rigidity_now(instance, select(ea(instance), own, own > 0.0)) / rest;
}
