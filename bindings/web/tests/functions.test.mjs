// The functions, in Node: in a worker and without one.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, it } from "node:test";
import * as twinedge from "../package/index.js";
import { load } from "../package/sync.js";
import { AcceptedFindings } from "../page/accepted.js";

const polygon = (id, ring) => ({ type: "Feature", id, properties: { name: `parcel ${id}` }, geometry: { type: "Polygon", coordinates: [ring] } });
const square = (x, width, height = 4) => [[x, 0], [x + width, 0], [x + width, height], [x, height], [x, 0]];
const collection = (...features) => ({ type: "FeatureCollection", features });
/** The right one begins half a unit inside the left one. */
const overlapping = collection(polygon(1, square(0, 4)), polygon(2, square(3.5, 4)));
const data = (path) => readFile(new URL(`../../../${path}`, import.meta.url));
/** A triangle: half-edges 0, 2 and 4 run around its inside. */
const triangle = { origin: [0, 1, 1, 2, 2, 0], twin: [1, 0, 3, 2, 5, 4], next: [2, 5, 4, 1, 0, 3] };

/** A module with the exports of twinedge that says this and ends, as it does after a panic. */
function panicking(message) {
  const text = (word) => [word.length, ...Buffer.from(word)];
  const section = (id, ...items) => [id, items.flat().length + 1, items.length, ...items.flat()];
  const [i32, end] = [0x7f, 0x0b];
  const body = (...code) => [code.length + 2, 0, ...code, end];
  const constant = (number) => [0x41, number];
  return new Uint8Array([
    ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
    ...section(1, [0x60, 2, i32, i32, 0], [0x60, 1, i32, 1, i32]),
    ...section(2, [...text("twinedge"), ...text("stage"), 0, 0], [...text("twinedge"), ...text("panicked"), 0, 0]),
    ...section(3, [1], [1]),
    ...section(5, [0, 1]),
    ...section(7, [...text("memory"), 2, 0], ...["buffer", "address", "length"].map((name) => [...text(name), 0, 2]), [...text("call"), 0, 3]),
    // The first function gives 63, as a number or as an address; the other one panics and traps.
    ...section(10, body(...constant(63)), body(...constant(0), ...constant(message.length), 0x10, 1, 0x00)),
    ...section(11, [0, ...constant(0), end, ...text(message)]),
  ]);
}

let sync;
before(async () => (sync = await load()));
after(() => twinedge.close());

describe("audit", () => {
  it("finds an overlap with its features, its area and its place", async () => {
    const { valid, coverage } = await twinedge.audit(overlapping);
    assert.equal(valid, false, "borders that cross are no planar map");
    const [finding] = coverage.findings;
    assert.deepEqual([coverage.overlaps, finding.rule, finding.area], [1, "C1", 2]);
    assert.deepEqual(finding.features.map(({ name }) => name), ["parcel 1", "parcel 2"]);
  });

  it("finishes a layer of many equal squares, all of whose numbers repeat", async () => {
    const side = 500;
    const squares = Array.from({ length: side * side }, (_, i) => polygon(i, square(i % side, 1, 1).map(([x, y]) => [x, y + Math.floor(i / side)])));
    const { valid, counts } = await twinedge.audit({ type: "FeatureCollection", features: squares });
    assert.deepEqual([valid, counts.vertices, counts.edges, counts.faces], [true, (side + 1) ** 2, 2 * side * (side + 1), side ** 2 + 1]);
  });

  it("says in the thread what it says in the worker", async () => {
    const timeless = ({ elapsed_ms, ...report }) => report;
    assert.deepEqual(timeless(await twinedge.audit(overlapping)), timeless(sync.audit(overlapping)));
  });

  it("takes text, bytes, buffers, objects and files", async () => {
    const text = JSON.stringify(overlapping);
    const bytes = new TextEncoder().encode(text);
    for (const input of [text, bytes, bytes.buffer, Buffer.from(text), overlapping, { name: "a.geojson", bytes }, [{ name: "a.geojson", bytes }]]) {
      assert.equal((await twinedge.audit(input)).coverage.overlaps, 1);
    }
  });

  it("takes an array of features as one collection: each overlap of the collection is found", async () => {
    const { features } = overlapping;
    assert.equal((await twinedge.audit(features)).coverage.overlaps, 1);
    assert.equal((await twinedge.audit(features.map(({ geometry }) => geometry))).coverage.overlaps, 1);
    assert.equal((await twinedge.audit([overlapping])).coverage.overlaps, 1);
    await assert.rejects(twinedge.audit([{ type: "Topology" }, ...features]), { name: "OptionError", message: /Topology/ });
  });

  it("refuses several maps, and names them; `layer` chooses one", async () => {
    const file = (name, layer) => ({ name, bytes: new TextEncoder().encode(JSON.stringify(layer)) });
    const files = [file("may.geojson", overlapping), file("june.geojson", collection(overlapping.features[0]))];
    await assert.rejects(twinedge.audit(files), ({ name, message, place }) => {
      assert.deepEqual([name, place.layers], ["InputError", ["may.geojson", "june.geojson"]]);
      return /may\.geojson, june\.geojson/.test(message);
    });
    assert.equal((await twinedge.audit(files, { layer: "may.geojson" })).coverage.overlaps, 1);
    assert.equal((await twinedge.audit(files, { layer: "june.geojson" })).coverage.overlaps, 0);
    // Other files are passed over.
    assert.equal((await twinedge.audit([file("may.geojson", overlapping), { name: "notes.pdf", bytes: new Uint8Array(4) }])).coverage.overlaps, 1);
    const [shp, dbf, cpg] = shapefile([], "UTF-8");
    const other = { ...shp, name: "b.shp" };
    await assert.rejects(twinedge.convert([shp, dbf, cpg, other], { to: "geojson" }), { message: /a\.shp, b\.shp/ });
  });

  it("advises no format that it does not read", async () => {
    const photo = { name: "photo.png", bytes: new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]) };
    await assert.rejects(twinedge.audit(photo), ({ code, message }) => code === "format" && !/GeoPackage|GeoParquet|GPKG/.test(message));
    const database = { name: "a.gpkg", bytes: new TextEncoder().encode("SQLite format 3\0") };
    await assert.rejects(twinedge.audit(database), { code: "needs-program" });
  });

  it("takes a File and a Blob", async () => {
    const blob = new Blob([JSON.stringify(overlapping)]);
    for (const input of [blob, new File([blob], "a.geojson"), [new File([blob], "a.geojson")], { name: "a.geojson", bytes: blob }]) {
      assert.equal((await twinedge.audit(input)).coverage.overlaps, 1);
    }
    assert.throws(() => sync.audit(blob), { name: "OptionError", message: /arrayBuffer/ });
  });

  it("counts causes, and has a headline of the structure and the coverage", async () => {
    const { headline, causes, consequences, coverage } = await twinedge.audit(overlapping);
    assert.deepEqual([causes, coverage.verdict], [1, "invalid"]);
    assert.equal(headline, `not valid: 1 finding, from which ${consequences} others follow · structure not valid · coverage: 1 overlap; 2 rules not checked`);
  });

  it("reads TopoJSON, and its arcs as they are", async () => {
    const topology = JSON.parse(await data("crates/layers/tests/layer/data/south-america.topojson"));
    const report = await twinedge.audit(topology);
    assert.deepEqual([report.valid, report.coverage.overlaps], [true, 0]);
    assert.equal((await twinedge.audit(topology, { arcs: true })).valid, true);
  });

  it("judges a mesh by what it must be", async () => {
    const open = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 1 0 3\n3 1 2 3\n";
    assert.equal((await twinedge.audit(open, { name: "open.off" })).valid, false, "two faces are wound against each other");
    const closed = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
    assert.equal((await twinedge.audit(closed, { closed: true, genus: 0, triangles: true })).valid, true);
    assert.equal((await twinedge.audit(closed, { genus: 1 })).valid, false);
  });

  it("judges where the points of a mesh lie, if asked", async () => {
    const inwards = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
    assert.equal((await twinedge.audit(inwards, { closed: true })).valid, true);
    const report = await twinedge.audit(inwards, { noZeroArea: true, noCrossings: true, outward: true });
    const broken = report.rules.filter((rule) => rule.violations).map((rule) => rule.id);
    assert.deepEqual(broken, ["M11"]);
  });

  it("judges edges along great circles, if asked", async () => {
    const box = (id, south, north) => ({ type: "Feature", id, properties: null, geometry: { type: "Polygon", coordinates: [[[0, south], [60, south], [60, north], [0, north], [0, south]]] } });
    // A great circle between two points of the northern hemisphere runs north of their parallel.
    const boxes = [box("south", 10, 40), { ...box("north", 40, 60), geometry: { type: "Polygon", coordinates: [[[0, 40], [30, 40], [60, 40], [60, 60], [0, 60], [0, 40]]] } }];
    assert.equal((await twinedge.audit(boxes)).coverage.overlaps, 0);
    assert.equal((await twinedge.audit(boxes, { edges: "geodesic" })).coverage.overlaps, 1);
  });

  it("judges parts by their parents, if asked", async () => {
    const box = (id, parent, x0, x1) => ({ type: "Feature", id, properties: { parent }, geometry: { type: "Polygon", coordinates: [[[x0, 0], [x1, 0], [x1, 2], [x0, 2], [x0, 0]]] } });
    const report = await twinedge.audit([box("whole", null, 0, 4), box("left", "whole", 0, 2), box("right", "whole", 2, 3)], { parentColumn: "parent" });
    assert.deepEqual(report.findings.filter((finding) => finding.rule === "X4").map((finding) => finding.kind), ["parent_not_covered"]);
  });

  it("makes a page and a layer of what it found", async () => {
    const page = await twinedge.auditPage(overlapping);
    assert.match(page, /^<!doctype html>/);
    const { features } = await twinedge.findings(overlapping);
    assert.ok(features.some(({ properties }) => properties.rule === "C1"));
  });

  it("tells which stage of the work begins", async () => {
    const stages = [];
    await twinedge.audit(overlapping, { progress: (stage) => stages.push(stage) });
    assert.deepEqual(stages.slice(0, 3), ["reading", "building the map", "validating"]);
  });
});

describe("winding", () => {
  const area = (ring) => ring.slice(1).reduce((sum, [x, y], i) => sum + ring[i][0] * y - x * ring[i][1], 0) / 2;
  const outer = ({ features }) => features.flatMap(({ geometry: { type, coordinates } }) => (type === "Polygon" ? [coordinates[0]] : type === "MultiPolygon" ? coordinates.map(([ring]) => ring) : []));

  it("is that of RFC 7946, or that of d3 if asked", async () => {
    for (const make of [
      (options) => twinedge.findings(overlapping, options),
      async (options) => (await twinedge.clean(overlapping, options)).layer,
      (options) => twinedge.voronoi([[0, 0], [4, 0], [2, 3]], options),
      async (options) => sync.findings(overlapping, options),
    ]) {
      const [usual, forD3] = [await make({}), await make({ winding: "d3" })].map(outer);
      assert.ok(usual.length > 0 && usual.every((ring) => area(ring) > 0), JSON.stringify(usual));
      assert.ok(forD3.length === usual.length && forD3.every((ring) => area(ring) < 0), JSON.stringify(forD3));
    }
    await assert.rejects(twinedge.findings(overlapping, { winding: "right" }), { name: "OptionError", message: /rfc7946, d3/ });
  });
});

describe("accepted findings", () => {
  const judged = { snap: "auto", coverage: true };
  /** As `twinedge audit --snap auto --coverage --accept-all` wrote it. */
  const written = {
    schema: "twinedge-accepted/1",
    accepted: [{ id: "C1-452944500fc7672d", reason: "a quarrel", date: "2026-11-25", rule: "C1", features: ["1", "2"], at: [3.75, 2], area: 2, length: 9 }],
  };

  it("are written as the program writes them", async () => {
    const list = await twinedge.acceptAll(overlapping, { ...judged, reason: "a quarrel" });
    assert.match(list.accepted[0].date, /^\d{4}-\d\d-\d\d$/);
    list.accepted[0].date = written.accepted[0].date;
    assert.deepEqual(list, written);
  });

  it("are read as the program reads them, and hold until they grow", async () => {
    const { valid, accepted, coverage } = await twinedge.audit(overlapping, { ...judged, accept: written });
    assert.deepEqual([valid, accepted, coverage.findings[0].accepted], [true, { count: 1, grown: [], gone: [] }, "a quarrel"]);
    const { features } = await twinedge.findings(overlapping, { ...judged, accept: written });
    assert.equal(features[0].properties.accepted, "a quarrel");
    const smaller = structuredClone(written);
    smaller.accepted[0].area = 1;
    assert.equal((await twinedge.audit(overlapping, { ...judged, accept: smaller })).valid, false);
    for (const accept of [{ ...written, schema: "twinedge-accepted/0" }, { accepted: [] }, { ...written, accepted: [{}] }]) {
      await assert.rejects(twinedge.audit(overlapping, { accept }), { name: "OptionError", message: /^accept: / });
    }
  });

  it("are the same in the page: what it saves the program reads, and the other way round", async () => {
    const { page, acceptAll } = await twinedge.auditWithPage(overlapping, judged);
    const [{ id }] = JSON.parse(page.match(/type="application\/json">(.*?)<\/script>/s)[1]).findings;
    assert.equal(acceptAll.accepted[0].id, id);
    const made = new AcceptedFindings();
    made.add(acceptAll.accepted[0], "a quarrel");
    const read = new AcceptedFindings().with([{ name: "accepted.json", bytes: Buffer.from(JSON.stringify(written)) }]);
    assert.deepEqual(read.list(), written);
    assert.deepEqual(read.with([]).list(), written);
    for (const list of [made, read]) {
      assert.equal((await twinedge.audit(overlapping, { ...judged, accept: JSON.parse(list.text()) })).valid, true);
    }
    for (const text of ["{", "[]", '{"accepted": []}', JSON.stringify(overlapping)]) {
      assert.throws(() => read.with([{ name: "a.json", bytes: Buffer.from(text) }]), /a\.json: no list of accepted findings/);
    }
    made.remove(id);
    assert.deepEqual(made.all(), []);
  });

  it("go from the module to the program and back", { skip: !process.env.TWINEDGE && "no program: TWINEDGE is not set" }, async () => {
    const folder = await mkdtemp(join(tmpdir(), "twinedge-accepted-"));
    try {
      const [layer, list] = ["layer.geojson", "accepted.json"].map((name) => join(folder, name));
      const program = (...options) =>
        spawnSync(process.env.TWINEDGE, ["audit", layer, "--snap", "auto", "--coverage", "--quiet", ...options]).status;
      await writeFile(layer, JSON.stringify(overlapping));
      const made = new AcceptedFindings();
      made.add((await twinedge.auditWithPage(overlapping, judged)).acceptAll.accepted[0], "a quarrel");
      await writeFile(list, made.text());
      assert.deepEqual([program(), program("--accept", list)], [1, 0]);
      program("--accept-all", list);
      const accept = new AcceptedFindings().with([{ name: list, bytes: await readFile(list) }]).list();
      assert.equal((await twinedge.audit(overlapping, { ...judged, accept })).valid, true);
    } finally {
      await rm(folder, { recursive: true });
    }
  });
});

/** A Shapefile of one point, whose name has these bytes. */
function shapefile(bytes, charset) {
  const [shp, dbf] = [new DataView(new ArrayBuffer(128)), new DataView(new ArrayBuffer(75))];
  for (const [at, number] of [[0, 9994], [24, 64], [100, 1], [104, 10]]) shp.setInt32(at, number);
  for (const [at, number] of [[28, 1000], [32, 1], [108, 1]]) shp.setInt32(at, number, true);
  new Uint8Array(dbf.buffer).set([3, 124, 1, 1, 1, 0, 0, 0, 65, 0, 9]);
  new Uint8Array(dbf.buffer, 32).set(Buffer.from("name\0\0\0\0\0\0\0C"));
  dbf.setUint8(48, 8);
  new Uint8Array(dbf.buffer, 64).set([0x0d, 0x20, ...bytes, ...Array(8 - bytes.length).fill(0x20), 0x1a]);
  const file = (name, { buffer }) => ({ name, bytes: new Uint8Array(buffer) });
  return [file("a.shp", shp), file("a.dbf", dbf), { name: "a.cpg", bytes: new Uint8Array(Buffer.from(charset)) }];
}

describe("character sets", () => {
  it("are those of the Encoding Standard and of DOS", async () => {
    // The bytes are those of Python's codecs.
    for (const [charset, bytes, text] of [
      ["CP932", [0x93, 0x8c, 0x8b, 0x9e, 0x93, 0x73], "東京都"],
      ["GBK", [0xb1, 0xb1, 0xbe, 0xa9, 0xca, 0xd0], "北京市"],
      ["950", [0xbb, 0x4f, 0xa5, 0x5f, 0xa5, 0xab], "臺北市"],
      ["949", [0xbc, 0xad, 0xbf, 0xef, 0xbd, 0xc3], "서울시"],
      ["OEM 437", [0x5a, 0x81, 0x72, 0x69, 0x63, 0x68], "Zürich"],
      ["OEM 866", [0x8c, 0xae, 0xe1, 0xaa, 0xa2, 0xa0], "Москва"],
      ["ISO 8859-2", [0xa3, 0xf3, 0x64, 0xbc], "Łódź"],
      ["1252", [0x8a, 0x6b, 0x6f, 0x64, 0x61, 0x80], "Škoda€"],
      ["UTF-8", [0x5a, 0xc3, 0xbc], "Zü"],
    ]) {
      const { bytes: geojson } = await twinedge.convert(shapefile(bytes, charset), { to: "geojson" });
      assert.equal(JSON.parse(Buffer.from(geojson)).features[0].properties.name, text, charset);
    }
  });

  it("refuse what is no text of them, and names that there are not", async () => {
    await assert.rejects(twinedge.convert(shapefile([0x93], "CP932"), { to: "geojson" }), { name: "InputError", code: "content" });
    await assert.rejects(twinedge.convert(shapefile([0xff], "UTF-8"), { to: "geojson" }), { name: "InputError", code: "content" });
    await assert.rejects(twinedge.convert(shapefile([0xff], "klingon"), { to: "geojson" }), /klingon/);
  });
});

describe("errors", () => {
  it("have a class, a code and a place", async () => {
    const broken = '{"type": "FeatureCollection",\n "features": [{"type": "Feature", "geometry": {"type": "Point", "coordinates": [1]}}]}';
    await assert.rejects(twinedge.audit(broken, { name: "broken.geojson" }), (error) => {
      assert.ok(error instanceof twinedge.InputError && error instanceof Error);
      assert.deepEqual([error.name, error.code, error.place.input, error.place.line], ["InputError", "content", "broken.geojson", 2]);
      return true;
    });
  });

  it("are of options where an option is wrong", async () => {
    await assert.rejects(twinedge.audit(overlapping, { gapWith: 1 }), { name: "OptionError", message: /gapWith/ });
    await assert.rejects(twinedge.audit(overlapping, { edges: "round" }), { name: "OptionError", message: /^edges: .*straight/ });
    await assert.rejects(twinedge.clean(overlapping, { genus: 1 }), { name: "OptionError", message: /^genus: / });
    await assert.rejects(twinedge.audit(overlapping, { gapWidth: -1 }), { name: "OptionError", message: /gapWidth/ });
    await assert.rejects(twinedge.audit(overlapping, { geodesic: true, nameFrom: "owner" }), { name: "OptionError", message: /owner/ });
    await assert.rejects(twinedge.audit(7), twinedge.OptionError);
  });

  it("name the layers that there are", async () => {
    const topology = { type: "Topology", arcs: [], objects: { a: { type: "GeometryCollection", geometries: [] }, b: { type: "GeometryCollection", geometries: [] } } };
    await assert.rejects(twinedge.audit(topology), (error) => error.code === "layer" && error.place.layers.join() === "a,b");
  });

  it("leave the functions usable, when twinedge itself fails", async () => {
    const { Engine } = await import("../package/engine.js");
    const engine = new Engine(new WebAssembly.Module(panicking("planted")));
    const broken = engine.exports;
    assert.throws(() => engine.call({ op: "audit" }), { name: "InternalError", message: "twinedge failed: planted" });
    assert.notEqual(engine.exports, broken, "its memory is used no more");
  });
});

describe("cancelling", () => {
  it("rejects with the reason, and what else was asked is done all the same", async () => {
    const controller = new AbortController();
    const reason = new Error("enough");
    const cancelled = twinedge.audit(await data("crates/cli/data/world-110m.geojson"), { signal: controller.signal, progress: () => controller.abort(reason) });
    const other = twinedge.audit(overlapping);
    await assert.rejects(cancelled, reason);
    assert.equal((await other).coverage.overlaps, 1);
    await assert.rejects(twinedge.audit(overlapping, { signal: AbortSignal.abort(reason) }), reason);
  });
});

describe("clean", () => {
  it("resolves the overlap and keeps ids and attributes; once more it changes nothing", async () => {
    const { report, layer } = await twinedge.clean(overlapping, { overlap: "first" });
    assert.deepEqual([report.clean, report.changes.length, report.changes[0].area], [true, 1, 2]);
    assert.deepEqual(layer.features.map(({ id, properties }) => [id, properties.name]), [[1, "parcel 1"], [2, "parcel 2"]]);
    assert.equal((await twinedge.audit(layer, { coverage: true })).valid, true);
    assert.equal((await twinedge.clean(layer)).report.changes.length, 0);
  });
});

describe("convert", () => {
  it("writes what it reads again, a Shapefile in a zip archive too", async () => {
    for (const to of ["geojson", "geojsonl", "wkt", "wkb", "flatgeobuf", "shapefile"]) {
      const file = await twinedge.convert(overlapping, { to, lossy: true });
      assert.equal((await twinedge.audit(file)).coverage.overlaps, 1, to);
    }
  });

  it("refuses what would be lost, and says what", async () => {
    await assert.rejects(twinedge.convert(overlapping, { to: "wkt" }), (error) => error.code === "loss" && /attributes/.test(error.message));
    const { losses } = await twinedge.convert(overlapping, { to: "wkt", lossy: true });
    assert.ok(losses.length > 0);
  });
});

describe("neighbours", () => {
  it("measures common borders", async () => {
    const { pairs } = await twinedge.neighbours(collection(polygon("a", square(0, 4)), polygon("b", square(4, 2))));
    assert.deepEqual(pairs.map(({ id, other_id, length }) => [id, other_id, length]), [["a", "b", 4]]);
  });
});

describe("voronoi", () => {
  it("cuts a box between two points in the middle", async () => {
    const { features } = await twinedge.voronoi([[1, 1], [3, 1]], { bounds: [0, 0, 4, 2] });
    const xs = features.map(({ geometry }) => geometry.coordinates[0].map(([x]) => x));
    assert.deepEqual(xs.map((all) => [Math.min(...all), Math.max(...all)]), [[0, 2], [2, 4]]);
  });

  it("makes triangles", async () => {
    const { features } = await twinedge.voronoi([[0, 0], [1, 0], [0, 1]], { delaunay: true });
    assert.deepEqual(features[0].properties.sites.toSorted(), [0, 1, 2]);
  });
});

describe("validate", () => {
  it("accepts a triangle, in arrays of each kind", async () => {
    for (const Column of [Array, Int32Array, Uint32Array]) {
      const columns = Object.fromEntries(Object.entries(triangle).map(([name, links]) => [name, Column.from(links)]));
      assert.equal((await twinedge.validate(columns)).valid, true);
    }
  });

  it("names the rule and the half-edge of each broken link", async () => {
    for (const [column, expected] of [["twin", "L1"], ["next", "L2"], ["origin", "L3"]]) {
      const broken = structuredClone(triangle);
      broken[column][0] = broken[column][2];
      const { valid, violations } = await twinedge.validate(broken);
      assert.deepEqual([valid, violations[0].rule], [false, expected], column);
    }
    const { violations } = await twinedge.validate({ ...triangle, next: [99, 5, 4, 1, 0, 3] });
    assert.equal(violations[0].kind, "dangling");
  });

  it("refuses columns of different lengths, names that there are not, and expectations that mean nothing", async () => {
    await assert.rejects(twinedge.validate({ ...triangle, twin: [1, 0] }), { name: "OptionError", message: /twin/ });
    await assert.rejects(twinedge.validate({ ...triangle, nxt: [] }), { name: "OptionError", message: /nxt/ });
    await assert.rejects(twinedge.validate(triangle, "sphere"), { name: "OptionError", message: /expectation/ });
  });
});

/** The certificate of a square, as `twinedge certify` wrote it, with some numbers changed. */
async function certificate(change = () => {}) {
  const columns = JSON.parse(await data("bindings/web/tests/certificate.json"));
  change(columns);
  const bytes = (name, numbers) => new Uint8Array((name.endsWith(".u32") ? Uint32Array.from(numbers) : BigInt64Array.from(numbers.map(BigInt))).buffer);
  return Object.fromEntries(Object.entries(columns).map(([name, value]) => [name, typeof value === "string" ? value : bytes(name, value)]));
}

describe("check", () => {
  it("accepts a certificate, and refuses it with any link changed", async () => {
    assert.deepEqual(await twinedge.check(await certificate()), { valid: true, claim: "a plane subdivision, drawn without crossings", failures: [] });
    const names = Object.keys(await certificate()).filter((name) => /^half_edge_(next|origin|prev|twin)/.test(name));
    assert.equal(names.length, 4);
    for (const name of names) {
      const { valid, failures } = await twinedge.check(await certificate((columns) => (columns[name][2] ^= 1)));
      assert.ok(!valid && failures.length > 0, name);
    }
  });

  it("needs a claim that it knows", async () => {
    await assert.rejects(twinedge.check({}), { code: "content", message: /claim\.txt is missing/ });
    await assert.rejects(twinedge.check({ "claim.txt": "something else\n" }), { message: /no claim that is known/ });
  });
});
