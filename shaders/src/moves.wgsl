// What a node under contact is about to do.

struct Move {
    // The move that FIRE would make.
    by: vec3<f32>,
    // The row sum of its springs.
    springs: f32,
}

@group(0) @binding(33) var<storage, read_write> moves: array<Move>;
