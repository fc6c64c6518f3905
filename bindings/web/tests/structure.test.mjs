// The structure of the lecture, in Node.

import assert from "node:assert/strict";
import { before, beforeEach, describe, it } from "node:test";
import { InputError, OptionError } from "../package/errors.js";
import { loadStructure } from "../package/structure.js";
import { faceOf, recordOf, rowOf, textOf } from "../page/lecture/records.js";
import { OPERATORS } from "../page/lecture/operators.js";
import { layout } from "../page/lecture/picture.js";
import { nestInEachOther, polygon, STEPS, vertices } from "../page/lecture/steps.js";

const broken = ({ rules }) => rules.filter(({ violations }) => violations > 0).map(({ id }) => id);
const figures = ({ report: { counts: { vertices, edges, faces, components } } }) => [vertices, edges, faces, components];
const places = () => {};

let structure;
before(async () => (structure = await loadStructure()));
beforeEach(() => structure.clear());

/** A triangle v1, v2, v3: h2 runs from v1 to v2, h4 and h6 follow it, and all three have the face f2 to their left. */
function triangle() {
  for (let i = 0; i < 3; i++) structure.addIsolatedVertex(1);
  structure.connect({ vertex: 1 }, { vertex: 2 });
  structure.connect({ halfEdge: 3 }, { vertex: 3 });
  return structure.connect({ halfEdge: 5 }, { halfEdge: 2 });
}

describe("operators", () => {
  it("begin with one unbounded face", () => {
    assert.deepEqual(structure.state.table.faces.filter(Boolean), [{ outer: null, inner: [], outer_half_edge: null, inner_starts: [] }]);
    assert.equal(structure.state.report.valid, true);
  });

  it("build a triangle with two faces", () => {
    const state = triangle();
    assert.deepEqual(figures(state), [3, 3, 2, 1]);
    assert.equal(state.report.valid, true);
    assert.deepEqual(state.table.half_edges.filter(Boolean).map(({ origin }) => origin), [1, 2, 2, 3, 3, 1]);
  });

  it("are taken back by their inverses", () => {
    triangle();
    const inverses = [
      [() => structure.splitEdge(2), () => structure.joinEdges(2)],
      [() => structure.splitVertex({ halfEdge: 2 }, { halfEdge: 2 }), ({ table }) => structure.contractEdge(table.half_edges.length - 2)],
      [() => structure.addIsolatedVertex(2), ({ table }) => structure.removeIsolatedVertex(table.vertices.findIndex((row) => row?.isolated))],
    ];
    for (const [act, inverse] of inverses) {
      const state = act();
      assert.equal(state.report.valid, true);
      assert.deepEqual(figures(inverse(state)), [3, 3, 2, 1]);
    }
  });

  it("move a hole and turn an edge", () => {
    triangle();
    const { isolated } = structure.addIsolatedVertex(1).table.vertices[4];
    assert.deepEqual(structure.moveInner(isolated, 2).table.faces[2].inner, [isolated]);
    structure.removeIsolatedVertex(4);
    structure.splitEdge(2);
    const third = structure.state.table.half_edges.findIndex((row) => row?.origin === 3 && structure.state.table.boundaries[row.boundary].face === 2);
    const { table } = structure.connect({ halfEdge: structure.state.table.half_edges[2].next }, { halfEdge: third });
    const h = table.half_edges.length - 2;
    const ends = ({ table }) => [h, h + 1].map((one) => table.half_edges[one].origin).sort();
    assert.deepEqual(ends(structure.state), [3, 4]);
    assert.deepEqual(ends(structure.flipEdge(h)), [1, 2]);
    assert.deepEqual(ends(structure.flipEdge(h, "clockwise")), [3, 4]);
    assert.equal(structure.state.report.valid, true);
  });

  it("refuse in words of the tables, and change nothing", () => {
    const { table } = triangle();
    assert.throws(() => structure.removeIsolatedVertex(1), (error) => error instanceof InputError && error.message === "v1 is not isolated");
    assert.throws(() => structure.connect({ halfEdge: 2 }, { halfEdge: 3 }), /^InputError: the corners lie in different faces, f2 and f1$/);
    assert.throws(() => structure.splitEdge(17), (error) => error instanceof OptionError && error.message === "there is no half-edge 17");
    assert.throws(() => structure.splitEdge("x"), OptionError);
    assert.deepEqual(structure.state.table, table);
  });
});

describe("undo and redo", () => {
  it("give back every state", () => {
    triangle();
    const states = [structure.state];
    const names = ["split edge", "split vertex", "remove edge"];
    const acts = [() => structure.splitEdge(2), () => structure.splitVertex({ halfEdge: 2 }, { halfEdge: 2 }), () => structure.removeEdge(4)];
    for (const act of acts) states.push(act());
    assert.equal(structure.state.undo, names.at(-1));
    for (let i = 2; i >= 0; i--) assert.deepEqual(structure.undo().table, states[i].table);
    assert.deepEqual(structure.undo().redo, "connect");
    structure.redo();
    for (let i = 1; i <= 3; i++) assert.deepEqual(structure.redo().keys, states[i].keys);
    assert.equal(structure.state.redo, null);
    assert.deepEqual(structure.redo().table, states[3].table);
  });

  it("take back what was set by hand before they take back operators", () => {
    const { table } = triangle();
    structure.set({ half_edge: 2 }, "next", "h7");
    structure.set({ vertex: 1 }, "leaving", "-");
    assert.equal(structure.state.undo, "leaving of v1");
    assert.deepEqual(structure.state.sound, table);
    structure.undo();
    assert.deepEqual(structure.undo().table, table);
    assert.equal(structure.undo().redo, "connect");
    assert.equal(structure.redo().redo, "next of h2");
    structure.redo();
    structure.redo();
    assert.equal(structure.state.table.half_edges[2].next, 7);
    assert.equal(structure.state.table.vertices[1].leaving, null);
  });

  it("forget what was undone when a link is set", () => {
    triangle();
    structure.undo();
    structure.set({ half_edge: 2 }, "twin", "h2");
    assert.equal(structure.state.redo, null);
    assert.deepEqual(broken(structure.redo()).includes("L1"), true);
  });

  it("forget what was before, if asked", () => {
    const { table } = triangle();
    assert.deepEqual(structure.forget().table, table);
    assert.deepEqual(structure.undo().table, table);
  });
});

describe("links set by hand", () => {
  it("break the rules that they are about, in the validator's words", () => {
    triangle();
    const state = structure.set({ half_edge: 2 }, "twin", "h2");
    assert.equal(state.report.valid, false);
    const violation = state.violations.find(({ kind }) => kind === "twin_is_self");
    assert.equal(violation.rule, "L1");
    assert.equal(violation.message, "half-edge h2 is its own twin, so its edge has one side only");
    assert.deepEqual(violation.records, [{ half_edge: 2 }]);
    assert.match(violation.remedy, /^create both half-edges/);
    // A value that leads nowhere breaks R1. Rules that need one that is broken are not checked.
    assert.deepEqual(broken(structure.set({ vertex: 1 }, "leaving", "h99")).slice(0, 1), ["R1"]);
    assert.ok(structure.state.rules.some(({ unchecked }) => /needs L1, which is broken/.test(unchecked)));
  });

  it("take every form of every field, and no other", () => {
    triangle();
    structure.addIsolatedVertex(2);
    const values = { leaving: "h3", isolated: "b0", origin: "v2", twin: "h5", next: "h2", prev: "-", boundary: "b2", face: "f0", start: "v3", place: "7", outer: "b9", inner: "b0 - b0" };
    for (const [name, fields] of [["v4", ["leaving", "isolated"]], ["h2", ["origin", "twin", "next", "prev", "boundary"]], ["b2", ["face", "start", "place"]], ["f2", ["outer", "inner"]]]) {
      for (const field of fields) {
        const { table } = structure.set(recordOf(name), field, values[field]);
        assert.equal(textOf(rowOf(table, name), name[0], field), values[field]);
        assert.throws(() => structure.set(recordOf(name), field, "x1"), (error) => error instanceof OptionError && error.message.startsWith(field === "inner" ? "`x1` is no value of inner" : `\`x1\` is no value of ${field}`));
      }
    }
    assert.equal(textOf(rowOf(structure.set({ boundary: 2 }, "place", "outer").table, "b2"), "b", "place"), "outer");
    assert.throws(() => structure.set({ vertex: 1 }, "next", "h2"), /a vertex has no field `next`/);
    assert.throws(() => structure.set({ face: 9 }, "outer", "-"), /there is no face 9/);
  });

  it("keep operators away until they are undone, or right again", () => {
    const { table } = triangle();
    structure.set({ half_edge: 2 }, "next", "h7");
    assert.throws(() => structure.splitEdge(2), /set by hand: undo that before/);
    structure.set({ half_edge: 2 }, "next", `h${table.half_edges[2].next}`);
    assert.deepEqual(figures(structure.splitEdge(2)), [4, 4, 2, 1]);
    assert.equal(structure.state.undo, "split edge");
  });
});

describe("steps of the lecture", () => {
  for (const { title, begin } of STEPS) {
    it(`"${title}" begins with a sound structure`, () => {
      begin(structure, places);
      assert.equal(structure.state.report.valid, true);
      const { vertices, edges, faces, components } = structure.state.report.counts;
      assert.equal(vertices - edges + faces, 1 + components);
    });
  }

  it("nest two triangles in each other, which breaks T2 alone", () => {
    STEPS.find(({ extra }) => extra).begin(structure, places);
    nestInEachOther(structure);
    assert.deepEqual(broken(structure.state), ["T2"]);
  });
});

describe("operators in the picture", () => {
  const points = new Map();
  const put = (key, point) => points.set(key, point);
  const places = (v) => points.get(structure.state.keys.find(([, record]) => record.vertex === v)[0]);

  function operate(name, chosen) {
    const tables = structure.state.sound;
    OPERATORS[name](structure, { tables, chosen, where: layout(tables, places), places, clicked: null });
    return structure.state.sound;
  }

  const halfEdge = ({ half_edges }, u, v) => half_edges.findIndex((row) => row?.origin === u && half_edges[row.twin].origin === v);
  const faceOfVertex = (tables, v) => tables.boundaries[tables.vertices[v].isolated].face;

  for (const order of [["a", "c"], ["c", "a"]]) {
    it(`split a face so that what lies left of a diagonal is on its left: ${order}`, () => {
      const [a, b, c] = polygon(structure, put, [[0, 400], [400, 400], [400, 0], [0, 0]]);
      const inside = faceOf(structure.state.sound, halfEdge(structure.state.sound, a, b));
      const [upper, lower] = vertices(structure, put, [[100, 100], [300, 300]], inside);
      const tables = operate("Connect", order.map((one) => `v${{ a, c }[one]}`));
      assert.equal(faceOfVertex(tables, upper), faceOf(tables, halfEdge(tables, a, c)));
      assert.equal(faceOfVertex(tables, lower), faceOf(tables, halfEdge(tables, c, a)));
      assert.equal(structure.state.report.valid, true);
    });
  }

  for (const isClockwise of [false, true]) {
    it(`close a path around a vertex, ${isClockwise ? "clockwise" : "counter-clockwise"}`, () => {
      const corners = [[0, 400], [400, 400], [200, 0]];
      const path = vertices(structure, put, isClockwise ? corners.reverse() : corners);
      const [within, without] = vertices(structure, put, [[200, 300], [500, 300]]);
      operate("Connect", [`v${path[0]}`, `v${path[1]}`]);
      operate("Connect", [`v${path[1]}`, `v${path[2]}`]);
      const tables = operate("Connect", [`v${path[2]}`, `v${path[0]}`]);
      const face = faceOf(tables, isClockwise ? halfEdge(tables, path[0], path[2]) : halfEdge(tables, path[2], path[0]));
      assert.notEqual(tables.faces[face].outer, null, "the inside is the bounded face");
      assert.equal(faceOfVertex(tables, within), face);
      assert.equal(tables.faces[faceOfVertex(tables, without)].outer, null);
    });
  }
});
