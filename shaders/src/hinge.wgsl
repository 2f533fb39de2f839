// Creases as hinges (paper 2.3), and how stiff they are.

struct Hinge {
    apex_one: u32,
    apex_two: u32,
    end_one: u32,
    end_two: u32,
    // The rest length, or the stiffness itself where the crease has its own.
    length: f32,
    kind: u32,
}

const FOLD: u32 = 0u;
const FACET: u32 = 1u;

// k = l0 k_fold of mountains and valleys, l0 k_facet of flat creases.
fn crease_stiffness(instance: u32, h: Hinge) -> f32 {
    if (h.kind == FOLD) {
        return h.length * k_fold(instance);
    }
    if (h.kind == FACET) {
        return h.length * k_facet(instance);
    }
    return h.length;
}

// The vectors from the first end of a hinge, its normals as long as twice the areas, and the squares of their lengths.
struct HingeShape {
    along: vec3<f32>,
    to_one: vec3<f32>,
    to_two: vec3<f32>,
    normal_one: vec3<f32>,
    normal_two: vec3<f32>,
    along_squared: f32,
    squared_one: f32,
    squared_two: f32,
    // Whether a triangle is too thin for an angle to mean anything.
    degenerate: bool,
}

fn hinge_shape(instance: u32, h: Hinge) -> HingeShape {
    let end = position_at(instance, h.end_one);
    var s: HingeShape;
    let along = difference(end, position_at(instance, h.end_two));
    let to_one = difference(end, position_at(instance, h.apex_one));
    let to_two = difference(end, position_at(instance, h.apex_two));
    s.along = vector(along);
    s.to_one = vector(to_one);
    s.to_two = vector(to_two);
    s.normal_one = cross_product(along, to_one);
    s.normal_two = cross_product(to_two, along);
    s.along_squared = dot(s.along, s.along);
    s.squared_one = dot(s.normal_one, s.normal_one);
    s.squared_two = dot(s.normal_two, s.normal_two);
    let limit = DEGENERATE * DEGENERATE;
    let least = limit * s.along_squared;
    s.degenerate = s.along_squared < limit || s.squared_one < least || s.squared_two < least;
    return s;
}
