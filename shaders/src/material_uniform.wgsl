// One material for all instances: constants of the pipeline.

override EA: f32;
override K_FOLD: f32;
override K_FACET: f32;
override K_FACE: f32;
override ZETA: f32;

fn ea(instance: u32) -> f32 {
    return EA;
}

fn k_fold(instance: u32) -> f32 {
    return K_FOLD;
}

fn k_facet(instance: u32) -> f32 {
    return K_FACET;
}

fn k_face(instance: u32) -> f32 {
    return K_FACE;
}

fn zeta(instance: u32) -> f32 {
    return ZETA;
}
