// Times an audit in Node and in Chromium beside the program, one after the other, five times: the medians of the time of a processor. Modules
// are loaded and warm, as in a page that stays open; the program starts each time.
//
//     TWINEDGE=… CHROMIUM=… MODULES=FOLDER/node_modules node bench.mjs FILE [LAYER]
//
// with esbuild and puppeteer-core in `MODULES`, as `tests/run` installs them. What is not named is not timed.

import { spawnSync } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { load } from "./package/sync.js";

const ROUNDS = 5;
const { CHROMIUM, MODULES, TWINEDGE } = process.env;
const [file, layer] = process.argv.slice(2);
const bytes = await readFile(file);
const module = await readFile(new URL("package/twinedge.wasm", import.meta.url));
const options = layer ? { layer } : {};

/** An audit in this process. Like the others it returns the time of a processor, in seconds. */
async function node() {
  const twinedge = await load(module);
  return () => {
    const before = process.cpuUsage();
    twinedge.audit({ name: file, bytes }, options);
    return process.cpuUsage(before).user / 1e6;
  };
}

/** An audit by the program. Python tells the time of a process that has ended. */
async function program() {
  const script = 'import os, subprocess, sys\nsubprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)\nprint(os.times().children_user)';
  const args = [TWINEDGE, "audit", file, "--format", "json", ...(layer ? ["--layer", layer] : [])];
  return () => Number(spawnSync("python3", ["-c", script, ...args], { encoding: "utf8" }).stdout);
}

/** An audit in a page, with all threads of its process. */
async function chromium() {
  const require = createRequire(`${MODULES}/`);
  const { outputFiles } = await require("esbuild").build({
    entryPoints: [fileURLToPath(new URL("package/sync.js", import.meta.url))],
    bundle: true,
    write: false,
    format: "iife",
    globalName: "bundle",
    external: ["node:*"],
    logOverride: { "empty-import-meta": "silent" },
  });
  const browser = await require("puppeteer-core").launch({ executablePath: CHROMIUM, headless: true, args: ["--no-sandbox"], protocolTimeout: 600_000 });
  const page = await browser.newPage();
  await page.addScriptTag({ content: outputFiles[0].text });
  const given = [module, bytes].map((one) => one.toString("base64"));
  await page.evaluate(async (module, bytes) => {
    const raw = (text) => Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
    globalThis.given = raw(bytes);
    globalThis.twinedge = await globalThis.bundle.load(raw(module));
  }, ...given);
  const session = await browser.target().createCDPSession();
  const used = async () => {
    const { processInfo } = await session.send("SystemInfo.getProcessInfo");
    return processInfo.filter(({ type }) => type === "renderer").reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  };
  const run = async () => {
    const before = await used();
    await page.evaluate((name, options) => void globalThis.twinedge.audit({ name, bytes: globalThis.given }, options), file, options);
    return (await used()) - before;
  };
  return Object.assign(run, { end: () => browser.close() });
}

const runs = { node: await node() };
if (TWINEDGE) runs.program = await program();
if (CHROMIUM) runs.chromium = await chromium();
// The first one of each compiles.
for (const run of Object.values(runs)) await run();
const times = Object.fromEntries(Object.keys(runs).map((name) => [name, []]));
for (let round = 0; round < ROUNDS; round++) {
  for (const [name, run] of Object.entries(runs)) times[name].push(await run());
}
const median = (all) => [...all].sort((a, b) => a - b)[all.length >> 1];
for (const [name, all] of Object.entries(times)) {
  const ratio = times.program ? `, ${(median(all) / median(times.program)).toFixed(2)} times that of the program` : "";
  console.log(`${name}: ${median(all).toFixed(2)} s (${all.map((one) => one.toFixed(2)).join(", ")})${ratio}`);
}
await runs.chromium?.end();
