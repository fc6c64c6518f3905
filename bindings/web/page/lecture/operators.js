// The operators on what is chosen: their arguments, and places for what they make.

import { angle, area, between, cornerDirection, cornerOf, distance, inside, step } from "./geometry.js";
import { cycleOf, indexOf, leavingOf, nameOf, verticesOf } from "./records.js";

/** The reason why nothing was done: something else has to be chosen first. */
export class Needs extends Error {}

/** The vertex at which a chosen vertex or half-edge begins. */
const vertexOf = (tables, name) => (name[0] === "v" ? indexOf(name) : tables.half_edges[indexOf(name)].origin);

/** The corner that a chosen vertex or half-edge stands for, seen in this direction. */
function cornerFor({ tables, where }, name, direction) {
  if (name[0] === "h") return { halfEdge: indexOf(name) };
  const halfEdge = cornerOf(tables, where.lines, indexOf(name), direction);
  return halfEdge === null ? { vertex: indexOf(name) } : { halfEdge };
}

const boundaryOf = (tables, { halfEdge, vertex }) => (halfEdge === undefined ? tables.vertices[vertex].isolated : tables.half_edges[halfEdge].boundary);

/** The polygon of the cycle that a new edge begins, and that a half-edge goes on with until another one. */
function polygonBetween({ tables, where, places }, origin, first, last) {
  const cycle = cycleOf(tables, first);
  return [places(origin), ...cycle.slice(0, cycle.indexOf(last)).flatMap((h) => where.lines[h].slice(0, -1))];
}

/** The side of a new edge on which the new face lies, and the inner boundary components in it, as in the picture. */
function splitOf(view, from, to) {
  const { tables, places } = view;
  const b = boundaryOf(tables, from);
  if (b !== boundaryOf(tables, to)) return {};
  // The inside of a loop lies to its right.
  if (from.halfEdge === to.halfEdge) return { newFace: "right" };
  const [u, v] = [from, to].map(({ halfEdge }) => tables.half_edges[halfEdge].origin);
  const left = polygonBetween(view, u, to.halfEdge, from.halfEdge);
  const isLeft = area(left) > 0;
  const region = isLeft ? left : polygonBetween(view, v, from.halfEdge, to.halfEdge);
  const { inner } = tables.faces[tables.boundaries[b].face];
  const isInside = (one) => one !== b && inside(places(verticesOf(tables, one)[0]), [region]);
  return { newFace: isLeft ? "left" : "right", inner: inner.filter(isInside) };
}

/** The last of what is chosen of these kinds. */
function last(chosen, letters, needs) {
  const name = chosen.findLast((one) => letters.includes(one[0]));
  if (name === undefined) throw new Needs(needs);
  return name;
}

const halfEdge = (chosen) => indexOf(last(chosen, "h", "Choose a half-edge first."));

/** The two corners of what is chosen: of two vertices or half-edges, or twice that of one. */
function corners(view, needs) {
  const { tables, places } = view;
  const ends = view.chosen.filter((name) => "vh".includes(name[0]));
  if (ends.length === 0) throw new Needs(needs);
  const [a, b] = [ends[0], ends.at(-1)];
  const [p, q] = [a, b].map((name) => places(vertexOf(tables, name)));
  if (distance(p, q) < 1) return [cornerFor(view, a, Math.PI / 2), cornerFor(view, b, Math.PI / 2)];
  return [cornerFor(view, a, angle(p, q)), cornerFor(view, b, angle(q, p))];
}

/** The place of a new vertex that an operator split off: near the old one, towards its neighbours or into the corner. */
function splitPlace({ tables, where, places }, corner, neighbours) {
  if (corner.vertex !== undefined) return step(places(corner.vertex), 0, 70);
  const origin = places(tables.half_edges[corner.halfEdge].origin);
  if (neighbours.length === 0) return step(origin, cornerDirection(tables, where.lines, corner.halfEdge), 60);
  const sum = neighbours.map(places).reduce(([x, y], p) => [x + p[0], y + p[1]], [0, 0]);
  return between(origin, [sum[0] / neighbours.length, sum[1] / neighbours.length], 0.45);
}

/** Moves a component into the room of a face. */
function moved({ tables, where, places }, boundary, face, move) {
  const all = verticesOf(tables, boundary);
  const points = all.map(places);
  const middle = [0, 1].map((i) => points.reduce((sum, p) => sum + p[i], 0) / points.length);
  const { point, room } = where.regions[face];
  const size = Math.max(1, ...points.map((p) => distance(p, middle)));
  const scale = Math.min(1, (0.7 * room) / size);
  all.forEach((v, i) => move(v, [0, 1].map((c) => point[c] + (points[i][c] - middle[c]) * scale)));
}

/**
 * The operators by their names. Each takes the structure and the view: the tables, the places, where everything is drawn, what is chosen, and
 * where a face was clicked. It returns how a place is found for a vertex that it made, in the state after it.
 */
export const OPERATORS = {
  "Add vertex": (structure, { chosen, where, clicked, tables }) => {
    const name = chosen.findLast((one) => one[0] === "f");
    const face = name === undefined ? tables.faces.findIndex((row) => row?.outer === null) : indexOf(name);
    structure.addIsolatedVertex(face);
    return () => clicked ?? where.regions[face].point;
  },
  "Remove vertex": (structure, { chosen }) => void structure.removeIsolatedVertex(indexOf(last(chosen, "v", "Choose an isolated vertex first."))),
  Connect: (structure, view) => {
    const [from, to] = corners(view, "Choose two vertices or half-edges of one face first. (One gives a loop.)");
    structure.connect(from, to, splitOf(view, from, to));
  },
  "Remove edge": (structure, { chosen }) => void structure.removeEdge(halfEdge(chosen)),
  "Split edge": (structure, { chosen, where }) => {
    const h = halfEdge(chosen);
    structure.splitEdge(h);
    const line = where.lines[h];
    return () => (line.length === 2 ? between(...line) : line[line.length >> 1]);
  },
  "Join edges": (structure, { chosen }) => void structure.joinEdges(halfEdge(chosen)),
  "Split vertex": (structure, view) => {
    const [from, to] = corners(view, "Choose one or two half-edges that leave the same vertex first.");
    structure.splitVertex(from, to);
    return (v, { sound }) => {
      const old = from.vertex ?? view.tables.half_edges[from.halfEdge].origin;
      const neighbours = leavingOf(sound, v).map((h) => sound.half_edges[sound.half_edges[h].twin].origin);
      return splitPlace(view, from, neighbours.filter((w) => w !== v && w !== old));
    };
  },
  "Contract edge": (structure, { chosen }) => void structure.contractEdge(halfEdge(chosen)),
  "Flip edge": (structure, { chosen }) => void structure.flipEdge(halfEdge(chosen)),
  "Flip back": (structure, { chosen }) => void structure.flipEdge(halfEdge(chosen), "clockwise"),
  "Move inner": (structure, view) => {
    const needs = "Choose a boundary component (or a half-edge or isolated vertex of it) and the face that it goes to first.";
    const face = indexOf(last(view.chosen, "f", needs));
    const name = last(view.chosen, "bhv", needs);
    const row = { b: () => indexOf(name), h: () => view.tables.half_edges[indexOf(name)].boundary, v: () => view.tables.vertices[indexOf(name)].isolated };
    const boundary = row[name[0]]();
    if (boundary === null) throw new Needs(needs);
    structure.moveInner(boundary, face);
    moved(view, boundary, face, view.move);
  },
};

/** The records that are new, and those that are gone, by the keys before and after. */
export function difference(before, after) {
  const names = (keys, others) => keys.filter(([key]) => !others.some(([other]) => other === key)).map(([, record]) => nameOf(record));
  return { made: names(after, before), gone: names(before, after) };
}

