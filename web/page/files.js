// Files: what is opened, generated and saved, and links to what was generated.

import { fill } from "./gallery.js";
import { $ } from "./panel.js";

export class Files {
    constructor(app) {
        this.app = app;
        this.catalog = [];
    }

    /** All that can be generated. */
    known(entries) {
        this.catalog = entries;
        this.showParameters();
        if ($("gallery").open) this.gallery();
    }

    /** What is opened first: the file of the command line, what the address names, or the gallery. */
    async begin() {
        const wanted = new URLSearchParams(location.hash.slice(1));
        if (wanted.has("pattern")) return this.linked(wanted);
        const first = this.app.kind === "worker" ? undefined : await fetch("first").catch(() => undefined);
        if (first?.status === 200) return this.open(decodeURIComponent(first.headers.get("X-Name") ?? "pattern"), await first.arrayBuffer());
        this.generate("crane");
        this.gallery();
    }

    open(name, buffer) {
        const session = name.endsWith(".origami-session.json");
        this.generated = undefined;
        this.app.ask(session ? { do: "restore" } : { do: "open", name }, new Uint8Array(buffer));
    }

    async openFile(file) {
        if (file) this.open(file.name, await file.arrayBuffer());
    }

    generate(name, parameters = []) {
        this.generated = { name, parameters };
        this.app.ask({ do: "generate", name, parameters });
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
        if (this.app.model) $("exports").showModal();
    }

    async export(format) {
        $("exports").close();
        if (format === "png") this.save(`${this.app.model.name.replace(/\.[^.]*$/, "")}.png`, await this.app.stage.png());
        else if (format === "film") this.film();
        else if (format === "link") this.link();
        else if (format === "save") this.app.ask({ do: "save" });
        else this.app.ask({ do: "export", format });
    }

    /** A film of what was recorded; where nothing was, of the way to where the slider is, once that is there. */
    film() {
        const { recording } = this.app;
        const save = () => this.app.ask({ do: "film" });
        if (recording.now && !this.app.last.running) return save();
        this.app.toast("The film is being made.");
        recording.begin(false, save);
    }

    save(name, blob) {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(blob);
        link.download = name;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
        this.app.toast(`Saved ${name}`);
    }

    /** An address that opens what was generated, folded as it is asked to be now. */
    async link() {
        const { name, parameters } = this.generated;
        const wanted = new URLSearchParams({ pattern: name, percent: this.app.wishes.percent, ...Object.fromEntries(parameters) });
        const creases = Object.entries(this.app.wishes.creases).map(([edge, own]) => `${edge}:${own === "free" ? "free" : own.angle}`);
        if (creases.length) wanted.set("creases", creases.join(","));
        location.hash = wanted;
        const copied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
        this.app.toast(copied ? "The link is copied." : "The link is this page's address now.");
    }

    linked(wanted) {
        const { pattern, percent, creases, ...parameters } = Object.fromEntries(wanted);
        this.app.onopen = () => {
            for (const [edge, own] of (creases ?? "").split(",").filter(Boolean).map((entry) => entry.split(":")))
                this.app.ask({ do: "crease", edges: [Number(edge)], own: own === "free" ? "free" : { angle: Number(own) } });
            if (percent) this.app.fold(Number(percent));
        };
        this.generate(pattern, Object.entries(parameters).map(([name, value]) => [name, Number(value)]));
    }
}
