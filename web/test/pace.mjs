// How long one evaluation takes in a browser's engine, and in the program on one thread: node pace.mjs FOLDER, which `web/build` has made.
// Both fold the same Miura-ori by the same evaluations, the fastest of some times.

import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ROOT, run } from "./program.mjs";

const solver = (await WebAssembly.instantiate(await readFile(join(process.argv[2], "origami_web.wasm")))).instance.exports;
const { packed, unpacked } = await import(`file://${join(ROOT, "web/page/packet.js")}`);

function ask(request) {
    const bytes = packed(request, new Uint8Array());
    const place = solver.origami_message(bytes.length);
    new Uint8Array(solver.memory.buffer, place, bytes.length).set(bytes);
    solver.origami_answer();
    const length = solver.origami_next();
    return length && unpacked(new Uint8Array(solver.memory.buffer, solver.origami_reply(), length).slice().buffer).head;
}

const scratch = await mkdtemp(join(tmpdir(), "origami-pace-"));
const [file, folded, told] = ["miura.fold", "folded.fold", "report.json"].map((name) => join(scratch, name));
for (const [side, percent, times] of [[31, 60, 9], [99, 5, 3]]) {
    ask({ do: "generate", name: "miura", parameters: [["columns", side], ["rows", side]] });
    await run("pattern", "miura", "--set", `columns=${side}`, "--set", `rows=${side}`, "-o", file);
    let [alone, program, steps] = [Infinity, Infinity];
    for (let i = 0; i < times; i++) {
        ask({ do: "record", way: { percent }, contact: false, parts: 1 });
        const begun = performance.now();
        solver.origami_advance(1);
        const took = performance.now() - begun;
        ({ steps } = ask({ do: "frame" }));
        alone = Math.min(alone, took / steps);
        const said = await run("fold", file, "--percent", `${percent}`, "--threads", "1", "-o", folded, "--report", told);
        if (said.code) throw new Error(said.err);
        const report = JSON.parse(await readFile(told, "utf8"));
        const { solve } = [report].flat()[0].seconds;
        program = Math.min(program, (1000 * solve) / steps);
    }
    const of = (ms) => `${(1000 * ms).toFixed(0)} µs`;
    console.log(`${(side + 1) ** 2} vertices, ${steps} evaluations: ${of(alone)} alone, ${of(program)} by the program: ${(alone / program).toFixed(2)} times as long`);
}
await rm(scratch, { recursive: true });
