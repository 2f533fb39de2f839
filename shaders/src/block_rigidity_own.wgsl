// Beams with a rigidity of their own, in a block; 0 stands for the material's.

// k = EA / l0 (paper 2.2) of side `side` of face `f`.
fn side_stiffness(instance: u32, f: u32, side: u32, rest: f32) -> f32 {
    let packed = word(block.at_faces + 3u * f + 1u);
    let own = bitcast<f32>(word(block.at_rigidities + ((packed >> (10u * side)) & 0x3ffu)));
    return rigidity_now(instance, select(ea(instance), own, own > 0.0)) / rest;
}
