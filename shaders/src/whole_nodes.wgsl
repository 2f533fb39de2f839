// Where the passes over all elements find nodes: by their indices in the model.

fn position_at(instance: u32, n: u32) -> SplitVector {
    return position_of(instance * NODES + n);
}

fn velocity_at(instance: u32, n: u32) -> vec3<f32> {
    return nodes[instance * NODES + n].velocity;
}
