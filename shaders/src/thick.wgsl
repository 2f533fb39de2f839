// Paper with a thickness: the distance at which a pair is closed.

fn closed_at(pair: Pair) -> f32 {
    return pair.closed;
}
