// Draws a sheet by WebGL 2.

import { Nodes, Strokes } from "./buffers.js";
import { ramp } from "./colours.js";
import { AHEAD, behind, DEPTHS } from "./depth.js";
import { programs } from "./paint.js";

/** Whether the processor draws. */
export function isSoftware() {
    const gl = document.createElement("canvas").getContext("webgl2");
    const named = gl?.getExtension("WEBGL_debug_renderer_info");
    const name = named ? gl.getParameter(named.UNMASKED_RENDERER_WEBGL) : gl?.getParameter(gl.RENDERER);
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name ?? "");
}

export class Painter {
    /** `again` is called where all must be drawn again. */
    constructor(canvas, antialias, again) {
        Object.assign(this, { canvas, antialias });
        this.begin();
        canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
        canvas.addEventListener("webglcontextrestored", () => {
            this.begin();
            if (this.opened) this.open(this.opened);
            if (this.points) this.moved(this.points);
            again();
        });
    }

    begin() {
        const gl = (this.gl = this.canvas.getContext("webgl2", { antialias: this.antialias, alpha: false }));
        if (!gl) throw new Error("This browser has no WebGL 2, which the picture of the sheet needs.");
        this.programs = programs(gl);
        this.nodes = this.faces = this.lines = undefined;
        gl.enable(gl.DEPTH_TEST);
        // Faces whose side is seen, too, are behind their lines.
        gl.polygonOffset(1, 1);
    }

    /** Another pattern: the ends of its lines by their kinds, the depth of each triangle, and whether lines are as thin as can be. */
    open(opened) {
        const { model, lines, depths, dense } = (this.opened = opened);
        for (const buffers of [this.nodes, this.faces, this.lines]) buffers?.drop();
        this.nodes = new Nodes(this.gl, model.nodes);
        const parts = Array.from({ length: DEPTHS }, () => []);
        depths.forEach((depth, triangle) => parts[depth].push(...model.corners.subarray(3 * triangle, 3 * triangle + 3)));
        this.faces = this.nodes.parts(parts);
        this.lines = dense ? this.nodes.parts(lines) : new Strokes(this.gl, lines);
    }

    /** Where the nodes are now. */
    moved(points) {
        this.points = points;
        this.nodes.write(points);
        if (!this.opened.dense) this.lines.write(points);
    }

    /** Draws what is to be seen, by so many pixels for each of the page. */
    draw(look, camera, ratio) {
        const { gl, canvas } = this;
        const [width, height] = [camera.width, camera.height].map((x) => Math.max(1, Math.round(x * ratio)));
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
        gl.viewport(0, 0, width, height);
        gl.clearColor(...look.ground, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        const matrix = camera.matrix();
        const use = (name) => {
            const { made, places } = this.programs[name];
            gl.useProgram(made);
            gl.uniformMatrix4fv(places.matrix, false, matrix);
            if (places.screen) gl.uniform2f(places.screen, width, height);
            return places;
        };
        if (look.faces) this.drawFaces(look, use("faces"));
        this.drawLines(look, use, ratio);
        this.drawDots(look.dots, use("dots"), ratio);
    }

    drawFaces({ light, largest, faces, crossed }, places) {
        const { gl } = this;
        const sides = ([front, back]) => {
            gl.uniform3fv(places.front, front);
            gl.uniform3fv(places.back, back);
        };
        sides(faces);
        gl.uniform3fv(places.light, light);
        gl.uniform3fv(places.ramp, ramp());
        gl.uniform1f(places.largest, largest ?? 1);
        gl.uniform1i(places.mapped, largest ? 1 : 0);
        gl.enable(gl.POLYGON_OFFSET_FILL);
        this.faces.draw(gl.TRIANGLES, (depth) => gl.uniform1f(places.behind, behind(depth)));
        if (crossed) {
            const parts = this.nodes.parts([crossed.corners]);
            sides(crossed.sides);
            gl.uniform1i(places.mapped, 0);
            gl.uniform1f(places.behind, behind(-1));
            parts.draw(gl.TRIANGLES, () => {});
            parts.drop();
        }
        gl.disable(gl.POLYGON_OFFSET_FILL);
    }

    drawLines({ lines, strokes }, use, ratio) {
        const { gl } = this;
        const pen = (places, line) => {
            if (!line) return false;
            gl.uniform4f(places.paint, ...line.colour, 1);
            if (places.width) gl.uniform1f(places.width, line.width * ratio);
        };
        const { dense } = this.opened;
        let places = use(dense ? "hairs" : "lines");
        gl.uniform1f(places.ahead, AHEAD.lines);
        this.lines.draw(gl[dense ? "LINES" : "TRIANGLES"], (kind) => pen(places, lines[kind]));
        if (!strokes.some(({ ends }) => ends.length)) return;
        places = use("lines");
        gl.uniform1f(places.ahead, AHEAD.marks);
        const marks = new Strokes(gl, strokes.map(({ ends }) => ends));
        marks.write(this.points);
        marks.draw(gl.TRIANGLES, (kind) => pen(places, strokes[kind]));
        marks.drop();
    }

    drawDots(dots, places, ratio) {
        const { gl } = this;
        if (!dots.some(({ nodes }) => nodes.length)) return;
        const parts = this.nodes.parts(dots.map(({ nodes }) => nodes));
        gl.uniform1f(places.ahead, AHEAD.dots);
        parts.draw(gl.POINTS, (kind) => {
            const { colour, width, ring } = dots[kind];
            gl.uniform4f(places.paint, ...colour, 1);
            gl.uniform1f(places.width, width * ratio);
            gl.uniform1i(places.ring, ring ? 1 : 0);
        });
        parts.drop();
    }
}
