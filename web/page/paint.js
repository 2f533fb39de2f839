// The shaders. What they draw are nodes of the sheet, by their numbers; but wide lines, which have both of their ends at each corner.

const SPACE = `#version 300 es
precision highp float;
uniform mat4 matrix;
`;
const NODE = SPACE + "layout(location = 0) in vec4 node;\n";

const FACES = [NODE + `
uniform float largest;
uniform float behind;
out vec3 place;
out float value;
void main() {
    place = node.xyz;
    value = node.w / largest;
    gl_Position = matrix * vec4(node.xyz, 1);
    gl_Position.z += behind * gl_Position.w;
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

const PLAIN = `#version 300 es
precision highp float;
uniform vec4 paint;
out vec4 colour;
void main() { colour = paint; }`;

const LINES = [SPACE + `
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
uniform vec2 screen;
uniform float width;
uniform float ahead;
void main() {
    vec4 a = matrix * vec4(from, 1), b = matrix * vec4(to, 1);
    vec2 way = (b.xy / b.w - a.xy / a.w) * screen;
    way = dot(way, way) > 0.0 ? normalize(way) : vec2(0);
    // Two triangles make a line as wide as it should be.
    vec4 own = (gl_VertexID & 1) == 0 ? a : b;
    float side = (gl_VertexID & 2) == 0 ? 1.0 : -1.0;
    own.xy += vec2(-way.y, way.x) * side * width / screen * own.w;
    own.z -= ahead * own.w;
    gl_Position = own;
}`, PLAIN];

/** Lines as thin as the screen can, for so many of them that wide ones would take long. */
const HAIRS = [NODE + `
uniform float ahead;
void main() {
    gl_Position = matrix * vec4(node.xyz, 1);
    gl_Position.z -= ahead * gl_Position.w;
}`, PLAIN];

const DOTS = [NODE + `
uniform float width;
uniform float ahead;
void main() {
    gl_Position = matrix * vec4(node.xyz, 1);
    gl_Position.z -= ahead * gl_Position.w;
    gl_PointSize = width;
}`, `#version 300 es
precision highp float;
uniform vec4 paint;
uniform bool ring;
out vec4 colour;
void main() {
    float r = length(gl_PointCoord - 0.5) * 2.0;
    if (r > 1.0 || (ring && r < 0.66)) discard;
    colour = r > 0.72 && !ring ? vec4(1) : paint;
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
    return { made, places };
}

export const programs = (gl) => ({ faces: program(gl, FACES), lines: program(gl, LINES), hairs: program(gl, HAIRS), dots: program(gl, DOTS) });
