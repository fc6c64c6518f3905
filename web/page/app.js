// The page: files come in, the report is shown, repairs are previewed and kept, findings are accepted, everything is saved.

import { TwinedgeWorker } from "../package/index.js";
import { AcceptedFindings } from "./accepted.js";
import { example } from "./example.js";
import { History } from "./history.js";
import { spawn, wasm } from "./inline.js";
import { LIMIT, refusal } from "./refusal.js";

const byId = (id) => document.getElementById(id);
const twinedge = new TwinedgeWorker(wasm(), spawn);
const history = new History();
const accepted = new AcceptedFindings();
let [cancel, preview, chosen, openNumber] = [null, null, null, 0];

/** A new element with these properties and children. */
function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function say(text) {
  byId("status").textContent = text;
}

/** Shows a message instead of a report. */
function showMessage(...children) {
  for (const id of ["welcome", "report", "panel"]) byId(id).hidden = true;
  byId("message").replaceChildren(...children);
  byId("message").hidden = false;
  byId("message").focus();
}

/** Does work that can be cancelled. Its errors are shown, and its result is null then. */
async function working(what, work) {
  cancel?.abort();
  const own = new AbortController();
  cancel = own;
  byId("cancel").hidden = false;
  document.body.setAttribute("aria-busy", "true");
  say(`${what}…`);
  try {
    return await work({ signal: own.signal, progress: (stage) => say(`${what}: ${stage}…`) });
  } catch (error) {
    if (cancel !== own) return null;
    if (own.signal.aborted) say("Cancelled.");
    else showError(error);
    return null;
  } finally {
    if (cancel === own) {
      cancel = null;
      byId("cancel").hidden = true;
      document.body.removeAttribute("aria-busy");
    }
  }
}

function showError(error) {
  say("");
  const parts = [element("h2", { textContent: "This could not be done" }), element("p", { className: "bad", textContent: error.message })];
  const layers = error.place?.layers;
  if (layers?.length && lastFiles) {
    const buttons = layers.map((layer) => {
      const button = element("button", { type: "button", textContent: layer });
      button.addEventListener("click", () => open(lastFiles, layer));
      return element("li", {}, button);
    });
    parts.push(element("p", { textContent: "Open one of its layers:" }), element("ul", {}, ...buttons));
  }
  if (error.code === "too-large") parts.push(element("pre", { textContent: "twinedge audit FILE -o report.html\ntwinedge clean FILE -o clean.gpkg" }));
  if (history.now) {
    const back = element("button", { type: "button", textContent: "Back to the report" });
    back.addEventListener("click", show);
    parts.push(element("p", {}, back));
  }
  showMessage(...parts);
}

/** The report of files, and the page that shows it. */
function audited(files, options, how) {
  return twinedge.auditWithPage(files, { ...options, explain: true, ...how });
}

let lastFiles = null;

/** Opens files: a map, a mesh, or a certificate. */
async function open(files, layer) {
  const number = ++openNumber;
  const notes = files.filter(({ name }) => /accepted.*\.json$/i.test(name));
  const rest = files.filter((file) => !notes.includes(file));
  if (rest.length === 0) {
    for (const { bytes } of notes) accepted.read(bytes);
    if (history.now) mark();
    return;
  }
  lastFiles = files;
  if (rest.some(({ name }) => name.split("/").at(-1) === "claim.txt")) return check(rest);
  const refused = refusal(rest);
  if (refused) {
    history.clear();
    showTools();
    say("");
    return showMessage(...refused.map((part) => element(part.code ? "pre" : "p", { textContent: part.code ?? part.text })));
  }
  const options = layer ? { layer } : {};
  const found = await working(`Reading ${rest[0].name}`, (how) => audited(rest, options, how));
  if (!found || number !== openNumber) return;
  accepted.clear();
  for (const { bytes } of notes) accepted.read(bytes);
  history.begin({ files: rest, options, ...found });
  closePanel();
  show();
}

async function check(files) {
  history.clear();
  showTools();
  const entries = Object.fromEntries(files.map(({ name, bytes }) => [name, bytes]));
  const found = await working("Checking the certificate", (how) => twinedge.check(entries, how));
  if (!found) return;
  say("");
  showMessage(
    element("h2", { textContent: "Certificate" }),
    element("p", found.valid ? { className: "good", textContent: `Valid: ${found.claim}.` } : { className: "bad", textContent: "Not valid." }),
    element("ul", {}, ...found.failures.map((failure) => element("li", { textContent: failure }))),
  );
}

function showTools() {
  byId("work-tools").hidden = !history.now;
  byId("undo").disabled = !history.canUndo || preview !== null;
  byId("redo").disabled = !history.canRedo || preview !== null;
  const isMap = Boolean(history.now?.report.import);
  byId("repair-open").disabled = !isMap;
  byId("save-map").disabled = !isMap;
  byId("save-findings").disabled = !isMap;
}

/** Shows the report of the version that is looked at. */
function show() {
  const side = byId("repair").elements.side.value;
  const version = preview && side === "after" ? preview : history.now;
  byId("welcome").hidden = byId("message").hidden = true;
  byId("panel").hidden = openPanel === null;
  const frame = byId("report");
  frame.hidden = false;
  chosen = null;
  frame.onload = () => watch(frame.contentDocument);
  frame.srcdoc = version.page;
  showTools();
  summarise(version);
}

function summarise(version) {
  const { report, name = version.files[0].name } = version;
  const coverage = report.coverage;
  const found = (report.violation_count ?? 0) + (report.finding_count ?? 0) + (coverage ? countOf(coverage) : 0);
  const left = found - accepted.count;
  const findings = found === 0 ? "nothing was found" : `${found} ${found === 1 ? "finding" : "findings"}`;
  const beside = accepted.count ? `, ${accepted.count} accepted, ${left} left` : "";
  say(`${name}: ${findings}${beside}${preview && version === preview ? " (preview)" : ""}`);
}

const countOf = (coverage) =>
  Object.entries(coverage).reduce((sum, [key, value]) => (typeof value === "number" && COUNTS.includes(key) ? sum + value : sum), 0);
const COUNTS = ["overlaps", "gaps", "near_misses", "slivers", "duplicates", "mismatches", "ogc_invalid"];

/** The findings of the report that is shown. */
function findingsOf(page) {
  return JSON.parse(page.getElementById("data").textContent);
}

/** Notes which finding is chosen in the report, and marks those that are accepted. */
function watch(page) {
  const data = findingsOf(page);
  const stage = page.getElementById("stage");
  const note = () => {
    const number = Number(stage.dataset.finding || 0);
    chosen = number ? { number, finding: data.findings[number - 1], features: data.features } : null;
    describeChosen();
  };
  new MutationObserver(note).observe(stage, { attributes: true, attributeFilter: ["data-finding"] });
  note();
  mark();
}

/** Tells the report which of its findings are accepted. */
function mark() {
  const page = byId("report").contentDocument;
  if (!page?.getElementById("data")) return;
  const { findings, features } = findingsOf(page);
  accepted.count = 0;
  findings.forEach((finding, i) => {
    const reason = accepted.reasonOf(finding, features);
    if (reason !== null) accepted.count++;
    page.dispatchEvent(new CustomEvent("accept", { detail: { number: i + 1, reason } }));
  });
  listAccepted();
  summarise(preview && byId("repair").elements.side.value === "after" ? preview : history.now);
}

function describeChosen() {
  const { finding, features } = chosen ?? {};
  const who = finding?.features.map((number) => features[number][0] ?? features[number][1] ?? `feature ${number}`).join(", ");
  byId("chosen").textContent = finding
    ? `${finding.rule} ${finding.name}${who ? ` of ${who}` : ""}: ${finding.sentence ?? finding.message}`
    : "Choose a finding in the list or on the map.";
  byId("accept").querySelector("[type=submit]").disabled = !finding;
}

function listAccepted() {
  const items = accepted.all().map(([key, { rule, features, reason }]) => {
    const remove = element("button", { type: "button", textContent: "Remove" });
    remove.setAttribute("aria-label", `Remove: ${rule} ${features.join(", ")}`);
    remove.addEventListener("click", () => {
      accepted.remove(key);
      mark();
    });
    return element("li", {}, `${rule} ${features.join(", ")}: ${reason} `, remove);
  });
  byId("accepted").replaceChildren(...items);
}

let openPanel = null;

function togglePanel(name) {
  openPanel = openPanel === name ? null : name;
  for (const one of ["repair", "accept", "save"]) {
    byId(one).hidden = one !== openPanel;
    byId(one + "-open").setAttribute("aria-expanded", String(one === openPanel));
  }
  byId("panel").hidden = openPanel === null;
  if (openPanel) byId(openPanel).querySelector("select, input, button")?.focus();
}

function closePanel() {
  if (openPanel) togglePanel(openPanel);
  preview = null;
  byId("preview").hidden = true;
}

/** A positive number from a field, or nothing. */
function numberOf(form, name) {
  const text = form.elements[name].value.trim().replace(",", ".");
  if (text === "") return undefined;
  return Number(text);
}

/** The name under which a repaired or saved map is written. */
const stemOf = ({ files }) => files[0].name.split("/").at(-1).replace(/\.(zip|gz)$/i, "").replace(/\.[^.]+$/, "");

/** Cleans a layer and keeps its format, with the reference system that it may have; what that cannot hold is GeoJSON. */
async function cleaned(files, asked, how) {
  const names = files.map(({ name }) => name.toLowerCase());
  const own = names.some((name) => /\.(zip|shp)$/.test(name)) ? "shapefile" : names[0].endsWith(".fgb") ? "flatgeobuf" : "geojson";
  try {
    return await twinedge.clean(files, { ...asked, to: own, lossy: own === "geojson", ...how });
  } catch (error) {
    if (error.code !== "loss") throw error;
    return twinedge.clean(files, { ...asked, to: "geojson", lossy: true, ...how });
  }
}

async function repair(event) {
  event.preventDefault();
  const form = byId("repair");
  const { files, options } = history.now;
  const [gapWidth, sliver, snap] = ["gapWidth", "sliver", "snap"].map((name) => numberOf(form, name));
  const asked = { ...options, overlap: form.elements.overlap.value, gapWidth, sliver, snap };
  const result = await working("Repairing", async (how) => {
    const { report, file } = await cleaned(files, asked, how);
    const name = `${stemOf(history.now).replace(/-repaired$/, "")}-repaired.${file.name.split(".").at(-1)}`;
    const after = [{ name, bytes: file.bytes }];
    return { files: after, options: {}, repair: report, ...(await audited(after, {}, how)) };
  });
  if (!result) return;
  preview = result;
  form.elements.side.value = "after";
  byId("preview").hidden = false;
  describeRepair(result.repair);
  show();
  byId("keep").focus();
}

function describeRepair({ changes, changed, left, warnings }) {
  const count = (n, one, many) => `${n} ${n === 1 ? one : many}`;
  const of = (kind) => changes.filter((change) => change.kind === kind).length;
  const left_ = left?.findings.length ? ` ${count(left.findings.length, "finding is", "findings are")} left.` : " Nothing is left.";
  byId("done").textContent =
    `${count(of("overlap"), "overlap", "overlaps")} resolved, ${count(of("gap"), "gap", "gaps")} filled, ` +
    `${count(of("sliver"), "sliver", "slivers")} given away; ${count(changed.length, "feature has", "features have")} another shape.${left_}`;
  const lines = [
    ...warnings.map((text) => element("li", { className: "bad", textContent: text })),
    ...changed.slice(0, 100).map(({ name, id, number, reasons }) => element("li", { textContent: `${name ?? id ?? "feature " + number}: ${reasons.join("; ")}` })),
  ];
  byId("changes").replaceChildren(...lines);
}

function download(name, bytes, type = "application/octet-stream") {
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
  say(`${name} is saved.`);
}

async function saveMap() {
  const to = byId("format").value;
  const { files, options } = history.now;
  const result = await working("Writing", (how) => twinedge.convert(files, { ...options, to, lossy: true, ...how }));
  if (!result) return;
  const extension = result.name.split(".").at(-1);
  download(`${stemOf(history.now)}.${extension}`, result.bytes);
  if (result.losses.length) say(`Saved. This format does not hold ${result.losses.join("; ")}.`);
}

async function saveFindings() {
  const { files, options } = history.now;
  const layer = await working("Writing the findings", (how) => twinedge.findings(files, { ...options, explain: true, ...how }));
  if (!layer) return;
  const { warnings, ...collection } = layer;
  const reasons = byId("report").contentDocument ? reasonsByPlace() : new Map();
  for (const { properties } of collection.features) {
    const reason = reasons.get([properties.rule, properties.x, properties.y].join());
    if (reason) properties.accepted = reason;
  }
  download(`${stemOf(history.now)}-findings.geojson`, JSON.stringify(collection));
}

function reasonsByPlace() {
  const { findings, features } = findingsOf(byId("report").contentDocument);
  return new Map(findings.map((finding) => [[finding.rule, ...(finding.at ?? [])].join(), accepted.reasonOf(finding, features)]));
}

async function filesOf(list) {
  return Promise.all([...list].map(async (file) => ({ name: file.webkitRelativePath || file.name, size: file.size, bytes: file.size > LIMIT ? null : new Uint8Array(await file.arrayBuffer()) })));
}

/** The files of a drop, those in folders included. */
async function dropped({ items, files }) {
  const entries = [...items].map((item) => item.webkitGetAsEntry?.()).filter(Boolean);
  if (!entries.some((entry) => entry.isDirectory)) return filesOf(files);
  const found = [];
  const walk = async (entry) => {
    if (entry.isFile) {
      const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
      found.push(...(await filesOf([file])));
      return;
    }
    const reader = entry.createReader();
    // It hands over some at a time.
    for (;;) {
      const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
      if (some.length === 0) return;
      for (const one of some) await walk(one);
    }
  };
  for (const entry of entries) await walk(entry);
  return found;
}

function addDrop() {
  addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("over");
  });
  addEventListener("dragleave", (event) => event.relatedTarget ?? document.body.classList.remove("over"));
  addEventListener("drop", async (event) => {
    event.preventDefault();
    document.body.classList.remove("over");
    open(await dropped(event.dataTransfer));
  });
  // A drag over the report goes to the report, unless the pointer passes through.
  addEventListener("dragenter", () => (byId("report").style.pointerEvents = "none"));
  for (const end of ["dragleave", "drop"]) addEventListener(end, () => (byId("report").style.pointerEvents = ""));
}

function addButtons() {
  const clicks = {
    example: () => open(example()),
    cancel: () => cancel?.abort(),
    undo: () => history.undo() && show(),
    redo: () => history.redo() && show(),
    "repair-open": () => togglePanel("repair"),
    "accept-open": () => togglePanel("accept"),
    "save-open": () => togglePanel("save"),
    keep: () => {
      history.add(preview);
      closePanel();
      show();
      byId("undo").focus();
    },
    discard: () => {
      preview = null;
      byId("preview").hidden = true;
      show();
    },
    "save-map": saveMap,
    "save-findings": saveFindings,
    "save-report": () => download(`${stemOf(history.now)}-report.html`, history.now.page, "text/html"),
    "save-accepted": () => download(`${stemOf(history.now)}-accepted.json`, accepted.text(), "application/json"),
  };
  for (const [id, act] of Object.entries(clicks)) byId(id).addEventListener("click", act);
  for (const id of ["files", "folder"]) {
    byId(id).addEventListener("change", async ({ target }) => {
      const files = await filesOf(target.files);
      target.value = "";
      if (files.length) open(files);
    });
  }
  byId("repair").addEventListener("submit", repair);
  for (const side of byId("repair").elements.side) side.addEventListener("change", show);
  byId("accept").addEventListener("submit", (event) => {
    event.preventDefault();
    const field = byId("accept").elements.reason;
    if (!chosen || !field.value.trim()) return;
    accepted.add(chosen.finding, chosen.features, field.value.trim());
    field.value = "";
    mark();
  });
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || event.target.matches?.("input")) return;
    event.preventDefault();
    byId(event.shiftKey ? "redo" : "undo").click();
  });
}

addDrop();
addButtons();
