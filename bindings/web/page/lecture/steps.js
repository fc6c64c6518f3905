// The lecture: steps with a text, a structure to begin with, and a task.

import { cycleOf, faceOf, indexOf } from "./records.js";

/** Adds vertices to a face, at these places. */
export function vertices(structure, put, points, face = 1) {
  return points.map((point) => {
    const before = new Set(structure.state.keys.map(([key]) => key));
    const { keys } = structure.addIsolatedVertex(face);
    const [key, { vertex }] = keys.find(([one, record]) => !before.has(one) && "vertex" in record);
    put(key, point);
    return vertex;
  });
}

/** The half-edge from one vertex to another one. */
const edge = ({ half_edges }, u, v) => half_edges.findIndex((row) => row?.origin === u && half_edges[row.twin].origin === v);

/** Adds a polygon to a face, with its vertices counter-clockwise, and gives these. */
export function polygon(structure, put, points, face = 1) {
  const all = vertices(structure, put, points, face);
  for (let i = 0; i + 1 < all.length; i++) {
    const from = i === 0 ? { vertex: all[0] } : { halfEdge: edge(structure.state.table, all[i], all[i - 1]) };
    structure.connect(from, { vertex: all[i + 1] });
  }
  const { table } = structure.state;
  const [last, first] = [edge(table, all.at(-1), all.at(-2)), edge(table, all[0], all[1])];
  structure.connect({ halfEdge: last }, { halfEdge: first });
  return all;
}

const square = (x, y, size) => [[x, y + size], [x + size, y + size], [x + size, y], [x, y]];

/** Two triangles that share an edge. */
function kite(structure, put) {
  const [a, b, c, d] = polygon(structure, put, [[180, 400], [420, 440], [640, 260], [330, 90]]);
  const { table } = structure.state;
  structure.connect({ halfEdge: edge(table, b, c) }, { halfEdge: edge(table, d, a) });
}

/** A square with a triangle and a vertex in it. */
function island(structure, put) {
  const [a, b] = polygon(structure, put, square(170, 60, 400));
  const inside = faceOf(structure.state.table, edge(structure.state.table, a, b));
  polygon(structure, put, [[230, 390], [410, 390], [320, 190]], inside);
  vertices(structure, put, [[480, 150]], inside);
}

/** Two triangles side by side, in the unbounded face. */
function pair(structure, put) {
  polygon(structure, put, [[120, 360], [340, 360], [230, 150]]);
  polygon(structure, put, [[460, 360], [680, 360], [570, 150]]);
}

/** Puts each of the two triangles into the other: every link fits, and nothing is outside any more. */
export function nestInEachOther(structure) {
  const { table } = structure.state;
  const faces = table.faces.flatMap((row, f) => (row ? [f] : []));
  const unbounded = faces.find((f) => table.faces[f].outer === null);
  const [first, second] = faces.filter((f) => f !== unbounded);
  const outside = (f) => table.half_edges[table.half_edges[table.boundaries[table.faces[f].outer].start.half_edge].twin].boundary;
  const [b, c] = [outside(first), outside(second)];
  const set = (record, field, value) => structure.set(record, field, value);
  set({ face: unbounded }, "inner", "");
  set({ boundary: b }, "face", `f${second}`);
  set({ boundary: b }, "place", "0");
  set({ face: second }, "inner", `b${b}`);
  set({ boundary: c }, "face", `f${first}`);
  set({ boundary: c }, "place", "0");
  set({ face: first }, "inner", `b${c}`);
}

const twins = ({ half_edges }, [a, b]) => a?.[0] === "h" && b?.[0] === "h" && half_edges[indexOf(a)]?.twin === indexOf(b);

/** Says if the last names are a whole cycle, in the order of `next`. */
function wentAround({ half_edges }, trail) {
  const last = trail.at(-1);
  if (last?.[0] !== "h") return false;
  const cycle = cycleOf({ half_edges }, indexOf(last));
  const tail = trail.slice(-cycle.length);
  return tail.length === cycle.length && tail.every((name, i) => name === `h${cycle[(i + 1) % cycle.length]}`);
}

/**
 * The steps. `is` says if the task is done, by the state now and at the beginning, the names that were chosen one after the other, and the
 * operators that were done.
 */
export const STEPS = [
  {
    title: "A half-edge is one side of an edge",
    text: [
      "A doubly connected edge list stores a plane drawing as links between records. Each edge is stored twice, once for each of its sides: as two half-edges that run in opposite directions. A half-edge has its face to its left.",
      "The record of a half-edge has five links. Its origin is the vertex where it starts. The others are the subject of the next steps.",
    ],
    task: "Choose a half-edge, in the picture or in the table.",
    begin: kite,
    is: ({ trail }) => trail.some((name) => name[0] === "h"),
  },
  {
    title: "Twin",
    text: [
      "The twin of a half-edge is the other side of the same edge. It runs the other way, so a half-edge needs no link to its target: target(h) is origin(twin(h)).",
      "Rule L1 says that the twin of the twin is the half-edge itself, and that no half-edge is its own twin.",
    ],
    task: "Choose a half-edge, and then its twin.",
    begin: kite,
    is: ({ state, trail }) => twins(state.sound, trail.slice(-2)),
  },
  {
    title: "Next and prev",
    text: [
      "With its face to the left, a half-edge is followed by next and preceded by prev. Rule L2 says that they undo each other, and rule L3 that next starts where the half-edge ends.",
      "When a half-edge is chosen, the picture shows next as a solid line, prev as a dotted one, and the twin as a dashed one.",
    ],
    task: "Walk once around a face: choose a half-edge, then its next, and go on until you are back at the first one.",
    begin: kite,
    is: ({ state, trail }) => wentAround(state.sound, trail.slice(1)) && trail.length > 1,
  },
  {
    title: "Cycles bound faces",
    text: [
      "The half-edges that follow each other under next are a cycle. A cycle is a boundary component of the face to its left: the outer one of a bounded face runs counter-clockwise. The face outside of everything is the unbounded face.",
      "An edge between two corners of the same cycle makes two cycles of it, and two faces of one. The operator is called Connect. All links are set for you, and an operator never breaks a rule.",
    ],
    task: "Choose two vertices that have a face in common and no edge between them, and press Connect.",
    begin: (structure, put) => void polygon(structure, put, [[180, 400], [420, 440], [640, 260], [330, 90]]),
    is: ({ state, first }) => state.report.counts.faces > first.report.counts.faces,
  },
  {
    title: "Holes are inner boundary components",
    text: [
      "A face can have holes. Each is an inner boundary component: a cycle that runs clockwise around what lies in the hole, or a vertex without any edge. The face lists them in inner.",
      "An edge between two boundary components is a bridge. It makes one of the two, and no new face.",
    ],
    task: "Connect the square with what is inside it, until no bounded face has a hole any more.",
    begin: island,
    is: ({ state }) => state.sound.faces.every((row) => !row || row.outer === null || row.inner.length === 0),
  },
  {
    title: "Euler's formula",
    text: [
      "In every plane drawing V − E + F = 1 + C: vertices, less edges, plus faces, are one more than the connected components. The line below the picture counts along.",
      "Each operator changes both sides alike. Splitting an edge adds a vertex and an edge. Connecting adds an edge, and either a face or, as a bridge, one component less.",
    ],
    task: "Do three different operators, and look at the formula after each.",
    begin: island,
    is: ({ done }) => new Set(done).size >= 3,
  },
  {
    title: "Break a link",
    text: [
      "A program that sets links by hand can get them wrong. Every cell of the tables can be set to anything here. The validator then says which rules fail, and why. The picture stays as it was, with the records at fault in red.",
      "Type another half-edge into a next, for example h2, and press Enter. Two rules or more fail together, as the cycle, its target and its prev no longer fit.",
    ],
    task: "Break a rule. Read what the validator says. Then press Undo until all rules hold.",
    begin: kite,
    is: ({ state, wasBroken }) => wasBroken && state.report.valid,
  },
  {
    title: "Right everywhere, and still wrong",
    text: [
      "Two triangles lie side by side. Press “Nest them in each other”: the outside of each becomes a hole in the other one. Every link fits its neighbours, the counts keep Euler's formula, and yet no such drawing exists: each triangle would lie inside the other.",
      "Only one rule fails: T2, nesting. It follows components and faces outwards, and must end at the unbounded face. A validator that looks at each record alone cannot see this.",
    ],
    task: "Break it, and find the one rule that fails.",
    begin: pair,
    extra: { label: "Nest them in each other", act: nestInEachOther },
    is: ({ state }) => state.rules.filter(({ violations }) => violations > 0).map(({ id }) => id).join() === "T2",
  },
  {
    title: "On your own",
    text: [
      "All operators, all cells. A click into a face chooses it, and “Add vertex” puts a vertex where you clicked. Vertices can be dragged, or moved by the arrow keys: places are no part of the structure, which knows only who follows whom.",
      "Nothing that the operators do breaks a rule. Try to build a map with a hole in a hole.",
    ],
    task: null,
    begin: () => {},
    is: () => false,
  },
];
