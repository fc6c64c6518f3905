// The tables of the records, whose cells take any value, and the rules with what breaks them.

import { FIELDS, nameOf, namesOf, rowOf, textOf, WORDS } from "./records.js";

const TITLES = { v: "Vertices", h: "Half-edges", b: "Boundary components", f: "Faces" };

export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key.includes("-") || key === "role") made.setAttribute(key, value);
    else made[key] = value;
  }
  made.append(...children);
  return made;
}

/** A button that chooses a record. */
export function chooser(name, chosen, choose) {
  const button = element("button", { type: "button", textContent: name, className: "name", "aria-pressed": String(chosen.includes(name)), "aria-label": `${WORDS[name[0]]} ${name}` });
  button.dataset.choose = name;
  button.addEventListener("click", () => choose(name));
  return button;
}

function cell(state, name, field, set) {
  const [now, was] = [state.table, state.sound].map((tables) => textOf(rowOf(tables, name), name[0], field));
  const input = element("input", { value: now, size: Math.max(4, now.length), autocomplete: "off", spellcheck: false, "aria-label": `${field} of ${name}`, className: now === was ? "" : "by-hand" });
  input.dataset.cell = `${name} ${field}`;
  input.autocapitalize = "off";
  input.addEventListener("change", () => set(name, field, input.value));
  input.addEventListener("keydown", ({ key }) => {
    if (key === "Escape") input.value = now;
  });
  input.addEventListener("focus", () => input.select());
  return element("td", {}, input);
}

/** The four tables. */
export function tables(state, chosen, choose, set) {
  const broken = new Set(state.violations.flatMap(({ records }) => records.map(nameOf)));
  return Object.entries(TITLES).map(([letter, title]) => {
    const names = namesOf(state.table, letter);
    const fields = Object.keys(FIELDS[letter]);
    const head = element("tr", {}, element("td", {}), ...fields.map((field) => element("th", { scope: "col", textContent: field })));
    const rows = names.map((name) =>
      element(
        "tr",
        { className: [chosen.includes(name) && "chosen", broken.has(name) && "broken"].filter(Boolean).join(" ") },
        element("th", { scope: "row" }, chooser(name, chosen, choose)),
        ...fields.map((field) => cell(state, name, field, set)),
      ),
    );
    return element("table", {}, element("caption", { textContent: `${title} (${names.length})` }), element("thead", {}, head), element("tbody", {}, ...rows));
  });
}

/** A sentence of the validator, in which code stands between backticks. */
const marked = (text) => text.split("`").map((part, i) => (i % 2 ? element("code", { textContent: part }) : part));

/** The rules, each with its outcome, and below it what breaks it. */
export function rules(state, chosen, choose) {
  return state.rules.map(({ id, name, statement, violations, unchecked }) => {
    const [mark, word] = violations ? ["✗", `broken ${violations === 1 ? "once" : `${violations} times`}`] : unchecked ? ["–", `not checked: ${unchecked}`] : ["✓", "holds"];
    const item = element(
      "li",
      { className: violations ? "broken" : unchecked ? "unchecked" : "" },
      element("span", { className: "mark", textContent: mark, "aria-hidden": "true" }),
      element("strong", { textContent: `${id} ${name}` }),
      element("span", { textContent: ` ${word}` }),
      element("p", { className: "quiet" }, ...marked(statement)),
    );
    const found = state.violations.filter(({ rule }) => rule === id);
    if (found.length) {
      const entries = found.map(({ message, cause, remedy, records }) =>
        element(
          "li",
          {},
          element("p", { className: "message", textContent: `${message}.` }),
          element("p", {}, ...records.map((record) => chooser(nameOf(record), chosen, choose))),
          element("p", { className: "quiet" }, ...marked(`Usual cause: ${cause}. Remedy: ${remedy}.`)),
        ),
      );
      item.append(element("ul", {}, ...entries));
    }
    return item;
  });
}

/** Euler's formula with the numbers of the structure. */
export function euler({ report: { counts } }) {
  const { vertices, edges, faces, components } = counts;
  if (components === null) return "V − E + F = 1 + C: the components cannot be counted, as a rule is broken that this needs.";
  const [left, right] = [vertices - edges + faces, 1 + components];
  return `V − E + F = ${vertices} − ${edges} + ${faces} = ${left}, 1 + C = 1 + ${components} = ${right}${left === right ? "" : " (Euler's formula fails)"}`;
}
