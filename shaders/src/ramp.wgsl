// How far the target angles have come on the ramp, from 0 to 1.

fn ramp_share(instance: u32) -> f32 {
    let length = control[instance].ramp_length;
    if (length == 0u) {
        return 1.0;
    }
    return f32(control[instance].ramp_step) / f32(length);
}
