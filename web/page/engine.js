// What folds: a program behind a socket, the solver in a worker, or a film. All of them take requests and give replies.

import { packed, unpacked } from "./packet.js";

/** The solver of `origami view`. `heard` gets each reply, `lost` is called once where the program is gone. */
export function socketEngine(heard, lost) {
    const address = new URL("socket", location.href);
    address.protocol = "ws:";
    address.hash = "";
    const socket = new WebSocket(address);
    socket.binaryType = "arraybuffer";
    const waiting = [];
    const send = (message) => (socket.readyState === WebSocket.OPEN ? socket.send(message) : waiting.push(message));
    socket.onopen = () => waiting.splice(0).forEach((message) => socket.send(message));
    socket.onmessage = (event) => heard(unpacked(event.data));
    socket.onclose = () => lost("The program behind this page has ended. Start `origami view` again.");
    return { live: true, ask: (request, body) => send(body ? packed(request, body) : JSON.stringify(request)) };
}

/** The solver compiled for browsers, in a worker of this page. */
export function workerEngine(heard, lost) {
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    worker.onmessage = (event) => heard(unpacked(event.data));
    worker.onerror = (event) => lost(`The solver has stopped: ${event.message || "it could not be loaded"}`);
    const none = new Uint8Array();
    return { live: true, ask: (request, body) => worker.postMessage(packed(request, body ?? none)) };
}

/** A film: states that were folded before, and what lies between them by going straight from one to the next. */
export async function filmEngine(heard, text) {
    const bytes = Uint8Array.from(atob(text), (digit) => digit.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    const { head, buffer, at } = unpacked(await new Response(stream).arrayBuffer());
    const { opened, frames, low, unit, strain } = head;
    const { nodes, triangles, edges } = opened;
    const numbers = 3 * nodes;
    let place = at + 4 * (numbers + 4 * triangles + 3 * edges);
    let [last, before] = [undefined, undefined];
    let strains = new Uint8Array(nodes);
    const states = frames.map(() => {
        const [least, most] = [0, 1].map((i) => new Uint8Array(buffer, place + i * numbers, numbers));
        const now = new Uint16Array(numbers);
        for (let i = 0; i < numbers; i++) {
            const zigzag = least[i] | (most[i] << 8);
            const expected = before ? 2 * last[i] - before[i] : last ? last[i] : i < 3 ? 0 : now[i - 3];
            now[i] = expected + ((zigzag >> 1) ^ -(zigzag & 1));
        }
        const differences = new Uint8Array(buffer, place + 2 * numbers, nodes);
        strains = strains.map((value, i) => value + differences[i]);
        place += 2 * numbers + nodes;
        [before, last] = [last, now];
        const points = new Float32Array(4 * nodes);
        for (let node = 0; node < nodes; node++) {
            for (let k = 0; k < 3; k++) points[4 * node + k] = low[k] + unit * now[3 * node + k];
            points[4 * node + 3] = (strains[node] / 255) * strain;
        }
        return points;
    });

    const [from, to] = [frames[0].percent, frames.at(-1).percent];
    let shown = to;
    let wanted = to;
    let due = true;
    let asked;
    /** The state at the percentage that is shown. */
    const frame = (map) => {
        const share = from === to ? 0 : ((shown - from) / (to - from)) * (frames.length - 1);
        const low = Math.min(Math.floor(share), Math.max(0, frames.length - 2));
        const [a, b, t] = [states[low], states[low + 1] ?? states[low], share - low];
        const points = a.map((x, i) => x + t * (b[i] - x));
        const nearest = frames[t < 0.5 || !states[low + 1] ? low : low + 1];
        const reply = { ...nearest, is: "frame", percent: shown, running: shown !== wanted, settled: nearest.settled && shown === wanted, crossings: share === low || share === low + 1 ? nearest.crossings : null };
        heard({ head: { ...reply, map, map_max: map === "strain" ? strain : 0 }, buffer: points.buffer, at: 0 });
    };
    const answer = () => {
        if (asked === undefined || !due) return;
        // The whole way takes four seconds.
        const step = Math.abs(to - from) / 240;
        shown += Math.max(-step, Math.min(step, wanted - shown));
        due = shown !== wanted;
        const map = asked;
        asked = undefined;
        frame(map);
    };
    const ask = (request) => {
        if (request.do === "frame") {
            due ||= asked === undefined && request.map !== ask.map;
            ask.map = asked = request.map;
        } else if (request.do === "fold") {
            wanted = Math.max(Math.min(from, to), Math.min(Math.max(from, to), request.percent));
            // A hand on the slider is followed at once.
            if (!request.slowly) shown = wanted;
            due = true;
        }
        queueMicrotask(answer);
    };
    const wishes = { ...opened.wishes, percent: shown };
    setTimeout(() => heard({ head: { ...opened, is: "opened", wishes }, buffer, at }));
    return { live: false, ask, from, to };
}
