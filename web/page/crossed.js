// Where paper goes through paper: a number, and the faces, which are shown on the sheet when they are pointed at.

import { number } from "./model.js";
import { $ } from "./panel.js";

/** Depths below that are told as no more than that, in per cent of the radius: the tolerance of the solver. */
const LEAST = 0.01;

export class Crossed {
    constructor(stage) {
        this.stage = stage;
        this.faces = [];
        $("crossed").ontoggle = () => this.mark();
    }

    /** What a picture says of it: nothing while the sheet moves. */
    frame(crossings) {
        if (!crossings) {
            if (this.known) $("crossings").classList.add("old");
            return this.mark([]);
        }
        const { count, deepest, faces } = crossings;
        this.known = true;
        $("crossings").classList.remove("old");
        // Layers that lie in one plane but for the solver's tolerance cross by as little.
        const deep = 100 * deepest < LEAST ? `under ${LEAST}` : number(100 * deepest, 2);
        const text = count ? `${count}, ${deep} % deep` : "none";
        if ($("crossings").textContent !== text) $("crossings").textContent = text;
        const key = faces.join(" ");
        if (key !== this.key) {
            this.key = key;
            this.faces = faces;
            this.list();
        }
        this.mark();
    }

    /** Another pattern. */
    opened() {
        Object.assign(this, { known: false, key: undefined, faces: [] });
        $("crossings").textContent = "–";
        this.list();
        this.mark();
    }

    list() {
        $("crossed").hidden = !this.faces.length;
        $("crossed-count").textContent = this.faces.length;
        $("crossed-list").replaceChildren(...this.faces.map((pair) => {
            const item = document.createElement("li");
            item.tabIndex = 0;
            item.textContent = pair[0] === pair[1] ? `face ${pair[0]}, with itself` : `faces ${pair[0]} and ${pair[1]}`;
            item.onpointerenter = item.onfocus = () => this.mark([pair]);
            item.onpointerleave = item.onblur = () => this.mark();
            return item;
        }));
    }

    /** Shows pairs on the sheet; all of them while their list is open. */
    mark(pairs = $("crossed").open ? this.faces : []) {
        this.stage.cross(new Set(pairs.flat()));
    }
}
