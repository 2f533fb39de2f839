// The page: what folds on one side, what is seen on the other, and all that is asked in between.

import { MAPS } from "./colours.js";
import { filmEngine, socketEngine, workerEngine } from "./engine.js";
import { Flat } from "./flat.js";
import { fill } from "./gallery.js";
import { hand } from "./hand.js";
import { keys } from "./keys.js";
import { isCrease, number, opened } from "./model.js";
import { $, chosen, material, numbers, warnings } from "./panel.js";
import { Stage } from "./stage.js";

/** What folds: a program behind a socket, a worker, or nobody, in a film. */
const KIND = document.documentElement.dataset.engine ?? "socket";
/** Changes by one hand without a pause of so many milliseconds are one to be undone. */
const PAUSE = 700;

class App {
    constructor(engine) {
        this.stage = new Stage($("stage"));
        this.flat = new Flat($("flat"));
        this.selected = new Set();
        this.tool = "grab";
        this.pending = {};
        this.sent = new Set();
        this.catalog = [];
        this.files = [];
        this.engine = engine;
        this.live = engine.live;
        this.range = [engine.from ?? -100, engine.to ?? 100];
        this.showMaterial = material($("material-list"), () => this.mark("material"), (values) => this.soon("material", { do: "material", ...values }));
        this.buttons();
        hand(this);
        keys(this);
        const [least, most] = [...this.range].sort((a, b) => a - b);
        for (const input of [$("percent"), $("percent-number")]) Object.assign(input, { min: least, max: most });
        ["least", "middle", "most"].forEach((id, i) => ($(id).textContent = `${number(least + (i * (most - least)) / 2)}${i === 2 ? " %" : ""}`));
        if (this.live) $("middle").textContent = "flat";
        if (this.live) {
            this.ask({ do: "catalog" });
            this.begin();
        }
        const tick = () => {
            requestAnimationFrame(tick);
            this.tick();
        };
        requestAnimationFrame(tick);
    }

    /** What is opened first: the file of the command line, what the address names, or the gallery. */
    async begin() {
        const wanted = new URLSearchParams(location.hash.slice(1));
        if (wanted.has("pattern")) return this.linked(wanted);
        const first = KIND === "worker" ? undefined : await fetch("first").catch(() => undefined);
        if (first?.status === 200) return this.open(decodeURIComponent(first.headers.get("X-Name") ?? "pattern"), await first.arrayBuffer());
        this.generate("crane");
        this.gallery();
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
        if (this.model && !this.asked && !document.hidden) {
            this.asked = true;
            this.ask({ do: "frame", map: $("map").value });
        }
        this.stage.draw();
        this.flat.draw();
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
        else if (head.is === "catalog") {
            this.catalog = head.entries;
            this.showParameters();
            if ($("gallery").open) this.gallery();
        } else if (head.is === "file") this.save(head.name, new Blob([new Uint8Array(reply.buffer, reply.at)], { type: head.media }));
        else if (head.is === "error") this.toast(head.text);
    }

    frame({ head, buffer, at }) {
        this.asked = false;
        if (!this.model || buffer.byteLength - at !== 16 * this.model.nodes) return;
        this.stage.map = { wish: head.map, largest: head.map_max };
        this.stage.moved(new Float32Array(buffer, at, 4 * this.model.nodes));
        this.last = head;
        numbers(head);
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
        this.stage.camera.look("corner");
        for (const button of document.querySelectorAll("[data-letter]"))
            button.hidden = ![...this.model.letters].some((letter) => (letter === "J" ? "F" : letter) === button.dataset.letter);
        $("hint").hidden = false;
        this.showWishes();
        this.showParameters();
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
        this.showChosen();
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

    // Files.

    open(name, buffer) {
        const session = name.endsWith(".origami-session.json");
        this.generated = undefined;
        this.ask(session ? { do: "restore" } : { do: "open", name }, new Uint8Array(buffer));
    }

    async openFile(file) {
        if (file) this.open(file.name, await file.arrayBuffer());
    }

    generate(name, parameters = []) {
        this.generated = { name, parameters };
        this.ask({ do: "generate", name, parameters });
    }

    showParameters() {
        const entry = this.catalog.find((entry) => entry.name === this.generated?.name);
        $("parameters").hidden = !entry?.parameters.length;
        if (!entry) return;
        const given = Object.fromEntries(this.generated.parameters);
        $("parameters-list").replaceChildren(...entry.parameters.map(({ name, meaning, default: usual }) => {
            const row = document.createElement("label");
            row.className = "row wide";
            row.title = meaning;
            const [label, field] = [document.createElement("span"), document.createElement("input")];
            label.textContent = name;
            Object.assign(field, { type: "number", step: "any", value: given[name] ?? usual });
            field.setAttribute("aria-label", `${name}: ${meaning}`);
            field.onchange = () => this.generate(entry.name, [...Object.entries({ ...given, [name]: Number(field.value) })]);
            row.append(label, field);
            return row;
        }));
    }

    chooseFile() {
        $("file").click();
    }

    gallery() {
        fill($("gallery-list"), this.catalog, (name) => {
            $("gallery").close();
            this.generate(name);
        });
        if (!$("gallery").open) $("gallery").showModal();
    }

    exports() {
        $("link").hidden = !this.generated;
        if (this.model) $("exports").showModal();
    }

    help() {
        $("help").showModal();
    }

    async export(format) {
        $("exports").close();
        if (format === "png") this.save(`${this.model.name.replace(/\.[^.]*$/, "")}.png`, await this.stage.png());
        else if (format === "link") this.link();
        else if (format === "save") this.ask({ do: "save" });
        else this.ask({ do: "export", format });
    }

    save(name, blob) {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(blob);
        link.download = name;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
        this.toast(`Saved ${name}`);
    }

    /** An address that opens what was generated, folded as it is asked to be now. */
    async link() {
        const { name, parameters } = this.generated;
        const wanted = new URLSearchParams({ pattern: name, percent: this.wishes.percent, ...Object.fromEntries(parameters) });
        const creases = Object.entries(this.wishes.creases).map(([edge, own]) => `${edge}:${own === "free" ? "free" : own.angle}`);
        if (creases.length) wanted.set("creases", creases.join(","));
        location.hash = wanted;
        const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
        this.toast(copied ? "The link is copied." : "The link is this page's address now.");
    }

    linked(wanted) {
        const { pattern, percent, creases, ...parameters } = Object.fromEntries(wanted);
        this.onopen = () => {
            for (const [edge, own] of (creases ?? "").split(",").filter(Boolean).map((entry) => entry.split(":")))
                this.ask({ do: "crease", edges: [Number(edge)], own: own === "free" ? "free" : { angle: Number(own) } });
            if (percent) this.fold(Number(percent));
        };
        this.generate(pattern, Object.entries(parameters).map(([name, value]) => [name, Number(value)]));
    }

    toast(text) {
        Object.assign($("toast"), { textContent: text, hidden: false });
        clearTimeout(this.toasting);
        this.toasting = setTimeout(() => ($("toast").hidden = true), Math.max(3000, 60 * text.length));
    }

    lose(text) {
        this.live = false;
        this.toast(text);
        $("state").textContent = "Gone";
    }

    buttons() {
        const click = (id, does) => ($(id).onclick = does);
        click("gallery-open", () => this.gallery());
        click("file-open", () => this.chooseFile());
        click("undo", () => this.ask({ do: "undo" }));
        click("redo", () => this.ask({ do: "redo" }));
        click("export-open", () => this.exports());
        click("help-open", () => this.help());
        click("play", () => this.foldOrUnfold());
        click("run", () => this.runOrPause());
        click("step", () => this.step());
        click("reset", () => this.reset());
        click("own-free", () => this.own("free"));
        click("own-back", () => this.own(null));
        click("alike", () => this.alike());
        click("choose-none", () => this.choose());
        click("unpin", () => (this.mark({}), Object.keys(this.wishes.pins).forEach((node) => this.release(Number(node)))));
        click("material-default", () => (this.mark("defaults"), this.soon("material", { do: "material", ...this.usual }), this.showMaterial(this.usual)));
        $("file").onchange = () => (this.openFile($("file").files[0]), ($("file").value = ""));
        $("percent").oninput = () => this.fold(Number($("percent").value));
        $("percent-number").onchange = () => this.fold(Number($("percent-number").value));
        $("own-slider").oninput = () => (($("own-angle").value = $("own-slider").value), this.own({ angle: Number($("own-slider").value) }));
        $("own-angle").onchange = () => this.own({ angle: Number($("own-angle").value) });
        $("show-faces").onchange = () => Object.assign(this.stage, { dirty: true, shown: { ...this.stage.shown, faces: $("show-faces").checked } });
        $("map").onchange = () => ((this.asked = true), this.ask({ do: "frame", map: $("map").value }));
        for (const key of ["name", "integrator", "precision", "tolerance"]) $(`solver-${key}`).onchange = () => this.solver();
        document.querySelectorAll("[data-view]").forEach((button) => (button.onclick = () => this.look(button.dataset.view)));
        document.querySelectorAll("[data-tool]").forEach((button) => (button.onclick = () => this.setTool(button.dataset.tool)));
        document.querySelectorAll("[data-export]").forEach((button) => (button.onclick = () => this.export(button.dataset.export)));
        document.querySelectorAll("#letters [data-letter]").forEach((button) => (button.onclick = () => {
            const shown = button.getAttribute("aria-pressed") !== "true";
            button.setAttribute("aria-pressed", shown);
            this.stage.shown[button.dataset.letter] = shown;
            this.stage.dirty = true;
        }));
        addEventListener("dragover", (event) => (event.preventDefault(), ($("drop").hidden = false)));
        addEventListener("dragleave", (event) => event.relatedTarget || ($("drop").hidden = true));
        addEventListener("drop", (event) => {
            event.preventDefault();
            $("drop").hidden = true;
            this.openFile(event.dataTransfer.files[0]);
        });
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (this.stage.restyle(), this.flat.restyle()));
        for (const map of $("map").options) map.textContent = MAPS[map.value].name.toLowerCase();
    }
}

let app;
const heard = (reply) => app.hear(reply);
const lost = (text) => app.lose(text);
try {
    const engine = KIND === "film" ? await filmEngine(heard, $("film").textContent) : (KIND === "worker" ? workerEngine : socketEngine)(heard, lost);
    app = window.origami = new App(engine);
} catch (error) {
    const box = document.getElementById("toast");
    Object.assign(box, { textContent: error.message, hidden: false });
    throw error;
}
