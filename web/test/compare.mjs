// How alike two results are: folded sheets, files, pictures.

import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { ROOT } from "./program.mjs";

/** The largest difference between the distances of any two vertices in two FOLD files: wherever the sheets lie. */
export function apart(one, other) {
    const [a, b] = [one, other].map((text) => JSON.parse(text).vertices_coords);
    assert.equal(a.length, b.length);
    const far = (points, i, j) => Math.hypot(...points[i].map((x, k) => x - points[j][k]));
    let most = 0;
    for (let i = 0; i < a.length; i++) for (let j = 0; j < i; j++) most = Math.max(most, Math.abs(far(a, i, j) - far(b, i, j)));
    return most;
}

/** Some of the stage's pixels. */
export const pixels = (page) => page.evaluate(async () => {
    origami.stage.paint();
    const { canvas, painter: { gl } } = origami.stage;
    const all = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return [...all.filter((_, i) => i % 64 < 4)];
});

/** The share of them that differs by more than a little. */
export const differ = (one, other) => one.filter((value, i) => Math.abs(value - other[i]) > 12).length / one.length;

/**
 * The share of the pixels of two PNGs that differ by more than an eighth of the range in some colour. One program draws the same
 * bytes each time; edges of triangles may go to the next pixel where a processor rounds otherwise, which is less than FEW of a picture.
 */
export const different = (page, one, other) => page.evaluate(async (pngs) => {
    const [a, b] = await Promise.all(pngs.map(async (png) => {
        const bytes = Uint8Array.from(atob(png), (digit) => digit.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const pen = new OffscreenCanvas(image.width, image.height).getContext("2d");
        pen.drawImage(image, 0, 0);
        return pen.getImageData(0, 0, image.width, image.height);
    }));
    if (a.width !== b.width || a.height !== b.height) return 1;
    let count = 0;
    for (let i = 0; i < a.data.length; i += 4) count += [0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 32);
    return (4 * count) / a.data.length;
}, [one, other].map((bytes) => Buffer.from(bytes).toString("base64")));

/** What may differ: see `different`. */
export const FEW = 0.005;

const kept = join(ROOT, "web/test/shots/");

/**
 * The picture of a canvas of the page, as PNG, 320 by 240 pixels: no text is in it, which differs from machine to machine. Of the stage
 * what WebGL draws, or the `draft`.
 */
export async function drawn(page, view = "stage") {
    const png = await page.evaluate(async (view) => {
        const { stage, flat } = origami;
        const { canvas } = view === "flat" ? flat : stage;
        canvas.style.cssText = "position: fixed; inset: 0 auto auto 0; width: 320px; height: 240px";
        stage.fit();
        if (view === "stage") stage.paint();
        if (view === "draft") stage.draft.draw(stage.look(), stage.camera);
        if (view === "flat") flat.draw();
        const blob = await new Promise((resolve) => (view === "draft" ? stage.draft.canvas : canvas).toBlob(resolve, "image/png"));
        canvas.style.cssText = "";
        return [...new Uint8Array(await blob.arrayBuffer())];
    }, view);
    return Buffer.from(png);
}

/** Compares a picture with the one that is kept under a name, or keeps it where PICTURES=keep. */
export async function isKept(page, name, png) {
    const file = join(kept, `${name}.png`);
    if (process.env.PICTURES === "keep") return writeFile(file, png);
    const share = await different(page, png, await readFile(file));
    if (share > FEW) await writeFile(join(ROOT, "target", `${name}-differs.png`), png);
    assert.ok(share <= FEW, `${name}: ${(100 * share).toFixed(2)} % of the pixels differ; target/${name}-differs.png is what was drawn, PICTURES=keep keeps it`);
}
