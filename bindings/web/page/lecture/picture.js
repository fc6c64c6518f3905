// The structure as SVG: faces, half-edges with their arrows, vertices; what is chosen, its links, and what is broken.

import { beside, innermost, linesOf, polygonOf } from "./geometry.js";
import { faceOf, FIELDS, nameOf, namesOf, rowOf, textOf } from "./records.js";

export const WIDTH = 800;
export const HEIGHT = 520;
const WHOLE = [[0, 0], [WIDTH, 0], [WIDTH, HEIGHT], [0, HEIGHT]];

function svg(name, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const path = (points, close = "") => `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}${close}`;
const middleOf = (line) => line[Math.floor((line.length - 1) / 2)].map((c, i) => (c + line[Math.ceil((line.length - 1) / 2)][i]) / 2);

/** The place of everything: lines of half-edges, and polygons and a place for the label of each face. */
export function layout(tables, places) {
  const lines = linesOf(tables, places);
  const regions = tables.faces.map((row) => {
    if (!row) return null;
    const bounds = [row.outer, ...row.inner].filter((b) => b !== null).map((b) => tables.boundaries[b]);
    const polygons = bounds.flatMap(({ start }) => (start.half_edge === undefined ? [] : [polygonOf(tables, lines, start.half_edge)]));
    if (row.outer === null) polygons.unshift(WHOLE);
    const [xs, ys] = [0, 1].map((i) => polygons[0].map((p) => p[i]));
    const box = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
    // A label stands beside the isolated vertices of its face.
    const dots = bounds.flatMap(({ start }) => (start.vertex === undefined ? [] : [[places(start.vertex)]]));
    return { polygons, ...innermost([...polygons, ...dots], box) };
  });
  return { lines, regions };
}

/** The links of what is chosen, by the names of the records to which they lead. */
function linksOf(tables, name) {
  const row = name && rowOf(tables, name);
  if (!row || name[0] !== "h") return {};
  const links = {};
  for (const field of ["prev", "next", "twin"]) if (row[field] !== null) links[`h${row[field]}`] = field;
  return links;
}

/** The half-edges of the cycle, or of the cycles, of a boundary component or a face. */
function halfEdgesOf(tables, name) {
  const index = Number(name.slice(1));
  const is = { b: (row) => row.boundary === index, f: (_, h) => faceOf(tables, h) === index }[name[0]];
  return is ? tables.half_edges.flatMap((row, h) => (row && is(row, h) ? [`h${h}`] : [])) : [];
}

/** The place of a record in the picture. */
function placeOf(name, tables, places, { lines, regions }) {
  const index = Number(name.slice(1));
  if (!rowOf(tables, name)) return null;
  if (name[0] === "v") return places(index);
  if (name[0] === "h") return middleOf(beside(lines[index], 5, 16));
  if (name[0] === "f") return regions[index].point;
  const { start } = tables.boundaries[index];
  return start.vertex === undefined ? middleOf(beside(lines[start.half_edge], 5, 16)) : places(start.vertex);
}

/** The links that were set by hand: from a record to another one. Lists and places are no links. */
function setByHand({ table, sound }) {
  const found = [];
  for (const letter of ["v", "h", "b", "f"]) {
    for (const name of namesOf(table, letter)) {
      for (const field of Object.keys(FIELDS[letter]).filter((one) => one !== "inner" && one !== "place")) {
        const [to, was] = [table, sound].map((tables) => textOf(rowOf(tables, name), letter, field));
        if (to !== was) found.push({ name, field, to });
      }
    }
  }
  return found;
}

/** Draws it anew. */
export function draw(root, state, places, chosen) {
  const { sound } = state;
  const where = layout(sound, places);
  const broken = new Set(state.violations.flatMap(({ records }) => records.map(nameOf)));
  const links = linksOf(sound, chosen.at(-1));
  const along = new Set(chosen.flatMap((name) => halfEdgesOf(sound, name)));
  const classes = (name, kind) =>
    [kind, chosen.includes(name) && "chosen", broken.has(name) && "broken", links[name] && `link-${links[name]}`, along.has(name) && "along"].filter(Boolean).join(" ");

  const faces = svg("g", {});
  sound.faces.forEach((row, f) => {
    if (!row) return;
    const shape = svg("path", { d: where.regions[f].polygons.map((polygon) => path(polygon, "Z")).join(""), class: classes(`f${f}`, `face ${row.outer === null ? "unbounded" : `colour-${f % 8}`}`), "data-name": `f${f}` });
    const [x, y] = row.outer === null ? [26, 26] : where.regions[f].point;
    faces.append(shape, svg("text", { x, y, class: classes(`f${f}`, "label of-face") }, `f${f}`));
  });

  const edges = svg("g", {});
  for (const [h, line] of where.lines.entries()) {
    if (!line) continue;
    const name = `h${h}`;
    const points = beside(line, 5, 16);
    const [x, y] = middleOf(beside(line, 17, 16));
    edges.append(
      svg("path", { d: path(points), class: classes(name, "half-edge"), "data-name": name }),
      svg("path", { d: path(points), class: "hit", "data-name": name }),
      svg("text", { x, y, class: classes(name, "label of-half-edge"), "data-name": name }, name),
    );
  }

  const vertices = svg("g", {});
  for (const name of namesOf(sound, "v")) {
    const [x, y] = places(Number(name.slice(1)));
    vertices.append(
      svg("circle", { cx: x, cy: y, r: 13, class: classes(name, "vertex"), "data-name": name }),
      svg("text", { x, y, class: classes(name, "label of-vertex"), "data-name": name }, name),
    );
  }

  const hand = svg("g", {});
  for (const { name, field, to } of setByHand(state)) {
    const from = placeOf(name, sound, places, where);
    const end = to === "-" ? null : placeOf(to, sound, places, where);
    if (end) hand.append(svg("path", { d: path([from, end]), class: "by-hand" }));
    const [x, y] = end ? middleOf([from, end]) : from;
    hand.append(svg("text", { x, y: y - 12, class: "label by-hand" }, end ? field : `${field}: ${to}`));
  }
  root.replaceChildren(root.querySelector("defs"), faces, edges, vertices, hand);
  return where;
}
