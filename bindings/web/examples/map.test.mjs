// Tests of a map, to be copied beside it: `node --test`. The map is read once, and each fault fails the test of its kind.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { audit, close } from "twinedge";

const FILE = process.env.MAP ?? new URL("map.topojson", import.meta.url);

let report;
before(async () => (report = await audit(await readFile(FILE), { name: String(FILE), explain: true })));
after(() => close());

const said = (findings) => findings.map(({ message, features, remedy }) => `${message} (${features.map(({ name }) => name)}): ${remedy}`).join("\n");

for (const [rule, name] of [["C1", "overlaps"], ["C5", "duplicates"], ["C6", "invalid polygons"]]) {
  test(`the map has no ${name}`, () => {
    const found = report.coverage.findings.filter((finding) => finding.rule === rule);
    assert.equal(found.length, 0, said(found));
  });
}

test("borders meet at their ends only", () => {
  assert.equal(report.violation_count, 0, said(report.violations));
});
