// A picture of a sheet that moves, drawn without WebGL: where the processor draws, that takes long for each triangle and line, however
// small. Each face has one shade, lines are as thin as a pixel, and no edges are smoothed; all else is as WebGL draws it.

import { AHEAD, behind } from "./depth.js";
import { ramp } from "./colours.js";

/** Shades of the map. */
const SHADES = 256;
/** Pixels around the nodes that lines and dots may take. */
const ROOM = 10;

export class Draft {
    constructor(canvas) {
        this.canvas = canvas;
        this.pen = canvas.getContext("2d", { alpha: false, willReadFrequently: true });
        const colours = ramp();
        this.ramp = Float32Array.from({ length: 3 * SHADES }, (_, i) => {
            const at = (8 * Math.floor(i / 3)) / (SHADES - 1);
            const [low, k] = [Math.min(Math.floor(at), 7), i % 3];
            return colours[3 * low + k] + (at - low) * (colours[3 * low + 3 + k] - colours[3 * low + k]);
        });
    }

    /** Another pattern: the ends of its lines by their kinds, the depth of each triangle, and whether lines are as thin as can be. */
    open(opened) {
        Object.assign(this, opened);
        [this.x, this.y, this.z] = [0, 1, 2].map(() => new Float64Array(this.model.nodes));
    }

    /** Draws what is to be seen; false where some of it is too near to the eye. */
    draw(look, camera) {
        this.fit(camera.width, camera.height);
        const box = this.project(camera);
        if (!box) return false;
        const ground = word(look.ground, 1);
        // What is drawn over now, and what was before; all of it at first, and where the theme has changed.
        const old = ground === this.ground && this.box ? this.box : [0, 0, this.width, this.height];
        const [left, top, right, bottom] = box.map((x, i) => (i < 2 ? Math.min(x, old[i]) : Math.max(x, old[i])));
        for (let row = top; row < bottom; row++)
            for (const [pixels, value] of [[this.words, ground], [this.depth, Infinity]]) pixels.fill(value, row * this.width + left, row * this.width + right);
        Object.assign(this, { box, ground });
        const { corners } = this.model;
        if (look.faces) this.faces(corners, this.depths, look.faces, look);
        if (look.faces && look.crossed) this.faces(look.crossed.corners, undefined, look.crossed.sides, { ...look, largest: undefined });
        this.lines.forEach((ends, kind) => look.lines[kind] && this.strokes({ ...look.lines[kind], ends, width: this.dense ? 0.5 : 1 }, AHEAD.lines));
        look.strokes.forEach((stroke) => this.strokes(stroke, AHEAD.marks));
        look.dots.forEach((dots) => this.dots(dots));
        this.pen.putImageData(this.image, 0, 0, left, top, right - left, bottom - top);
        return true;
    }

    fit(width, height) {
        if (this.width === width && this.height === height) return;
        Object.assign(this, { width, height, box: undefined, image: new ImageData(width, height), depth: new Float32Array(width * height) });
        Object.assign(this.canvas, { width, height });
        this.words = new Uint32Array(this.image.data.buffer);
    }

    /** Brings the nodes to the screen. The box around them, with room for marks; none where a node is not in front of the eye. */
    project(camera) {
        const { x, y, z, width, height } = this;
        const { points, nodes } = this.model;
        const m = camera.matrix();
        let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
        for (let node = 0, i = 0; node < nodes; node++, i += 4) {
            const [px, py, pz] = [points[i], points[i + 1], points[i + 2]];
            const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
            z[node] = (m[2] * px + m[6] * py + m[10] * pz + m[14]) / w;
            if (w <= 0 || z[node] < -1) return undefined;
            const sx = (x[node] = (0.5 + (0.5 * (m[0] * px + m[4] * py + m[8] * pz + m[12])) / w) * width);
            const sy = (y[node] = (0.5 - (0.5 * (m[1] * px + m[5] * py + m[9] * pz + m[13])) / w) * height);
            if (sx < left) left = sx;
            if (sx > right) right = sx;
            if (sy < top) top = sy;
            if (sy > bottom) bottom = sy;
        }
        const within = (value, most) => Math.max(0, Math.min(most, Math.floor(value)));
        return [within(left - ROOM, width), within(top - ROOM, height), within(right + 1 + ROOM, width), within(bottom + 1 + ROOM, height)];
    }

    /** Triangles, row by row. */
    faces(corners, depths, [front, back], { light, largest }) {
        const { x, y, z, width, height, words, depth, ramp } = this;
        const { points } = this.model;
        for (let i = 0; i < corners.length; i += 3) {
            const [a, b, c] = [corners[i], corners[i + 1], corners[i + 2]];
            const [xb, yb, zb, xc, yc, zc] = [x[b] - x[a], y[b] - y[a], z[b] - z[a], x[c] - x[a], y[c] - y[a], z[c] - z[a]];
            const area = xb * yc - xc * yb;
            if (!area) continue;
            // From top to bottom.
            let [p, q, r] = [a, b, c];
            if (y[q] < y[p]) [p, q] = [q, p];
            if (y[r] < y[p]) [p, r] = [r, p];
            if (y[r] < y[q]) [q, r] = [r, q];
            const first = Math.max(0, Math.ceil(y[p] - 0.5));
            const end = Math.min(height, Math.ceil(y[r] - 0.5));
            if (!(first < end)) continue;
            const lit = shade(points, a, b, c, light, area < 0);
            const paper = area < 0 ? front : back;
            const colour = word(paper, lit);
            const [zx, zy] = [(zb * yc - zc * yb) / area, (zc * xb - zb * xc) / area];
            const slope = Math.max(Math.abs(zx), Math.abs(zy));
            const start = z[a] + slope + (depths ? behind(depths[i / 3]) : behind(-1));
            let [value, vx, vy] = [0, 0, 0];
            if (largest) {
                const of = (node) => ((SHADES - 1) * points[4 * node + 3]) / largest;
                value = of(a);
                const [vb, vc] = [of(b) - value, of(c) - value];
                [vx, vy] = [(vb * yc - vc * yb) / area, (vc * xb - vb * xc) / area];
            }
            const long = (x[r] - x[p]) / (y[r] - y[p]);
            const above = (x[q] - x[p]) / (y[q] - y[p]);
            const below = (x[r] - x[q]) / (y[r] - y[q]);
            for (let row = first; row < end; row++) {
                const at = row + 0.5;
                const one = x[p] + (at - y[p]) * long;
                const other = at < y[q] ? x[p] + (at - y[p]) * above : x[q] + (at - y[q]) * below;
                const from = Math.max(0, Math.ceil((one < other ? one : other) - 0.5));
                const to = Math.min(width, Math.ceil((one < other ? other : one) - 0.5));
                let near = start + (from + 0.5 - x[a]) * zx + (at - y[a]) * zy;
                for (let k = row * width + from, last = row * width + to; k < last; k++, near += zx) {
                    if (near >= depth[k]) continue;
                    depth[k] = near;
                    if (largest) {
                        const column = k - row * width + 0.5 - x[a];
                        const tone = 3 * Math.max(0, Math.min(SHADES - 1, Math.round(value + column * vx + (at - y[a]) * vy)));
                        const light = 255 * (0.75 + 0.25 * lit);
                        words[k] = 0xff000000 | ((light * ramp[tone + 2]) << 16) | ((light * ramp[tone + 1]) << 8) | (light * ramp[tone]);
                    } else words[k] = colour;
                }
            }
        }
    }

    /** Lines, pixel by pixel, of so many pixels; of less than one they hide half of what is below. */
    strokes({ ends, colour, width: wide }, ahead) {
        const { x, y, z, width, height, words, depth } = this;
        const isThin = wide < 1;
        const ink = word(colour, 1);
        const size = Math.max(1, Math.round(wide));
        const before = (size - 1) >> 1;
        for (let i = 0; i < ends.length; i += 2) {
            const [a, b] = [ends[i], ends[i + 1]];
            const [dx, dy] = [x[b] - x[a], y[b] - y[a]];
            const count = Math.max(1, Math.ceil(Math.max(Math.abs(dx), Math.abs(dy))));
            // Of what is long and mostly elsewhere only what may be seen is gone through.
            const [from, to] = inside(x[a], dx, width, ...inside(y[a], dy, height, 0, 1));
            for (let step = Math.ceil(from * count); step <= to * count; step++) {
                const share = step / count;
                const near = z[a] + share * (z[b] - z[a]) - ahead;
                const [column, row] = [Math.floor(x[a] + share * dx) - before, Math.floor(y[a] + share * dy) - before];
                for (let py = Math.max(0, row); py < Math.min(height, row + size); py++)
                    for (let px = Math.max(0, column); px < Math.min(width, column + size); px++) {
                        const k = py * width + px;
                        if (near >= depth[k]) continue;
                        depth[k] = near;
                        words[k] = isThin ? half(words[k], ink) : ink;
                    }
            }
        }
    }

    /** Dots with a white rim, or rings. */
    dots({ nodes, colour, width: wide, ring }) {
        const { x, y, z, width, height, words, depth } = this;
        const [ink, rim] = [word(colour, 1), 0xffffffff];
        for (const node of nodes) {
            const [near, radius] = [z[node] - AHEAD.dots, wide / 2];
            for (let py = Math.max(0, Math.floor(y[node] - radius)); py < Math.min(height, y[node] + radius); py++)
                for (let px = Math.max(0, Math.floor(x[node] - radius)); px < Math.min(width, x[node] + radius); px++) {
                    const far = Math.hypot(px + 0.5 - x[node], py + 0.5 - y[node]) / radius;
                    const k = py * width + px;
                    if (far > 1 || (ring && far < 0.66) || near >= depth[k]) continue;
                    [depth[k], words[k]] = [near, far > 0.72 && !ring ? rim : ink];
                }
        }
    }
}

/** How light a triangle is, as the shader has it: by the side that is seen. */
function shade(points, a, b, c, light, isFront) {
    const [i, j, k] = [4 * a, 4 * b, 4 * c];
    const [ux, uy, uz] = [points[j] - points[i], points[j + 1] - points[i + 1], points[j + 2] - points[i + 2]];
    const [vx, vy, vz] = [points[k] - points[i], points[k + 1] - points[i + 1], points[k + 2] - points[i + 2]];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
    const along = length > 0 ? (nx * light[0] + ny * light[1] + nz * light[2]) / length : 0.5;
    const facing = isFront ? along : -along;
    return 0.72 + 0.24 * Math.max(facing, 0) + 0.08 * facing;
}

/** A colour as the four bytes of a pixel. */
function word([red, green, blue], lit) {
    const byte = (share) => Math.min(255, 255 * lit * share + 0.5);
    return 0xff000000 | (byte(blue) << 16) | (byte(green) << 8) | byte(red);
}

/** The mean of two colours. */
const half = (one, other) => (one & other) + (((one ^ other) & 0xfefefefe) >>> 1);

/** The shares of a way from `start` that lie between 0 and `most`, of those from `from` to `to`. */
function inside(start, way, most, from, to) {
    if (!way) return start >= 0 && start <= most ? [from, to] : [1, 0];
    const [one, other] = [-start / way, (most - start) / way];
    return [Math.max(from, Math.min(one, other)), Math.min(to, Math.max(one, other))];
}
