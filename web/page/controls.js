// Buttons and fields: what is done when they are used.

import { MAPS } from "./colours.js";
import { $ } from "./panel.js";

/** Wires all of them. */
export function controls(app) {
    const click = (id, does) => ($(id).onclick = does);
    click("gallery-open", () => app.files.gallery());
    click("file-open", () => app.files.chooseFile());
    click("undo", () => app.ask({ do: "undo" }));
    click("redo", () => app.ask({ do: "redo" }));
    click("export-open", () => app.files.exports());
    click("help-open", () => app.help());
    click("play", () => app.foldOrUnfold());
    click("run", () => app.runOrPause());
    click("step", () => app.step());
    click("reset", () => app.reset());
    click("own-free", () => app.own("free"));
    click("own-back", () => app.own(null));
    click("alike", () => app.alike());
    click("choose-none", () => app.choose());
    click("unpin", () => (app.mark({}), Object.keys(app.wishes.pins).forEach((node) => app.release(Number(node)))));
    click("material-default", () => (app.mark("defaults"), app.soon("material", { do: "material", ...app.usual }), app.showMaterial(app.usual)));
    $("file").onchange = () => (app.files.openFile($("file").files[0]), ($("file").value = ""));
    $("percent").oninput = () => app.fold(Number($("percent").value));
    $("percent-number").onchange = () => app.fold(Number($("percent-number").value));
    $("own-slider").oninput = () => (($("own-angle").value = $("own-slider").value), app.own({ angle: Number($("own-slider").value) }));
    $("own-angle").onchange = () => app.own({ angle: Number($("own-angle").value) });
    $("show-faces").onchange = () => Object.assign(app.stage, { dirty: true, shown: { ...app.stage.shown, faces: $("show-faces").checked } });
    $("map").onchange = () => ((app.asked = true), app.ask({ do: "frame", map: $("map").value }));
    for (const key of ["name", "integrator", "precision", "tolerance"]) $(`solver-${key}`).onchange = () => app.solver();
    document.querySelectorAll("[data-view]").forEach((button) => (button.onclick = () => app.look(button.dataset.view)));
    document.querySelectorAll("[data-tool]").forEach((button) => (button.onclick = () => app.setTool(button.dataset.tool)));
    document.querySelectorAll("[data-export]").forEach((button) => (button.onclick = () => app.files.export(button.dataset.export)));
    document.querySelectorAll("#letters [data-letter]").forEach((button) => (button.onclick = () => {
        const shown = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", shown);
        app.stage.shown[button.dataset.letter] = shown;
        app.stage.dirty = true;
    }));
    addEventListener("dragover", (event) => (event.preventDefault(), ($("drop").hidden = false)));
    addEventListener("dragleave", (event) => event.relatedTarget || ($("drop").hidden = true));
    addEventListener("drop", (event) => {
        event.preventDefault();
        $("drop").hidden = true;
        app.files.openFile(event.dataTransfer.files[0]);
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => (app.stage.restyle(), app.flat.restyle()));
    for (const map of $("map").options) map.textContent = MAPS[map.value].name.toLowerCase();
}
