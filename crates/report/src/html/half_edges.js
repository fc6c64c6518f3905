// Draws half-edges as textbooks do: each is an arrow to the left of its edge, in the face that it bounds, and a thin curve leads
// from its head to the tail of the next one. `detail.rs` of the library draws the same picture.

/** No more edges than this are drawn so, and they are as long as this on average, in pixels. */
const MOST_EDGES = 400;
const SHORTEST = 34;

/** How far from its edge an arrow lies, and how far from the ends it starts and stops: at most. */
const ASIDE = 7;
const SHORT = 15;

/** The half-edges of a side, in order: the first and the last point of each, in the direction of the side. */
function runs(s, side) {
  const c = side >> 1;
  const found = [];
  for (let p = s.start[c]; p + 1 < s.start[c + 1]; ) {
    let end = p + 1;
    while (end + 1 < s.start[c + 1] && s.half[end] === s.half[p] && s.vertex[end] < 0) end += 1;
    found.push({ side, half: s.half[p], from: p, to: end });
    p = end;
  }
  if (side % 2) {
    found.reverse();
    for (const run of found) [run.from, run.to] = [run.to, run.from];
  }
  return found;
}

/** The chains in sight, if their half-edges can be drawn. */
function legibleChains(view, s) {
  const seen = view.box();
  const found = [];
  let [count, length] = [0, 0];
  for (let c = 0; c < s.chains; c++) {
    if (!meets(seen, s.box, 4 * c)) continue;
    for (let p = s.start[c]; p + 1 < s.start[c + 1]; p++) {
      const line = emptyBox();
      extend(line, s.x[p], s.y[p]);
      extend(line, s.x[p + 1], s.y[p + 1]);
      if (!meets(seen, line)) continue;
      length += Math.min(Math.hypot(s.x[p + 1] - s.x[p], s.y[p + 1] - s.y[p]) * view.scale, view.width);
      if (++count > MOST_EDGES) return [];
    }
    found.push(c);
  }
  return length >= SHORTEST * count ? found : [];
}

/** Where a half-edge is drawn. */
function arrow(view, s, run) {
  const step = run.from < run.to ? 1 : -1;
  const points = [];
  for (let p = run.from; p !== run.to + step; p += step) points.push([view.px(s.x[p]), view.py(s.y[p])]);
  const length = points.slice(1).reduce((sum, p, i) => sum + Math.hypot(p[0] - points[i][0], p[1] - points[i][1]), 0);
  const [aside, short] = [Math.min(ASIDE, length * 0.12), Math.min(SHORT, length * 0.25)];
  const along = points.slice(1).map((b, i) => {
    const a = points[i];
    const size = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    return { x: (b[0] - a[0]) / size, y: (b[1] - a[1]) / size, cut: Math.min(short, size * 0.4) };
  });
  const line = points.map(([x, y], i) => {
    const [before, after] = [along[i - 1] ?? along[i], along[i] ?? along[i - 1]];
    // At a bend where both offset lines cross; not too far away where it is sharp. Pixels count downwards.
    const away = aside / Math.max(0.3, 1 + before.x * after.x + before.y * after.y);
    const on = i === 0 ? after.cut : i + 1 === points.length ? -before.cut : 0;
    return [x + (before.y + after.y) * away + after.x * on, y - (before.x + after.x) * away + after.y * on];
  });
  return { points, line, aside, short, length, tail: line[0], head: line[line.length - 1] };
}

function angleFrom(a, b) {
  return Math.atan2(a[1] - b[1], b[0] - a[0]);
}

/** Draws the half-edges of these chains, and the names of them and of vertices; the room that the names take. */
function drawHalfEdges(context, view, s, chains, hasNames) {
  const arrows = new Map();
  const arrowOf = (run) => {
    const key = 2 * Math.min(run.from, run.to) + (run.side % 2);
    if (!arrows.has(key)) arrows.set(key, arrow(view, s, run));
    return arrows.get(key);
  };
  const labels = [];
  context.lineCap = "butt";
  for (const c of chains) {
    for (const side of s.oneSided[c] ? [2 * c] : [2 * c, 2 * c + 1]) {
      const own = runs(s, side);
      own.forEach((run, i) => {
        const here = arrowOf(run);
        if (!near(view, here)) return;
        drawArrow(context, here.line);
        const next = own[i + 1] || (s.next[side] >= 0 ? runs(s, s.next[side])[0] : null);
        if (next) drawNext(context, view, s, here, run, arrowOf(next), next);
        if (hasNames && here.length > 46) labels.push([halfEdgeName(s, run.half, side % 2 === 1), here]);
      });
    }
  }
  const taken = drawVertices(context, view, s, chains, hasNames);
  context.font = "11px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [text, { line, length }] of labels) {
    const i = Math.floor((line.length - 1) / 2);
    const [a, b] = [line[i], line[i + 1]];
    const size = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    const [left, wide] = [[(b[1] - a[1]) / size, -(b[0] - a[0]) / size], context.measureText(text).width];
    if (length < wide + 24) continue;
    const away = Math.hypot(left[1] * 8, left[0] * (wide / 2 + 4));
    const at = [(a[0] + b[0]) / 2 + left[0] * away, (a[1] + b[1]) / 2 + left[1] * away];
    if (isFree(taken, at, wide)) haloed(context, text, ...at, colours.half);
  }
  return taken;
}

/** Whether there is room for a text of this width; if so, it is taken. */
function isFree(taken, [x, y], width) {
  const area = [x - width / 2, y - 6, x + width / 2, y + 6];
  if (taken.some((other) => meets(area, other))) return false;
  taken.push(area);
  return true;
}

/** Whether an arrow comes near the picture, and is not so long that it is none. */
function near(view, { line }) {
  const box = emptyBox();
  for (const [x, y] of line) extend(box, x, y);
  return meets([-50, -50, view.width + 50, view.height + 50], box);
}

function drawArrow(context, line) {
  context.strokeStyle = context.fillStyle = colours.half;
  context.lineWidth = 1.3;
  context.beginPath();
  line.forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y)));
  context.stroke();
  head(context, line[line.length - 2], line[line.length - 1], 7);
}

function head(context, from, to, size) {
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  context.beginPath();
  context.moveTo(to[0], to[1]);
  for (const turn of [2.7, -2.7]) context.lineTo(to[0] + size * Math.cos(angle + turn), to[1] + size * Math.sin(angle + turn));
  context.fill();
}

/** The curve to the next half-edge: along the corner between them, in an arc if that is elsewhere. */
function drawNext(context, view, s, here, run, to, next) {
  const corner = here.points[here.points.length - 1];
  const isHere = Math.hypot(corner[0] - to.points[0][0], corner[1] - to.points[0][1]) < 1;
  const [a, b] = [here.head, to.tail];
  // Beside the straight line, where an edge may be.
  let bend = [(a[0] + b[0]) / 2 + (b[1] - a[1]) / 4, (a[1] + b[1]) / 2 - (b[0] - a[0]) / 4];
  if (isHere) {
    const from = angleFrom(to.points[0], to.points[1]);
    let width = angleFrom(corner, here.points[here.points.length - 2]) - from;
    width = ((width % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
    // A dead end, around which one goes once.
    if (width < 1e-9) width = 2 * Math.PI;
    const { short, aside } = to;
    const chord = short * Math.cos(width / 2) + aside * Math.sin(width / 2);
    const wanted = chord > aside ? aside + (chord - aside) * 0.6 : aside + (aside - chord) * 0.15;
    const [away, direction] = [2 * wanted - chord, from + width / 2];
    bend = [corner[0] + Math.cos(direction) * away, corner[1] - Math.sin(direction) * away];
  }
  context.strokeStyle = context.fillStyle = isHere ? colours.next : colours.bad;
  context.lineWidth = isHere ? 0.9 : 1.4;
  context.setLineDash([3, 2]);
  context.beginPath();
  context.moveTo(a[0], a[1]);
  context.quadraticCurveTo(bend[0], bend[1], b[0], b[1]);
  context.stroke();
  context.setLineDash([]);
  head(context, bend, b, 5);
}

/** Vertices, and their names in the widest corner; the room that the names take. */
function drawVertices(context, view, s, chains, hasNames) {
  const leaving = new Map();
  const add = (p, q) => {
    if (s.vertex[p] < 0) return;
    const here = [view.px(s.x[p]), view.py(s.y[p])];
    if (!leaving.has(s.vertex[p])) leaving.set(s.vertex[p], { here, angles: [] });
    leaving.get(s.vertex[p]).angles.push(angleFrom([s.x[p], -s.y[p]], [s.x[q], -s.y[q]]));
  };
  for (const c of chains) {
    for (let p = s.start[c]; p + 1 < s.start[c + 1]; p++) {
      add(p, p + 1);
      add(p + 1, p);
    }
  }
  const texts = [];
  for (const [index, { here, angles }] of leaving) {
    context.beginPath();
    context.arc(here[0], here[1], 3.2, 0, 7);
    context.fillStyle = colours.halo;
    context.fill();
    context.strokeStyle = colours.vertex;
    context.lineWidth = 1.4;
    context.stroke();
    angles.sort((a, b) => a - b);
    let [widest, direction] = [-1, 0];
    angles.forEach((angle, i) => {
      const width = i + 1 < angles.length ? angles[i + 1] - angle : angles[0] + 2 * Math.PI - angle;
      if (width > widest) [widest, direction] = [width, angle + width / 2];
    });
    texts.push([vertexName(s, index), here, direction]);
  }
  for (const [x, y, index] of s.isolated) texts.push([vertexName(s, index), [view.px(x), view.py(y)], Math.PI / 2]);
  const taken = [];
  if (!hasNames) return taken;
  context.font = "bold 12px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [text, here, direction] of texts) {
    const wide = context.measureText(text).width;
    const away = 9 + Math.hypot(Math.sin(direction) * 8, Math.cos(direction) * (wide / 2 + 4));
    const at = [here[0] + Math.cos(direction) * away, here[1] - Math.sin(direction) * away];
    if (isFree(taken, at, wide)) haloed(context, text, ...at, colours.vertex);
  }
  return taken;
}

/** Text that can be read on any ground. */
function haloed(context, text, x, y, colour) {
  context.strokeStyle = colours.halo;
  context.lineWidth = 3;
  context.lineJoin = "round";
  context.strokeText(text, x, y);
  context.fillStyle = colour;
  context.fillText(text, x, y);
}
