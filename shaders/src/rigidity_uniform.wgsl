// All beams of one rigidity.

// k = EA / l0 (paper 2.2) of side `side` of face `f`.
fn side_stiffness(instance: u32, f: u32, side: u32, rest: f32) -> f32 {
    return rigidity_now(instance, ea(instance)) / rest;
}
