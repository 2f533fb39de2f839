// The solver in a worker: moves the sheet in slices, and listens in between.

import start, { WebSession } from "./origami_web.js";

const SLICE = 8;
const channel = new MessageChannel();
const early = [];
let session;
let steps = 8;
let due = false;

const give = (bytes) => bytes && postMessage(bytes.buffer, [bytes.buffer]);

function again() {
    if (!due && session.has_work()) {
        due = true;
        channel.port2.postMessage(0);
    }
}

channel.port1.onmessage = () => {
    due = false;
    const begun = performance.now();
    session.advance(steps);
    const took = performance.now() - begun;
    steps = took > SLICE ? Math.max(1, steps >> 1) : took < SLICE / 2 ? Math.min(4096, 2 * steps) : steps;
    give(session.take_frame());
    again();
};

function listen(event) {
    for (const reply of session.answer(event.data)) give(reply);
    give(session.take_frame());
    again();
}

onmessage = (event) => early.push(event);
await start();
session = new WebSession();
onmessage = listen;
early.splice(0).forEach(listen);
