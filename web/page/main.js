// The page begins: what folds is found, and all the rest is made around it.

import { App } from "./app.js";
import { filmEngine, socketEngine, workerEngine } from "./engine.js";

/** What folds: a program behind a socket, a worker, or nobody, in a film. */
const KIND = document.documentElement.dataset.engine ?? "socket";

let app;
const heard = (reply) => app.hear(reply);
const lost = (text) => app.lose(text);
try {
    const engine = KIND === "film" ? await filmEngine(heard, $("film").textContent) : (KIND === "worker" ? workerEngine : socketEngine)(heard, lost);
    app = window.origami = new App(engine, KIND);
} catch (error) {
    const box = document.getElementById("toast");
    Object.assign(box, { textContent: error.message, hidden: false });
    throw error;
}
