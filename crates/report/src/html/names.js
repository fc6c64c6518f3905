// Writes the names of features, and of faces where half-edges are drawn, into the widest stretch of them that is in sight.

/** At how many heights of a face the widest stretch is looked for, in how many faces, with how many points in all. */
const HEIGHTS = 7;
const MOST_FACES = 250;
const MOST_POINTS = 400000;

/** A name is cut to so many letters. */
const LONGEST = 40;

/** The widest stretch of a face along each of some horizontal lines in sight, the widest first: its middle in pixels and its width. */
function widest(view, s, face) {
  const seen = view.box();
  const [low, high] = [Math.max(face.box[1], seen[1]), Math.min(face.box[3], seen[3])];
  const found = [];
  for (let i = 0; i < HEIGHTS; i++) {
    let best = null;
    const y = low + ((high - low) * (i + 0.5)) / HEIGHTS;
    const crossings = [];
    for (const ring of face.rings) {
      let [firstX, firstY, lastX, lastY] = [NaN, NaN, NaN, NaN];
      const side = (ax, ay, bx, by) => {
        if (ay > y !== by > y) crossings.push(ax + ((bx - ax) * (y - ay)) / (by - ay));
      };
      eachPoint(s, ring, (px, py) => {
        if (Number.isNaN(firstX)) [firstX, firstY] = [px, py];
        else side(lastX, lastY, px, py);
        [lastX, lastY] = [px, py];
      });
      side(lastX, lastY, firstX, firstY);
    }
    crossings.sort((a, b) => a - b);
    for (let j = 0; j + 1 < crossings.length; j += 2) {
      const [from, to] = [Math.max(crossings[j], seen[0]), Math.min(crossings[j + 1], seen[2])];
      // The middle heights are better where widths are about the same.
      const worth = (to - from) * (1 - 0.06 * Math.abs(i - (HEIGHTS - 1) / 2));
      if (to > from && (!best || worth > best.worth)) best = { worth, x: (from + to) / 2, y, width: to - from };
    }
    if (best) found.push({ worth: best.worth, x: view.px(best.x), y: view.py(best.y), width: best.width * view.scale });
  }
  return found.sort((a, b) => b.worth - a.worth);
}

/** Text as it is drawn on the map: without control characters, and not too long. */
function shown(text) {
  const letters = Array.from(text.replace(/\p{C}/gu, "\u{fffd}"));
  return letters.length > LONGEST ? letters.slice(0, LONGEST - 1).join("") + "…" : letters.join("");
}

/** Writes names where no room is taken. Those of the chosen features have their turn before the others. */
function drawNames(context, view, s, features, { chosen: first, taken, withFaces }) {
  const seen = view.box();
  const inSight = [];
  for (const face of s.faces) {
    if (!face.isBounded || !meets(seen, face.box)) continue;
    const [w, h] = [0, 1].map((i) => (Math.min(face.box[i + 2], seen[i + 2]) - Math.max(face.box[i], seen[i])) * view.scale);
    if (w > 14 && h > 9) inSight.push([face, w * h * (face.features.some((one) => first.has(one)) ? 1e6 : 1)]);
  }
  inSight.sort((a, b) => b[1] - a[1]);
  const named = new Set();
  let points = 0;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (const [face] of inSight.slice(0, MOST_FACES)) {
    for (const ring of face.rings) eachPoint(s, ring, () => (points += HEIGHTS));
    if (points > MOST_POINTS) return;
    const spots = widest(view, s, face);
    const chosen = face.features.filter((one) => features[one][0] !== null && !named.has(one));
    const lines = chosen.slice(0, 3).map((one) => shown(features[one][0]));
    if (face.features.length > 1 && lines.length > 1) lines.splice(0, lines.length, lines.join(" + "));
    const text = lines[0];
    context.font = "13px system-ui, sans-serif";
    if (text !== undefined && place(context, taken, spots, text, colours.ink)) {
      if (face.features.length === 1) named.add(face.features[0]);
    }
    if (withFaces) {
      context.font = "italic 12px system-ui, sans-serif";
      place(context, taken, spots, faceName(s, face.index), colours.quiet);
    }
  }
}

/** Writes a text at the first of some spots where there is room for it. */
function place(context, taken, spots, text, colour) {
  const width = context.measureText(text).width;
  for (const { x, y, width: room } of spots) {
    const area = [x - width / 2 - 2, y - 8, x + width / 2 + 2, y + 8];
    if (width > room - 4 || taken.some((other) => meets(area, other))) continue;
    taken.push(area);
    haloed(context, text, x, y, colour);
    return true;
  }
  return false;
}
