// How soon the page answers the slider: ORIGAMI=program node latency.mjs [address of a published folder]
// DRAW=no leaves out the drawing, which a machine without a GPU does on the cores that fold.
// Vertices, then how long one picture is drawn, milliseconds from the slider to the first picture that has moved, and pictures in a second
// while it moves.

import { browser, open, slide, view } from "./program.mjs";

const site = process.argv[2];
const chrome = await browser();
for (const side of site ? [32] : [32, 100]) {
    const started = site ? { address: site, stop() {} } : await view();
    const page = await open(chrome, started.address);
    await page.evaluate((draws) => {
        document.getElementById("gallery").close();
        if (!draws) origami.stage.draw = () => false;
    }, process.env.DRAW !== "no");
    await page.evaluate((side) => origami.files.generate("miura", [["columns", side - 1], ["rows", side - 1]]), side);
    await page.waitForFunction((side) => origami.model.nodes === side * side && origami.last.settled, side, { timeout: 120_000 });
    // The least of some, until the last pixel is there.
    const drawn = await page.evaluate(() => {
        const { stage } = origami;
        const { gl } = stage.painter;
        let least = Infinity;
        for (let i = 0; i < 15; i++) {
            const begun = performance.now();
            stage.dirty = true;
            stage.draw();
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
            least = Math.min(least, performance.now() - begun);
        }
        return least;
    });
    const times = [];
    let frames = 0;
    for (let i = 1; i <= 10; i++) {
        const [ms, count] = await page.evaluate((percent) => new Promise((resolve) => {
            const before = origami.model.points.slice();
            const begun = performance.now();
            let [moved, seen] = [0, 0];
            const slider = document.getElementById("percent");
            slider.value = percent;
            slider.dispatchEvent(new Event("input"));
            const look = () => {
                seen++;
                if (!moved && origami.model.points.some((x, i) => i % 4 < 3 && x !== before[i])) moved = performance.now() - begun;
                performance.now() - begun < 1000 ? requestAnimationFrame(look) : resolve([moved, seen]);
            };
            requestAnimationFrame(look);
        }), 3 * i);
        times.push(ms);
        frames += count;
    }
    times.sort((a, b) => a - b);
    console.log(`${side * side} vertices: drawn in ${drawn.toFixed(0)} ms; ${times.map((ms) => ms.toFixed(0)).join(" ")} ms; ${(frames / 10).toFixed(0)} pictures a second`);
    await page.close();
    started.stop();
}
await chrome.close();
