// The page between what folds and what is seen: what was asked, what came of it, and all that is asked in between.

import { controls } from "./controls.js";
import { Crossed } from "./crossed.js";
import { Files } from "./files.js";
import { Flat } from "./flat.js";
import { hand } from "./hand.js";
import { keys } from "./keys.js";
import { isCrease, number, opened } from "./model.js";
import { $, chosen, material, numbers, warnings } from "./panel.js";
import { Recording } from "./recording.js";
import { Stage } from "./stage.js";

/** Changes by one hand without a pause of so many milliseconds are one to be undone. */
const PAUSE = 700;
/** Numbers change after so many milliseconds at the soonest: nobody reads faster, and the page is laid out anew for them. */
const READ = 100;

export class App {
    /** `kind` says what folds: a program behind a socket, a worker, or nobody, in a film. */
    constructor(engine, kind) {
        this.kind = kind;
        this.stage = new Stage($("stage"), $("draft"));
        this.flat = new Flat($("flat"));
        this.selected = new Set();
        this.tool = "grab";
        this.pending = {};
        this.sent = new Set();
        this.files = new Files(this);
        this.crossed = new Crossed(this.stage);
        this.recording = new Recording(this);
        this.engine = engine;
        this.live = engine.live;
        this.range = [engine.from ?? -100, engine.to ?? 100];
        this.showMaterial = material($("material-list"), () => this.mark("material"), (values) => this.soon("material", { do: "material", ...values }));
        controls(this);
        hand(this);
        keys(this);
        const [least, most] = [...this.range].sort((a, b) => a - b);
        for (const input of [$("percent"), $("percent-number")]) Object.assign(input, { min: least, max: most });
        ["least", "middle", "most"].forEach((id, i) => ($(id).textContent = `${number(least + (i * (most - least)) / 2)}${i === 2 ? " %" : ""}`));
        if (this.live) $("middle").textContent = "flat";
        if (this.live) {
            this.ask({ do: "catalog" });
            this.files.begin();
        }
        const tick = () => {
            requestAnimationFrame(tick);
            this.tick();
        };
        requestAnimationFrame(tick);
    }

    ask(request, body) {
        this.engine.ask(request, body);
    }

    /** Asks at once, but once for each picture; of several requests of one kind the last. */
    soon(kind, request) {
        if (this.sent.has(kind)) this.pending[kind] = request;
        else this.ask(request);
        this.sent.add(kind);
    }

    /** Something is about to be changed that can be undone; of several changes of one kind without a pause the first counts. */
    mark(kind) {
        const now = performance.now();
        if (this.live && (kind !== this.marked?.kind || now - this.marked.at > PAUSE)) this.ask({ do: "mark" });
        this.marked = { kind, at: now };
    }

    tick() {
        this.sent.clear();
        for (const [kind, request] of Object.entries(this.pending)) {
            delete this.pending[kind];
            this.soon(kind, request);
        }
        this.mayAsk = true;
        this.askForFrame();
        this.recording.tick();
        this.tell();
        this.stage.draw();
        this.flat.draw();
    }

    /** Asks for a picture, once in each refresh of the screen; one that comes late asks for the next at once. */
    askForFrame() {
        if (!this.model || this.asked || !this.mayAsk || document.hidden) return;
        Object.assign(this, { asked: true, mayAsk: false });
        this.ask({ do: "frame", map: $("map").value });
    }

    hear(reply) {
        const { head } = reply;
        if (head.is === "frame") this.frame(reply);
        else if (head.is === "opened") this.opened(reply);
        else if (head.is === "wishes") {
            this.wishes = head.wishes;
            this.showUndo(head);
            this.showWishes();
        } else if (head.is === "marked") this.showUndo(head);
        else if (head.is === "catalog") this.files.known(head.entries);
        else if (head.is === "file") this.files.save(head.name, new Blob([new Uint8Array(reply.buffer, reply.at)], { type: head.media }));
        else if (head.is === "error") this.toast(head.text);
    }

    frame({ head, buffer, at }) {
        this.asked = false;
        this.askForFrame();
        if (!this.model || buffer.byteLength - at !== 16 * this.model.nodes) return;
        this.stage.map = { wish: head.map, largest: head.map_max };
        this.stage.moved(new Float32Array(buffer, at, 4 * this.model.nodes));
        this.last = this.untold = head;
        this.crossed.frame(head.crossings);
        this.recording.frame(head);
    }

    /** How the sheet is, in numbers. */
    tell() {
        const now = performance.now();
        if (!this.untold || now - this.told < READ) return;
        numbers(this.untold);
        Object.assign(this, { untold: undefined, told: now });
    }

    opened(reply) {
        this.model = opened(reply);
        this.wishes = reply.head.wishes;
        this.usual ??= this.wishes.material;
        this.asked = false;
        this.selected.clear();
        this.stage.open(this.model);
        this.flat.open(this.model);
        const { name, title, nodes, edges, creases, format, computer } = reply.head;
        $("title").textContent = title && title !== name.replace(/\.fold$/, "") ? title : name;
        document.title = `${name} – origami`;
        $("about").textContent = `${format} · ${nodes} vertices · ${edges} edges · ${creases} hinges`;
        $("computer").textContent = `Folded by the ${computer}.`;
        $("stage").setAttribute("aria-label", `${name}, a sheet of ${nodes} vertices. Arrow keys turn it, plus and minus zoom.`);
        this.warned = { nodes: this.model.warnings.flatMap((note) => note.nodes), edges: this.model.warnings.flatMap((note) => note.edges) };
        this.showWarned();
        warnings(this.model.warnings, (note) => this.showWarned(note));
        this.showUndo({});
        this.crossed.opened();
        this.recording.opened(this.model.steps);
        this.stage.camera.look("corner");
        for (const button of document.querySelectorAll("[data-letter]"))
            button.hidden = ![...this.model.letters].some((letter) => (letter === "J" ? "F" : letter) === button.dataset.letter);
        $("hint").hidden = false;
        this.showWishes();
        this.files.showParameters();
        this.onopen?.();
        this.onopen = undefined;
    }

    showWarned(note) {
        for (const view of [this.stage, this.flat]) Object.assign(view, { warned: note ?? this.warned, dirty: true });
    }

    showUndo({ can_undo, can_redo }) {
        [$("undo").disabled, $("redo").disabled] = [!can_undo, !can_redo];
    }

    /** All that is asked of the sheet, in the controls. */
    showWishes() {
        const { percent, creases, pins, material, solver } = this.wishes;
        this.showPercent(percent);
        this.showMaterial(material);
        for (const key of ["name", "integrator", "precision", "tolerance"]) $(`solver-${key}`).value = solver[key];
        this.flat.own = creases;
        const held = Object.keys(pins).map(Number);
        for (const view of [this.stage, this.flat]) Object.assign(view, { pins: held, dirty: true });
        $("pinned").hidden = !held.length;
        $("pinned-count").textContent = held.length === 1 ? "1 vertex is pinned." : `${held.length} vertices are pinned.`;
        this.showChosen();
    }

    showPercent(percent) {
        $("percent").value = percent;
        if (document.activeElement !== $("percent-number")) $("percent-number").value = Math.round(10 * percent) / 10;
        $("play").textContent = percent === (this.live ? 100 : this.range[1]) ? "Unfold" : "Fold";
    }

    showChosen() {
        for (const view of [this.stage, this.flat]) Object.assign(view, { selected: this.selected, dirty: true });
        if (this.model) chosen(this);
    }

    // What a hand does.

    fold(percent, slowly) {
        percent = Math.max(Number($("percent").min), Math.min(Number($("percent").max), percent));
        if (!this.wishes || !Number.isFinite(percent)) return;
        this.mark("fold");
        this.wishes.percent = percent;
        $("hint").hidden = true;
        this.soon("fold", slowly ? { do: "fold", percent, slowly } : { do: "fold", percent });
        this.resume();
        this.showPercent(percent);
        chosen(this);
    }

    foldOrUnfold() {
        const [from, to] = this.live ? [0, 100] : this.range;
        if (this.wishes) this.fold(this.wishes.percent === to ? from : to, !this.live);
    }

    resume() {
        if (this.paused) this.runOrPause();
    }

    runOrPause() {
        this.paused = !this.paused;
        this.ask({ do: "run", on: !this.paused });
        this.showRun();
    }

    step() {
        this.paused = true;
        this.ask({ do: "step", count: 10 });
        this.showRun();
    }

    showRun() {
        $("run").textContent = this.paused ? "▶" : "❚❚";
        $("run").setAttribute("aria-label", this.paused ? "Go on" : "Pause");
    }

    reset() {
        this.ask({ do: "reset" });
        this.resume();
    }

    grab(node) {
        this.mark({});
        this.ask({ do: "grab", node });
        this.wishes.pins[node] = [0, 0, 0];
        $("hint").hidden = true;
        this.resume();
        this.showWishes();
    }

    drag(node, to) {
        this.soon("drag", { do: "drag", node, to });
    }

    release(node, keep) {
        if (this.pending.drag) this.ask(this.pending.drag);
        delete this.pending.drag;
        if (keep) return;
        this.ask({ do: "release", node });
        delete this.wishes.pins[node];
        this.showWishes();
    }

    /** A click on a vertex pins it, or lets it go. */
    toggle(node) {
        if (this.wishes.pins[node]) {
            this.mark({});
            this.release(node);
        } else this.grab(node);
    }

    choose(edge, more) {
        if (!more) this.selected.clear();
        if (edge !== undefined) this.selected.has(edge) && more ? this.selected.delete(edge) : this.selected.add(edge);
        this.showChosen();
    }

    /** The next crease, for those who use keys. */
    next(by) {
        if (!this.model) return;
        let edge = [...this.selected].at(-1) ?? (by > 0 ? -1 : this.model.edges);
        do edge += by;
        while (edge >= 0 && edge < this.model.edges && !isCrease(this.model, edge));
        if (edge >= 0 && edge < this.model.edges) this.choose(edge);
    }

    point(at) {
        if (this.stage.hover.node === at.node && this.stage.hover.edge === at.edge) return;
        for (const view of [this.stage, this.flat]) Object.assign(view, { hover: at, dirty: true });
        $("stage").dataset.over = at.node !== undefined ? "node" : at.edge !== undefined ? "edge" : "";
    }

    own(own) {
        if (!this.selected.size) return;
        this.mark("own");
        const edges = [...this.selected];
        for (const edge of edges) own === null ? delete this.wishes.creases[edge] : (this.wishes.creases[edge] = own);
        this.soon("crease", { do: "crease", edges, own });
        this.resume();
        this.showChosen();
    }

    alike() {
        const [edge] = this.selected;
        const { letters, angles, edges } = this.model;
        for (let other = 0; other < edges; other++)
            if (isCrease(this.model, other) && letters[other] === letters[edge] && Object.is(angles[other], angles[edge])) this.selected.add(other);
        this.showChosen();
    }

    setTool(tool) {
        this.tool = tool;
        document.querySelectorAll("[data-tool]").forEach((button) => button.setAttribute("aria-pressed", button.dataset.tool === tool));
    }

    look(view) {
        this.stage.camera.look(view);
        this.stage.dirty = true;
    }

    solver() {
        this.mark("solver");
        const [name, integrator, precision] = ["name", "integrator", "precision"].map((key) => $(`solver-${key}`).value);
        this.wishes.solver = { name, integrator, precision, tolerance: Number($("solver-tolerance").value) };
        this.ask({ do: "solver", ...this.wishes.solver });
    }

    help() {
        $("help").showModal();
    }

    toast(text) {
        Object.assign($("toast"), { textContent: text, hidden: false });
        clearTimeout(this.toasting);
        this.toasting = setTimeout(() => ($("toast").hidden = true), Math.max(3000, 60 * text.length));
    }

    lose(text) {
        this.live = false;
        this.untold = undefined;
        this.toast(text);
        $("state").textContent = "Gone";
    }
}
