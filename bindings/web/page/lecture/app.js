// The lecture: a structure, its picture and its tables; what is chosen; the steps.

import { moduleOf } from "../../package/sync.js";
import { Engine } from "../../package/engine.js";
import { Structure } from "../../package/structure.js";
import { wasm } from "../inline.js";
import { difference, Needs, OPERATORS } from "./operators.js";
import { draw, HEIGHT, WIDTH } from "./picture.js";
import { nameOf, recordOf, rowOf, WORDS } from "./records.js";
import { STEPS } from "./steps.js";
import { element, euler, rules, tables } from "./tables.js";

const byId = (id) => document.getElementById(id);
const picture = byId("picture");

let structure;
/** The place of each vertex by its key, which no other vertex has. Undoing finds it again. */
const places = new Map();
let [chosen, clicked, where, isSaid] = [[], null, null, true];
let lesson = { number: 0 };

const keyOf = (v) => structure.state.keys.find(([, record]) => record.vertex === v)[0];
const placeOf = (v) => places.get(keyOf(v)) ?? [WIDTH / 2, HEIGHT / 2];
const inPicture = ([x, y]) => [Math.max(20, Math.min(WIDTH - 20, x)), Math.max(20, Math.min(HEIGHT - 20, y))];
const move = (v, place) => places.set(keyOf(v), inPicture(place));

function say(text, isBad = false) {
  byId("status").textContent = text;
  byId("status").className = isBad ? "bad" : "";
}

/** Shows the state. What has the focus keeps it. */
function show() {
  const { state } = structure;
  chosen = chosen.filter((name) => rowOf(state.sound, name));
  const focused = document.activeElement?.dataset ?? {};
  where = draw(picture, state, placeOf, chosen);
  byId("tables").replaceChildren(...tables(state, chosen, choose, set));
  byId("rules").replaceChildren(...rules(state, chosen, choose));
  const broken = state.rules.filter(({ violations }) => violations > 0).map(({ id }) => id);
  byId("verdict").textContent = broken.length ? `Broken: ${broken.join(", ")}` : "All rules hold";
  byId("verdict").className = broken.length ? "bad" : "good";
  byId("euler").textContent = euler(state);
  byId("chosen").textContent = chosen.length ? `Chosen: ${chosen.join(", then ")}` : "Nothing is chosen.";
  for (const way of ["undo", "redo"]) {
    byId(way).disabled = state[way] === null;
    byId(way).title = state[way] ?? "";
  }
  const { counts } = state.report;
  picture.setAttribute("aria-label", `Picture of ${counts.vertices} vertices, ${counts.edges} edges and ${counts.faces} faces. The tables say the same.`);
  for (const key of ["choose", "cell"]) {
    if (focused[key]) document.querySelector(`#tables [data-${key}="${focused[key]}"]`)?.focus();
  }
  judge();
}

/** Looks whether the task of the step is done. */
function judge() {
  const { state } = structure;
  lesson.wasBroken ||= !state.report.valid;
  if (lesson.isDone || !lesson.first || !STEPS[lesson.number].is({ ...lesson, state })) return;
  lesson.isDone = true;
  byId("task").classList.add("done");
  byId("done").textContent = lesson.number + 1 < STEPS.length ? "Done. Go on to the next step." : "Done.";
}

function choose(name) {
  clicked = null;
  chosen = chosen.includes(name) && chosen.at(-1) === name ? chosen.filter((one) => one !== name) : [...chosen.filter((one) => one !== name), name].slice(-2);
  lesson.trail.push(name);
  const { state } = structure;
  const wrong = state.violations.filter(({ records }) => records.some((record) => nameOf(record) === name)).map(({ rule }) => rule);
  say(`${WORDS[name[0]]} ${name}${chosen.includes(name) ? "" : ": no longer chosen"}${wrong.length ? `: breaks ${[...new Set(wrong)].join(", ")}` : ""}`);
  show();
}

/** Does something that may be refused, and says so. */
function attempt(act) {
  try {
    say(act() ?? "");
  } catch (error) {
    if (!(error instanceof Needs) && error.code !== "refused" && error.code !== "option") throw error;
    say(error.message[0].toUpperCase() + error.message.slice(1), true);
  }
  show();
}

/** The verdict of the validator, in a few words. */
function verdict() {
  const { rules: all } = structure.state;
  const broken = all.filter(({ violations }) => violations > 0).map(({ id, name }) => `${id} ${name}`);
  return broken.length ? `Broken: ${broken.join(", ")}.` : "All rules hold.";
}

function operate(name) {
  attempt(() => {
    const before = structure.state;
    const view = { tables: before.sound, chosen, clicked, where, places: placeOf, move };
    const placeFor = OPERATORS[name](structure, view);
    const { state } = structure;
    const { made, gone } = difference(before.keys, state.keys);
    for (const vertex of made.filter((one) => one[0] === "v")) {
      const v = Number(vertex.slice(1));
      move(v, placeFor(v, state));
    }
    lesson.done.push(name);
    clicked = null;
    const parts = [made.length && `new: ${made.join(", ")}`, gone.length && `removed: ${gone.join(", ")}`].filter(Boolean);
    return `${name}. ${parts.join("; ") || "Links changed"}. ${verdict()}`;
  });
}

function set(name, field, value) {
  attempt(() => {
    structure.set(recordOf(name), field, value);
    return `${field} of ${name} is set. ${verdict()}`;
  });
}

function travel(way, word) {
  attempt(() => {
    const name = structure.state[way];
    structure[way]();
    return name === null ? "" : `${word}: ${name}. ${verdict()}`;
  });
}

/** Begins a step anew. */
function begin(number) {
  const step = STEPS[number];
  structure.clear();
  places.clear();
  [chosen, clicked] = [[], null];
  lesson = { number, trail: [], done: [], wasBroken: false, isDone: false, first: null };
  step.begin(structure, (key, place) => places.set(key, place));
  // Undo ends at the beginning of the step.
  lesson.first = structure.forget();
  byId("step-title").textContent = step.title;
  byId("step-number").textContent = `Step ${number + 1} of ${STEPS.length}`;
  byId("step-text").replaceChildren(...step.text.map((text) => element("p", { textContent: text })));
  byId("task").hidden = step.task === null;
  byId("task").classList.remove("done");
  byId("task-text").textContent = step.task ?? "";
  byId("done").textContent = "";
  byId("extra").hidden = !step.extra;
  byId("extra").textContent = step.extra?.label ?? "";
  byId("back").disabled = number === 0;
  byId("forward").disabled = number === STEPS.length - 1;
  say("");
  show();
}

function go(number) {
  location.hash = `step-${number + 1}`;
}

/** The step in the address. */
const stepInAddress = () => Math.max(0, Math.min(STEPS.length - 1, (Number(/^#step-(\d+)$/.exec(location.hash)?.[1]) || 1) - 1));

/** The point of the picture under a pointer. */
function pointOf({ clientX, clientY }) {
  const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(picture.getScreenCTM().inverse());
  return [x, y];
}

function addPointer() {
  let dragged = null;
  picture.addEventListener("pointerdown", (event) => {
    const name = event.target.dataset.name;
    if (name?.[0] !== "v") return;
    dragged = { name, from: pointOf(event), isMoved: false };
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener("pointermove", (event) => {
    if (!dragged) return;
    const point = pointOf(event);
    dragged.isMoved ||= Math.hypot(point[0] - dragged.from[0], point[1] - dragged.from[1]) > 4;
    if (!dragged.isMoved) return;
    move(Number(dragged.name.slice(1)), point);
    where = draw(picture, structure.state, placeOf, chosen);
  });
  const end = (event) => {
    if (!dragged) return;
    const { name, isMoved } = dragged;
    dragged = null;
    if (event.type === "pointerup" && !isMoved) choose(name);
  };
  picture.addEventListener("pointerup", end);
  picture.addEventListener("pointercancel", end);
  picture.addEventListener("click", (event) => {
    const name = event.target.dataset.name;
    if (!name || name[0] === "v") return;
    choose(name);
    if (name[0] === "f") clicked = pointOf(event);
  });
}

function addKeys() {
  const steps = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, -10], ArrowDown: [0, 10] };
  picture.addEventListener("keydown", (event) => {
    const vertex = chosen.findLast((name) => name[0] === "v");
    if (!steps[event.key] || !vertex) return;
    event.preventDefault();
    const v = Number(vertex.slice(1));
    move(v, placeOf(v).map((c, i) => c + steps[event.key][i]));
    show();
  });
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || event.target.matches?.("input")) return;
    event.preventDefault();
    byId(event.shiftKey ? "redo" : "undo").click();
  });
}

function addButtons() {
  for (const name of Object.keys(OPERATORS)) {
    const button = element("button", { type: "button", textContent: name });
    button.addEventListener("click", () => operate(name));
    byId("operators").append(button);
  }
  byId("undo").addEventListener("click", () => travel("undo", "Undone"));
  byId("redo").addEventListener("click", () => travel("redo", "Redone"));
  byId("back").addEventListener("click", () => go(lesson.number - 1));
  byId("forward").addEventListener("click", () => go(lesson.number + 1));
  byId("again").addEventListener("click", () => begin(lesson.number));
  byId("extra").addEventListener("click", () =>
    attempt(() => {
      STEPS[lesson.number].extra.act(structure);
      return verdict();
    }),
  );
  addEventListener("hashchange", () => {
    begin(stepInAddress());
    byId("step-title").focus();
  });
}

// Nothing can be asked before there is a structure.
moduleOf(wasm()).then((module) => {
  structure = new Structure(new Engine(module));
  addPointer();
  addKeys();
  addButtons();
  begin(stepInAddress());
});
