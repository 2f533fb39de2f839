// What stands beside the sheet: numbers, the crease that was chosen, material and solver, warnings.

import { MAPS, gradient } from "./colours.js";
import { described, LETTERS, number } from "./model.js";

export const $ = (id) => document.getElementById(id);

/** What the sheet is made of: names, what each turns, and how far its slider goes (powers of ten). */
export const MATERIAL = [
    ["ea", "Axial stiffness", "Higher: the paper stretches less, and takes more steps", 0, 4],
    ["k_fold", "Crease stiffness", "Higher: creases come nearer to their angles, and strain the paper more", -3, 2],
    ["k_facet", "Face stiffness", "Higher: faces stay flatter", -3, 2],
    ["k_face", "Shear stiffness", "Higher: corners of triangles keep their angles", -3, 2],
    ["collapse", "Against collapse", "Higher: triangles keep more of their area; 0: not at all", -4, 0],
    ["zeta", "Damping ratio", "For the motion: higher comes to rest sooner", -2, 1],
];

/** Makes the sliders of the material; `changed` gets all numbers, `begun` is called before the first change. */
export function material(list, begun, changed) {
    const inputs = {};
    const values = () => Object.fromEntries(MATERIAL.map(([key]) => [key, Number(inputs[key].number.value)]));
    list.replaceChildren(...MATERIAL.map(([key, name, turns, least, most]) => {
        const row = document.createElement("label");
        row.className = "row";
        row.title = turns;
        row.innerHTML = `<span></span><input type="range" step="0.01"><input type="number" step="any" min="0">`;
        const [label, slider, field] = row.children;
        label.textContent = name;
        Object.assign(slider, { min: least, max: most });
        slider.setAttribute("aria-label", `${name}, power of ten`);
        field.setAttribute("aria-label", `${name}. ${turns}`);
        slider.onpointerdown = begun;
        slider.oninput = () => {
            field.value = number(10 ** slider.value, 3).replace(" ", "");
            changed(values());
        };
        field.onchange = () => {
            begun();
            slider.value = Math.log10(Math.max(Number(field.value), 1e-9));
            changed(values());
        };
        inputs[key] = { slider, number: field };
        return row;
    }));
    return (material) => {
        for (const [key] of MATERIAL) {
            inputs[key].number.value = material[key];
            inputs[key].slider.value = Math.log10(Math.max(material[key], 1e-9));
        }
    };
}

/** How the sheet is, by the head of a frame. */
export function numbers(head) {
    const state = head.failed || head.recorded?.ended ? "failed" : head.settled ? "settled" : head.running ? "moving" : "paused";
    const words = { failed: head.failed ? "Stopped" : "Held up", settled: "Settled", moving: head.ramp < 1 ? "Folding" : "Settling", paused: "Paused" };
    const badge = $("state");
    if (badge.dataset.state !== state || badge.textContent !== words[state]) {
        badge.dataset.state = state;
        badge.textContent = words[state];
    }
    const told = {
        distance: head.distance === null ? "–" : `${number(100 * head.distance, 2)} %`,
        "strain-mean": `${number(100 * head.strain_mean, 2)} %`,
        "strain-max": `${number(100 * head.strain_max, 2)} %`,
        "angle-error": `${number(head.angle_error_max, 3)}°`,
        energy: number(head.energy, 3),
        steps: head.steps.toLocaleString("en"),
    };
    for (const [id, text] of Object.entries(told)) if ($(id).textContent !== text) $(id).textContent = text;
    const odd = [];
    if (head.failed) odd.push(head.failed);
    if (head.recorded?.ended) odd.push(head.recorded.ended);
    if (head.settled && head.lost_creases) odd.push(`${head.lost_creases} creases went astray: this is not the fold that was asked for. Reset, and fold in smaller steps.`);
    if (head.settled && head.crushed) odd.push(`${head.crushed} triangles are crushed to a line.`);
    if (head.settled && !odd.length && head.strain_max > 0.05) odd.push("Some paper is strained by more than 5\u00a0%: real paper would tear or bend here.");
    const list = $("told");
    if (list.dataset.said !== odd.join("\n")) {
        list.dataset.said = odd.join("\n");
        list.replaceChildren(...odd.map((text) => Object.assign(document.createElement("p"), { textContent: text })));
    }
    const { name, unit, factor } = MAPS[head.map];
    $("bar").hidden = head.map === "none";
    if (head.map !== "none") {
        $("bar-name").textContent = name;
        $("bar-most").textContent = `${number(factor * head.map_max, 2)}${unit}`;
        $("bar-colours").style.background = gradient();
    }
}

/** The creases that were chosen. */
export function chosen(app) {
    const { model, wishes, selected } = app;
    $("crease").hidden = !selected.size;
    $("crease-none").hidden = selected.size > 0;
    if (!selected.size) return;
    const edges = [...selected];
    const kinds = [...new Set(edges.map((edge) => LETTERS[model.letters[edge]] ?? "crease"))];
    $("crease-name").textContent = edges.length === 1 ? described(model, edges[0], wishes) : `${edges.length} creases: ${kinds.join(", ")}`;
    const own = edges.map((edge) => wishes.creases[edge]).find((own) => own?.angle !== undefined);
    const angle = own ? own.angle : model.angles[edges[0]] * wishes.percent / 100;
    if (document.activeElement !== $("own-angle") && document.activeElement !== $("own-slider")) {
        $("own-angle").value = $("own-slider").value = Number.isNaN(angle) ? 0 : Math.round(10 * angle) / 10;
    }
    const free = edges.every((edge) => wishes.creases[edge] === "free");
    $("own-free").setAttribute("aria-pressed", free);
    $("own-back").disabled = !edges.some((edge) => wishes.creases[edge]);
}

/** What is odd about the pattern; `at` is called with a note that is pointed at. */
export function warnings(notes, at) {
    $("warnings").hidden = !notes.length;
    $("warnings-count").textContent = notes.length;
    $("warnings-list").replaceChildren(...notes.map((note) => {
        const item = document.createElement("li");
        item.tabIndex = 0;
        item.textContent = note.text;
        item.onpointerenter = item.onfocus = () => at(note);
        item.onpointerleave = item.onblur = () => at();
        return item;
    }));
}
