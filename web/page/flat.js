// The flat pattern beside the sheet: what is pointed at or chosen here is so there.

import { css, lineOf, theme } from "./colours.js";
import { isCrease } from "./model.js";

const MARGIN = 14;

export class Flat {
    constructor(canvas) {
        this.canvas = canvas;
        this.hover = {};
        this.selected = new Set();
        this.restyle();
    }

    restyle() {
        this.theme = theme(this.canvas);
        this.lines = undefined;
        this.dirty = true;
    }

    open(model) {
        Object.assign(this, { model, lines: undefined, hover: {}, warned: { nodes: [], edges: [] }, pins: [], own: {} });
        this.selected.clear();
        const [xs, ys] = [0, 1].map((axis) => model.rest.filter((_, i) => i % 3 === axis));
        const [least, most] = [(list) => list.reduce((a, b) => Math.min(a, b), Infinity), (list) => list.reduce((a, b) => Math.max(a, b), -Infinity)];
        this.box = [least(xs), least(ys), most(xs), most(ys)];
        this.dirty = true;
    }

    /** From nodes to pixels. */
    place() {
        const { clientWidth: width, clientHeight: height } = this.canvas;
        const [x0, y0, x1, y1] = this.box;
        const scale = Math.min((width - 2 * MARGIN) / (x1 - x0 || 1), (height - 2 * MARGIN) / (y1 - y0 || 1));
        const [left, top] = [(width - scale * (x0 + x1)) / 2, (height + scale * (y0 + y1)) / 2];
        const rest = this.model.rest;
        return (node) => [left + scale * rest[3 * node], top - scale * rest[3 * node + 1]];
    }

    draw() {
        const { canvas, model, theme } = this;
        const ratio = Math.min(devicePixelRatio || 1, 2);
        const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) => Math.round(x * ratio));
        if (!model || (!this.dirty && canvas.width === width && canvas.height === height)) return;
        this.dirty = false;
        if (!this.lines || this.lines.width !== width || this.lines.height !== height) this.lines = this.pattern(width, height, ratio);
        const pen = this.pen(canvas, width, height, ratio);
        // Of size 0 where the page has no room for it.
        if (width && height) pen.drawImage(this.lines, 0, 0, width / ratio, height / ratio);
        this.stroke(pen, this.warned.edges, css(theme.warn, 0.6), 5);
        this.stroke(pen, Object.keys(this.own).map(Number), css(theme.accent, 0.35), 5);
        this.stroke(pen, this.selected, css(theme.accent), 3.5);
        if (this.hover.edge !== undefined) this.stroke(pen, [this.hover.edge], css(theme.accent), 4.5);
        const at = this.place();
        const dot = (node, colour, size, hollow) => {
            pen.beginPath();
            pen.setLineDash([]);
            pen.arc(...at(node), size, 0, 7);
            Object.assign(pen, { fillStyle: colour, strokeStyle: colour, lineWidth: 2 });
            hollow ? pen.stroke() : pen.fill();
        };
        this.warned.nodes.forEach((node) => dot(node, css(theme.warn), 6, true));
        this.pins.forEach((node) => dot(node, css(theme.pin), 4.5));
        if (this.hover.node !== undefined) dot(this.hover.node, css(theme.accent), 5);
    }

    /** The lines of the pattern, which stay as they are while a hand points and chooses: many take long. */
    pattern(width, height, ratio) {
        const { model, theme } = this;
        const lines = document.createElement("canvas");
        const pen = this.pen(lines, width, height, ratio);
        const dense = model.edges > 1500;
        const byLetter = {};
        for (let edge = 0; edge < model.edges; edge++)
            if (model.ends[2 * edge] !== model.ends[2 * edge + 1]) (byLetter[model.letters[edge]] ??= []).push(edge);
        // Borders last: they frame the rest.
        for (const letter of Object.keys(byLetter).sort((a, b) => (a === "B") - (b === "B")))
            this.stroke(pen, byLetter[letter], css(theme[lineOf(letter)]), (letter === "B" ? 1.8 : 1.3) * (dense ? 0.5 : 1), letter === "U" ? [3, 3] : []);
        return lines;
    }

    /** A pen for an empty canvas of so many pixels. */
    pen(canvas, width, height, ratio) {
        Object.assign(canvas, { width, height });
        const pen = canvas.getContext("2d");
        pen.scale(ratio, ratio);
        return pen;
    }

    stroke(pen, edges, colour, line, dash = []) {
        const at = this.place();
        pen.beginPath();
        for (const edge of edges) {
            pen.moveTo(...at(this.model.ends[2 * edge]));
            pen.lineTo(...at(this.model.ends[2 * edge + 1]));
        }
        Object.assign(pen, { strokeStyle: colour, lineWidth: line, lineCap: "round" });
        pen.setLineDash(dash);
        pen.stroke();
    }

    /** The crease near a place. */
    edgeAt(x, y, within) {
        const at = this.place();
        let [best, nearest] = [undefined, within];
        for (let edge = 0; edge < this.model.edges; edge++) {
            if (!isCrease(this.model, edge)) continue;
            const [[ax, ay], [bx, by]] = [at(this.model.ends[2 * edge]), at(this.model.ends[2 * edge + 1])];
            const [wx, wy] = [bx - ax, by - ay];
            const share = Math.max(0, Math.min(1, ((x - ax) * wx + (y - ay) * wy) / (wx * wx + wy * wy || 1)));
            const far = Math.hypot(ax + share * wx - x, ay + share * wy - y);
            if (far < nearest) [best, nearest] = [edge, far];
        }
        return best;
    }
}
