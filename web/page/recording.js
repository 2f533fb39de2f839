// What was recorded: the steps of a file, or the way to an angle, to be played, gone through step by step, and saved as a film.

import { $ } from "./panel.js";

/** States that are kept of each step, and of the way to a percentage. */
const PARTS = { step: 12, way: 30 };
/** States that are shown in a second. */
const SPEED = 14;

export class Recording {
    constructor(app) {
        this.app = app;
        this.steps = [];
        const click = (id, does) => ($(id).onclick = does);
        click("recording-play", () => this.play());
        click("recording-back", () => this.go(-1));
        click("recording-on", () => this.go(1));
        click("recording-end", () => app.ask({ do: "live" }));
        click("contact", () => this.begin(true));
        $("recording-at").oninput = () => this.show(Number($("recording-at").value));
    }

    /** Another pattern. */
    opened(steps) {
        Object.assign(this, { steps, now: undefined, playing: false });
        $("contact").textContent = steps.length ? "Fold the steps without crossing" : "Fold without crossing";
        $("recording-steps").replaceChildren(...steps.map((name, step) => {
            const button = Object.assign(document.createElement("button"), { textContent: `${step + 1}. ${name}` });
            button.onclick = () => this.toStep(step + 1);
            return button;
        }));
        this.draw();
    }

    /** Records: the steps of the file where it has any, else the way to where the slider is. */
    begin(contact, then) {
        const { app, steps } = this;
        if (!app.wishes) return;
        const percent = app.wishes.percent || 100;
        const way = steps.length ? { way: "steps", parts: PARTS.step } : { way: { percent }, parts: PARTS.way };
        app.ask({ do: "record", contact, ...way });
        app.paused = false;
        app.showRun();
        $("hint").hidden = true;
        Object.assign(this, { at: 0, playing: true, then, waits: true });
    }

    play() {
        if (!this.now) return this.begin(false);
        this.playing = !this.playing;
        if (this.playing && this.at >= this.last()) this.at = 0;
        this.draw();
    }

    /** Shows a state, and stops there. */
    show(at) {
        this.playing = false;
        this.at = Math.max(0, Math.min(this.last(), at));
        this.app.soon("show", { do: "show", at: this.at });
        this.draw();
    }

    /** One step, or one state where there are no steps, on or back. */
    go(by) {
        if (!this.now) return by > 0 && this.begin(false);
        const whole = this.length();
        this.show((by > 0 ? Math.floor(this.at / whole + 1e-6) + 1 : Math.ceil(this.at / whole - 1e-6) - 1) * whole);
    }

    /** To the end of a step, which is folded first where it has not been. */
    toStep(step) {
        if (!this.now) this.begin(false);
        Object.assign(this, { until: step * PARTS.step, playing: true });
        if (this.at > this.until) this.at = Math.max(0, this.until - PARTS.step);
    }

    length() {
        return this.steps.length ? PARTS.step : 1;
    }

    last() {
        return (this.now?.states ?? 1) - 1;
    }

    /** A picture has come, of a recording or of the sheet itself. */
    frame(head) {
        const { recorded } = head;
        if (recorded) this.waits = false;
        else if (this.waits) return;
        this.now = recorded ?? undefined;
        if (!recorded) this.playing = false;
        else if (!head.running && this.then) {
            this.then();
            this.then = undefined;
        }
        this.draw();
    }

    /** Once for each picture: what plays goes on, as far as it has come. */
    tick() {
        const now = performance.now();
        const seconds = Math.min(0.1, (now - (this.ticked ?? now)) / 1000);
        this.ticked = now;
        if (!this.playing || !this.now) return;
        const end = Math.min(this.until ?? Infinity, this.now.ended ? this.last() : this.now.of - 1);
        this.at = Math.min(this.at + seconds * SPEED, end, this.last());
        if (this.at >= end) [this.playing, this.until] = [false, undefined];
        this.app.soon("show", { do: "show", at: this.at });
    }

    draw() {
        const { now, steps, app } = this;
        // A film of a way has its percentages beside the slider already.
        $("recording").hidden = app.live ? !now && !steps.length : !now || now.label.endsWith("%");
        if ($("recording").hidden) return;
        const label = now?.label ?? (steps.length === 1 ? "1 step" : `${steps.length} steps`);
        if ($("recording-label").textContent !== label) $("recording-label").textContent = label;
        Object.assign($("recording-at"), { max: now ? now.of - 1 : 1, disabled: !now });
        $("recording-at").value = now ? now.at : 0;
        $("recording-end").hidden = !now || !app.live;
        $("recording-play").textContent = this.playing ? "❚❚" : "▶";
        $("recording-play").setAttribute("aria-label", this.playing ? "Stop" : "Play");
        const done = now ? Math.floor(now.at / PARTS.step + 1e-6) : 0;
        [...$("recording-steps").children].forEach((button, step) => button.setAttribute("aria-pressed", step < done));
    }
}
