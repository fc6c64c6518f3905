"use strict";
// Unpacks a structure: `packed.rs` says what is in it.

/** Reads numbers in LEB128. They have up to 53 bits, so there is no shifting. */
class Numbers {
  constructor(text) {
    const letters = atob(text);
    this.bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; i++) this.bytes[i] = letters.charCodeAt(i);
    this.at = 0;
  }

  number() {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.bytes[this.at++];
      value += (byte & 127) * scale;
      if (!(byte & 128)) return value;
    }
  }

  signed() {
    return unzigzag(this.number());
  }
}

function unzigzag(n) {
  return n % 2 ? -(n + 1) / 2 : n / 2;
}

/** A structure: chains of points, each with two sides, `2 c` and `2 c + 1`. */
function unpack(packed) {
  const numbers = new Numbers(packed.stream);
  const { chains, points, faces, isolated, step } = packed;
  const s = {
    names: packed.names,
    chains,
    x: new Float64Array(points),
    y: new Float64Array(points),
    // The index of the vertex at a point, -1 for a bend; the half-edge of the line that begins there.
    vertex: new Int32Array(points),
    half: new Int32Array(points).fill(-1),
    // The first point of each chain, and one past the last.
    start: new Uint32Array(chains + 1),
    oneSided: new Uint8Array(chains),
    box: new Float64Array(4 * chains),
    next: new Int32Array(2 * chains),
    face: new Int32Array(2 * chains),
    faces: [],
    isolated: [],
    bounds: null,
  };
  let [x, y, vertex, half] = [0, 0, 0, 0];
  // The cells of the vertices that came before.
  const [cellX, cellY] = [new Float64Array(packed.vertex_slots), new Float64Array(packed.vertex_slots)];
  const stop = () => {
    const code = numbers.number();
    const isNew = code % 2 === 0;
    if (code) vertex += unzigzag(Math.floor((code - 1) / 2));
    if (isNew) {
      x += numbers.signed();
      y += numbers.signed();
      if (code) [cellX[vertex], cellY[vertex]] = [x, y];
    } else {
      [x, y] = [cellX[vertex], cellY[vertex]];
    }
    return [packed.origin[0] + x * step, packed.origin[1] + y * step, code ? vertex : -1];
  };
  for (let c = 0, p = 0; c < chains; c++) {
    s.oneSided[c] = numbers.number();
    const count = numbers.number();
    s.start[c] = p;
    const box = emptyBox();
    for (let i = 0; i < count; i++) {
      const [px, py, v] = stop();
      s.x[p + i] = px;
      s.y[p + i] = py;
      s.vertex[p + i] = v;
      extend(box, px, py);
    }
    for (let i = 0; i + 1 < count; i++) s.half[p + i] = half += numbers.signed();
    s.box.set(box, 4 * c);
    p += count;
    s.start[c + 1] = p;
  }
  for (let side = 0; side < 2 * chains; side++) {
    const next = numbers.number();
    s.next[side] = next ? side + unzigzag(next - 1) : -1;
    s.face[side] = numbers.number() - 1;
  }
  for (let f = 0, index = 0; f < faces; f++) {
    index += numbers.signed();
    const features = [];
    for (let n = numbers.number(), feature = 0; n > 0; n--) features.push((feature += numbers.signed()));
    s.faces.push({ index, features, rings: [], box: emptyBox(), isBounded: false });
  }
  for (let i = 0; i < isolated; i++) s.isolated.push(stop());
  findRings(s);
  const bounds = emptyBox();
  for (let c = 0; c < chains; c++) join(bounds, s.box, 4 * c);
  for (const [px, py] of s.isolated) extend(bounds, px, py);
  if (bounds[0] <= bounds[2]) s.bounds = bounds;
  return s;
}

/** The sides of each face, as rings that close: one side of each. */
function findRings(s) {
  const seen = new Uint8Array(2 * s.chains);
  for (let start = 0; start < 2 * s.chains; start++) {
    const face = s.faces[s.face[start]];
    if (seen[start] || !face) continue;
    const box = emptyBox();
    let area = 0;
    let side = start;
    while (side >= 0 && !seen[side] && s.face[side] === s.face[start]) {
      seen[side] = 1;
      join(box, s.box, 4 * (side >> 1));
      area += signedArea(s, side);
      side = s.next[side];
    }
    if (side !== start) continue;
    face.rings.push(start);
    // The ring around the face is the one that turns left.
    if (area > 0) face.isBounded = true;
    join(face.box, box, 0);
  }
}

/** Twice the area between a side and the first corner of the map. */
function signedArea(s, side) {
  const c = side >> 1;
  const [ox, oy] = [s.x[0], s.y[0]];
  let sum = 0;
  for (let p = s.start[c]; p + 1 < s.start[c + 1]; p++) {
    sum += (s.x[p] - ox) * (s.y[p + 1] - oy) - (s.x[p + 1] - ox) * (s.y[p] - oy);
  }
  return side % 2 ? -sum : sum;
}

/** Calls `each` with the points of a ring, in order; the last point of a side is the first of the next one. */
function eachPoint(s, start, each) {
  let side = start;
  do {
    const c = side >> 1;
    const [first, last] = [s.start[c], s.start[c + 1] - 1];
    if (side % 2) for (let p = last; p > first; p--) each(s.x[p], s.y[p]);
    else for (let p = first; p < last; p++) each(s.x[p], s.y[p]);
    side = s.next[side];
  } while (side !== start);
}

// A box is [least x, least y, greatest x, greatest y].

function emptyBox() {
  return [Infinity, Infinity, -Infinity, -Infinity];
}

function extend(box, x, y) {
  box[0] = Math.min(box[0], x);
  box[1] = Math.min(box[1], y);
  box[2] = Math.max(box[2], x);
  box[3] = Math.max(box[3], y);
}

function join(box, other, at) {
  extend(box, other[at], other[at + 1]);
  extend(box, other[at + 2], other[at + 3]);
}

function meets(a, b, at = 0) {
  return a[0] <= b[at + 2] && b[at] <= a[2] && a[1] <= b[at + 3] && b[at + 1] <= a[3];
}

/** What a record is called. `index` is that of the half-edge in the direction of its chain. */
function vertexName(s, index) {
  const own = s.names.own || s.names.ids;
  return own ? own.vertices[index] : "v" + index;
}

function faceName(s, index) {
  const own = s.names.own || s.names.ids;
  return own ? own.faces[index] : "f" + index;
}

function halfEdgeName(s, index, isBack) {
  if (s.names.own) return s.names.own.half_edges[isBack ? s.names.own.twins[index] : index];
  const side = isBack ? index ^ 1 : index;
  if (s.names.ids) return (side % 2 ? "-" : "+") + s.names.ids.edges[side >> 1];
  return "h" + side;
}
