// The lowest and the highest node. `PositionsBuffer` says how nodes lie in their buffer.
struct Node { high: vec3<i32>, held: u32, low: vec3<f32>, mass: f32, others: array<vec4<f32>, 2> }

@group(0) @binding(0) var<storage, read> nodes: array<Node>;
@group(0) @binding(1) var<storage, read_write> heights: array<f32, 2>;

@compute @workgroup_size(1)
fn find_heights() {
    var lowest = 1e9;
    var highest = -1e9;
    for (var i = 0u; i < arrayLength(&nodes); i++) {
        let position = vec3<f32>(nodes[i].high) / 4096.0 + nodes[i].low;
        lowest = min(lowest, position.z);
        highest = max(highest, position.z);
    }
    heights = array<f32, 2>(lowest, highest);
}
