// Creases that have their stiffness and no more.

fn more_stiffness(instance: u32, c: u32) -> f32 {
    return 0.0;
}
