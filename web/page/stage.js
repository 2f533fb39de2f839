// The sheet in space, by WebGL 2.

import { Camera } from "./camera.js";
import { lineOf, ramp, theme } from "./colours.js";
import { programs } from "./paint.js";

/** Kinds of lines, in the order of the shader's colours. */
const KINDS = ["line-b", "line-m", "line-v", "line-f", "line-u"];
const [HOVER, SELECTED, WARNED] = [5, 6, 7];
const WIDTH = 1024;
/** Corners that are drawn of each. */
const CORNERS = { faces: 1, lines: 6, hairs: 1, dots: 1 };
/** A sheet that has not changed for so many milliseconds stands still. */
const CALM = 250;
/** From so many edges on they are hairs. */
const DENSE = 4000;

/** Whether the processor draws: then four samples for each pixel take three times as long as one. */
function isSoftware() {
    const gl = document.createElement("canvas").getContext("webgl2");
    const named = gl?.getExtension("WEBGL_debug_renderer_info");
    const name = named ? gl.getParameter(named.UNMASKED_RENDERER_WEBGL) : gl?.getParameter(gl.RENDERER);
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ?? "");
}

export class Stage {
    constructor(canvas) {
        this.canvas = canvas;
        this.camera = new Camera();
        this.shown = { faces: true, B: true, M: true, V: true, F: true, U: true, marks: true };
        this.map = { wish: "none", largest: 1 };
        this.hover = {};
        this.selected = new Set();
        this.dirty = true;
        this.begin();
        canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
        canvas.addEventListener("webglcontextrestored", () => {
            this.faces = this.lines = this.crossed = undefined;
            this.begin();
            if (this.model) this.open(this.model);
        });
    }

    begin() {
        this.software ??= isSoftware();
        const gl = (this.gl = this.canvas.getContext("webgl2", { antialias: !this.software, alpha: false }));
        if (!gl) throw new Error("This browser has no WebGL 2, which the picture of the sheet needs.");
        this.programs = programs(gl);
        this.texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        for (const [name, value] of [["MIN_FILTER", "NEAREST"], ["MAG_FILTER", "NEAREST"], ["WRAP_S", "CLAMP_TO_EDGE"], ["WRAP_T", "CLAMP_TO_EDGE"]])
            gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
        this.restyle();
    }

    /** The theme has changed. */
    restyle() {
        this.theme = theme();
        this.dirty = true;
    }

    /** Another pattern. */
    open(model) {
        const gl = this.gl;
        this.model = model;
        this.rows = Math.ceil(model.nodes / WIDTH);
        this.texels = new Float32Array(4 * WIDTH * this.rows);
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, WIDTH, this.rows, 0, gl.RGBA, gl.FLOAT, null);
        [this.faces, this.lines, this.crossed].forEach((arrays) => this.drop(arrays));
        this.crossed = undefined;
        this.faces = this.arrays("faces", [["corner", model.corners, 1]]);
        const kinds = Uint32Array.from(model.letters, (letter) => KINDS.indexOf(lineOf(letter)));
        this.hairs = model.edges > DENSE;
        this.lines = this.hairs
            ? this.arrays("hairs", [["dot", model.ends, 1], ["kind", Uint32Array.from(model.ends, (_, i) => kinds[i >> 1]), 1]])
            : this.arrays("lines", [["ends", model.ends, 2], ["kind", kinds, 1]]);
        this.selected.clear();
        this.hover = {};
        this.warned = { nodes: [], edges: [] };
        this.pins = [];
        this.moved(model.points);
    }

    /** Attributes of each triangle, line or dot, written once for each of its corners: some drivers take long for many instances. */
    arrays(name, attributes, usage = this.gl.STATIC_DRAW) {
        const gl = this.gl;
        const array = gl.createVertexArray();
        gl.bindVertexArray(array);
        const buffers = attributes.map(([attribute, numbers, size]) => {
            const corners = CORNERS[name];
            const copies = new Uint32Array(numbers.length * corners);
            for (let i = 0; i < numbers.length; i += size)
                for (let corner = 0; corner < corners; corner++)
                    for (let k = 0; k < size; k++) copies[i * corners + corner * size + k] = numbers[i + k];
            const buffer = gl.createBuffer();
            gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
            gl.bufferData(gl.ARRAY_BUFFER, copies, usage);
            const at = this.programs[name].attribute(attribute);
            gl.enableVertexAttribArray(at);
            gl.vertexAttribIPointer(at, size, gl.UNSIGNED_INT, 0, 0);
            return buffer;
        });
        gl.bindVertexArray(null);
        return { array, buffers, count: (CORNERS[name] * attributes[0][1].length) / attributes[0][2] };
    }

    /** Draws what was made by `arrays`. */
    put({ array, count }, kind = this.gl.TRIANGLES) {
        this.gl.bindVertexArray(array);
        this.gl.drawArrays(kind, 0, count);
        this.gl.bindVertexArray(null);
    }

    drop(arrays) {
        if (!arrays) return;
        this.gl.deleteVertexArray(arrays.array);
        arrays.buffers.forEach((buffer) => this.gl.deleteBuffer(buffer));
    }

    /** Where the nodes are now: x, y, z and a value of each. */
    moved(points) {
        const gl = this.gl;
        this.model.points = points;
        this.texels.set(points);
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, WIDTH, this.rows, gl.RGBA, gl.FLOAT, this.texels);
        this.dirty = true;
    }

    /** Shows faces that cross. */
    cross(faces) {
        if (!faces.size && !this.crossed) return;
        this.drop(this.crossed);
        const { corners } = this.model;
        const own = [...this.model.faces.keys()].filter((triangle) => faces.has(this.model.faces[triangle]));
        const picked = Uint32Array.from(own.flatMap((triangle) => [...corners.subarray(3 * triangle, 3 * triangle + 3)]));
        this.crossed = picked.length ? this.arrays("faces", [["corner", picked, 1]]) : undefined;
        this.dirty = true;
    }

    /** Fits the canvas to the page. Where the processor draws, what moves is drawn coarser if there is much of it, and what stands finer. */
    fit() {
        const finer = !this.software ? 1 : this.fine ? 2 : this.hairs ? 0.75 : 1;
        const ratio = Math.min(devicePixelRatio || 1, 2) * finer;
        const { clientWidth, clientHeight } = this.canvas;
        const [width, height] = [clientWidth, clientHeight].map((x) => Math.max(1, Math.round(x * ratio)));
        if (this.canvas.width !== width || this.canvas.height !== height) {
            Object.assign(this.canvas, { width, height });
            this.dirty = true;
        }
        Object.assign(this.camera, { width: Math.max(1, clientWidth), height: Math.max(1, clientHeight) });
        this.ratio = ratio;
    }

    /** Draws, where something has changed. */
    draw() {
        const now = performance.now();
        if (this.dirty) Object.assign(this, { fine: false, changed: now });
        else if (this.software && !this.fine && now - this.changed > CALM) this.fine = true;
        this.fit();
        if (!this.dirty || !this.model) return false;
        this.dirty = false;
        const { gl, theme, camera, canvas } = this;
        const matrix = camera.matrix();
        gl.viewport(0, 0, canvas.width, canvas.height);
        gl.clearColor(...theme.ground, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        const use = (name) => {
            const { made, places } = this.programs[name];
            gl.useProgram(made);
            gl.uniformMatrix4fv(places.matrix, false, matrix);
            gl.uniform1i(places.nodes, 0);
            gl.uniform2f(places.screen, canvas.width, canvas.height);
            return places;
        };
        if (this.shown.faces) {
            const places = use("faces");
            const { right, up, back } = camera.axes();
            const light = right.map((x, i) => -0.35 * x + 0.55 * up[i] + 0.76 * back[i]);
            gl.uniform3fv(places.front, theme.front);
            gl.uniform3fv(places.back, theme.back);
            gl.uniform3fv(places.light, light);
            gl.uniform3fv(places.ramp, ramp());
            gl.uniform1f(places.largest, this.map.largest || 1);
            gl.uniform1i(places.mapped, this.map.wish !== "none" ? 1 : 0);
            gl.enable(gl.POLYGON_OFFSET_FILL);
            gl.polygonOffset(1, 1);
            this.put(this.faces);
            gl.disable(gl.POLYGON_OFFSET_FILL);
            if (this.crossed) {
                gl.uniform3fv(places.front, theme.warn);
                gl.uniform3fv(places.back, theme.warn.map((x) => 0.75 * x));
                gl.uniform1i(places.mapped, 0);
                this.put(this.crossed);
            }
        }
        const shown = ["B", "M", "V", "F", "U"].map((letter) => (this.shown[letter] ? 1 : 0));
        const colours = KINDS.flatMap((kind, i) => [...theme[kind], shown[i]]);
        const mark = [theme.accent, theme.accent, theme.warn].flatMap((colour) => [...colour, 1]);
        const pen = (name) => {
            const places = use(name);
            gl.uniform4fv(places.colours, [...colours, ...mark]);
            gl.uniform1f(places.nearer, 1e-4);
            if (places.widths) gl.uniform1fv(places.widths, [1.3, 1.2, 1.2, 0.7, 0.9, 3.2, 2.6, 2.6].map((w) => w * this.ratio));
        };
        if (this.hairs) {
            pen("hairs");
            this.put(this.lines, gl.LINES);
        }
        pen("lines");
        if (!this.hairs) this.put(this.lines);
        this.drawMarks(use);
        return true;
    }

    /** What the hand is at, what was chosen, what is odd. */
    drawMarks(use) {
        const { gl, model, theme } = this;
        const marks = this.shown.marks ? this.warned : { nodes: [], edges: [] };
        const lines = [...marks.edges.map((e) => [e, WARNED]), ...[...this.selected].map((e) => [e, SELECTED])];
        if (this.hover.edge !== undefined) lines.push([this.hover.edge, HOVER]);
        if (lines.length) {
            const places = this.programs.lines.places;
            gl.uniform1f(places.nearer, 4e-4);
            const ends = Uint32Array.from(lines.flatMap(([e]) => [model.ends[2 * e], model.ends[2 * e + 1]]));
            this.once("lines", [["ends", ends, 2], ["kind", Uint32Array.from(lines, ([, kind]) => kind), 1]]);
        }
        const dots = [...marks.nodes.map((n) => [n, 2]), ...this.pins.map((n) => [n, 1])];
        if (this.hover.node !== undefined) dots.push([this.hover.node, 0]);
        if (dots.length) {
            const places = use("dots");
            const colours = [theme.accent, theme.pin, theme.warn].flatMap((colour) => [...colour, 1]);
            gl.uniform4fv(places.colours, [...colours, ...new Array(20).fill(0)]);
            gl.uniform1fv(places.widths, [13, 12, 17, 0, 0, 0, 0, 0].map((w) => w * this.ratio));
            this.once("dots", [["dot", Uint32Array.from(dots, ([n]) => n), 1], ["kind", Uint32Array.from(dots, ([, kind]) => kind), 1]], gl.POINTS);
        }
    }

    /** Draws arrays that are made for this picture alone. */
    once(name, attributes, kind) {
        const arrays = this.arrays(name, attributes, this.gl.STREAM_DRAW);
        this.put(arrays, kind);
        this.drop(arrays);
    }

    /** The node within so many pixels of a place on the screen that is nearest to the eye. */
    nodeAt(x, y, within) {
        const { model, camera } = this;
        const matrix = camera.matrix();
        const at = [0, 0, 0];
        let best;
        for (let node = 0; node < model.nodes; node++) {
            const [px, py, depth] = camera.project(matrix, model.points, node, at);
            const far = Math.hypot(px - x, py - y);
            if (far <= within && (!best || far + depth * 8 < best.score)) best = { node, score: far + depth * 8 };
        }
        return best?.node;
    }

    /** The edge there, of those that are shown and `may` be taken. */
    edgeAt(x, y, within, may) {
        const { model, camera } = this;
        const matrix = camera.matrix();
        const [a, b] = [[0, 0, 0], [0, 0, 0]];
        let best;
        for (let edge = 0; edge < model.edges; edge++) {
            if (!may(edge)) continue;
            camera.project(matrix, model.points, model.ends[2 * edge], a);
            camera.project(matrix, model.points, model.ends[2 * edge + 1], b);
            const [wx, wy] = [b[0] - a[0], b[1] - a[1]];
            const share = Math.max(0, Math.min(1, ((x - a[0]) * wx + (y - a[1]) * wy) / (wx * wx + wy * wy || 1)));
            const far = Math.hypot(a[0] + share * wx - x, a[1] + share * wy - y);
            const depth = a[2] + share * (b[2] - a[2]);
            if (far <= within && (!best || far + depth * 8 < best.score)) best = { edge, score: far + depth * 8 };
        }
        return best?.edge;
    }

    /** The picture as PNG. */
    png() {
        this.dirty = true;
        this.draw();
        this.changed = -Infinity;
        this.draw();
        return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
    }
}
