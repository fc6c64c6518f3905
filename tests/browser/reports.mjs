// Opens reports in a browser and looks at what they show. The argument is a folder for reports and pictures.

import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { farApart, hostile, hostileNames, many, overlapping, parcels, tables } from "./maps.mjs";

const folder = process.argv[2];
const puppeteer = createRequire(join(process.env.MODULES, "index.js"))("puppeteer-core");
const results = { passed: 0, failed: 0 };

function check(what, holds, found = "") {
  results[holds ? "passed" : "failed"] += 1;
  if (!holds) console.log(`FAILED: ${what}`, found);
}

function same(what, found, expected) {
  check(what, JSON.stringify(found) === JSON.stringify(expected), `found ${JSON.stringify(found)}, not ${JSON.stringify(expected)}`);
}

/** Writes the report of a map. */
function report(name, text, status, ...options) {
  const [input, output] = [join(folder, name), join(folder, `${name}.html`)];
  writeFileSync(input, text);
  const run = spawnSync(process.env.TWINEDGE, ["audit", input, "-o", output, ...options], { encoding: "utf8" });
  same(`exit status for ${name}`, run.status, status);
  return pathToFileURL(output).href;
}

/** Opens a report, and notes what it should not do. */
async function open(browser, url, settings = {}) {
  const page = await browser.newPage();
  const complaints = [];
  page.on("console", (message) => complaints.push(message.text()));
  page.on("pageerror", (error) => complaints.push(error.stack));
  page.on("request", (request) => {
    if (request.url() !== url && !request.url().startsWith("data:")) complaints.push(`asks for ${request.url()}`);
  });
  page.on("dialog", (dialog) => {
    complaints.push(`says ${dialog.message()}`);
    dialog.dismiss();
  });
  await page.setViewport({ width: 1280, height: 800, ...settings.viewport });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: settings.scheme ?? "light" }]);
  await page.goto(url);
  await drawn(page);
  return { page, complaints };
}

/** Waits until the map is drawn as it was asked for last. */
async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  await page.waitForFunction(() => document.getElementById("stage").dataset.state === "drawn", { timeout: 30000 });
}

async function press(page, ...keys) {
  for (const key of keys) await page.keyboard.press(key);
  await drawn(page);
}

async function click(page, selector) {
  await page.click(selector);
  await drawn(page);
}

const picture = (page, name) => page.screenshot({ path: join(folder, `${name}.png`) });
const text = (page, selector) => page.$eval(selector, (element) => element.innerText);
const options = (page) => page.$$eval("[role=option]", (all) => all.map((one) => one.innerText.replace(/\s+/g, " ")));
const chosen = (page) => page.$$eval("[aria-selected=true]", (all) => all.map((one) => one.innerText.split(/\s/)[0]));
/** The part of the map that is seen. */
const seen = (page) => page.evaluate(() => view.box());
/** Returns the colour of a canvas at a pixel: red, green, blue, opacity. It is copied, so that it stays as fast as it is. */
const pixel = (page, id, px, py) =>
  page.evaluate(
    (id, px, py) => {
      const copy = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
      copy.drawImage(document.getElementById(id), -Math.round(px * ratio), -Math.round(py * ratio));
      return [...copy.getImageData(0, 0, 1, 1).data];
    },
    id,
    px,
    py,
  );
const at = (page, x, y) => page.evaluate((x, y) => [view.px(x), view.py(y)], x, y);
/** Returns the colours of the map and of the overlay at a place. */
const baseAt = async (page, x, y) => pixel(page, "base", ...(await at(page, x, y)));
const drawnAt = async (page, x, y) => pixel(page, "over", ...(await at(page, x, y)));
const holds = ([x0, y0, x1, y1], [x, y]) => x0 < x && x < x1 && y0 < y && y < y1;

async function parcelsByMouse(browser, url) {
  const { page, complaints } = await open(browser, url);
  same("title", await page.title(), "parcels.geojson");
  same("heading", await text(page, "h1"), "parcels.geojson");
  same("half-edges are off", await page.$eval("#links-on", (box) => box.checked), false);
  check("verdict", (await text(page, "#verdict")).startsWith("not valid:"), await text(page, "#verdict"));
  // Consequences are folded under their causes.
  const causes = await options(page);
  const told = await page.evaluate(() => data.findings.filter(({ follows }) => follows === null).length);
  same("causes are listed", causes.length, told);
  check("with the number of consequences", causes.some((one) => /\d+ others follow from it/.test(one)), causes);
  check("the count is that of the causes", (await text(page, "#shown")).startsWith(`${told} of ${told} findings`), await text(page, "#shown"));
  await click(page, "#follow-on");
  const all = await options(page);
  same("all are listed then", all.length, await page.evaluate(() => data.findings.length));
  for (const [rule, features] of [
    ["C1 overlap", "Alder (id P-1), Birch (id P-2)"],
    ["C2 gap", "Dogwood (id P-4)"],
    ["C4 sliver", "Fir (id P-6b)"],
    ["C5 duplicate", "Cedar (id P-3), Cedar again (id P-8)"],
  ]) {
    check(`${rule} is listed`, all.some((one) => one.startsWith(`${rule} `) && one.includes(features)), all);
  }
  await picture(page, "parcels");
  const [alder, sea] = [await baseAt(page, 30, 130), await baseAt(page, -60, 60)];
  check("faces are filled", Math.hypot(...alder.map((x, i) => x - sea[i])) > 40, [alder, sea]);

  // The overlap of Alder and Birch.
  const place = all.findIndex((one) => one.startsWith("C1 overlap Alder"));
  const before = await seen(page);
  await click(page, `[role=option]:nth-child(${place + 1})`);
  same("the overlap is chosen", await chosen(page), ["C1"]);
  const box = await seen(page);
  check("it is in sight", holds(box, [101, 101]) && holds(box, [101, 199]), box);
  check("closer than the whole map", box[2] - box[0] < 0.9 * (before[2] - before[0]), box);
  const mark = await drawnAt(page, 101, 120);
  check("it is marked", mark[3] > 40, mark);
  same("nothing beside it is", (await drawnAt(page, 150, 150))[3], 0);
  const detail = await text(page, "#detail");
  for (const part of ["C1 overlap", "Alder (id P-1)", "Birch (id P-2)", "200 ", "no face is claimed by two features"]) {
    check(`the panel says ${part}`, detail.includes(part), detail);
  }
  await picture(page, "parcels-overlap");
  await click(page, "#closer");
  const close = await seen(page);
  check("closer", close[2] - close[0] < 0.5 * (box[2] - box[0]) && holds(close, [101, 150]), close);
  const fill = await drawnAt(page, 101, 151);
  check("it is filled", fill[3] > 40 && fill[3] < 200, fill);
  await picture(page, "parcels-closer");
  await click(page, "#whole");
  check("the whole map again", holds(await seen(page), [0.5, -49]), await seen(page));

  // A click on the map chooses the gap between Dogwood and Elm.
  const [x, y] = await page.evaluate(() => {
    const gap = data.findings.find((one) => one.rule === "C2");
    const { left, top } = over.getBoundingClientRect();
    return [left + view.px(gap.at[0]), top + view.py(gap.at[1])];
  });
  await page.mouse.click(x, y);
  await drawn(page);
  same("the gap is chosen", await chosen(page), ["C2"]);

  // The wheel zooms towards the pointer, dragging moves.
  await click(page, "#whole");
  const [wide, middle] = [await seen(page), await page.$eval("#over", (c) => c.getBoundingClientRect().toJSON())];
  const start = [middle.left + middle.width / 4, middle.top + middle.height / 4];
  const under = await page.evaluate((w, h) => view.at(w / 4, h / 4), middle.width, middle.height);
  await page.mouse.move(...start);
  await page.mouse.wheel({ deltaY: -240 });
  await drawn(page);
  const narrow = await seen(page);
  check("the wheel zooms", narrow[2] - narrow[0] < 0.6 * (wide[2] - wide[0]), narrow);
  const still = await page.evaluate((w, h) => view.at(w / 4, h / 4), middle.width, middle.height);
  check("the pointer stays where it was", Math.hypot(still[0] - under[0], still[1] - under[1]) < (wide[2] - wide[0]) / middle.width, still);
  await page.mouse.down();
  await page.mouse.move(start[0] + 100, start[1] + 50, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  const moved = await seen(page);
  const scale = middle.width / (moved[2] - moved[0]);
  check("dragging moves", Math.abs((narrow[0] - moved[0]) * scale - 100) < 1.5, [narrow, moved]);
  same("a drag is no click", await chosen(page), ["C2"]);

  // Filters.
  await page.type("#feature", "elm");
  await drawn(page);
  const ofElm = await options(page);
  check("those of Elm", ofElm.length > 0 && ofElm.every((one) => one.includes("Elm (id P-5)")), ofElm);
  await picture(page, "parcels-filter");
  await page.$eval("#feature", (input) => {
    input.value = "P-3";
    input.dispatchEvent(new Event("input"));
  });
  const ofCedar = await options(page);
  check("by id", ofCedar.length > 0 && ofCedar.every((one) => one.includes("Cedar (id P-3)")), ofCedar);
  await page.$eval("#feature", (input) => {
    input.value = "nobody";
    input.dispatchEvent(new Event("input"));
  });
  same("none is left", await options(page), []);
  check("and it is said", (await text(page, "#list")).includes("No finding matches"));
  await page.$eval("#feature", (input) => {
    input.value = "";
    input.dispatchEvent(new Event("input"));
  });
  await click(page, "input[value=C1]");
  const without = await options(page);
  check("without C1", without.length > 0 && without.every((one) => !one.startsWith("C1")), without);
  check("the count says so", (await text(page, "#shown")).startsWith(`${without.length} of ${all.length} findings`));
  same("no complaint", complaints, []);
  await page.close();
}

async function parcelsByKeys(browser, url) {
  const { page, complaints } = await open(browser, url, { scheme: "dark" });
  const paper = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  same("dark paper", paper, "rgb(13, 17, 23)");
  const dark = await pixel(page, "base", 3, 3);
  check("a dark map", Math.max(...dark.slice(0, 3)) < 110, dark);
  // The order of the focus: from the details through the filter and the list to the map.
  const focus = () => page.evaluate(() => document.activeElement.id || document.activeElement.tagName);
  const order = [];
  for (let i = 0; i < 25 && order.at(-1) !== "over"; i++) {
    await page.keyboard.press("Tab");
    order.push(await focus());
    const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
    check(`the focus on ${order.at(-1)} is visible`, outline !== "none", outline);
  }
  same("the order of the focus", order.filter((id) => ["feature", "list", "whole", "over"].includes(id)), ["feature", "list", "whole", "over"]);
  await page.focus("#list");
  await press(page, "ArrowDown");
  const [first] = await options(page);
  same("the first is chosen", await page.$eval("[aria-selected=true]", (one) => one.dataset.place), "0");
  same("and said to be", await page.$eval("#list", (one) => one.getAttribute("aria-activedescendant")), "finding-1");
  const whole = await seen(page);
  await press(page, "Enter");
  const close = await seen(page);
  check(`Enter goes closer to ${first}`, close[2] - close[0] < whole[2] - whole[0], [whole, close]);
  await press(page, "End");
  const count = (await options(page)).length;
  same("the last is chosen", await page.$eval("[aria-selected=true]", (one) => one.dataset.place), String(count - 1));
  await picture(page, "parcels-dark");
  await page.focus("#over");
  await press(page, "p");
  same("the one before", await page.$eval("[aria-selected=true]", (one) => one.dataset.place), String(count - 2));
  await press(page, "0");
  const before = await seen(page);
  await press(page, "ArrowRight", "+");
  const after = await seen(page);
  check("arrows move and plus zooms", after[0] > before[0] && after[2] - after[0] < before[2] - before[0], [before, after]);
  await press(page, "Escape");
  same("none is chosen", await chosen(page), []);
  // The page follows when the colours of the system change.
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "light" }]);
  await drawn(page);
  const light = await pixel(page, "base", 3, 3);
  check("a light map", Math.min(...light.slice(0, 3)) > 150, light);
  same("no complaint", complaints, []);
  await page.close();
}

async function roles(browser, url) {
  const { page } = await open(browser, url);
  const found = [];
  const walk = (node) => {
    found.push(`${node.role}: ${node.name}`);
    (node.children ?? []).forEach(walk);
  };
  walk(await page.accessibility.snapshot({ interestingOnly: false }));
  for (const part of ["combobox: Feature, by name or id", "listbox: Findings", "application: Map.", "toolbar: Map tools", "button: Zoom in"]) {
    check(`a screen reader finds ${part}`, found.some((one) => one.startsWith(part)), found);
  }
  check("options have names", found.some((one) => /^option: C1\s*overlap/.test(one)), found.filter((one) => one.startsWith("option")));
  await page.close();
}

async function brokenLink(browser, url) {
  const { page, complaints } = await open(browser, url);
  const all = await options(page);
  check("the link is listed", all.some((one) => one.startsWith("L3") && one.includes("half-edge e1,1")), all);
  same("half-edges are drawn", await page.$eval("#stage", (stage) => stage.dataset.drawn), "half-edges");
  await click(page, `[role=option]:nth-child(${all.findIndex((one) => one.startsWith("L3")) + 1})`);
  check("its edge is marked", (await drawnAt(page, 2.2, 0))[3] > 100, await drawnAt(page, 2.2, 0));
  await picture(page, "tables");
  await page.focus("#over");
  await press(page, "0", ..."--------");
  same("from far away they are not", await page.$eval("#stage", (stage) => stage.dataset.drawn), "map");
  await page.type("#feature", "e1,1");
  await page.keyboard.press("Enter");
  await drawn(page);
  check("the findings of an edge are found", (await options(page)).every((one) => one.includes("e1,1")), await options(page));
  same("no complaint", complaints, []);
  await page.close();
}

/** Clashes come after the findings that say the same, in words about features; an edge is found by its number. */
async function crossings(browser, url) {
  const { page, complaints } = await open(browser, url);
  await click(page, "#follow-on");
  const all = await options(page);
  const [first, clash] = [all.findIndex((one) => one.startsWith("C1")), all.findIndex((one) => one.startsWith("G4"))];
  check("findings come first", 0 <= first && first < clash, all);
  check("a clash names features", all.some((one) => one.includes("the borders of Meier and Mueller overlap from (9.5, 0) to (10, 0)")), all);
  check("and no half-edge", !all.some((one) => one.startsWith("G4") && one.includes("half-edge")), all);
  const half = await page.evaluate(() => Number(data.findings.find((one) => one.rule === "G4" && one.records[0].startsWith("half-edge")).records[0].split(" ")[1]));
  await page.type("#feature", `h${half}`);
  const found = await options(page);
  check("the clashes of an edge", found.length > 0 && found.every((one) => one.startsWith("G4")), found);
  const wide = await seen(page);
  await press(page, "Enter");
  const near = await seen(page);
  check("Enter goes to the edge", near[2] - near[0] < wide[2] - wide[0], [wide, near]);
  await picture(page, "crossings");
  same("no complaint", complaints, []);
  await page.close();
}

/** The first view shows the part with most features, and the others are in insets. */
async function farAway(browser, url) {
  const { page, complaints } = await open(browser, url);
  const box = await seen(page);
  check("most features are in sight", holds(box, [5, 5]) && !holds(box, [500, 1]), box);
  await picture(page, "far-away");
  same("an inset has a name", await page.$$eval("#insets button", (all) => all.map((one) => one.title)), ["far (id f)"]);
  same("the scale", await page.evaluate(() => scaleBar(view, null)[1]), "2");
  await click(page, "#insets button");
  check("the inset leads there", holds(await seen(page), [500.5, 0.5]), await seen(page));
  await click(page, "#whole");
  const whole = await seen(page);
  check("the whole map", holds(whole, [5, 5]) && holds(whole, [500, 1]), whole);
  same("no complaint", complaints, []);
  await page.close();
}

/** A dense map that is small in the window is not black. */
async function denseBorders(browser, url) {
  const { page, complaints } = await open(browser, url);
  await page.focus("#over");
  await press(page, "0", "-", "-", "-", "-");
  const middle = await page.evaluate(() => {
    const [x, y] = [view.width / 2, view.height / 2];
    const copy = new OffscreenCanvas(20, 20).getContext("2d", { willReadFrequently: true });
    copy.drawImage(base, -Math.round((x - 10) * ratio), -Math.round((y - 10) * ratio));
    const { data } = copy.getImageData(0, 0, 20, 20);
    return [0, 1, 2].map((i) => data.filter((_, at) => at % 4 === i).reduce((sum, one) => sum + one, 0) / 400);
  });
  check("faces can be seen between the borders", Math.max(...middle) > 150, middle);
  await picture(page, "dense");
  same("no complaint", complaints, []);
  await page.close();
}

/** A page of a map of which most is not shown says so. */
async function cutMap(browser, url) {
  const whole = readFileSync(fileURLToPath(url), "utf8");
  const cut = join(folder, "cut.html");
  writeFileSync(cut, whole.replace('"edges":[5,5]', '"edges":[5,5000000]'));
  const { page, complaints } = await open(browser, pathToFileURL(cut).href);
  same("what is not shown", await text(page, "#cut"), "The map has 5,000,000 edges. Shown are 5 of them: those near the listed findings.");
  same("no complaint", complaints, []);
  await page.close();
}

async function hostileTexts(browser, url) {
  const { page, complaints } = await open(browser, url);
  same("title", await page.title(), "hostile.geojson");
  same("names", await page.evaluate(() => data.features.map(([name]) => name)), hostileNames);
  await page.focus("#list");
  for (let i = 0; i < (await options(page)).length; i++) await press(page, "ArrowDown");
  same("no element was made", await page.evaluate(() => document.querySelectorAll("main img, #list b").length), 0);
  check("they are shown", (await options(page)).some((one) => one.includes("</script><script>")));
  await page.type("#feature", "</script>");
  check("and found", (await options(page)).length > 0);
  await click(page, "#whole");
  await picture(page, "hostile");
  same("title still", await page.title(), "hostile.geojson");
  same("no complaint", complaints, []);
  await page.close();
}

async function manyParcels(browser, url) {
  const { page, complaints } = await open(browser, url);
  same("all edges are there", await page.evaluate(() => data.map.edges[0] === data.map.edges[1] && data.map.edges[0] > 20000), true);
  await page.focus("#list");
  await press(page, "ArrowDown");
  const gap = (await options(page)).find((one) => one.startsWith("C2"));
  check("the gap of a hundredth is listed", gap?.includes("Parcel 5050"), await options(page));
  await page.type("#feature", "Parcel 5050");
  await page.focus("#list");
  await press(page, "Home", "Enter");
  check("it is in sight", holds(await seen(page), [50.995, 50.5]), await seen(page));
  await picture(page, "many");
  same("no complaint", complaints, []);
  await page.close();
}

async function narrowWindow(browser, url) {
  const { page, complaints } = await open(browser, url, { viewport: { width: 390, height: 844 } });
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  check("nothing is wider than the window", width <= 390, width);
  check("the map is in sight", await page.evaluate(() => over.getBoundingClientRect().height > 300));
  await picture(page, "narrow");
  same("no complaint", complaints, []);
  await page.close();
}

/** What is accepted on the page is what `--accept` reads. */
async function accepting(browser, url) {
  const { page, complaints } = await open(browser, url);
  const count = () => text(page, "#accepted-count");
  same("nothing is accepted", await count(), "0 findings are accepted.");
  const isOffered = () => page.$eval("#accept", (form) => !form.hidden);
  same("nothing is chosen", await isOffered(), false);
  await click(page, "#follow-on");
  await page.focus("#list");
  await press(page, "End", "End");
  same("a violation of the structure cannot be accepted", await isOffered(), false);
  await press(page, "Home");
  same("a finding of the coverage can be accepted", await isOffered(), true);
  await click(page, "#accept [type=submit]");
  same("not without a reason", await count(), "0 findings are accepted.");
  await page.type("#reason", "a lake, as of <2026> & \"later\"");
  await click(page, "#accept [type=submit]");
  same("one is accepted", await count(), "1 finding is accepted.");
  check("and the list says why", (await options(page))[0].includes('Accepted: a lake, as of <2026> & "later"'), (await options(page))[0]);
  await click(page, "#unaccept");
  same("no longer", await count(), "0 findings are accepted.");
  await page.type("#reason", "a lake");
  await click(page, "#accept [type=submit]");
  await click(page, "#save-accepted");
  const list = await page.evaluate(() => acceptance.text());
  const [input, file] = [join(folder, "parcels.geojson"), join(folder, "accepted.json")];
  writeFileSync(file, list);
  const run = spawnSync(process.env.TWINEDGE, ["audit", input, "--sliver", "50", "--accept", file, "--format", "json"], { encoding: "utf8" });
  const { accepted, coverage } = JSON.parse(run.stdout);
  same("the program accepts it", accepted, { count: 1, grown: [], gone: [] });
  same("for that reason", coverage.findings.filter((one) => one.accepted).map((one) => one.accepted), ["a lake"]);
  await picture(page, "accepting");
  same("no complaint", complaints, []);
  await page.close();
}

const browser = await puppeteer.launch({
  timeout: 180_000,
  executablePath: process.env.CHROMIUM,
  // The sandbox needs rights that a container may lack; the pages are our own.
  args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"],
});
try {
  console.log(await browser.version());
  const ofParcels = report("parcels.geojson", parcels, 1, "--sliver", "50");
  const ofTables = report("tables.txt", tables, 1);
  await parcelsByMouse(browser, ofParcels);
  await parcelsByKeys(browser, ofParcels);
  await roles(browser, ofParcels);
  await accepting(browser, ofParcels);
  await brokenLink(browser, ofTables);
  await cutMap(browser, ofTables);
  await hostileTexts(browser, report("hostile.geojson", hostile, 1));
  await manyParcels(browser, report("many.geojson", many, 1));
  await crossings(browser, report("overlapping.geojson", overlapping, 1));
  await farAway(browser, report("far-away.geojson", farApart, 0));
  await denseBorders(browser, report("dense.geojson", many, 1));
  await narrowWindow(browser, ofParcels);
} finally {
  await browser.close();
}
console.log(`${results.passed} passed, ${results.failed} failed`);
process.exitCode = results.failed === 0 && results.passed > 0 ? 0 : 1;
