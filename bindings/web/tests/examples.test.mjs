// The examples, as users have them: `twinedge` is an installed package, and so are three, topojson-client, d3-geo and the checker of MapLibre's styles.
//
//     node --test examples.test.mjs        from a folder with the examples and `node_modules`

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { before, test } from "node:test";
import { pathToFileURL } from "node:url";

const examples = pathToFileURL(`${process.env.EXAMPLES}/`);
const load = (name) => import(new URL(name, examples));
const run = (args, env = {}) => spawnSync(process.execPath, args, { cwd: process.env.EXAMPLES, encoding: "utf8", env: { ...process.env, NODE_TEST_CONTEXT: undefined, ...env } });

/** Two parcels that overlap, and one beyond a gap. */
const arc = (x0, x1, y0 = 0, y1 = 10) => [[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]];
const planted = {
  type: "Topology",
  arcs: [arc(0, 10), arc(9, 20), arc(0, 20, 10.001, 20)],
  objects: { parcels: { type: "GeometryCollection", geometries: ["West", "East", "North"].map((name, i) => ({ type: "Polygon", id: name, properties: { name }, arcs: [[i]] })) } },
};

let path;
before(async () => {
  path = join(await mkdtemp(join(tmpdir(), "twinedge-examples-")), "map.topojson");
  await writeFile(path, JSON.stringify(planted));
});

test("overlaps.mjs prints the overlap of a TopoJSON file", () => {
  const { status, stdout, stderr } = run(["overlaps.mjs", path, "parcels"]);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^C1 overlap West, East .*/m);
});

test("map.test.mjs fails for a map with an overlap, and passes for one without", () => {
  const tests = (map) => run(["--test", "map.test.mjs"], { MAP: map });
  const { status, stdout } = tests(path);
  assert.equal(status, 1);
  assert.match(stdout, /not ok 1 - the map has no overlaps|✖ the map has no overlaps/);
  assert.match(stdout, /West,East/);
  const sound = tests(new URL("../../../crates/layers/tests/layer/data/south-america.topojson", import.meta.url).pathname);
  assert.equal(sound.status, 0, sound.stdout);
});

test("topojson-map.mjs draws the borders, and the overlap in red", async () => {
  const { status, stdout, stderr } = run(["topojson-map.mjs", path, "parcels"]);
  assert.equal(status, 0, stderr);
  assert.match(stdout, /^<svg .*<path d="M[^"]*" fill="none" stroke="black"\/>.*<\/svg>\n$/);
  assert.match(stdout, /<path d="M[^"]*" fill="red"[^>]*><title>C1 overlap of West, East: area 10/);
});

test("topojson-map.mjs fills the faults and not the globe in a projection of d3", () => {
  const { status, stdout, stderr } = run(["topojson-map.mjs", path, "parcels", "geoEqualEarth"]);
  assert.equal(status, 0, stderr);
  const [, overlap] = stdout.match(/<path d="([^"]*)" fill="red"[^>]*><title>C1/);
  // A path around the globe goes along its edge as well, in a second part.
  assert.equal(overlap.match(/M/g).length, 1, overlap);
});

test("maplibre.mjs has a style that MapLibre takes, and puts the findings in it", async () => {
  const { LAYERS, showFindings } = await load("maplibre.mjs");
  const { validateStyleMin } = await load("node_modules/@maplibre/maplibre-gl-style-spec/dist/index.mjs");
  const [sources, layers, clicks, popups] = [{}, [], {}, []];
  const map = {
    getSource: (name) => sources[name] && { setData: (data) => (sources[name].data = data) },
    addSource: (name, source) => (sources[name] = source),
    addLayer: (layer) => layers.push(layer),
    on: (event, id, act) => (clicks[id] = act),
  };
  const url = `data:application/json,${encodeURIComponent(JSON.stringify(planted))}`;
  await showFindings(map, url, (...args) => popups.push(args));
  assert.deepEqual(validateStyleMin({ version: 8, sources, layers }), []);
  assert.deepEqual(layers, LAYERS);
  const overlap = sources.findings.data.features.find(({ properties }) => properties.rule === "C1");
  assert.match(overlap.geometry.type, /Polygon/);
  clicks["findings-areas"]({ lngLat: [9.5, 5], features: [{ properties: { ...overlap.properties, features: JSON.stringify(overlap.properties.features) } }] });
  assert.match(popups[0][1], /^C1 overlap of West, East: area 10/);
  await showFindings(map, url, () => {});
  assert.equal(layers.length, 3, "the layers are added once");
});

test("three-mesh.mjs marks the open border of a mesh, and nothing of a closed one", async () => {
  const { BoxGeometry, PlaneGeometry } = await load("node_modules/three/build/three.module.js");
  const { faultLines } = await load("three-mesh.mjs");
  const box = await faultLines(new BoxGeometry(1, 2, 3));
  assert.equal(box.report.valid, true);
  assert.equal(box.lines.geometry.getAttribute("position").count, 0);
  const plane = await faultLines(new PlaneGeometry(2, 2));
  assert.equal(plane.report.valid, false);
  const { array, count } = plane.lines.geometry.getAttribute("position");
  assert.equal(count, 8, "four edges, with two ends each");
  assert.ok(array.every((coordinate, i) => (i % 3 === 2 ? coordinate === 0 : Math.abs(coordinate) === 1)));
  assert.equal((await faultLines(new PlaneGeometry(2, 2), { closed: false })).report.valid, true);
});

test("notebook.md lists findings and changes", async () => {
  const text = await readFile(new URL("notebook.md", examples), "utf8");
  const cells = [...text.matchAll(/^```js\n([\s\S]*?)^```/gm)].map(([, code]) => code);
  assert.equal(cells.length, 6);
  const shown = [];
  globalThis.display = (one) => shown.push(one);
  globalThis.Inputs = { table: (rows) => rows };
  globalThis.FileAttachment = () => ({ json: async () => planted });
  const module = join(process.env.EXAMPLES, "notebook.mjs");
  await writeFile(module, cells.join("").replaceAll('"npm:', '"'));
  await import(pathToFileURL(module));
  const [findings, changes] = shown;
  assert.ok(findings.some(({ rule, features }) => rule === "C1" && features === "West, East"), JSON.stringify(findings));
  assert.ok(changes.some(({ feature }) => ["West", "East"].includes(feature)), JSON.stringify(changes));
});
