// What a crease on the wrong side adds to its stiffness, in units of it.

fn more_stiffness(instance: u32, c: u32) -> f32 {
    return wrong_side(instance, angle_before(instance, c), target_angle(instance, c, ramp_share(instance)));
}
