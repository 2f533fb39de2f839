// The page itself: what can be opened, how it is at any size, and films.

import assert from "node:assert/strict";
import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { different, drawn } from "./compare.mjs";
import { broken, open, patterns, run, saved, settled, slide, view } from "./program.mjs";

export const page = ({ chrome, context, scratch, shot }) => ({
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

    async "draws a draft of what moves, and what stands still in full"() {
        const { address, stop } = await view(join(patterns, "miura.fold"));
        const page = await open(context, address);
        // What is to be seen after each refresh of the screen: the draft, or the picture by WebGL, which then is whole.
        await page.evaluate(() => {
            const { stage } = origami;
            window.seen = [];
            const look = () => (seen.push(stage.draft && !stage.draft.canvas.hidden ? "draft" : stage.fine ? "full" : "neither"), requestAnimationFrame(look));
            requestAnimationFrame(look);
        });
        const rest = () => page.waitForFunction(() => origami.last.settled && origami.stage.fine && (!origami.stage.draft || origami.stage.draft.canvas.hidden));
        await rest();
        await page.evaluate(() => (seen.length = 0));
        await slide(page, 60);
        await settled(page, 60);
        await rest();
        const { seen, software, ratio } = await page.evaluate(() => {
            const { canvas, draft } = origami.stage;
            return { seen, software: !!draft, ratio: canvas.width / canvas.clientWidth };
        });
        assert.equal(ratio, software ? 2 : 1);
        const turns = seen.filter((what, i) => i && what !== seen[i - 1]);
        assert.deepEqual(turns.slice(turns[0] === "draft" ? 1 : 0), software ? ["full"] : [], "it flickers");
        if (software) {
            const png = await drawn(page);
            const likeness = await different(page, png, await drawn(page, "draft"));
            assert.ok(likeness < 0.02, `${likeness}`);
            await slide(page, 20);
            await settled(page, 20);
            const other = await different(page, png, await drawn(page, "draft"));
            assert.ok(other > 0.04, `${other}`);
            // An eye within the sheet sees it by WebGL, and the draft goes on from where it is seen whole again.
            await page.evaluate(() => (origami.stage.camera.zoomBy(50), (origami.stage.dirty = true)));
            await page.waitForFunction(() => origami.stage.draft.canvas.hidden && origami.stage.fine);
        }
        assert.deepEqual(page.wrong, []);
        await page.close();
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
        const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select, canvas:not([aria-hidden])")].filter((element) =>
            !(element.textContent.trim() || element.getAttribute("aria-label") || element.closest("label"))).map((element) => element.outerHTML));
        assert.deepEqual(nameless, []);
        assert.deepEqual(page.wrong, []);
        await narrow.close();
        stop();
    },

});
