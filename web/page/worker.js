// The solver in a worker: moves the sheet in slices, and listens in between.

const SLICE = 8;
const channel = new MessageChannel();
const early = [];
let solver;
let steps = 8;
let due = false;

/** Hands on what the solver has to say. */
function tell() {
    for (let length; (length = solver.origami_next()); ) {
        const bytes = new Uint8Array(solver.memory.buffer, solver.origami_reply(), length).slice();
        postMessage(bytes.buffer, [bytes.buffer]);
    }
}

function again() {
    if (!due && solver.origami_has_work()) {
        due = true;
        channel.port2.postMessage(0);
    }
}

channel.port1.onmessage = () => {
    due = false;
    const begun = performance.now();
    solver.origami_advance(steps);
    const took = performance.now() - begun;
    steps = took > SLICE ? Math.max(1, steps >> 1) : took < SLICE / 2 ? Math.min(4096, 2 * steps) : steps;
    tell();
    again();
};

function listen({ data }) {
    const place = solver.origami_message(data.length);
    new Uint8Array(solver.memory.buffer, place, data.length).set(data);
    solver.origami_answer();
    tell();
    again();
}

onmessage = (event) => early.push(event);
const module = await (await fetch(new URL("./origami_web.wasm", import.meta.url))).arrayBuffer();
solver = (await WebAssembly.instantiate(module)).instance.exports;
onmessage = listen;
early.splice(0).forEach(listen);
