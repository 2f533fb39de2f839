// The shaders. Nodes lie in a texture, so that a picture of the sheet is one upload, whatever is drawn of it.

const NODES = `#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D nodes;
uniform mat4 matrix;
uniform vec2 screen;
vec4 node(uint i) { return texelFetch(nodes, ivec2(i & 1023u, i >> 10u), 0); }
`;

const FACES = [NODES + `
in uint corner;
uniform float largest;
out vec3 place;
out float value;
void main() {
    vec4 own = node(corner);
    place = own.xyz;
    value = own.w / largest;
    gl_Position = matrix * vec4(own.xyz, 1);
    // Faces that lie on each other keep one order, and do not flicker.
    gl_Position.z += 2e-5 * float(gl_VertexID / 3 & 31) / 31.0 * gl_Position.w;
}`, `#version 300 es
precision highp float;
in vec3 place;
in float value;
uniform vec3 front, back, light;
uniform vec3 ramp[9];
uniform bool mapped;
out vec4 colour;
void main() {
    vec3 paper = gl_FrontFacing ? front : back;
    if (mapped) {
        float at = clamp(value, 0.0, 1.0) * 8.0;
        int low = min(int(at), 7);
        paper = mix(ramp[low], ramp[low + 1], at - float(low));
    }
    // From how the place changes to the next pixels comes the side of the face that is seen.
    vec3 normal = cross(dFdx(place), dFdy(place));
    float n = length(normal);
    float facing = n > 0.0 ? dot(normal / n, light) : 0.5;
    float lit = 0.72 + 0.24 * max(facing, 0.0) + 0.08 * facing;
    colour = vec4(paper * (mapped ? 0.75 + 0.25 * lit : lit), 1);
}`];

const LINES = [NODES + `
in uvec2 ends;
in uint kind;
uniform vec4 colours[8];
uniform float widths[8];
uniform float nearer;
out vec4 paint;
void main() {
    vec4 a = matrix * vec4(node(ends.x).xyz, 1), b = matrix * vec4(node(ends.y).xyz, 1);
    vec2 way = (b.xy / b.w - a.xy / a.w) * screen;
    way = dot(way, way) > 0.0 ? normalize(way) : vec2(0);
    // Two triangles make a line as wide as it should be.
    int corner = int[](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
    vec4 own = (corner & 1) == 0 ? a : b;
    float side = corner < 2 ? 1.0 : -1.0;
    own.xy += vec2(-way.y, way.x) * side * widths[kind] / screen * own.w;
    own.z -= nearer * own.w;
    paint = colours[kind];
    gl_Position = paint.a > 0.0 && ends.x != ends.y ? own : vec4(2, 2, 2, 1);
}`, `#version 300 es
precision highp float;
in vec4 paint;
out vec4 colour;
void main() { colour = paint; }`];

/** Lines as thin as the screen can, for so many of them that wide ones would take long. */
const HAIRS = [NODES + `
in uint dot;
in uint kind;
uniform vec4 colours[8];
uniform float nearer;
out vec4 paint;
void main() {
    gl_Position = matrix * vec4(node(dot).xyz, 1);
    gl_Position.z -= nearer * gl_Position.w;
    paint = colours[kind];
    if (paint.a == 0.0) gl_Position = vec4(2, 2, 2, 1);
}`, LINES[1]];

const DOTS = [NODES + `
in uint dot;
in uint kind;
uniform vec4 colours[8];
uniform float widths[8];
out vec4 paint;
flat out float ring;
void main() {
    gl_Position = matrix * vec4(node(dot).xyz, 1);
    gl_Position.z -= 2e-3 * gl_Position.w;
    gl_PointSize = widths[kind];
    paint = colours[kind];
    ring = kind == 2u ? 1.0 : 0.0;
}`, `#version 300 es
precision highp float;
in vec4 paint;
flat in float ring;
out vec4 colour;
void main() {
    float r = length(gl_PointCoord - 0.5) * 2.0;
    if (r > 1.0 || (ring > 0.5 && r < 0.66)) discard;
    colour = r > 0.72 && ring < 0.5 ? vec4(1) : paint;
}`];

function program(gl, [vertex, fragment]) {
    const made = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
    }
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) {
        const logs = gl.getAttachedShaders(made).map((shader) => gl.getShaderInfoLog(shader));
        throw new Error(`WebGL: ${gl.getProgramInfoLog(made)} ${logs.join(" ")}`);
    }
    const places = {};
    for (let i = 0; i < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); i++) {
        const { name } = gl.getActiveUniform(made, i);
        places[name.replace("[0]", "")] = gl.getUniformLocation(made, name);
    }
    return { made, places, attribute: (name) => gl.getAttribLocation(made, name) };
}

export const programs = (gl) => ({ faces: program(gl, FACES), lines: program(gl, LINES), hairs: program(gl, HAIRS), dots: program(gl, DOTS) });
