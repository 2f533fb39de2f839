// The page in a real browser; `web/check` runs this.

import assert from "node:assert/strict";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import net from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { browser, nodeAt, open, publish, run, saved, settled, slide, stopAll, view } from "./program.mjs";

const patterns = join(process.env.ORIGAMI_ROOT, "examples/patterns/");
const broken = join(process.env.ORIGAMI_ROOT, "tests/broken/");
const shots = process.argv[2];
if (shots) await mkdir(shots, { recursive: true });
const scratch = await mkdtemp(join(tmpdir(), "origami-view-"));
const chrome = await browser();
const context = await chrome.newContext({ viewport: { width: 1000, height: 640 }, acceptDownloads: true });

/** The largest distance between the vertices of two FOLD files once one is laid on the other: pairs of distances tell. */
function apart(one, other) {
    const [a, b] = [one, other].map((text) => JSON.parse(text).vertices_coords);
    assert.equal(a.length, b.length);
    const far = (points, i, j) => Math.hypot(...points[i].map((x, k) => x - points[j][k]));
    let most = 0;
    for (let i = 0; i < a.length; i++) for (let j = 0; j < i; j++) most = Math.max(most, Math.abs(far(a, i, j) - far(b, i, j)));
    return most;
}

const shot = (page, name) => shots && page.screenshot({ path: join(shots, `${name}.png`) });

/** How many of the stage's pixels differ by more than a little between now and `old`. */
const pixels = (page) => page.evaluate(async () => {
    origami.stage.dirty = true;
    origami.stage.draw();
    const { gl, canvas } = origami.stage;
    const all = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, all);
    return [...all.filter((_, i) => i % 64 < 4)];
});
const differ = (one, other) => one.filter((value, i) => Math.abs(value - other[i]) > 12).length / one.length;

const tests = {
    async "folds to what the command line folds to, and saves the same files"() {
        const { address, stop } = await view(join(patterns, "miura.fold"));
        const page = await open(context, address);
        const flat = await pixels(page);
        await slide(page, 60);
        await settled(page, 60);
        const folded = await pixels(page);
        assert.ok(differ(flat, folded) > 0.02, "the picture has not changed");
        await shot(page, "miura");
        const mine = await saved(page, "fold");
        assert.equal(mine.name, "miura-folded.fold");
        await run("fold", join(patterns, "miura.fold"), "--percent", "60", "-o", join(scratch, "a.fold"), "-o", join(scratch, "a.obj"), "-o", join(scratch, "a.stl"));
        const theirs = await readFile(join(scratch, "a.fold"), "utf8");
        const distance = apart(mine.bytes.toString(), theirs);
        assert.ok(distance < 2e-3, `${distance}`);
        const keys = (text) => Object.keys(JSON.parse(text)).sort();
        assert.deepEqual(keys(mine.bytes.toString()), keys(theirs));
        for (const format of ["obj", "stl"]) {
            const [own, other] = [(await saved(page, format)).bytes, await readFile(join(scratch, `a.${format}`))];
            // As many lines, or bytes, of the same kinds.
            if (format === "stl") assert.equal(own.length, other.length);
            else assert.deepEqual(...[own, other].map((text) => text.toString().split("\n").map((line) => line.split(" ")[0])));
        }
        assert.equal((await saved(page, "glb")).bytes.subarray(0, 4).toString(), "glTF");
        assert.equal((await saved(page, "png")).bytes.subarray(1, 4).toString(), "PNG");
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "drags a vertex, pins it, and takes it back"() {
        const { address, stop } = await view(join(patterns, "bird-base.fold"));
        const page = await open(context, address);
        await slide(page, 40);
        await settled(page, 40);
        const before = await page.evaluate(() => [...origami.model.points]);
        const [x, y] = await nodeAt(page, 0);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 30, y + 60, { steps: 8 });
        await page.waitForFunction(([x, y, z]) => Math.hypot(origami.model.points[0] - x, origami.model.points[1] - y, origami.model.points[2] - z) > 0.1, before.slice(0, 3));
        await shot(page, "dragged");
        await page.keyboard.down("Shift");
        await page.mouse.up();
        await page.keyboard.up("Shift");
        const [px, py] = await nodeAt(page, 0);
        assert.ok(Math.hypot(px - x - 30, py - y - 60) < 6, `the vertex is at ${px} ${py}, the hand at ${x + 30} ${y + 60}`);
        const asked = await page.evaluate(() => Object.keys(origami.wishes.pins));
        assert.ok(asked.length <= 1);
        await page.click("#undo");
        await page.waitForFunction((before) => Math.max(...origami.model.points.map((p, i) => (i % 4 < 3 ? Math.abs(p - before[i]) : 0))) < 2e-3, before);
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "gives a crease an angle of its own, from either picture"() {
        const { address, stop } = await view(join(patterns, "single-crease.fold"));
        const page = await open(context, address);
        const edge = await page.evaluate(() => [...origami.model.letters].findIndex((letter) => letter === "M" || letter === "V"));
        const box = await page.locator("#flat").boundingBox();
        const [x, y] = await page.evaluate((edge) => {
            const at = origami.flat.place();
            const [a, b] = [at(origami.model.ends[2 * edge]), at(origami.model.ends[2 * edge + 1])];
            return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        }, edge);
        await page.mouse.click(box.x + x, box.y + y);
        assert.deepEqual(await page.evaluate(() => [...origami.selected]), [edge]);
        await page.fill("#own-angle", "70");
        await page.press("#own-angle", "Enter");
        await page.waitForFunction(() => origami.last.settled && origami.wishes.creases && origami.last.angle_error_max < 0.05 && origami.model.points.some((p, i) => i % 4 === 2 && Math.abs(p) > 0.05));
        const { bytes } = await saved(page, "fold");
        const angle = JSON.parse(bytes).edges_foldAngle[edge];
        assert.ok(Math.abs(angle - 70) < 0.1, `${angle}`);
        // The same crease on the sheet: a click beside it chooses nothing.
        const middle = await page.evaluate((edge) => {
            const { camera, model, canvas } = origami.stage;
            const ends = [0, 1].map((end) => [...camera.project(camera.matrix(), model.points, model.ends[2 * edge + end], [0, 0, 0])]);
            const box = canvas.getBoundingClientRect();
            return [box.x + (ends[0][0] + ends[1][0]) / 2, box.y + (ends[0][1] + ends[1][1]) / 2];
        }, edge);
        await page.mouse.click(middle[0] + 60, middle[1] + 40);
        assert.deepEqual(await page.evaluate(() => [...origami.selected]), []);
        await page.mouse.click(...middle);
        assert.deepEqual(await page.evaluate(() => [...origami.selected]), [edge]);
        await shot(page, "crease");
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "opens patterns of the gallery, and goes on where it was saved"() {
        const { address, stop } = await view();
        const page = await open(context, address);
        await page.waitForSelector("#gallery-list .card path", { state: "attached" });
        assert.equal(await page.locator("#gallery-list .card").count(), (await run("pattern", "--list")).out.match(/^[a-z]/gm).length);
        await shot(page, "gallery");
        await page.click("[data-pattern=waterbomb]");
        await page.waitForFunction(() => origami.model.name === "waterbomb.fold");
        await slide(page, 30);
        await settled(page, 30);
        const { name, bytes } = await saved(page, "save");
        await page.keyboard.press("g");
        await page.click("[data-pattern=crane]");
        await page.waitForFunction(() => origami.model.name === "crane.fold");
        await page.setInputFiles("#file", { name, mimeType: "application/json", buffer: bytes });
        await page.waitForFunction(() => origami.model.name === "waterbomb.fold" && origami.wishes.percent === 30);
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "tells of wrong files what the command line tells"() {
        const { address, stop } = await view();
        const page = await open(context, address);
        const { readdir } = await import("node:fs/promises");
        const files = (await readdir(broken)).filter((file) => file.endsWith(".fold")).slice(0, 24);
        let refused = 0;
        for (const file of files) {
            const told = (await run("fold", join(broken, file), "-o", join(scratch, "x.fold"))).err.trim();
            await page.evaluate(() => (document.getElementById("toast").textContent = ""));
            await page.setInputFiles("#file", join(broken, file));
            await page.waitForFunction((file) => document.getElementById("toast").textContent || origami.model.name === file, file);
            const seen = await page.textContent("#toast");
            // Some are odd rather than wrong, and only warned of; some are read, and do not fold.
            const expected = told.split("\n").find((line) => line.startsWith("error: "))?.slice(7).replace(broken, "");
            if (seen) assert.equal(seen, expected, file);
            refused += seen ? 1 : 0;
        }
        assert.ok(refused > 8, `${refused} of ${files.length} were refused`);
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "shows a film that one can turn, from one file"() {
        const file = join(scratch, "bird.html");
        const said = await run("fold", join(patterns, "bird-base.fold"), "--percent", "90", "--frames", "30", "-o", file, "-o", join(scratch, "bird.fold"));
        assert.equal(said.code, 0, said.err);
        const size = (await readFile(file)).length;
        const { vertices_coords: flat, file_frames: frames } = JSON.parse(await readFile(join(scratch, "bird.fold"), "utf8"));
        assert.ok(size < 400_000 + 8 * flat.length * frames.length, `${size} bytes`);
        const apart = await chrome.newContext({ viewport: { width: 1000, height: 700 }, offline: true });
        const page = await open(apart, `file://${file}`);
        await page.waitForFunction(() => origami.last.percent === 90);
        await shot(page, "film");
        const seen = await page.evaluate(() => [...origami.model.points]);
        const { vertices_coords: end } = frames.at(-1);
        const far = (at, i, j) => Math.hypot(...at(i).map((x, k) => x - at(j)[k]));
        // Distances within the sheet, in its radius; the film has its nodes in the order of the vertices.
        const radius = Math.max(...flat.map((p) => Math.hypot(...p.map((x, k) => x - (Math.max(...flat.map((q) => q[k])) + Math.min(...flat.map((q) => q[k]))) / 2))));
        for (let i = 1; i < end.length; i++) {
            const [film, fold] = [far((n) => seen.slice(4 * n, 4 * n + 3), i, 0), far((n) => end[n], i, 0) / radius];
            assert.ok(Math.abs(film - fold) < 1e-4, `vertex ${i}: ${film} ${fold}`);
        }
        await page.selectOption("#map", "strain");
        await slide(page, 45);
        await page.waitForFunction(() => origami.last.percent === 45 && origami.last.map === "strain");
        await shot(page, "film-strain");
        await page.keyboard.press("Space");
        await page.waitForFunction(() => origami.last.percent === 90);
        assert.deepEqual(page.wrong, []);
        await apart.close();
    },

    async "turns strangers away, and outlives floods and closed tabs"() {
        const { address, server, stop } = await view(join(patterns, "crane.fold"));
        const { host, pathname, port } = new URL(address);
        // A page of another origin, in the same browser.
        const stranger = await context.newPage();
        await stranger.goto("data:text/html,hello");
        const opened = await stranger.evaluate((url) => new Promise((resolve) => {
            const socket = new WebSocket(url);
            socket.onopen = () => resolve(true);
            socket.onerror = () => resolve(false);
        }), `ws://${host}${pathname}socket`);
        assert.equal(opened, false, "a page of another origin has opened the socket");
        await stranger.close();
        const asked = (text) => new Promise((resolve) => {
            const socket = net.connect(Number(port), "127.0.0.1", () => socket.end(text));
            let said = "";
            socket.on("data", (data) => (said += data)).on("close", () => resolve(said)).on("error", () => resolve(said));
        });
        const status = async (path, name) => (await asked(`GET ${path} HTTP/1.1\r\nHost: ${name}\r\n\r\n`)).split(" ")[1];
        assert.equal(await status(pathname, host), "200");
        assert.equal(await status(pathname, `example.org:${port}`), "421");
        assert.equal(await status("/", host), "404");
        assert.equal(await status(`${pathname.slice(0, -2)}${pathname.at(-2) === "0" ? 1 : 0}/`, host), "404");
        assert.equal(await status(`${pathname}socket`, host), "403");
        assert.equal(await status(`${pathname}../../Cargo.toml`, host), "404");
        // Tabs that are closed in the middle of it, one of them after a flood that it never hears the answers of.
        for (let i = 0; i < 3; i++) {
            const page = await open(context, address);
            await slide(page, 90);
            await page.evaluate(() => {
                for (let i = 0; i < 400; i++) origami.ask({ do: "save" }), origami.ask({ do: "nonsense", i });
            });
            await page.close();
        }
        const page = await open(context, address);
        await slide(page, 20);
        await settled(page, 20);
        await page.waitForTimeout(1500);
        const { readFileSync } = await import("node:fs");
        const threads = Number(/Threads:\s+(\d+)/.exec(readFileSync(`/proc/${server.pid}/status`, "utf8"))[1]);
        assert.ok(threads < 12, `${threads} threads are left`);
        await page.close();
        stop();
    },

    async "does the same for long and keeps nothing"() {
        // SOAK=3600 is an hour.
        const until = performance.now() + 1000 * Number(process.env.SOAK ?? 4);
        const { address, server, stop } = await view(join(patterns, "miura.fold"));
        const memory = async () => Number(/VmRSS:\s+(\d+)/.exec(await readFile(`/proc/${server.pid}/status`, "utf8"))[1]) / 1024;
        let first;
        for (let round = 0; round < 3 || performance.now() < until; round++) {
            const page = await open(context, address);
            for (const percent of [70, -40, 20]) {
                await slide(page, percent);
                await page.evaluate(() => (origami.grab(5), origami.ask({ do: "material", k_fold: 2 }), origami.drag(5, [0, 0, 0.5])));
                await page.waitForTimeout(150);
                await page.evaluate(() => (origami.release(5), origami.ask({ do: "undo" }), origami.ask({ do: "save" })));
            }
            await page.waitForFunction(() => origami.last.frame > 5);
            assert.deepEqual(page.wrong, []);
            await page.close();
            first ??= await memory();
        }
        const grown = (await memory()) - first;
        assert.ok(grown < 60, `${grown} MB more than after the first round`);
        stop();
    },

    async "is whole at 360 pixels, in the dark, and by keys alone"() {
        const { address, stop } = await view(join(patterns, "square-twist.fold"));
        const narrow = await chrome.newContext({ viewport: { width: 360, height: 740 }, colorScheme: "dark", hasTouch: true });
        const page = await open(narrow, address);
        await page.keyboard.press("Space");
        await settled(page, 100);
        await shot(page, "narrow-dark");
        const wide = await page.evaluate(() => document.documentElement.scrollWidth);
        assert.ok(wide <= 360, `${wide} pixels wide`);
        await page.keyboard.press("]");
        assert.match(await page.textContent("#crease-name"), /edge \d+, (mountain|valley|flat)/);
        const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas")].filter((element) =>
            !(element.textContent.trim() || element.getAttribute("aria-label") || element.closest("label"))).map((element) => element.outerHTML));
        assert.deepEqual(nameless, []);
        assert.deepEqual(page.wrong, []);
        await narrow.close();
        stop();
    },
};

// The folder that `web/build` has made.
if (process.env.SITE) tests["folds in a browser alone, without a program"] = async () => {
    const { address, stop } = await publish(process.env.SITE);
    const page = await open(context, address);
    await page.keyboard.press("Escape");
    await page.setInputFiles("#file", join(patterns, "miura.fold"));
    await page.waitForFunction(() => origami.model.name === "miura.fold");
    await slide(page, 60);
    await settled(page, 60);
    await shot(page, "alone");
    const mine = await saved(page, "fold");
    await run("fold", join(patterns, "miura.fold"), "--percent", "60", "-o", join(scratch, "b.fold"));
    const distance = apart(mine.bytes.toString(), await readFile(join(scratch, "b.fold"), "utf8"));
    assert.ok(distance < 2e-3, `${distance}`);
    const [x, y] = await nodeAt(page, 0);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 40, y + 30, { steps: 5 });
    await page.waitForFunction(() => Object.keys(origami.wishes.pins).length === 1);
    await page.mouse.up();
    await page.keyboard.press("]");
    await page.fill("#own-angle", "20");
    await page.press("#own-angle", "Enter");
    await page.waitForFunction(() => Object.keys(origami.wishes.creases).length === 1 && origami.last.settled);
    await page.setInputFiles("#file", join(broken, "edge-out-of-range.fold"));
    await page.waitForFunction(() => document.getElementById("toast").textContent.includes("edge-out-of-range.fold: "));
    assert.deepEqual(page.wrong, []);
    await page.close();
    stop();
};

const only = process.env.ONLY;
let failed = 0;
for (const [name, test] of Object.entries(tests).filter(([name]) => !only || name.includes(only))) {
    const begun = performance.now();
    try {
        await test();
        console.log(`ok      ${name} (${((performance.now() - begun) / 1000).toFixed(1)} s)`);
    } catch (error) {
        failed++;
        console.log(`FAILED  ${name}\n${error.stack}`);
    }
    // What a test that failed has left.
    await Promise.all(chrome.contexts().flatMap((context) => context.pages()).map((page) => page.close()));
    stopAll();
}
await chrome.close();
await rm(scratch, { recursive: true, force: true });
process.exit(failed ? 1 : 0);
