// Lines, polygons and places of the picture. It is as on screens: y grows downwards.

import { cycleOf, leavingOf } from "./records.js";

const LOOP = 55;
const BEND = 70;
const STEPS = 16;

const along = ([a, b], t) => a + (b - a) * t;
export const between = (p, q, t = 0.5) => [along([p[0], q[0]], t), along([p[1], q[1]], t)];
export const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

/** The direction from one point to another one, counter-clockwise on the screen. */
export const angle = (p, q) => Math.atan2(p[1] - q[1], q[0] - p[0]);
export const turn = (from, to) => (((to - from) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
export const step = (p, direction, length) => [p[0] + length * Math.cos(direction), p[1] - length * Math.sin(direction)];

/** Twice the area of a polygon, positive if it runs counter-clockwise on the screen. */
export const area = (polygon) => polygon.reduce((sum, p, i) => sum + polygon[(i + 1) % polygon.length][0] * p[1] - p[0] * polygon[(i + 1) % polygon.length][1], 0);

export function inside(point, polygons) {
  let is = false;
  for (const polygon of polygons) {
    for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
      const [p, q] = [polygon[i], polygon[j]];
      if (p[1] > point[1] !== q[1] > point[1] && point[0] < p[0] + ((point[1] - p[1]) / (q[1] - p[1])) * (q[0] - p[0])) is = !is;
    }
  }
  return is;
}

function distanceToLine(point, p, q) {
  const length = distance(p, q) ** 2;
  const t = length ? Math.max(0, Math.min(1, ((point[0] - p[0]) * (q[0] - p[0]) + (point[1] - p[1]) * (q[1] - p[1])) / length)) : 0;
  return distance(point, between(p, q, t));
}

/** The point of a region that is farthest from its border, and how far that is. */
export function innermost(polygons, [x0, y0, x1, y1]) {
  let best = { point: [(x0 + x1) / 2, (y0 + y1) / 2], room: 0 };
  for (let i = 1; i < 32; i++) {
    for (let j = 1; j < 24; j++) {
      const point = [along([x0, x1], i / 32), along([y0, y1], j / 24)];
      if (!inside(point, polygons)) continue;
      let room = Infinity;
      for (const polygon of polygons) {
        polygon.forEach((p, k) => (room = Math.min(room, distanceToLine(point, p, polygon[(k + 1) % polygon.length]))));
      }
      if (room > best.room) best = { point, room };
    }
  }
  return best;
}

const curve = (controls) =>
  Array.from({ length: STEPS + 1 }, (_, i) => {
    let points = controls;
    while (points.length > 1) points = points.slice(1).map((q, k) => between(points[k], q, i / STEPS));
    return points[0];
  });

/** The line of a loop, counter-clockwise, into the widest gap around its vertex. */
function loop(tables, places, v, nth) {
  const others = leavingOf(tables, v)
    .map((h) => tables.half_edges[tables.half_edges[h].twin].origin)
    .filter((w) => w !== v)
    .map((w) => angle(places(v), places(w)))
    .sort((a, b) => a - b);
  let [middle, widest] = [Math.PI / 2, 0];
  others.forEach((from, i) => {
    const gap = turn(from, others[(i + 1) % others.length]) || 2 * Math.PI;
    if (gap > widest) [middle, widest] = [from + gap / 2, gap];
  });
  const [direction, size] = [middle + (others.length ? 0 : nth * 2), LOOP * (2.2 + nth * (others.length ? 0.8 : 0))];
  return curve([places(v), step(places(v), direction - 0.7, size), step(places(v), direction + 0.7, size), places(v)]);
}

/** The line of each half-edge, from its origin to its target. Parallel edges are bent, loops are round. */
export function linesOf(tables, places) {
  const lines = [];
  const bundles = new Map();
  tables.half_edges.forEach((row, h) => {
    if (!row || row.twin < h) return;
    const ends = [row.origin, tables.half_edges[row.twin].origin];
    const key = [...ends].sort((a, b) => a - b).join();
    if (!bundles.has(key)) bundles.set(key, []);
    bundles.get(key).push([h, ...ends]);
  });
  for (const bundle of bundles.values()) {
    bundle.forEach(([h, a, b], nth) => {
      const t = tables.half_edges[h].twin;
      let line;
      if (a === b) {
        line = loop(tables, places, a, nth);
        // The half-edge that bounds what is inside runs counter-clockwise.
        const isInner = (one) => tables.half_edges[one].next === one || tables.boundaries[tables.half_edges[one].boundary].place === "outer";
        if (tables.half_edges[h].next !== h && isInner(t)) line.reverse();
      } else {
        const [p, q] = [places(a), places(b)];
        const bend = (nth - (bundle.length - 1) / 2) * BEND * (a < b ? 1 : -1);
        const length = distance(p, q) || 1;
        const middle = between(p, q);
        line = bend === 0 ? [p, q] : curve([p, [middle[0] + ((q[1] - p[1]) / length) * bend, middle[1] - ((q[0] - p[0]) / length) * bend], q]);
      }
      lines[h] = line;
      lines[t] = [...line].reverse();
    });
  }
  return lines;
}

/** The polygon of a cycle. */
export const polygonOf = (tables, lines, h) => cycleOf(tables, h).flatMap((one) => lines[one].slice(0, -1));

/** A part of a line, moved to its left; so far from both ends. */
export function beside(line, offset, trim) {
  const lengths = line.slice(1).map((q, i) => distance(line[i], q));
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  const cut = Math.min(trim, whole / 3);
  const at = (where) => {
    let i = 0;
    while (i < lengths.length - 1 && where > lengths[i]) where -= lengths[i++];
    const direction = angle(line[i], line[i + 1]);
    return step(between(line[i], line[i + 1], lengths[i] ? where / lengths[i] : 0), direction + Math.PI / 2, offset);
  };
  const n = line.length === 2 ? 1 : STEPS;
  return Array.from({ length: n + 1 }, (_, i) => at(cut + ((whole - 2 * cut) * i) / n));
}

/** The half-edge in whose corner a line from the vertex in this direction begins; nothing, if the vertex is isolated. */
export function cornerOf(tables, lines, v, direction) {
  const all = leavingOf(tables, v).map((h) => [turn(angle(lines[h][0], lines[h][1]), direction), h]);
  return all.length ? all.reduce((best, one) => (one[0] < best[0] ? one : best))[1] : null;
}

/** The middle of the corner of a half-edge, as a direction. */
export function cornerDirection(tables, lines, h) {
  const from = angle(lines[h][0], lines[h][1]);
  const others = leavingOf(tables, tables.half_edges[h].origin).map((one) => turn(from, angle(lines[one][0], lines[one][1]))).filter((gap) => gap > 1e-9);
  return from + (others.length ? Math.min(...others) : 2 * Math.PI) / 2;
}
