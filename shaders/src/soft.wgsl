// A sheet that is softer than its material while its target angles rise: `Softening` of the core.

// Whether it is on the way.
fn softens(instance: u32) -> bool {
    return control[instance].soft_ea > 0.0 && control[instance].ramp_step < control[instance].ramp_length;
}

// The axial rigidity of a beam at present.
fn rigidity_now(instance: u32, own: f32) -> f32 {
    return select(own, min(own, control[instance].soft_ea), softens(instance));
}

// The stiffness of corner angles at present, as a share of the material's.
fn corner_share(instance: u32) -> f32 {
    return select(1.0, control[instance].soft_corners, softens(instance));
}

// What pulls a crease back to flat that is folded to the other side than its target, in units of its stiffness.
fn wrong_side(instance: u32, angle: f32, target_now: f32) -> f32 {
    return select(0.0, control[instance].wrong_side, softens(instance) && angle * target_now < 0.0);
}
