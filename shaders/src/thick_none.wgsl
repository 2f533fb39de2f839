// Paper without a thickness.

fn closed_at(pair: Pair) -> f32 {
    return 0.0;
}
