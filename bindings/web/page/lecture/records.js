// Records by their names, as the tables have them: v0, h0, b0, f0.

const KINDS = { v: "vertex", h: "half_edge", b: "boundary", f: "face" };
const TABLES = { v: "vertices", h: "half_edges", b: "boundaries", f: "faces" };
const LETTERS = Object.fromEntries(Object.entries(KINDS).map(([letter, kind]) => [kind, letter]));

export const WORDS = { v: "vertex", h: "half-edge", b: "boundary component", f: "face" };

/** The name of a record: `{ half_edge: 3 }` is h3. */
export function nameOf(record) {
  const [[kind, index]] = Object.entries(record);
  return LETTERS[kind] + index;
}

/** The record of a name. */
export const recordOf = (name) => ({ [KINDS[name[0]]]: indexOf(name) });

export const indexOf = (name) => Number(name.slice(1));

/** The row of a name; nothing, if there is no such record. */
export const rowOf = (tables, name) => tables[TABLES[name[0]]][indexOf(name)] ?? null;

/** The names of all records of a kind. */
export const namesOf = (tables, letter) => tables[TABLES[letter]].flatMap((row, i) => (row ? [letter + i] : []));

/** The fields of each kind, and the letter of what they lead to. */
export const FIELDS = {
  v: { leaving: "h", isolated: "b" },
  h: { origin: "v", twin: "h", next: "h", prev: "h", boundary: "b" },
  b: { face: "f", start: "", place: "" },
  f: { outer: "b", inner: "b" },
};

/** A field as text: the name of a record, `-` for nil, names with spaces for a list. */
export function textOf(row, letter, field) {
  const value = row[field];
  if (Array.isArray(value)) return value.map((one) => (one === null ? "-" : FIELDS[letter][field] + one)).join(" ");
  if (value === null) return "-";
  if (value === "outer") return value;
  if (typeof value === "object") return "inner" in value ? String(value.inner) : nameOf(value);
  return FIELDS[letter][field] + value;
}

/** The half-edges of the cycle of one. It ends, whatever the links are. */
export function cycleOf(tables, h) {
  const cycle = [];
  const seen = new Set();
  for (let at = h; at !== null && tables.half_edges[at] && !seen.has(at); at = tables.half_edges[at].next) {
    seen.add(at);
    cycle.push(at);
  }
  return cycle;
}

/** The half-edges that leave a vertex. */
export const leavingOf = (tables, v) => tables.half_edges.flatMap((row, h) => (row?.origin === v ? [h] : []));

/** The face of a half-edge. */
export const faceOf = (tables, h) => tables.boundaries[tables.half_edges[h].boundary].face;

/** The vertices of the component that a boundary component is part of. */
export function verticesOf(tables, b) {
  const { start } = tables.boundaries[b];
  const first = start.vertex ?? tables.half_edges[start.half_edge].origin;
  const found = new Set([first]);
  for (const v of found) {
    for (const h of leavingOf(tables, v)) found.add(tables.half_edges[tables.half_edges[h].twin].origin);
  }
  return [...found];
}
