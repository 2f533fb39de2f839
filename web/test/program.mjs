// The program under test, a browser, and a page in it.

import { spawn } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { basename, join } from "node:path";
import { createInterface } from "node:readline";
import { chromium } from "playwright-core";

export const ROOT = process.env.ORIGAMI_ROOT ?? join(import.meta.dirname, "../..");
export const patterns = join(ROOT, "examples/patterns/");
export const sequences = join(ROOT, "examples/sequences/");
export const broken = join(ROOT, "tests/broken/");
export const PROGRAM = process.env.ORIGAMI;
export const BROWSER = process.env.CHROMIUM ?? "/usr/bin/chromium";

const servers = new Set();

/** Ends all programs that are still there. */
export const stopAll = () => servers.forEach((server) => server.kill());

/** Starts `origami view`; `stop` ends it. */
export async function view(...args) {
    const server = spawn(PROGRAM, ["view", "--no-open", ...args], { stdio: ["ignore", "pipe", "inherit"] });
    servers.add(server);
    const address = await new Promise((resolve, reject) => {
        createInterface({ input: server.stdout }).once("line", resolve);
        server.once("exit", (code) => reject(new Error(`origami view ended with ${code}`)));
    });
    return { address, server, stop: () => server.kill() };
}

/** Serves a folder as any static server does. */
export function publish(folder) {
    const kinds = { html: "text/html", js: "text/javascript", css: "text/css", svg: "image/svg+xml", wasm: "application/wasm" };
    const server = createServer((request, answer) => {
        const name = request.url.slice(1).split(/[?#]/)[0] || "index.html";
        readFile(join(folder, basename(name))).then(
            (bytes) => answer.writeHead(200, { "Content-Type": kinds[name.split(".").pop()] }).end(bytes),
            () => answer.writeHead(404).end(),
        );
    });
    return new Promise((resolve) => server.listen(0, "127.0.0.1", () =>
        resolve({ address: `http://127.0.0.1:${server.address().port}/`, stop: () => server.close() })));
}

/** Runs the program to its end. */
export function run(...args) {
    return new Promise((resolve) => {
        const child = spawn(PROGRAM, args, { stdio: ["ignore", "pipe", "pipe"] });
        const said = { out: "", err: "" };
        child.stdout.on("data", (data) => (said.out += data));
        child.stderr.on("data", (data) => (said.err += data));
        child.on("exit", (code) => resolve({ code, ...said }));
    });
}

export const browser = () =>
    chromium.launch({ executablePath: BROWSER, args: ["--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader"] });

/** A page at an address, with a pattern open; what goes wrong in it is collected in `wrong`. */
export async function open(context, address) {
    const page = await context.newPage();
    page.wrong = [];
    page.on("console", (message) => message.type() === "error" && page.wrong.push(message.text()));
    page.on("pageerror", (error) => page.wrong.push(error.stack));
    await page.goto(address);
    await page.waitForFunction(() => window.origami?.model && window.origami.last);
    return page;
}

/** Waits until the sheet has settled at a percentage. */
export const settled = (page, percent) =>
    page.waitForFunction((percent) => origami.last?.settled && Math.abs(origami.last.percent - percent) < 1e-9 && !Object.keys(origami.pending).length, percent, { timeout: 60_000 });

/** Sets the slider as a hand does. */
export const slide = (page, percent) =>
    page.$eval("#percent", (slider, percent) => {
        slider.value = percent;
        slider.dispatchEvent(new Event("input"));
    }, percent);

/** What a button saves, as bytes. */
export async function saved(page, format) {
    await page.click("#export-open");
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`[data-export=${format}]`)]);
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    return { name: download.suggestedFilename(), bytes: Buffer.concat(chunks) };
}

/** Where a node is on the screen. */
export const nodeAt = (page, node) =>
    page.evaluate((node) => {
        const { camera, model, canvas } = origami.stage;
        const [x, y] = camera.project(camera.matrix(), model.points, node, [0, 0, 0]);
        const box = canvas.getBoundingClientRect();
        return [box.x + x, box.y + y];
    }, node);
