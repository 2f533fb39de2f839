// The film of the page that the README begins with; `web/film` runs this: node film.mjs FILE

import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { apng } from "./apng.mjs";
import { browser, nodeAt, open, patterns, view } from "./program.mjs";

const SIZE = { width: 960, height: 600 };
const chrome = await browser();
const context = await chrome.newContext({ viewport: SIZE });
const { address, stop } = await view(join(patterns, "bird-base.fold"));
const page = await open(context, address);
// A pointer, which pictures of pages do not have.
await page.evaluate(() => {
    const dot = document.createElement("div");
    dot.style.cssText = "position: fixed; z-index: 99; width: 18px; height: 18px; margin: -9px; border-radius: 9px; border: 2px solid #e08a00; background: rgb(255 176 46 / 0.45); pointer-events: none; left: -40px";
    document.body.append(dot);
    addEventListener("pointermove", (event) => Object.assign(dot.style, { left: `${event.clientX}px`, top: `${event.clientY}px` }), true);
});
const helper = await context.newPage();
const frames = [];

/** One picture, as long as it is shown. */
async function take(milliseconds = 90) {
    await page.waitForTimeout(60);
    const png = (await page.screenshot()).toString("base64");
    const data = await helper.evaluate(async ([png, { width, height }]) => {
        const bytes = Uint8Array.from(atob(png), (digit) => digit.charCodeAt(0));
        const pen = new OffscreenCanvas(width, height).getContext("2d");
        pen.drawImage(await createImageBitmap(new Blob([bytes])), 0, 0);
        const { data } = pen.getImageData(0, 0, width, height);
        let text = "";
        for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
        return btoa(text);
    }, [png, SIZE]);
    frames.push({ ...SIZE, data: Buffer.from(data, "base64"), milliseconds });
}

/** The pointer goes somewhere, in so many pictures. */
async function go(x, y, count, { from } = {}) {
    const [x0, y0] = from ?? go.at;
    for (let i = 1; i <= count; i++) {
        const share = i / count;
        const eased = share * share * (3 - 2 * share);
        await page.mouse.move(x0 + (x - x0) * eased, y0 + (y - y0) * eased);
        await take();
    }
    go.at = [x, y];
}

const slider = await page.locator("#percent").boundingBox();
const along = (percent) => slider.x + 8 + ((percent + 100) / 200) * (slider.width - 16);
const level = slider.y + slider.height / 2;
await take(700);
await go(along(0), level, 5, { from: [560, 420] });
await page.mouse.down();
await go(along(66), level, 22);
await page.mouse.up();
await take(500);
await go(430, 380, 3);
await page.mouse.down();
await go(330, 360, 10);
await page.mouse.up();
await take(300);
const [x, y] = await nodeAt(page, 2);
await go(x, y, 4);
await page.mouse.down();
await go(x - 40, y - 60, 10);
await page.mouse.up();
for (let i = 0; i < 8; i++) await take();
await page.selectOption("#map", "strain");
await take(1600);
await page.selectOption("#map", "none");
await go(along(66), level, 4);
await page.mouse.down();
await go(along(0), level, 14);
await page.mouse.up();
const file = apng(frames);
await writeFile(process.argv[2], file);
console.log(`${process.argv[2]}: ${frames.length} pictures, ${file.length} bytes`);
await chrome.close();
stop();
