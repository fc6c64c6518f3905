// Findings on the map: a mark for each, and the chosen one in full.

/** A finding that is smaller than this in pixels has a ring around it. */
const SMALL = 28;

/** The box around a finding; null if it has no place. */
function boxOf(finding) {
  if (finding.box !== undefined) return finding.box;
  const box = emptyBox();
  const { points, lines, polygons } = finding.trace;
  for (const [x, y] of [...points, ...(finding.at ? [finding.at] : [])]) extend(box, x, y);
  for (const line of [...lines, ...polygons.flat()]) for (const [x, y] of line) extend(box, x, y);
  finding.box = box[0] <= box[2] ? box : null;
  return finding.box;
}

/** The length of the shortest line that ends at the point of the map nearest to a place, to choose a scale by. */
function lengthNear(s, [x, y]) {
  let [best, length] = [Infinity, 0];
  for (let c = 0; c < s.chains; c++) {
    for (let p = s.start[c]; p < s.start[c + 1]; p++) {
      const distance = (s.x[p] - x) ** 2 + (s.y[p] - y) ** 2;
      if (distance > best) continue;
      const sides = [];
      if (p > s.start[c]) sides.push(Math.hypot(s.x[p] - s.x[p - 1], s.y[p] - s.y[p - 1]));
      if (p + 1 < s.start[c + 1]) sides.push(Math.hypot(s.x[p + 1] - s.x[p], s.y[p + 1] - s.y[p]));
      const shortest = Math.min(...sides.filter((one) => one > 0));
      if (!Number.isFinite(shortest)) continue;
      length = distance < best ? shortest : Math.min(length, shortest);
      best = distance;
    }
  }
  return length;
}

/** What to show of a finding: all of it, or the place to look at, closer. */
function target(s, finding, isClose) {
  const box = boxOf(finding);
  if (!box) return null;
  const at = finding.at || [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
  const span = Math.max(box[2] - box[0], box[3] - box[1]);
  if (span > 0 && !isClose) return { box, part: 0.5 };
  const near = finding.width > 0 ? 4 * finding.width : (isClose ? 0.5 : 1.5) * lengthNear(s, at);
  const half = Math.min(near, span > 0 ? span / 4 : Infinity) || 1e-9;
  return { box: [at[0] - half, at[1] - half, at[0] + half, at[1] + half], part: 0.5 };
}

function markColour(finding) {
  return finding.violation ? colours.bad : colours.mark;
}

/** Draws a mark for each finding, those of the chosen one last and in full. */
function drawFindings(context, view, findings, chosen) {
  const taken = new Uint8Array(Math.ceil(view.width / 8 + 2) * Math.ceil(view.height / 8 + 2));
  const columns = Math.ceil(view.width / 8 + 2);
  for (const finding of findings) {
    if (finding === chosen || !finding.at) continue;
    const [x, y] = [view.px(finding.at[0]), view.py(finding.at[1])];
    if (x < -8 || y < -8 || x > view.width + 8 || y > view.height + 8) continue;
    // One for each few pixels.
    const cell = Math.floor(y / 8 + 1) * columns + Math.floor(x / 8 + 1);
    if (taken[cell]) continue;
    taken[cell] = 1;
    ring(context, x, y, 6, markColour(finding), 2);
  }
  if (chosen) drawChosen(context, view, chosen);
}

function ring(context, x, y, radius, colour, width) {
  for (const [stroke, line] of [[colours.halo, width + 2.5], [colour, width]]) {
    context.beginPath();
    context.arc(x, y, radius, 0, 7);
    context.strokeStyle = stroke;
    context.lineWidth = line;
    context.stroke();
  }
}

function drawChosen(context, view, finding) {
  const box = boxOf(finding);
  if (!box) return;
  const colour = markColour(finding);
  const outline = new Path2D();
  const add = (path, line) => line.forEach(([x, y], i) => path[i ? "lineTo" : "moveTo"](view.px(x), view.py(y)));
  for (const rings of finding.trace.polygons) {
    const path = new Path2D();
    for (const one of rings) {
      add(path, one);
      path.closePath();
    }
    context.fillStyle = colour;
    context.globalAlpha = 0.35;
    context.fill(path, "evenodd");
    context.globalAlpha = 1;
    outline.addPath(path);
  }
  for (const line of finding.trace.lines) add(outline, line);
  context.lineJoin = context.lineCap = "round";
  for (const [stroke, width] of [[colours.halo, 5], [colour, 2.5]]) {
    context.strokeStyle = stroke;
    context.lineWidth = width;
    context.stroke(outline);
  }
  for (const [x, y] of finding.trace.points) ring(context, view.px(x), view.py(y), 5, colour, 2.5);
  if (!finding.at) return;
  const size = Math.max(box[2] - box[0], box[3] - box[1]) * view.scale;
  const [x, y] = [view.px(finding.at[0]), view.py(finding.at[1])];
  if (size < SMALL) ring(context, x, y, 16, colour, 2.5);
  else if (finding.trace.lines.length === 2) ring(context, x, y, 8, colour, 2.5);
}

/** The finding whose mark is at a pixel, or whose polygon is there. */
function findingAt(view, findings, px, py) {
  let [best, distance] = [null, 12];
  for (const finding of findings) {
    if (!finding.at) continue;
    const away = Math.hypot(view.px(finding.at[0]) - px, view.py(finding.at[1]) - py);
    if (away < distance) [best, distance] = [finding, away];
  }
  if (best) return best;
  const [x, y] = view.at(px, py);
  const holds = (ringPoints) => {
    let isInside = false;
    for (let i = 0; i + 1 < ringPoints.length; i++) {
      const [[ax, ay], [bx, by]] = [ringPoints[i], ringPoints[i + 1]];
      if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) isInside = !isInside;
    }
    return isInside;
  };
  const covers = (finding) => finding.trace.polygons.some((rings) => rings.filter(holds).length % 2 === 1);
  return findings.find((finding) => boxOf(finding) && covers(finding)) || null;
}
