// Puts the page together: what it shows, when it is drawn, and the mouse and the keys.

const data = JSON.parse(document.getElementById("data").textContent);
const structure = unpack(data.map);
// Of a map that is not plane it is not known which faces the features cover; those of the map with its borders cut are filled.
const areas = data.map.areas ? unpack(data.map.areas) : structure;
const byId = (id) => document.getElementById(id);
const [stage, base, over] = ["stage", "base", "over"].map(byId);
const [baseContext, overContext] = [base, over].map((canvas) => canvas.getContext("2d"));
// The picture that is being drawn, and the last one with the view of then.
const back = document.createElement("canvas").getContext("2d");
let [painter, finished] = [null, null];
const view = new View();
let [left, matching, edge] = [data.findings, new Set(), null];
let ratio = 1;

/** How long a part of the drawing may take, in milliseconds. */
const SLICE = 14;

function* paint() {
  const now = view.copy();
  back.setTransform(1, 0, 0, 1, 0, 0);
  back.fillStyle = colours.sea;
  back.fillRect(0, 0, back.canvas.width, back.canvas.height);
  back.setTransform(ratio, 0, 0, ratio, 0, 0);
  yield* drawFaces(back, now, areas, data.features);
  yield* drawMatching(now);
  yield* drawEdges(back, now, structure);
  drawEdge(now);
  const hasNames = byId("names-on").checked;
  const chains = byId("links-on").checked ? legibleChains(now, structure) : [];
  const taken = chains.length ? drawHalfEdges(back, now, structure, chains, hasNames) : [];
  const chosen = new Set(list?.chosen?.features ?? []);
  const withFaces = chains.length > 0 && areas === structure;
  if (hasNames) drawNames(back, now, areas, data.features, { chosen, taken, withFaces });
  stage.dataset.drawn = chains.length ? "half-edges" : "map";
  return now;
}

/** Outlines the features that the filter names. */
function* drawMatching(now) {
  if (matching.size === 0) return;
  back.strokeStyle = colours.accent;
  back.lineWidth = 4;
  for (const face of areas.faces) {
    if (!face.isBounded || !meets(now.box(), face.box) || !face.features.some((one) => matching.has(one))) continue;
    const path = new Path2D();
    for (const ring of face.rings) addRing(path, now, areas, ring);
    back.stroke(path);
    yield;
  }
}

/** The edge that the filter names. */
function drawEdge(now) {
  if (!edge) return;
  back.strokeStyle = colours.accent;
  back.lineWidth = 4;
  back.beginPath();
  edge.forEach(([x, y], i) => back[i ? "lineTo" : "moveTo"](now.px(x), now.py(y)));
  back.stroke();
}

/** Draws on for a while; until it is done, the last picture stands in its place. */
function frame() {
  const end = performance.now() + SLICE;
  while (painter && performance.now() < end) {
    const { done, value } = painter.next();
    if (!done) continue;
    painter = null;
    const kept = finished?.picture ?? document.createElement("canvas");
    [kept.width, kept.height] = [base.width, base.height];
    kept.getContext("2d").drawImage(back.canvas, 0, 0);
    finished = { picture: kept, view: value };
  }
  show();
  stage.dataset.state = painter ? "drawing" : "drawn";
  if (painter) requestAnimationFrame(frame);
}

function show() {
  baseContext.setTransform(1, 0, 0, 1, 0, 0);
  baseContext.fillStyle = colours.sea;
  baseContext.fillRect(0, 0, base.width, base.height);
  if (finished) {
    const { picture, view: then } = finished;
    const times = view.scale / then.scale;
    const [x, y] = then.at(0, 0);
    baseContext.setTransform(times, 0, 0, times, view.px(x) * ratio, view.py(y) * ratio);
    baseContext.drawImage(picture, 0, 0);
  }
  overContext.setTransform(1, 0, 0, 1, 0, 0);
  overContext.clearRect(0, 0, over.width, over.height);
  overContext.setTransform(ratio, 0, 0, ratio, 0, 0);
  drawFindings(overContext, view, left, list?.chosen ?? null);
  if (structure.bounds) drawScaleBar(overContext, view, data.unit);
}

/** Draws everything again. */
function redraw() {
  const isWaiting = painter !== null;
  painter = paint();
  stage.dataset.state = "drawing";
  if (!isWaiting) requestAnimationFrame(frame);
}

function resize() {
  const [isFirst, width, height] = [view.width === 1, stage.clientWidth, stage.clientHeight];
  if (width === 0 || height === 0) return;
  ratio = window.devicePixelRatio || 1;
  [view.width, view.height] = [width, height];
  for (const canvas of [base, over, back.canvas]) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  readColours(back);
  drawInsets(ratio);
  if (isFirst) view.fit(first.box, 1);
  redraw();
}

function goTo(box) {
  view.fit(box, 1);
  redraw();
}

function wholeMap() {
  goTo(view.bounds);
}

/** Shows a finding, all of it or closer. */
function look(finding, isClose) {
  const to = finding && target(structure, finding, isClose);
  if (to) view.fit(to.box, to.part);
  redraw();
}

function chose(finding, isClose = false) {
  for (const id of ["shape", "closer"]) byId(id).disabled = !finding || !boxOf(finding);
  stage.dataset.finding = finding ? finding.number : "";
  acceptance?.show(finding);
  look(finding, isClose);
}

let [list, acceptance] = [null, null];
list = new FindingList(data, structure, chose, (found, features, half) => {
  [left, matching, edge] = [found, features, lineOf(structure, half)];
  redraw();
});

acceptance = new Acceptance(data, list);

// A page that this one stands in says which findings are accepted, and why.
document.addEventListener("accept", ({ detail: { number, reason } }) => list.accept(number, reason));

/** Tells what is at a pixel. */
function tell(px, py) {
  const [x, y] = view.at(px, py);
  const digits = Math.max(0, Math.min(12, Math.ceil(Math.log10(view.scale)) + 1));
  const face = faceAt(areas, x, y);
  const names = face ? face.features.map((one) => labelOf(data.features, one)) : [];
  const what = face ? [names.join(" + "), areas === structure ? "face " + faceName(areas, face.index) : ""] : ["outside"];
  byId("place").textContent = [`(${x.toFixed(digits)}, ${y.toFixed(digits)})`, ...what.filter((text) => text)].join(" · ");
}

function addMouse() {
  let from = null;
  const fingers = new Map();
  over.addEventListener("pointerdown", (event) => {
    over.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
    from = { x: event.offsetX, y: event.offsetY, isClick: fingers.size === 1 };
  });
  over.addEventListener("pointermove", (event) => {
    const here = [event.offsetX, event.offsetY];
    if (!fingers.has(event.pointerId)) {
      tell(...here);
      return;
    }
    const before = fingers.get(event.pointerId);
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    fingers.set(event.pointerId, here);
    if (from && Math.hypot(here[0] - from.x, here[1] - from.y) > 4) from.isClick = false;
    if (from?.isClick) return;
    over.classList.add("dragged");
    if (other) {
      const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
      view.zoom(apart(here) / apart(before), (here[0] + other[0]) / 2, (here[1] + other[1]) / 2);
    } else {
      view.move(before[0] - here[0], before[1] - here[1]);
    }
    redraw();
  });
  const end = (event) => {
    fingers.delete(event.pointerId);
    over.classList.remove("dragged");
    if (event.type === "pointerup" && from?.isClick) {
      const finding = findingAt(view, left, event.offsetX, event.offsetY);
      if (finding) list.choose(finding);
      else tell(event.offsetX, event.offsetY);
    }
    if (fingers.size === 0) from = null;
  };
  over.addEventListener("pointerup", end);
  over.addEventListener("pointercancel", end);
  over.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 30 : 1;
    view.zoom(Math.exp(-Math.max(-300, Math.min(300, event.deltaY * lines)) / 300), event.offsetX, event.offsetY);
    redraw();
  }, { passive: false });
  over.addEventListener("dblclick", (event) => {
    view.zoom(2, event.offsetX, event.offsetY);
    redraw();
  });
}

function addKeys() {
  const step = 80;
  const keys = {
    ArrowLeft: () => view.move(-step, 0),
    ArrowRight: () => view.move(step, 0),
    ArrowUp: () => view.move(0, -step),
    ArrowDown: () => view.move(0, step),
    "+": () => view.zoom(1.5),
    "=": () => view.zoom(1.5),
    "-": () => view.zoom(1 / 1.5),
    0: wholeMap,
    n: () => list.step(1),
    p: () => list.step(-1),
    Enter: () => list.chosen && look(list.chosen, true),
    Escape: () => list.choose(null),
  };
  over.addEventListener("keydown", (event) => {
    const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
    tell(view.width / 2, view.height / 2);
    redraw();
  });
  const buttons = {
    whole: wholeMap,
    in: () => view.zoom(1.5),
    out: () => view.zoom(1 / 1.5),
    shape: () => look(list.chosen, false),
    closer: () => look(list.chosen, true),
  };
  for (const [id, act] of Object.entries(buttons)) {
    byId(id).addEventListener("click", () => {
      act();
      redraw();
    });
  }
  for (const id of ["names-on", "links-on"]) byId(id).addEventListener("change", redraw);
  // Enter in the filter goes to the edge that it names.
  byId("feature").addEventListener("change", () => edge && goTo(edge.reduce((box, [x, y]) => (extend(box, x, y), box), emptyBox())));
}

/** What does not change. */
function addTexts() {
  byId("input").textContent = data.name;
  byId("input").title = data.input;
  // Who asks about features asks about half-edges later, if at all.
  byId("links-on").checked = data.features.length === 0;
  byId("verdict").className = data.tone;
  for (const [what, count] of data.counts) {
    byId("counts").append(element("div", {}, element("dt", { textContent: what }), element("dd", { textContent: count })));
  }
  byId("notes").append(...data.notes.map((note) => element("li", { textContent: note })));
  const rows = byId("outcomes").tBodies[0];
  for (const { id, name, statement, outcome, found } of data.rules) {
    const cell = element("td", { textContent: outcome, className: found ? "bad" : "" });
    rows.append(
      element("tr", {}, element("th", { scope: "row", textContent: `${id} ${name}` }), element("td", { textContent: statement?.replaceAll("`", "") ?? "" }), cell),
    );
  }
  const [edges, all] = data.map.edges;
  const cuts = [];
  const number = (n) => n.toLocaleString("en");
  if (edges < all) cuts.push(`The map has ${number(all)} edges. Shown are ${number(edges)} of them: those near the listed findings.`);
  if (!structure.bounds) cuts.push("Nothing has coordinates: there is nothing to draw.");
  else if (data.map.placeless) cuts.push(`${number(data.map.placeless)} records without a place in the plane are not drawn.`);
  if (areas !== structure) cuts.push("Borders cross, touch or overlap: the faces are those after cutting them there.");
  byId("cut").hidden = cuts.length === 0;
  byId("cut").classList.toggle("bad", edges < all);
  byId("cut").textContent = cuts.join(" ");
  const marks = [];
  if (areas.faces.some((face) => face.features.length > 1)) marks.push(["overlap", "claimed by several features"]);
  if (areas.faces.some((face) => face.features.length) && areas.faces.some((face) => face.isBounded && !face.features.length)) {
    marks.push(["gap", "claimed by none"]);
  }
  if (data.findings.some((one) => one.violation)) marks.push(["violation", "violation"]);
  if (data.findings.some((one) => !one.violation)) marks.push(["finding", "finding of the coverage"]);
  byId("legend").append(...marks.map(([name, text]) => element("span", {}, element("i", { className: name }), text)));
  byId("legend").hidden = marks.length === 0;
}

const bounds = emptyBox();
for (const one of [structure.bounds, ...data.findings.map(boxOf)]) if (one) join(bounds, one, 0);
if (bounds[0] <= bounds[2]) view.bounds = bounds;
const first = firstView(areas, view.bounds);
const drawInsets = makeInsets(first.others, areas, data.features, goTo);
addTexts();
addMouse();
addKeys();
resize();
new ResizeObserver(resize).observe(stage);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
  readColours(back);
  drawInsets(ratio);
  redraw();
});
