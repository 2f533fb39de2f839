// From light to the picture's bytes: averages squares of the finer picture, lays them on the ground, converts to sRGB.

struct Resolve {
    // Linear light of the ground.
    ground: vec3<f32>,
    // Pixels a side of a square.
    factor: u32,
    // The tile, in pixels of the picture.
    size: vec2<u32>,
    // What a pixel is on which nothing lies: red in the lowest byte, alpha in the highest; transparent if alpha is 0.
    bare: u32,
    unused: u32,
}

// Premultiplied: samples on which nothing lies are zero.
@group(0) @binding(0) var fine: texture_2d<f32>;
@group(0) @binding(1) var<uniform> settings: Resolve;
@group(0) @binding(2) var<storage, read_write> pixels: array<u32>;

// IEC 61966-2-1, from light to a channel's value.
fn to_srgb(light: vec3<f32>) -> vec3<f32> {
    let l = clamp(light, vec3<f32>(0.0), vec3<f32>(1.0));
    let curve = 1.055 * pow(max(l, vec3<f32>(1e-6)), vec3<f32>(1.0 / 2.4)) - 0.055;
    return select(curve, 12.92 * l, l <= vec3<f32>(0.0031308));
}

fn packed(light: vec3<f32>, alpha: f32) -> u32 {
    let bytes = vec4<u32>(vec4<f32>(to_srgb(light), alpha) * 255.0 + 0.5);
    return bytes.x | (bytes.y << 8u) | (bytes.z << 16u) | (bytes.w << 24u);
}

@compute @workgroup_size(8, 8)
fn resolve(@builtin(global_invocation_id) id: vec3<u32>) {
    if (id.x >= settings.size.x || id.y >= settings.size.y) {
        return;
    }
    var sum = vec4<f32>();
    for (var y = 0u; y < settings.factor; y += 1u) {
        for (var x = 0u; x < settings.factor; x += 1u) {
            sum += textureLoad(fine, id.xy * settings.factor + vec2<u32>(x, y), 0);
        }
    }
    let mean = sum / f32(settings.factor * settings.factor);
    var pixel = settings.bare;
    if (mean.w > 0.0) {
        if ((settings.bare >> 24u) == 0u) {
            pixel = packed(mean.xyz / mean.w, mean.w);
        } else {
            pixel = packed(mean.xyz + settings.ground * (1.0 - mean.w), 1.0);
        }
    }
    pixels[id.y * settings.size.x + id.x] = pixel;
}
