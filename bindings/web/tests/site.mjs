// The site in Chromium, from a folder and without network, as somebody uses it who has never seen a terminal.

import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { load } from "../package/sync.js";
import { open } from "./browser.mjs";

const { page, faults, pictures, site, text, waitFor, click, close } = await open("index.html");
const folder = await mkdtemp(join(tmpdir(), "twinedge-site-"));
const frame = async () => (await page.waitForSelector("#report")).contentFrame();
const inReport = async (act, ...args) => (await frame()).evaluate(act, ...args);

async function put(name, bytes) {
  const path = join(folder, name);
  await writeFile(path, bytes);
  return path;
}

/** Drops files while a report is shown, along a way of the pointer. */
async function dropAlong(way, ...paths) {
  const session = await page.createCDPSession();
  const data = { items: [], files: paths, dragOperationsMask: 1 };
  for (const [i, [x, y]] of way.entries()) {
    for (const type of i === 0 ? ["dragEnter", "dragOver"] : ["dragOver", "dragOver"]) await session.send("Input.dispatchDragEvent", { type, x, y, data });
  }
  const [x, y] = way.at(-1);
  await session.send("Input.dispatchDragEvent", { type: "dragOver", x, y, data });
  await session.send("Input.dispatchDragEvent", { type: "drop", x, y, data });
  await session.detach();
}

async function upload(...paths) {
  await (await page.$("#files")).uploadFile(...paths);
}

/** Drops files on the page, as the pointer brings them from a folder. */
async function drop(...paths) {
  const session = await page.createCDPSession();
  const data = { items: [], files: paths, dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", "drop"]) await session.send("Input.dispatchDragEvent", { type, x: 600, y: 400, data });
  await session.detach();
}

/** The text of a file that a button saves. */
async function saved(button) {
  await page.evaluate(() => {
    window.savedBlobs ??= [];
    window.makeUrl ??= URL.createObjectURL.bind(URL);
    URL.createObjectURL = (blob) => {
      window.savedBlobs.push(blob);
      return window.makeUrl(blob);
    };
    HTMLAnchorElement.prototype.click = () => {};
  });
  const before = await page.evaluate(() => window.savedBlobs.length);
  await click(button);
  await page.waitForFunction((before) => window.savedBlobs.length > before, {}, before);
  const bytes = await page.evaluate(async () => [...new Uint8Array(await window.savedBlobs.at(-1).arrayBuffer())]);
  return Buffer.from(bytes);
}

const twinedge = await load();
const square = (name, x, width) => ({
  type: "Feature",
  properties: { name },
  geometry: { type: "Polygon", coordinates: [[[x, 0], [x + width, 0], [x + width, 4], [x, 4], [x, 0]]] },
});
const planted = { type: "FeatureCollection", features: [square("Left", 0, 4), square("Right", 3.5, 4)] };

try {
  // A zipped Shapefile with a planted overlap is dropped, seen, repaired and saved.
  await page.setViewport({ width: 1280, height: 800 });
  await page.goto(site);
  await page.screenshot({ path: join(pictures, "welcome.png") });
  const zip = twinedge.convert(planted, { to: "shapefile", name: "parcels.geojson" });
  const path = await put("parcels.zip", zip.bytes);
  await drop(path);
  await waitFor("status", /finding/);
  assert.equal(await text("status"), "parcels.zip: 1 finding");
  await (await frame()).waitForSelector("#list [role=option]");
  assert.ok(await inReport(() => [...document.querySelectorAll("[role=option]")].some((one) => /C1 overlap.*Left.*Right/.test(one.textContent))));
  await page.screenshot({ path: join(pictures, "found.png") });

  await click("repair-open");
  await page.click("#repair [type=submit]");
  await waitFor("done", /1 overlap resolved.*Nothing is left/);
  assert.match(await text("status"), /nothing was found \(preview\)/);
  await page.screenshot({ path: join(pictures, "preview.png") });
  await page.click("input[value=before]");
  await waitFor("status", /finding$/);
  await page.click("input[value=after]");
  await waitFor("status", /preview/);
  await click("keep");
  assert.match(await text("status"), /parcels-repaired\.zip: nothing was found$/);
  // The keys work while the report has the focus, too.
  await (await frame()).waitForSelector("#list");
  await (await frame()).focus("#list");
  await page.keyboard.down("Control");
  await page.keyboard.press("z");
  await page.keyboard.up("Control");
  await waitFor("status", /^parcels\.zip: 1 finding$/);
  await click("redo");
  await waitFor("status", /repaired/);
  await click("save-open");
  assert.equal(await page.$eval("#format", ({ value }) => value), "shapefile", "a Shapefile is saved as one");
  await page.select("#format", "geojson");
  const repaired = JSON.parse(await saved("save-map"));
  await page.select("#format", "shapefile");
  assert.equal(twinedge.audit(repaired, { coverage: true }).valid, true);
  assert.deepEqual(repaired.features.map(({ properties }) => properties.name), ["Left", "Right"]);
  assert.match((await saved("save-report")).toString(), /^<!doctype html>/);
  assert.equal(twinedge.audit({ name: "again.zip", bytes: new Uint8Array(await saved("save-map")) }).valid, true);

  // A finding is accepted with a reason, by keys alone, and known again.
  await upload(path);
  await waitFor("status", /^parcels\.zip: 1 finding$/);
  await (await frame()).waitForSelector("#list [role=option]");
  await click("accept-open");
  await (await frame()).focus("#list");
  await page.keyboard.press("ArrowDown");
  await waitFor("chosen", /C1 overlap/);
  await page.focus("#accept [name=reason]");
  await page.keyboard.type("a disputed strip");
  await page.keyboard.press("Enter");
  await waitFor("status", /1 accepted/);
  assert.ok(await inReport(() => document.querySelector(".accepted")?.textContent === "Accepted: a disputed strip"));
  await page.screenshot({ path: join(pictures, "accepted.png") });
  await click("save-open");
  const notes = await saved("save-accepted");
  const findings = JSON.parse(await saved("save-findings"));
  assert.ok(findings.features.some(({ properties }) => properties.accepted === "a disputed strip"));
  await upload(path, await put("parcels-accepted.json", notes));
  await waitFor("status", /1 accepted/);

  // A remedy is a button.
  await click("accept-open");
  await (await frame()).waitForSelector("#list [role=option]");
  await (await frame()).focus("#list");
  await page.keyboard.press("ArrowDown");
  const [remedy] = await inReport(() => [...document.querySelectorAll("#detail button")].map(({ textContent }) => textContent));
  assert.equal(remedy, "Repair…");
  await inReport(() => document.querySelector("#detail button").click());
  assert.ok(await page.$eval("#repair", ({ hidden }) => !hidden));

  // A file is dropped on a report that is shown, whichever way the pointer comes.
  const ways = [[[640, 400]], [[640, 10], [640, 400]], [[200, 400], [900, 400]], [[640, 400], [640, 10], [900, 600]]];
  for (const [i, way] of ways.entries()) {
    await upload(await put(`shown-${i}.zip`, zip.bytes));
    await page.waitForFunction((name) => {
      const { contentDocument, dataset } = document.getElementById("report");
      return dataset.state === "shown" && contentDocument.getElementById("input")?.textContent === name;
    }, {}, `shown-${i}.zip`);
    await dropAlong(way, await put(`dropped-${i}.geojson`, JSON.stringify(planted)));
    await waitFor("status", new RegExp(`^dropped-${i}\\.geojson: 1 finding$`));
  }

  // Two maps are refused, with a button for each.
  await upload(await put("may.geojson", JSON.stringify(planted)), await put("june.geojson", JSON.stringify({ ...planted, features: [planted.features[0]] })));
  await waitFor("message", /these are 2 maps/);
  await page.evaluate(() => [...document.querySelectorAll("#message li button")].find(({ textContent }) => textContent === "june.geojson").click());
  await waitFor("status", /nothing was found$/);

  // The column of the names is chosen.
  const parcels = planted.features.map((one, i) => ({ ...one, properties: { EGRID: `CH${i}`, use: "a" } }));
  await upload(await put("egrid.geojson", JSON.stringify({ ...planted, features: parcels })));
  await waitFor("status", /^egrid\.geojson/);
  await page.select("#name-from", "EGRID");
  await page.waitForFunction(() => [...document.getElementById("report").contentDocument.querySelectorAll("[role=option]")].some((one) => /CH0, CH1/.test(one.textContent)));

  // A file that the page does not take is refused, with a command to run instead, and the report is still there.
  await upload(await put("photo.png", Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a])));
  await waitFor("message", /This could not be done/);
  assert.doesNotMatch(await text("message"), /The program takes it/);
  await upload(await put("cadastre.gpkg", "SQLite format 3\0"));
  await waitFor("message", /twinedge audit cadastre\.gpkg/);
  await page.evaluate(() => [...document.querySelectorAll("#message button")].at(-1).click());
  await (await frame()).waitForSelector("#list [role=option]");
  assert.match(await text("status"), /^egrid\.geojson/);
  const packed = Buffer.from(
    "UEsDBBQAAAAAAAAAIQAL4Pb0EAAAABAAAAAGAAAAYS5ncGtnU1FMaXRlIGZvcm1hdCAzAFBLAQIUAxQAAAAAAAAAIQAL4Pb0EAAAABAAAAAGAAAAAAAAAAAAAACAAQAAAABhLmdwa2dQSwUGAAAAAAEAAQA0AAAANAAAAAAA",
    "base64",
  );
  await upload(await put("packed.zip", packed));
  await waitFor("message", /twinedge audit packed\.zip/);
  await upload(await put("broken.geojson", '{"type": "FeatureCollection", "features": ['));
  await waitFor("message", /broken\.geojson: line 1/);

  // Meshes, TopoJSON and hostile names.
  await upload(await put("open.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"));
  await waitFor("status", /open\.off/);
  await (await frame()).waitForSelector("#stage[data-drawn]");
  const hostile = { ...planted, features: [square("<img src=x onerror=alert(1)>", 0, 4), square("B", 3.5, 4)] };
  await upload(await put("hostile.geojson", JSON.stringify(hostile)));
  await waitFor("status", /hostile/);
  const topology = await readFile(new URL("../../../crates/layers/tests/layer/data/south-america.topojson", import.meta.url));
  await upload(await put("south-america.topojson", topology));
  await waitFor("status", /south-america/);

  // On a phone, and in the dark.
  await page.setViewport({ width: 390, height: 844, isMobile: true, hasTouch: true, deviceScaleFactor: 2 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await page.goto(site);
  await page.screenshot({ path: join(pictures, "phone-welcome.png") });
  await click("example");
  await waitFor("status", /finding/);
  await (await frame()).waitForSelector("#stage[data-state=drawn]");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 390), "nothing is wider than the phone");
  await page.screenshot({ path: join(pictures, "phone.png") });
  assert.deepEqual(faults, []);
  console.log("the site: all is well");
} finally {
  await close();
  await rm(folder, { recursive: true, force: true });
}
