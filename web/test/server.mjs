// The program behind the page: who may ask it, and what it outlives.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import net from "node:net";
import { join } from "node:path";
import { open, patterns, settled, slide, view } from "./program.mjs";

export const server = ({ context }) => ({
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
        const threads = Number(/Threads:\s+(\d+)/.exec(await readFile(`/proc/${server.pid}/status`, "utf8"))[1]);
        assert.ok(threads < 12, `${threads} threads are left`);
        await page.close();
        stop();
    },

    async "does the same for long and keeps nothing"() {
        // SOAK=3600 is an hour.
        const until = performance.now() + 1000 * Number(process.env.SOAK ?? 4);
        const { address, server, stop } = await view(join(patterns, "miura.fold"));
        const memory = async () => Number(/VmRSS:\s+(\d+)/.exec(await readFile(`/proc/${server.pid}/status`, "utf8"))[1]) / 1024;
        let [first, rounds] = [undefined, 0];
        // One page stays, others come and go.
        const stays = await open(context, address);
        const heap = async () => {
            const session = await context.newCDPSession(stays);
            await session.send("HeapProfiler.collectGarbage");
            const { usedSize } = await session.send("Runtime.getHeapUsage");
            await session.detach();
            return usedSize / 2 ** 20;
        };
        for (; rounds < 3 || performance.now() < until; rounds++) {
            const page = await open(context, address);
            for (const percent of [70, -40, 20]) {
                await slide(page, percent);
                await page.evaluate(() => (origami.grab(5), origami.ask({ do: "material", k_fold: 2 }), origami.drag(5, [0, 0, 0.5])));
                await page.waitForTimeout(150);
                await page.evaluate(() => (origami.release(5), origami.ask({ do: "undo" }), origami.ask({ do: "save" })));
            }
            await page.waitForFunction(() => origami.last.frame > 5);
            await page.close();
            await stays.bringToFront();
            await stays.evaluate(() => origami.ask({ do: "live" }));
            await slide(stays, rounds % 2 ? 60 : -60);
            await stays.evaluate(() => origami.recording.begin(false));
            await stays.waitForFunction(() => origami.last.recorded);
            assert.deepEqual([...page.wrong, ...stays.wrong], []);
            const now = { program: await memory(), page: await heap() };
            first ??= now;
            if (process.env.SOAK && rounds % 50 === 49) console.log(`        round ${rounds + 1}: program ${now.program.toFixed(1)} MB, page ${now.page.toFixed(1)} MB`);
        }
        const last = { program: await memory(), page: await heap() };
        const told = Object.keys(last).map((whose) => `${whose} ${first[whose].toFixed(1)} to ${last[whose].toFixed(1)} MB`);
        if (process.env.SOAK) console.log(`        ${rounds} rounds: ${told.join(", ")}`);
        assert.ok(last.program - first.program < 60 && last.page - first.page < 20, told.join(", "));
        await stays.close();
        stop();
    },

    async "sleeps and wakes: the program, and the page when nobody looks"() {
        const { address, server, stop } = await view(join(patterns, "miura.fold"));
        const page = await open(context, address);
        server.kill("SIGSTOP");
        await slide(page, 40);
        const asleep = await page.evaluate(() => origami.last.frame);
        await page.waitForTimeout(1000);
        assert.ok((await page.evaluate(() => origami.last.frame)) - asleep <= 1, "who sleeps sends pictures");
        server.kill("SIGCONT");
        await settled(page, 40);
        await page.evaluate(() => Object.defineProperty(document, "hidden", { value: true, configurable: true }));
        const before = await page.evaluate(() => origami.last.frame);
        await slide(page, -40);
        await page.waitForTimeout(500);
        const after = await page.evaluate(() => origami.last.frame);
        // One may have been asked for before.
        assert.ok(after - before <= 1, `${after - before} pictures for a page that nobody sees`);
        await page.evaluate(() => delete document.hidden);
        await settled(page, -40);
        assert.deepEqual(page.wrong, []);
        await page.close();
        stop();
    },
});
