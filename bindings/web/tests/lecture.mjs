// The lecture in Chromium, from a folder and without network: the steps as somebody does them, by pointer and by keys.

import assert from "node:assert/strict";
import { join } from "node:path";
import { open } from "./browser.mjs";

const { page, faults, pictures, site, text, waitFor, click, close } = await open("lecture.html");

/** The middle of a record in the picture, where a pointer meets it. */
const placeOf = (name) =>
  page.evaluate((name) => {
    const all = [...document.querySelectorAll(`#picture [data-name="${name}"]`)];
    const one = all.find((each) => each.classList.contains("hit")) ?? all[0];
    const [point, matrix] = [one.tagName === "circle" ? { x: one.cx.baseVal.value, y: one.cy.baseVal.value } : one.getPointAtLength(one.getTotalLength() / 2), one.getScreenCTM()];
    return [point.x * matrix.a + matrix.e, point.y * matrix.d + matrix.f];
  }, name);
const pick = async (name) => page.mouse.click(...(await placeOf(name)));
const operator = (name) => page.evaluate((name) => [...document.querySelectorAll("#operators button")].find((one) => one.textContent === name).click(), name);
const link = (name, field) => page.$eval(`[data-cell="${name} ${field}"]`, (one) => one.value);
const isDone = async () => (await text("done")) !== "";

async function type(name, field, value) {
  await page.click(`[data-cell="${name} ${field}"]`, { clickCount: 3 });
  await page.keyboard.type(value);
  await page.keyboard.press("Enter");
}

try {
  await page.setViewport({ width: 1400, height: 1000 });
  await page.goto(site);
  await waitFor("verdict", /All rules hold/);
  assert.equal(await text("step-number"), "Step 1 of 9");
  await page.screenshot({ path: join(pictures, "lecture.png") });

  // A half-edge, its twin, and once around a face.
  await pick("h2");
  assert.equal(await text("chosen"), "Chosen: h2");
  assert.ok(await isDone());
  await click("forward");
  await waitFor("step-title", /Twin/);
  await pick("h2");
  await pick(await link("h2", "twin"));
  assert.ok(await isDone());
  await click("forward");
  await waitFor("step-title", /Next/);
  // By keys alone, in the table.
  let at = "h2";
  await page.focus(`[data-choose="${at}"]`);
  await page.keyboard.press("Enter");
  for (let i = 0; i < 3; i++) {
    assert.equal(await isDone(), false);
    at = await link(at, "next");
    await page.focus(`[data-choose="${at}"]`);
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.activeElement.dataset.choose), at, "the focus stays");
  }
  assert.equal(at, "h2");
  assert.ok(await isDone());

  // A face is split, undone, and split again.
  await click("forward");
  await waitFor("step-title", /Cycles/);
  await operator("Connect");
  assert.match(await text("status"), /^Choose two vertices/);
  await pick("v1");
  await pick("v3");
  await operator("Connect");
  assert.match(await text("status"), /^Connect\. new: h10, h11, b\d, f3\. All rules hold\.$/);
  assert.ok(await isDone());
  await click("undo");
  assert.match(await text("status"), /^Undone: connect/);
  await page.keyboard.down("Control");
  await page.keyboard.down("Shift");
  await page.keyboard.press("z");
  await page.keyboard.up("Shift");
  await page.keyboard.up("Control");
  assert.match(await text("status"), /^Redone: connect/);

  // Holes become part of the outer boundary.
  await click("forward");
  await waitFor("step-title", /Holes/);
  const holes = () => page.$$eval('[data-cell$=" inner"]', (all) => all.map((one) => one.value));
  assert.deepEqual((await holes()).map((one) => one.split(" ").length), [1, 2, 1]);
  await page.screenshot({ path: join(pictures, "lecture-holes.png") });
  for (const ends of [["v1", "v5"], ["v3", "v8"]]) {
    for (const end of ends) await pick(end);
    await operator("Connect");
    assert.match(await text("status"), /^Connect\. new: h\d+, h\d+; removed: b\d/);
  }
  assert.ok(await isDone());

  // Euler's formula counts along. Vertices appear where a face was clicked, and edges where they are split.
  await click("forward");
  await waitFor("euler", /= 8 − 7 \+ 3 = 4, 1 \+ C = 1 \+ 3 = 4/);
  const box = await page.$eval("#picture", (one) => one.getBoundingClientRect().toJSON());
  await page.mouse.click(box.x + (700 / 800) * box.width, box.y + (100 / 520) * box.height);
  assert.equal(await text("chosen"), "Chosen: f1");
  await operator("Add vertex");
  const [x, y] = await placeOf("v9");
  assert.ok(Math.hypot(x - box.x - (700 / 800) * box.width, y - box.y - (100 / 520) * box.height) < 3);
  await pick("h2");
  await operator("Split edge");
  await operator("Remove edge");
  assert.ok(await isDone());
  assert.match(await text("euler"), /= 10 − 7 \+ 2 = 5, 1 \+ C = 1 \+ 4 = 5/);
  // One vertex alone gives a loop, which has a face inside.
  await pick("v9");
  await operator("Connect");
  assert.match(await text("euler"), /= 10 − 8 \+ 3 = 5, 1 \+ C = 1 \+ 4 = 5$/);
  await page.screenshot({ path: join(pictures, "lecture-euler.png") });

  // A vertex is dragged, and moved by keys.
  const from = await placeOf("v9");
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] - 60, from[1] + 40, { steps: 3 });
  await page.mouse.up();
  assert.ok(Math.hypot((await placeOf("v9"))[0] - from[0] + 60, (await placeOf("v9"))[1] - from[1] - 40) < 3);

  // A link is broken: the rules that fail are named, with the records in the picture.
  await click("forward");
  await waitFor("step-title", /Break/);
  const next = await link("h2", "next");
  await type("h2", "next", next === "h5" ? "h7" : "h5");
  assert.match(await text("verdict"), /Broken: .*L2.*/);
  assert.match(await text("rules"), /half-edge h2/);
  assert.ok(await page.$("#picture .half-edge.broken[data-name=h2]"));
  assert.ok(await page.$("#picture path.by-hand"));
  await page.screenshot({ path: join(pictures, "lecture-broken.png"), fullPage: true });
  // A link to nothing has no arrow, but its value.
  await type("h2", "twin", "h99");
  assert.ok((await text("picture")).includes("twin: h99"));
  await click("undo");
  await pick("h4");
  await operator("Split edge");
  assert.match(await text("status"), /^Links were set by hand/);
  await type("h2", "prev", "nonsense");
  assert.match(await text("status"), /`nonsense` is no value of prev: a half-edge such as h2/);
  assert.equal(await isDone(), false);
  await click("undo");
  assert.match(await text("verdict"), /All rules hold/);
  assert.ok(await isDone());

  // Everything fits, and nesting is wrong.
  await click("forward");
  await waitFor("step-title", /still wrong/);
  await click("extra");
  assert.equal(await text("verdict"), "Broken: T2");
  assert.ok(await isDone());
  await page.screenshot({ path: join(pictures, "lecture-nesting.png") });

  // From nothing: an address leads to a step, and every operator is there.
  await page.goto(`${site}#step-9`);
  await waitFor("step-title", /On your own/);
  await operator("Add vertex");
  assert.equal(await text("euler"), "V − E + F = 1 − 0 + 1 = 2, 1 + C = 1 + 1 = 2");

  // On a phone, and in the dark.
  await page.setViewport({ width: 390, height: 844, isMobile: true, hasTouch: true, deviceScaleFactor: 2 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await page.goto(`${site}#step-5`);
  await waitFor("step-title", /Holes/);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= 390), "nothing is wider than the phone");
  await page.screenshot({ path: join(pictures, "lecture-phone.png"), fullPage: true });
  await page.$eval("#picture", (one) => one.scrollIntoView({ block: "center" }));
  await page.touchscreen.tap(...(await placeOf("v8")));
  assert.equal(await text("chosen"), "Chosen: v8");
  // Everything that can be used has a name.
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, a, [role]")].filter((one) => !one.hidden && !(one.getAttribute("aria-label") || one.textContent.trim() || one.getAttribute("role") === "status")).map((one) => one.outerHTML));
  assert.deepEqual(nameless, []);
  assert.deepEqual(faults, []);
  console.log("the lecture: all is well");
} finally {
  await close();
}
