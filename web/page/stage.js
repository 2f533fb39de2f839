// The sheet in space: what is to be seen of it, and when it is drawn. WebGL does that; but where that is the processor's work, it draws
// only what stands still, and of what moves there is a draft.

import { Camera } from "./camera.js";
import { lineOf, theme } from "./colours.js";
import { depths } from "./depth.js";
import { Draft } from "./draft.js";
import { isSoftware, Painter } from "./painter.js";

/** Kinds of lines, borders first: they frame the rest. As wide as so many pixels. */
const KINDS = ["line-b", "line-m", "line-v", "line-f", "line-u"];
const WIDTHS = [1.3, 1.2, 1.2, 0.7, 0.9];
/** From so many edges on they are as thin as the screen has them: wide ones would take long. */
const DENSE = 4000;
/** A sheet that has not changed for so many milliseconds stands still. */
const CALM = 250;

export class Stage {
    constructor(canvas, draft) {
        this.canvas = canvas;
        this.camera = new Camera();
        this.shown = { faces: true, B: true, M: true, V: true, F: true, U: true, marks: true };
        this.map = { wish: "none", largest: 1 };
        this.hover = {};
        this.selected = new Set();
        const software = isSoftware();
        this.painter = new Painter(canvas, !software, () => (this.dirty = true));
        this.draft = software ? new Draft(draft) : undefined;
        // By the processor smooth edges take four samples of each pixel, and a GPU has its own.
        this.finest = software ? 2 : 1;
        this.restyle();
    }

    /** The theme has changed. */
    restyle() {
        this.theme = theme();
        this.dirty = true;
    }

    /** Another pattern. */
    open(model) {
        const lines = KINDS.map(() => []);
        for (let edge = 0; edge < model.edges; edge++) {
            const [a, b] = model.ends.subarray(2 * edge, 2 * edge + 2);
            if (a !== b) lines[KINDS.indexOf(lineOf(model.letters[edge]))].push(a, b);
        }
        Object.assign(this, { model, crossed: undefined, hover: {}, warned: { nodes: [], edges: [] }, pins: [] });
        this.selected.clear();
        for (const artist of [this.painter, this.draft]) artist?.open({ model, lines, depths: depths(model.triangles), dense: model.edges > DENSE });
        this.moved(model.points);
    }

    /** Where the nodes are now: x, y, z and a value of each. */
    moved(points) {
        this.model.points = points;
        this.dirty = this.stale = true;
    }

    /** Shows faces that cross. */
    cross(faces) {
        if (!faces.size && !this.crossed) return;
        const { corners } = this.model;
        const own = [...this.model.faces.keys()].filter((triangle) => faces.has(this.model.faces[triangle]));
        this.crossed = own.length ? own.flatMap((triangle) => [...corners.subarray(3 * triangle, 3 * triangle + 3)]) : undefined;
        this.dirty = true;
    }

    /** What is to be seen, for whoever draws it: colours, and the nodes of what is marked. */
    look() {
        const { theme, shown, map, model, hover } = this;
        const { right, up, back } = this.camera.axes();
        const light = right.map((x, i) => -0.35 * x + 0.55 * up[i] + 0.76 * back[i]);
        const odd = shown.marks ? this.warned : { nodes: [], edges: [] };
        const given = (index) => (index === undefined ? [] : [index]);
        const ends = (edges) => edges.flatMap((edge) => [...model.ends.subarray(2 * edge, 2 * edge + 2)]);
        return {
            ground: theme.ground,
            light,
            faces: shown.faces ? [theme.front, theme.back] : undefined,
            crossed: this.crossed ? { corners: this.crossed, sides: [theme.warn, theme.warn.map((x) => 0.75 * x)] } : undefined,
            largest: map.wish === "none" ? undefined : map.largest || 1,
            lines: KINDS.map((kind, i) => (shown["BMVFU"[i]] ? { colour: theme[kind], width: WIDTHS[i] } : undefined)),
            strokes: [
                { ends: ends(given(hover.edge)), colour: theme.accent, width: 3.2 },
                { ends: ends([...this.selected]), colour: theme.accent, width: 2.6 },
                { ends: ends(odd.edges), colour: theme.warn, width: 2.6 },
            ],
            dots: [
                { nodes: given(hover.node), colour: theme.accent, width: 13 },
                { nodes: this.pins, colour: theme.pin, width: 12 },
                { nodes: odd.nodes, colour: theme.warn, width: 17, ring: true },
            ],
        };
    }

    /** Draws, where something has changed; what stands still is drawn finer once. */
    draw() {
        this.fit();
        if (!this.model) return;
        const { draft } = this;
        const now = performance.now();
        if (this.dirty) {
            Object.assign(this, { dirty: false, changed: now, fine: false });
            const drafted = draft?.draw(this.look(), this.camera);
            if (!drafted) this.paint();
            if (draft) draft.canvas.hidden = !drafted;
        } else if (draft && this.fine) {
            // Not before the finer picture is there.
            if (!draft.canvas.hidden) draft.canvas.hidden = true;
        } else if (draft && now - this.changed > CALM) this.paint(this.finest);
    }

    /** Fits the view to the page. */
    fit() {
        const { camera, canvas } = this;
        const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) => Math.max(1, x));
        if (camera.width !== width || camera.height !== height) this.dirty = true;
        Object.assign(camera, { width, height });
    }

    /** Draws by WebGL: by as many pixels as the screen has, or by so many for each of the page. */
    paint(least = 1) {
        if (this.stale) this.painter.moved(this.model.points);
        this.painter.draw(this.look(), this.camera, Math.max(Math.min(devicePixelRatio || 1, 2), least));
        Object.assign(this, { stale: false, fine: least === this.finest });
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
        this.paint(this.finest);
        return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
    }
}
