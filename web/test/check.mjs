// The page in a real browser; `web/check` runs this.

import { mkdir, mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { behind, engine } from "./engines.mjs";
import { page } from "./page.mjs";
import { browser, stopAll } from "./program.mjs";
import { server } from "./server.mjs";

const shots = process.argv[2];
if (shots) await mkdir(shots, { recursive: true });
const scratch = await mkdtemp(join(tmpdir(), "origami-view-"));
const chrome = await browser();
const context = await chrome.newContext({ viewport: { width: 1000, height: 640 }, acceptDownloads: true });
let now = "";
const shot = (page, name) => shots && page.screenshot({ path: join(shots, `${now.replaceAll(" ", "-")}${name}.png`) });
const all = { chrome, context, scratch, shot };

const tests = { ...page(all), ...server(all) };
for (const [name, begin] of Object.entries(behind)) {
    if (begin === behind["in a browser alone"] && !process.env.SITE) continue;
    for (const [what, test] of Object.entries(engine(begin, all))) tests[`${name}: ${what}`] = test;
}

const only = process.env.ONLY;
let failed = 0;
for (const [name, test] of Object.entries(tests).filter(([name]) => !only || name.includes(only))) {
    const begun = performance.now();
    now = name.startsWith("in a browser alone") ? "alone " : "";
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
