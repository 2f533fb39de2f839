// What folds behind the page, in each of the two ways there are: by `origami view`, and in the browser alone.

import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { basename, join } from "node:path";
import { apart, differ, different, drawn, FEW, isKept, pixels } from "./compare.mjs";
import { broken, nodeAt, open, patterns, publish, run, saved, sequences, settled, slide, view } from "./program.mjs";

/** A page with a file open, and what ends what is behind it. */
export const behind = {
    async "with a program"(context, file) {
        const { address, stop } = await view(file);
        return { page: await open(context, address), stop };
    },
    async "in a browser alone"(context, file) {
        const { address, stop } = await publish(process.env.SITE);
        const page = await open(context, address);
        await page.keyboard.press("Escape");
        await page.setInputFiles("#file", file);
        await page.waitForFunction((name) => origami.model.name === name, basename(file));
        return { page, stop };
    },
};

/** The tests, with `begin` as one of those. */
export const engine = (begin, { context, chrome, scratch, shot }) => ({
    async "folds to what the command line folds to, and saves the same files"() {
        const { page, stop } = await begin(context, join(patterns, "miura.fold"));
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
        const { page, stop } = await begin(context, join(patterns, "bird-base.fold"));
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
        const { page, stop } = await begin(context, join(patterns, "single-crease.fold"));
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

    async "goes through the steps of a file, forth and back"() {
        const file = join(sequences, "letter-fold.fold");
        const { page, stop } = await begin(context, file);
        assert.deepEqual(await page.locator("#recording-steps button").allTextContents(), ["1. left third over", "2. right third over it"]);
        await page.click("#recording-steps button:first-child");
        await page.waitForFunction(() => origami.last.recorded?.at === 12 && !origami.recording.playing);
        assert.equal(await page.textContent("#recording-label"), "left third over");
        await page.keyboard.press(".");
        await page.waitForFunction(() => origami.last.recorded.at === 24 && origami.last.crossings);
        await shot(page, "steps");
        const mine = (await saved(page, "fold")).bytes.toString();
        await run("fold", file, "--sequence", "own", "--frames", "12", "-o", join(scratch, "letter.fold"));
        const theirs = JSON.parse(await readFile(join(scratch, "letter.fold"), "utf8"));
        const distance = apart(mine, JSON.stringify(theirs.file_frames.at(-1)));
        assert.ok(distance < 1e-6, `${distance}`);
        await page.click("#recording-back");
        await page.waitForFunction(() => origami.last.recorded.at === 12);
        await page.click("#recording-end");
        await page.waitForFunction(() => !origami.last.recorded);
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "says where paper goes through paper, and folds without that"() {
        const { page, stop } = await begin(context, join(sequences, "letter-fold.fold"));
        await page.evaluate(() => origami.ask({ do: "record", way: { percent: 100 }, contact: false, parts: 20 }));
        await page.waitForFunction(() => origami.last.recorded?.states === 21 && !origami.last.running);
        await page.evaluate(() => origami.recording.show(19));
        await page.waitForFunction(() => origami.last.recorded.at === 19 && origami.last.crossings?.count > 0);
        assert.match(await page.textContent("#crossings"), /^[1-9]\d*, [\d.e −]+ % deep$/);
        await page.click("#crossed summary");
        await page.hover("#crossed-list li");
        await page.waitForFunction(() => origami.stage.crossed);
        await shot(page, "crossed");
        await page.click("#contact");
        await page.waitForFunction(() => origami.last.recorded && !origami.last.running && !origami.recording.waits && !origami.recording.playing && origami.last.recorded.at > 20);
        assert.equal(await page.textContent("#crossings"), "none");
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },

    async "makes a film of where the slider is"() {
        const { page, stop } = await begin(context, join(patterns, "bird-base.fold"));
        await slide(page, 70);
        await settled(page, 70);
        const { name, bytes } = await saved(page, "film");
        assert.equal(name, "bird-base.html");
        const file = join(scratch, "from-the-page.html");
        await writeFile(file, bytes);
        const film = await open(context, `file://${file}`);
        await film.waitForFunction(() => origami.last.percent === 70);
        assert.deepEqual([...page.wrong, ...film.wrong], []);
        await film.close();
        await page.close();
        stop();
    },

    async "draws what it has drawn before"() {
        for (const [name, file, way, map, dark] of [
            ["miura", join(patterns, "miura.fold"), { percent: 60 }, "none", false],
            ["bird-strain", join(patterns, "bird-base.fold"), { percent: 80 }, "strain", true],
            ["crane-base", join(sequences, "crane-base.fold"), "steps", "none", false],
        ]) {
            const themed = await chrome.newContext({ viewport: { width: 1000, height: 640 }, colorScheme: dark ? "dark" : "light" });
            const { page, stop } = await begin(themed, file);
            // What is recorded is the same each time; what a hand does comes at some time or other.
            await page.evaluate((way) => origami.ask({ do: "record", way, contact: false, parts: 2 }), way);
            await page.waitForFunction(() => origami.last.recorded && !origami.last.running && origami.last.recorded.at === origami.last.recorded.of - 1);
            // At the end of its steps a sheet is flat, and nothing of it is seen from the edge.
            const at = await page.evaluate((steps) => origami.last.recorded.of - (steps ? 2 : 1), way === "steps");
            await page.evaluate((at) => origami.recording.show(at), at);
            await page.waitForFunction((at) => origami.last.recorded.at === at, at);
            await page.selectOption("#map", map);
            await page.waitForFunction((map) => origami.last.map === map, map);
            const png = await drawn(page);
            await isKept(page, name, png);
            if (way === "steps") await isKept(page, `${name}-flat`, await drawn(page, "flat"));
            // The comparison can fail: the state before is another picture.
            await page.evaluate((at) => origami.recording.show(at - 1), at);
            await page.waitForFunction((at) => origami.last.recorded.at === at - 1, at);
            const share = await different(page, png, await drawn(page));
            assert.ok(share > 4 * FEW, `${share}`);
            await themed.close();
            stop();
        }
    },

    async "tells of a wrong file, and goes on"() {
        const { page, stop } = await begin(context, join(patterns, "miura.fold"));
        await page.setInputFiles("#file", join(broken, "edge-out-of-range.fold"));
        await page.waitForFunction(() => document.getElementById("toast").textContent.includes("edge-out-of-range.fold: "));
        await slide(page, 20);
        await settled(page, 20);
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },
});
