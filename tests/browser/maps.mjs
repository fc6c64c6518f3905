// Maps with faults at places that are known.

import { readFileSync } from "node:fs";

const ring = (...points) => [...points, points[0]];
const square = (x, y, w, h) => ring([x, y], [x + w, y], [x + w, y + h], [x, y + h]);
const feature = (id, name, ...rings) => ({
  type: "Feature",
  id,
  properties: { name },
  geometry: { type: "Polygon", coordinates: rings },
});
const collection = (...features) => JSON.stringify({ type: "FeatureCollection", features });

/**
 * Three by two parcels, 100 m wide, in metres: A and B overlap by 2 m; D and E leave a gap of 0.5 m between them, closed by B above
 * and G below; F has a sliver of 0.2 m in C's place; H is a twin of C.
 */
export const parcels = collection(
  feature("P-1", "Alder", square(0, 100, 102, 100)),
  feature("P-2", "Birch", square(100, 100, 100, 100)),
  feature("P-3", "Cedar", ring([200, 100], [299.8, 100], [299.8, 200], [200, 200])),
  feature("P-4", "Dogwood", square(0, 0, 99.5, 100)),
  feature("P-5", "Elm", square(100, 0, 100, 100)),
  feature("P-6", "Fir", square(200, 0, 100, 100)),
  feature("P-7", "Grove", square(0, -50, 300, 50)),
  { ...feature("P-6b", "Fir"), geometry: { type: "MultiPolygon", coordinates: [[square(299.8, 100, 0.2, 100)]] } },
  feature("P-8", "Cedar again", ring([200, 100], [299.8, 100], [299.8, 200], [200, 200])),
);

/** The three tables of a square with a diagonal; the next of e1,1 leads to the half-edge across, e3,1. */
export const tables = `
v1 (0, 0) e1,1
v2 (4, 0) e2,1
v3 (4, 4) e3,1
v4 (0, 4) e4,1
f1 nil e1,2
f2 e1,1 nil
f3 e3,1 nil
e1,1 v1 e1,2 f2 e3,1 e5,2
e1,2 v2 e1,1 f1 e4,2 e2,2
e2,1 v2 e2,2 f2 e5,2 e1,1
e2,2 v3 e2,1 f1 e1,2 e3,2
e3,1 v3 e3,2 f3 e4,1 e5,1
e3,2 v4 e3,1 f1 e2,2 e4,2
e4,1 v4 e4,2 f3 e5,1 e3,1
e4,2 v1 e4,1 f1 e3,2 e1,2
e5,1 v1 e5,2 f3 e3,1 e4,1
e5,2 v3 e5,1 f2 e1,1 e2,1
`;

export const hostileNames = [
  "</script><script>document.title='hit'</script>",
  "<img src=x onerror=\"document.title='hit'\">",
  "line\u2028and paragraph\u2029separators",
  "\"quotes\" & 'more' {data} {script}",
  "\u202egnirts \u0000\u001b[31m",
  "x".repeat(400),
];

/** Squares side by side; the second begins inside the first. */
export const hostile = collection(
  ...hostileNames.map((name, i) => feature(`<b>${i}</b>`, name, square(i * 10 - (i === 1 ? 1 : 0), 0, i === 1 ? 11 : 10, 10))),
);

/** Parcels side by side, some 20,000 edges; one of them is a little smaller than its place. */
export const many = collection(
  ...Array.from({ length: 100 * 100 }, (_, i) => {
    const [x, y] = [i % 100, Math.floor(i / 100)];
    return feature(i, `Parcel ${i}`, square(x, y, i === 5050 ? 0.99 : 1, 1));
  }),
);

/** Two parcels that overlap by half a unit, as in the README of the program. */
export const overlapping = readFileSync(new URL("../../docs/overlapping.geojson", import.meta.url), "utf8");

/** Squares side by side, and one far away. */
export const farApart = collection(
  ...Array.from({ length: 25 }, (_, i) => feature(i, `near ${i}`, square(2 * (i % 5), 2 * Math.floor(i / 5), 2, 2))),
  feature("f", "far", square(500, 0, 1, 1)),
);
