// Draws faces and edges. A generator each: it yields from time to time, so that a large map does not block the page.

/** How many points are drawn between two looks at the clock. */
const PORTION = 20000;

/** Lines are thinner where they would cover more than this part of the cells, of so many pixels, through which they run. */
const COVERED = 0.08;
const CELL = 16;

/** Lines that would be thinner than this, in pixels, are fainter instead. */
const THINNEST = 0.3;

/** Fills the faces of a structure by their features. */
function* drawFaces(context, view, s, features) {
  const seen = view.box();
  const hasAreas = features.length > 0 && s.faces.some((face) => face.features.length > 0);
  let drawn = 0;
  for (const face of s.faces) {
    if (!face.isBounded || !meets(seen, face.box)) continue;
    const [first] = face.features;
    const isGap = first === undefined && hasAreas;
    const colour = colours.faces[(first === undefined ? face.index : features[first][2]) % COLOURS];
    const size = Math.max(face.box[2] - face.box[0], face.box[3] - face.box[1]) * view.scale;
    if (size < 1) {
      context.fillStyle = colour;
      if (!isGap) context.fillRect(view.px(face.box[0]), view.py(face.box[3]), 1, 1);
      drawn += 1;
    } else {
      const path = new Path2D();
      for (const ring of face.rings) drawn += addRing(path, view, s, ring);
      context.fillStyle = isGap ? colours.dots : colour;
      // Without features, faces are told apart only.
      context.globalAlpha = hasAreas ? 1 : 0.35;
      context.fill(path, "evenodd");
      context.globalAlpha = 1;
      if (face.features.length > 1) {
        context.fillStyle = colours.hatch;
        context.fill(path, "evenodd");
      }
    }
    if (drawn > PORTION) {
      drawn = 0;
      yield;
    }
  }
}

/** Adds a ring to a path, without points that fall on the one before; how many points it has. */
function addRing(path, view, s, ring) {
  let [lastX, lastY, count] = [NaN, NaN, 0];
  eachPoint(s, ring, (x, y) => {
    const [px, py] = [view.px(x), view.py(y)];
    count += 1;
    if (Math.abs(px - lastX) < 0.5 && Math.abs(py - lastY) < 0.5) return;
    if (Number.isNaN(lastX)) path.moveTo(px, py);
    else path.lineTo(px, py);
    [lastX, lastY] = [px, py];
  });
  path.closePath();
  return count;
}

/** Draws all edges that are seen, and isolated vertices. */
function* drawEdges(context, view, s) {
  const seen = view.box();
  const paths = [];
  const taken = new Uint8Array(Math.ceil(view.width) * Math.ceil(view.height));
  const [wide, high] = [view.width, view.height].map((size) => Math.ceil(size / CELL));
  const cells = new Uint8Array(wide * high);
  /** Marks the cells through which a line runs; how long it is inside the picture. */
  const cross = (ax, ay, bx, by) => {
    const whole = Math.hypot(bx - ax, by - ay);
    const steps = Math.min(Math.ceil((2 * whole) / CELL), 4 * (wide + high)) + 1;
    let inside = 0;
    for (let i = 0; i < steps; i++) {
      const [x, y] = [(ax + ((bx - ax) * (i + 0.5)) / steps) / CELL, (ay + ((by - ay) * (i + 0.5)) / steps) / CELL];
      if (x < 0 || y < 0 || x >= wide || y >= high) continue;
      cells[Math.floor(y) * wide + Math.floor(x)] = 1;
      inside += 1;
    }
    return (whole * inside) / steps;
  };
  let path = new Path2D();
  let [points, length] = [0, 0];
  for (let c = 0; c < s.chains; c++) {
    if (!meets(seen, s.box, 4 * c)) continue;
    const at = 4 * c;
    const size = Math.max(s.box[at + 2] - s.box[at], s.box[at + 3] - s.box[at + 1]) * view.scale;
    if (size < 1) {
      // One for each pixel.
      const [px, py] = [Math.floor(view.px(s.box[at])), Math.floor(view.py(s.box[at + 3]))];
      const pixel = py * Math.ceil(view.width) + px;
      if (px < 0 || py < 0 || px >= view.width || taken[pixel]) continue;
      taken[pixel] = 1;
      path.moveTo(px, py + 0.5);
      path.lineTo(px + 1, py + 0.5);
      points += 1;
      length += cross(px, py, px + 1, py);
    } else {
      let [lastX, lastY] = [NaN, NaN];
      const last = s.start[c + 1] - 1;
      for (let p = s.start[c]; p <= last; p++) {
        const [px, py] = [view.px(s.x[p]), view.py(s.y[p])];
        if (p < last && Math.abs(px - lastX) < 0.7 && Math.abs(py - lastY) < 0.7) continue;
        if (Number.isNaN(lastX)) path.moveTo(px, py);
        else {
          path.lineTo(px, py);
          length += cross(lastX, lastY, px, py);
        }
        [lastX, lastY] = [px, py];
        points += 1;
      }
    }
    if (points > PORTION) {
      paths.push(path);
      path = new Path2D();
      points = 0;
      yield;
    }
  }
  paths.push(path);
  context.strokeStyle = colours.edge;
  context.lineJoin = context.lineCap = "round";
  const covered = cells.reduce((sum, cell) => sum + cell, 0) * CELL * CELL;
  const width = Math.min(1, (COVERED * covered) / Math.max(length, 1));
  context.lineWidth = Math.max(width, THINNEST);
  const strength = Math.min(1, width / THINNEST);
  for (const one of paths) {
    context.globalAlpha = strength;
    context.stroke(one);
    context.globalAlpha = 1;
    yield;
  }
  context.fillStyle = colours.vertex;
  for (const [x, y] of s.isolated) {
    if (!meets(seen, [x, y, x, y])) continue;
    context.beginPath();
    context.arc(view.px(x), view.py(y), 3, 0, 7);
    context.fill();
  }
}

/** The face at a place: the smallest one with it inside, by the even-odd rule. */
function faceAt(s, x, y) {
  let found = null;
  const area = (face) => (face.box[2] - face.box[0]) * (face.box[3] - face.box[1]);
  for (const face of s.faces) {
    if (!face.isBounded || !meets([x, y, x, y], face.box) || (found && area(found) <= area(face))) continue;
    let isInside = false;
    for (const ring of face.rings) {
      let [firstX, firstY, lastX, lastY] = [NaN, NaN, NaN, NaN];
      const side = (ax, ay, bx, by) => {
        if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) isInside = !isInside;
      };
      eachPoint(s, ring, (px, py) => {
        if (Number.isNaN(firstX)) [firstX, firstY] = [px, py];
        else side(lastX, lastY, px, py);
        [lastX, lastY] = [px, py];
      });
      side(lastX, lastY, firstX, firstY);
    }
    if (isInside) found = face;
  }
  return found;
}
