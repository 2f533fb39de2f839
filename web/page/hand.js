// The hand: turns, moves and zooms the view, takes a vertex and drags it, points at creases and chooses them.

import { isCrease } from "./model.js";

const CLICK = 4;

/** `app` has stage, flat, and what to do: grab, drag, release, choose, point. */
export function hand(app) {
    const { stage, flat } = app;
    const canvas = stage.canvas;
    const fingers = new Map();
    let doing;

    const reach = (event, fine, coarse) => (event.pointerType === "touch" ? coarse : fine);
    const under = (event) => {
        if (!stage.model) return {};
        const [x, y] = [event.offsetX, event.offsetY];
        const may = (edge) => isCrease(stage.model, edge) && stage.shown[{ M: "M", V: "V", F: "F", J: "F" }[stage.model.letters[edge]] ?? "U"];
        const node = app.tool === "grab" && app.live && !event.altKey ? stage.nodeAt(x, y, reach(event, 11, 24)) : undefined;
        return node !== undefined ? { node } : { edge: stage.edgeAt(x, y, reach(event, 6, 14), may) };
    };

    const spread = () => {
        const [a, b] = [...fingers.values()];
        return { far: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
    };

    canvas.addEventListener("pointerdown", (event) => {
        if (!stage.model) return;
        canvas.setPointerCapture(event.pointerId);
        fingers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
        if (fingers.size === 2) {
            if (doing?.node !== undefined) app.release(doing.node);
            doing = { kind: "pinch", ...spread() };
            return;
        }
        const found = under(event);
        const pans = event.button !== 0 || event.shiftKey && found.node === undefined && found.edge === undefined;
        doing = { kind: pans ? "pan" : "orbit", ...found, moved: 0, shift: event.shiftKey };
        if (found.node !== undefined && event.button === 0) {
            const at = stage.model.points.subarray(4 * found.node, 4 * found.node + 3);
            Object.assign(doing, { kind: "take", from: [...at], dx: 0, dy: 0 });
        }
    });

    canvas.addEventListener("pointermove", (event) => {
        const old = fingers.get(event.pointerId);
        if (!old) {
            if (event.pointerType !== "touch") app.point(under(event));
            return;
        }
        const [dx, dy] = [event.offsetX - old.x, event.offsetY - old.y];
        Object.assign(old, { x: event.offsetX, y: event.offsetY });
        if (!doing) return;
        doing.moved += Math.hypot(dx, dy);
        if (doing.kind === "pinch" && fingers.size === 2) {
            const now = spread();
            stage.camera.zoomBy(now.far / (doing.far || 1), now.x, now.y);
            stage.camera.pan(now.x - doing.x, now.y - doing.y);
            Object.assign(doing, now);
        } else if (doing.kind === "take" && doing.moved > CLICK) {
            if (!doing.held) {
                doing.held = true;
                app.grab(doing.node);
            }
            doing.dx += dx;
            doing.dy += dy;
            app.drag(doing.node, stage.camera.moved(doing.from, doing.dx, doing.dy));
        } else if (doing.kind === "orbit" && doing.moved > CLICK) {
            stage.camera.orbit(dx, dy);
        } else if (doing.kind === "pan") {
            stage.camera.pan(dx, dy);
        }
        stage.dirty = true;
    });

    const up = (event) => {
        fingers.delete(event.pointerId);
        if (!doing || fingers.size) return;
        const { kind, node, edge, held, moved, shift } = doing;
        doing = undefined;
        if (kind === "take" && held) app.release(node, shift || app.keeps);
        else if (kind === "take" && event.type === "pointerup") app.toggle(node);
        else if (kind === "orbit" && moved <= CLICK && event.type === "pointerup") app.choose(edge, shift || event.ctrlKey || event.metaKey);
    };
    canvas.addEventListener("pointerup", up);
    canvas.addEventListener("pointercancel", up);
    canvas.addEventListener("pointerleave", () => fingers.size || app.point({}));
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        const unit = [1, 30, 400][event.deltaMode] ?? 1;
        stage.camera.zoomBy(Math.exp(-event.deltaY * unit * 0.0012), event.offsetX, event.offsetY);
        stage.dirty = true;
    }, { passive: false });

    const page = flat.canvas;
    page.addEventListener("pointermove", (event) => flat.model && app.point({ edge: flat.edgeAt(event.offsetX, event.offsetY, 9) }));
    page.addEventListener("pointerleave", () => app.point({}));
    page.addEventListener("click", (event) => {
        if (!flat.model) return;
        app.choose(flat.edgeAt(event.offsetX, event.offsetY, 14), event.shiftKey || event.ctrlKey || event.metaKey);
    });
}
