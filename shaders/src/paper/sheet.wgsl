// What the paper's five passes share: the sheet and its state. Positions are displacements from rest. It comes after
// control.wgsl; there is one instance.

struct Settings {
    time_step: f32,
}

// Ranges tell where the lists below speak of a node.
struct Node {
    rest: vec3<f32>,
    fixed_in_place: u32,
    beams: vec2<u32>,
    creases: vec2<u32>,
    corners: vec2<u32>,
}

struct Motion {
    displacement: vec3<f32>,
    velocity: vec3<f32>,
}

struct Triangle {
    nodes: array<u32, 3>,
    // At rest, from each corner to the next.
    sides: array<vec3<f32>, 3>,
    // Cosine and sine of the first two angles at rest.
    angles: vec4<f32>,
}

struct Crease {
    // Apexes 1 and 2, then ends 3 and 4.
    nodes: array<u32, 4>,
    // At rest, from end 3: to end 4, to either apex.
    along: vec3<f32>,
    triangle_one: u32,
    to_one: vec3<f32>,
    triangle_two: u32,
    to_two: vec3<f32>,
}

struct Spring {
    angle: f32,
    target_angle: f32,
    stiffness: f32,
    // One over the height of each apex over the crease, and where its foot lies between the ends.
    per_height: vec2<f32>,
    foot: vec2<f32>,
}

struct BeamEnd {
    // At rest, from the node to the other end.
    rest: vec3<f32>,
    rest_length: f32,
    other: u32,
    stiffness: f32,
    damping: f32,
}

// That a node is one of the four of a crease, or one of the three of a triangle.
struct Role {
    element: u32,
    // 0 to 3, or 0 to 2.
    place: u32,
    // Of a crease only.
    triangle_one: u32,
    triangle_two: u32,
}

@group(0) @binding(15) var<uniform> settings: Settings;
@group(0) @binding(16) var<storage, read> nodes: array<Node>;
@group(0) @binding(17) var<storage, read_write> motions: array<Motion>;
@group(0) @binding(18) var<storage, read_write> next_velocities: array<vec4<f32>>;
@group(0) @binding(19) var<storage, read> triangles: array<Triangle>;
// Unit normals; the last number is twice the area.
@group(0) @binding(20) var<storage, read_write> face_normals: array<vec4<f32>>;
@group(0) @binding(21) var<storage, read> creases: array<Crease>;
@group(0) @binding(22) var<storage, read_write> springs: array<Spring>;
@group(0) @binding(23) var<storage, read> beam_ends: array<BeamEnd>;
@group(0) @binding(24) var<storage, read> roles: array<Role>;

// From one node to another that lies `rest` away from it at rest.
fn difference(rest: vec3<f32>, start: u32, end: u32) -> vec3<f32> {
    return rest + (motions[end].displacement - motions[start].displacement);
}

// Whether a crease, or a height over it, is too short for an angle to mean anything.
fn too_thin(length: f32, doubled_area_one: f32, doubled_area_two: f32) -> bool {
    return length < DEGENERATE || min(doubled_area_one, doubled_area_two) < DEGENERATE * length;
}
