// The parts of a map that lie far from each other: the one with most features is shown first, the others in insets, as
// `layout.rs` of the library draws them.

/** An empty strip is between two parts if it is wider than this, as a part of the longer side of both together. */
const STRIP = 0.1;
/** There are insets if without them everything would be smaller by this; and the most of them. */
const GAIN = 1.5;
const MOST_INSETS = 6;
const DEPTH = 8;
/** The room that is left below the main part for the insets, as a part of its height. */
const ROW = 0.15;

function longer(box) {
  return Math.max(box[2] - box[0], box[3] - box[1]);
}

/** The faces of each part, that with the most faces first. Without features all faces count. */
function partsOf(s) {
  const bounded = s.faces.filter((face) => face.isBounded);
  const covered = bounded.filter((face) => face.features.length > 0);
  const found = [];
  divide(covered.length > 0 ? covered : bounded, DEPTH, found);
  return found.sort((a, b) => b.faces.length - a.faces.length);
}

/** Parts faces along the widest empty strip, and so on. */
function divide(faces, depth, found) {
  const all = emptyBox();
  for (const { box } of faces) join(all, box, 0);
  let [widest, axis, first] = [STRIP * longer(all), 0, 0];
  const sorted = [0, 1].map((along) => [...faces].sort((a, b) => a.box[along] - b.box[along]));
  sorted.forEach((inOrder, along) => {
    let reached = Infinity;
    inOrder.forEach(({ box }, i) => {
      if (box[along] - reached > widest) [widest, axis, first] = [box[along] - reached, along, i];
      reached = i === 0 ? box[along + 2] : Math.max(reached, box[along + 2]);
    });
  });
  if (depth === 0 || first === 0) {
    if (faces.length > 0) found.push({ box: all, faces });
    return;
  }
  divide(sorted[axis].slice(0, first), depth - 1, found);
  divide(sorted[axis].slice(first), depth - 1, found);
}

/** The box to show first, and the parts outside it that are shown in insets. */
function firstView(s, bounds) {
  const [main, ...others] = partsOf(s);
  if (!main || longer(bounds) < GAIN * longer(main.box)) return { box: bounds, others: [] };
  const [x0, y0, x1, y1] = main.box;
  return { box: [x0, y0 - ROW * (y1 - y0), x1, y1], others: others.slice(0, MOST_INSETS) };
}

/** Makes a button for each part, which `go` shows; returns a function that draws them. */
function makeInsets(parts, s, features, go) {
  const drawings = parts.map(({ box, faces }) => {
    const largest = faces.reduce((a, b) => (longer(b.box) > longer(a.box) ? b : a));
    const name = largest.features.length > 0 ? labelOf(features, largest.features[0]) : "a part far away";
    const canvas = element("canvas", {});
    const button = element("button", { type: "button", title: name }, canvas);
    button.setAttribute("aria-label", `Show ${name}`);
    button.addEventListener("click", () => go(box));
    document.getElementById("insets").append(button);
    return [canvas, box];
  });
  return (ratio) => {
    for (const [canvas, box] of drawings) {
      const small = new View();
      [small.width, small.height, small.bounds] = [canvas.clientWidth, canvas.clientHeight, box];
      [canvas.width, canvas.height] = [small.width * ratio, small.height * ratio];
      small.fit(box, 1, 10);
      const context = canvas.getContext("2d");
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      for (const drawing of [drawFaces(context, small, s, features), drawEdges(context, small, s)]) for (const _ of drawing);
    }
  };
}
