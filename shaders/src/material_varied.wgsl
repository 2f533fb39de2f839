// Instances that differ in material: numbers from their control block.

fn ea(instance: u32) -> f32 {
    return control[instance].ea;
}

fn k_fold(instance: u32) -> f32 {
    return control[instance].k_fold;
}

fn k_facet(instance: u32) -> f32 {
    return control[instance].k_facet;
}

fn k_face(instance: u32) -> f32 {
    return control[instance].k_face;
}

fn zeta(instance: u32) -> f32 {
    return control[instance].zeta;
}
