// The functions, each done when it returns. `index.js` has the same in a worker.

import { Engine } from "./engine.js";
import { OptionError } from "./errors.js";

export * from "./errors.js";

const encoder = new TextEncoder();

/** Loads the module, from where this file is unless something else is given: bytes, a module, a URL or a response. */
export async function load(source = new URL("./twinedge.wasm", import.meta.url)) {
  return new Twinedge(new Engine(await moduleOf(await source)));
}

/** A module of WebAssembly from bytes, a URL or a response. */
export async function moduleOf(source) {
  if (source instanceof WebAssembly.Module) return source;
  if (source instanceof Uint8Array || source instanceof ArrayBuffer) return WebAssembly.compile(source);
  if (typeof Response === "function" && source instanceof Response) return WebAssembly.compile(await source.arrayBuffer());
  const url = new URL(source);
  if (url.protocol !== "file:") return moduleOf(await fetch(url));
  // Node fetches no files.
  const { readFile } = await import(/* webpackIgnore: true */ "node:fs/promises");
  return WebAssembly.compile(await readFile(url));
}

/** Types of GeoJSON objects that are parts of a collection. */
const GEOMETRIES = ["Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection"];

const isObject = (input) => typeof input?.type === "string" && input.bytes === undefined && !isBlob(input);

/** Several features or geometries of GeoJSON are one collection. */
function collectionOf(parts) {
  const features = parts.flatMap((part) => {
    if (part.type === "Feature") return [part];
    if (part.type === "FeatureCollection") return part.features;
    if (GEOMETRIES.includes(part.type)) return [{ type: "Feature", properties: null, geometry: part }];
    throw new OptionError("option", `an array of objects is features of GeoJSON, and one has the type ${part.type}`);
  });
  return { type: "FeatureCollection", features };
}

/** A file of a browser, or its content. */
export const isBlob = (input) => typeof Blob === "function" && input instanceof Blob;

/** An input whose files of a browser are read. */
export async function read(input) {
  const isFile = (one) => isBlob(one) || isBlob(one?.bytes);
  if (Array.isArray(input)) return input.some(isFile) ? Promise.all(input.map(read)) : input;
  if (!isFile(input)) return input;
  const file = isBlob(input) ? input : input.bytes;
  return { name: input.webkitRelativePath || (input.name ?? "blob"), bytes: await file.arrayBuffer() };
}

/** The bytes of an input and its name. */
export function fileOf(input, name) {
  if (isBlob(input)) throw new OptionError("option", "a File or a Blob cannot be read at once: give its bytes, await file.arrayBuffer()");
  if (typeof input === "string") return { name: name ?? "text", bytes: encoder.encode(input) };
  if (input instanceof ArrayBuffer) return { name: name ?? "bytes", bytes: new Uint8Array(input) };
  // A buffer of Node turns into numbers in JSON, and is none here.
  if (ArrayBuffer.isView(input)) return { name: name ?? "bytes", bytes: new Uint8Array(input.buffer, input.byteOffset, input.byteLength) };
  if (typeof input?.name === "string" && input.bytes !== undefined) return fileOf(input.bytes, input.name);
  if (typeof input?.type === "string") return { name: name ?? input.type, bytes: encoder.encode(JSON.stringify(input)) };
  throw new OptionError("option", "an input is a text, bytes, an object of GeoJSON or TopoJSON, features of GeoJSON, or a file");
}

/** A column of links as 32-bit integers. What is no index of an array, such as −1, stays what it is. */
function columnOf(name, column) {
  if (column === undefined || column === null) return null;
  if (column instanceof Int32Array || column instanceof Uint32Array) {
    return new Uint8Array(column.buffer, column.byteOffset, column.byteLength);
  }
  if (typeof column.length !== "number") throw new OptionError("option", `${name}: a column is an array of whole numbers`);
  const numbers = new Int32Array(column.length);
  for (let i = 0; i < numbers.length; i++) {
    const number = Number(column[i] ?? -1);
    if (!Number.isInteger(number)) throw new OptionError("option", `${name}: ${column[i]} is no whole number`);
    // Beyond every array, it leads nowhere.
    numbers[i] = Math.max(-2, Math.min(number, 2 ** 31 - 1));
  }
  return new Uint8Array(numbers.buffer);
}

const COLUMNS = ["origin", "target", "twin", "next", "prev", "face", "leaving", "outerHalfEdge"];

/** Options as the module takes them: what JavaScript alone looks at stays here. */
function plain({ progress, signal, name, winding, ...options }) {
  if (![undefined, ...WINDINGS].includes(winding)) throw new OptionError("option", `winding: ${winding} is none of ${WINDINGS.join(", ")}`);
  return options;
}

/** The ways in which rings of GeoJSON turn: outer ones counter-clockwise on the map, or, for d3's spherical projections, clockwise. */
const WINDINGS = ["rfc7946", "d3"];

const isClockwise = (ring) => ring.reduce((sum, [x, y], i) => sum + (x - ring[0][0]) * (ring[(i + 1) % ring.length][1] - y) - (ring[(i + 1) % ring.length][0] - x) * (y - ring[0][1]), 0) < 0;

/** The rings of a polygon, the first of them clockwise and the others counter-clockwise. */
const turned = (rings) => rings.map((ring, i) => (isClockwise(ring) === (i === 0) ? ring : [...ring].reverse()));

/** A geometry of GeoJSON with rings that turn as d3's spherical projections want them. */
function forD3(geometry) {
  if (geometry?.type === "Polygon") return { ...geometry, coordinates: turned(geometry.coordinates) };
  if (geometry?.type === "MultiPolygon") return { ...geometry, coordinates: geometry.coordinates.map(turned) };
  if (geometry?.type === "GeometryCollection") return { ...geometry, geometries: geometry.geometries.map(forD3) };
  return geometry;
}

const collectionForD3 = (layer) => ({ ...layer, features: layer.features.map((one) => ({ ...one, geometry: forD3(one.geometry) })) });

/** A request about files. */
const about = (op, rest = {}) => (input, options = {}) => ({
  op,
  files: filesOf(input, options.name),
  options: plain(options),
  ...rest,
});

function filesOf(input, name) {
  if (!Array.isArray(input)) return [fileOf(input, name)];
  if (input.length > 0 && input.every(isObject)) return [fileOf(collectionOf(input), name)];
  return input.map((one) => fileOf(one, input.length === 1 ? name : undefined));
}

/** An audit that writes findings as accepted, today: the module has no clock. */
const accepting = (want) => (input, options) => about("audit", { want, date: new Date().toISOString().slice(0, 10) })(input, options);

/** What each function asks of the module, and what it makes of the answer. */
export const requests = {
  audit: about("audit", { want: ["report"] }),
  auditPage: about("audit", { want: ["page"] }),
  auditWithPage: accepting(["report", "page", "accept_all"]),
  acceptAll: accepting(["accept_all"]),
  findings: about("audit", { want: ["findings"] }),
  clean: about("clean"),
  convert: about("convert"),
  neighbours: about("neighbours"),
  voronoi: (input, options = {}) =>
    Array.isArray(input) && input.every((one) => Array.isArray(one))
      ? { op: "voronoi", points: input, options: plain(options) }
      : about("voronoi")(input, options),
  validate: (columns, expectation = "plane", options = {}) => {
    for (const name in columns) {
      if (![...COLUMNS, "vertices", "faces"].includes(name)) throw new OptionError("option", `${name} is no column`);
    }
    const { vertices, faces } = columns;
    const given = Object.fromEntries(COLUMNS.map((name) => [name, columnOf(name, columns[name])]));
    return { op: "validate", columns: given, vertices, faces, expectation, options: plain(options) };
  },
  check: (files) => ({ op: "check", files: Object.entries(files).map(([name, bytes]) => fileOf(bytes, name)) }),
};

const texts = new TextDecoder();
const parsed = (bytes) => JSON.parse(texts.decode(bytes));

const answers = {
  audit: ({ report }) => parsed(report),
  auditPage: ({ page }) => texts.decode(page),
  auditWithPage: ({ report, page, accept_all }) => ({ report: parsed(report), page: texts.decode(page), acceptAll: parsed(accept_all) }),
  acceptAll: ({ accept_all }) => parsed(accept_all),
  findings: ({ findings, warnings }) => Object.assign(parsed(findings), { warnings }),
  clean: ({ report, file, isLayer }) => ({ report: parsed(report), ...(isLayer ? { layer: parsed(file.bytes) } : { file }) }),
  convert: ({ file, losses }) => ({ ...file, losses }),
  neighbours: ({ answer }) => parsed(answer),
  voronoi: ({ answer }) => parsed(answer),
  validate: ({ report }) => judged(parsed(report)),
  check: (answer) => answer,
};

/** A report of the validator with its verdict. */
function judged(report) {
  const isInvalid = report.violation_count > 0;
  return { ...report, verdict: report.valid ? "valid" : isInvalid ? "invalid" : "unknown" };
}

/** What a function returns: the answer of the module, with rings that turn as was asked. */
export function returned(name, ok, options) {
  const made = answers[name](ok);
  if (options?.winding !== "d3") return made;
  if (made.type === "FeatureCollection") return collectionForD3(made);
  return made.layer ? { ...made, layer: collectionForD3(made.layer) } : made;
}

/** The functions, over one module. */
export class Twinedge {
  constructor(engine) {
    for (const [name, request] of Object.entries(requests)) {
      this[name] = (...args) => returned(name, engine.call(request(...args), progressOf(args)), args.at(-1));
    }
  }
}

/** The function that is told what begins, if the last argument has one: an input may have a member of that name. */
export const progressOf = (args) => (typeof args.at(-1)?.progress === "function" ? args.at(-1).progress : null);
