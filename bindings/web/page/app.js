// The page: files come in, the report is shown, repairs are previewed and kept, findings are accepted, everything is saved.

import { TwinedgeWorker } from "../package/index.js";
import { AcceptedFindings } from "./accepted.js";
import { example } from "./example.js";
import { History } from "./history.js";
import { spawn, wasm } from "./inline.js";
import { commandFor, LIMIT, refusal } from "./refusal.js";

const byId = (id) => document.getElementById(id);
const twinedge = new TwinedgeWorker(wasm(), spawn);
const history = new History();
let accepted = new AcceptedFindings();
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
    parts.push(element("p", { textContent: "Open one of these:" }), element("ul", {}, ...buttons));
  }
  const command = lastFiles && commandFor(error, lastFiles[0]);
  if (command) parts.push(element("p", { textContent: "The program takes it. Run this instead:" }), element("pre", { textContent: command }));
  showMessage(...parts, ...wayBack());
}

/** A button that shows the report again, if there is one. */
function wayBack() {
  if (!history.now) return [];
  const back = element("button", { type: "button", textContent: "Back to the report" });
  back.addEventListener("click", show);
  return [element("p", {}, back)];
}

const accepting = (list) => (list.all().length ? list.list() : null);

/** The report of files, the page that shows it, and the findings that can be accepted; with these, which are. */
async function audited(files, options, how, list = accepted) {
  const found = await twinedge.auditWithPage(files, { ...options, coverage: true, explain: true, accept: accepting(list), ...how });
  return { ...found, accepted: list.text() };
}

/** Judges a version again, if other findings are accepted by now. */
async function refresh(version) {
  if (version.accepted === accepted.text()) return;
  const found = await working("Looking for what is accepted", (how) => audited(version.files, version.options, how));
  if (found) Object.assign(version, found);
}

let lastFiles = null;

/** Opens files: a map, a mesh, or a certificate. */
async function open(files, layer) {
  const number = ++openNumber;
  const notes = files.filter(({ name }) => /accepted.*\.json$/i.test(name));
  const rest = files.filter((file) => !notes.includes(file));
  let list;
  try {
    list = (rest.length ? new AcceptedFindings() : accepted).with(notes);
  } catch (error) {
    return showError(error);
  }
  if (rest.length === 0) {
    const version = history.now;
    if (!version) return say("Open the map together with what is accepted in it.");
    const found = await working(`Reading ${notes[0].name}`, (how) => audited(version.files, version.options, how, list));
    if (!found || number !== openNumber) return;
    accepted = list;
    Object.assign(version, found);
    return show();
  }
  lastFiles = files;
  if (rest.some(({ name }) => name.split("/").at(-1) === "claim.txt")) return check(rest);
  const refused = refusal(rest);
  if (refused) {
    say("");
    const told = refused.map((part) => element(part.code ? "pre" : "p", { textContent: part.code ?? part.text }));
    return showMessage(...told, ...wayBack());
  }
  const options = layer ? { layer } : {};
  const found = await working(`Reading ${rest[0].name}`, (how) => audited(rest, options, how, list));
  if (!found || number !== openNumber) return;
  accepted = list;
  history.begin({ files: rest, options, ...found });
  closePanel();
  byId("format").value = isShapefile(rest) ? "shapefile" : "geojson";
  show();
}

const isShapefile = (files) => files.some(({ name }) => /\.(zip|shp)$/i.test(name));

/** Judges the version that is looked at again, with the names of its features from another column. */
async function nameFrom(column) {
  const version = history.now;
  const options = { ...version.options, nameFrom: column || undefined };
  const found = await working("Reading the names", (how) => audited(version.files, options, how));
  if (!found) return;
  Object.assign(version, found, { options });
  show();
}

/** Offers the columns that can name the features, if they have no names of their own. */
function offerNames({ options, report }) {
  const columns = report.import?.name_columns ?? (options.nameFrom ? [options.nameFrom] : []);
  const known = [...byId("name-from").options].map(({ value }) => value).slice(1);
  if (columns.some((column) => !known.includes(column)) || columns.length === 0) {
    byId("name-from").replaceChildren(...["", ...columns].map((value) => element("option", { value, textContent: value || "their numbers" })));
  }
  byId("name-from").value = options.nameFrom ?? "";
  byId("names").hidden = columns.length === 0;
}

async function check(files) {
  const entries = Object.fromEntries(files.map(({ name, bytes }) => [name, bytes]));
  const found = await working("Checking the certificate", (how) => twinedge.check(entries, how));
  if (!found) return;
  say("");
  showMessage(
    element("h2", { textContent: "Certificate" }),
    element("p", found.valid ? { className: "good", textContent: `Valid: ${found.claim}.` } : { className: "bad", textContent: "Not valid." }),
    element("ul", {}, ...found.failures.map((failure) => element("li", { textContent: failure }))),
    ...wayBack(),
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

/** The version that is looked at. */
const shown = () => (preview && byId("repair").elements.side.value === "after" ? preview : history.now);

/** The reasons for which findings of the report that is shown are accepted, by their ids. */
let reasons = new Map();

/** Shows the report of the version that is looked at. */
async function show() {
  const version = shown();
  await refresh(version);
  if (version !== shown()) return;
  const listed = version.report.coverage?.findings ?? [];
  reasons = new Map(listed.filter(({ accepted }) => accepted !== undefined).map(({ id, accepted }) => [id, accepted]));
  byId("welcome").hidden = byId("message").hidden = true;
  byId("panel").hidden = openPanel === null;
  const frame = byId("report");
  frame.hidden = false;
  chosen = null;
  frame.dataset.state = "loading";
  frame.onload = () => {
    watch(frame.contentDocument);
    frame.dataset.state = "shown";
  };
  frame.srcdoc = version.page;
  showTools();
  offerNames(version);
  summarise(version);
}

function summarise(version) {
  const { report, name = version.files[0].name } = version;
  const all = [report.violations, report.findings, report.coverage?.findings].flatMap((list) => list ?? []);
  const causes = all.filter((one) => one.follows_from === undefined);
  const left = causes.filter(({ id }) => !reasons.has(id)).length;
  const findings = causes.length === 0 ? "nothing was found" : `${causes.length} ${causes.length === 1 ? "finding" : "findings"}`;
  const beside = reasons.size ? `, ${reasons.size} accepted, ${left} left` : "";
  say(`${name}: ${findings}${beside}${preview && version === preview ? " (preview)" : ""}`);
}

/** The findings of the report that is shown. */
function findingsOf(page) {
  return JSON.parse(page.getElementById("data").textContent);
}

/** Notes which finding is chosen in the report. */
function watch(page) {
  const data = findingsOf(page);
  const stage = page.getElementById("stage");
  const note = () => {
    const number = Number(stage.dataset.finding || 0);
    chosen = number ? { number, finding: data.findings[number - 1], features: data.features } : null;
    describeChosen();
  };
  new MutationObserver(note).observe(stage, { attributes: true, attributeFilter: ["data-finding"] });
  // Keys and files reach the report while it has the focus or the pointer.
  page.addEventListener("keydown", undoKey);
  page.addEventListener("dragenter", beginDrop);
  for (const name of ["repair", "accept"]) page.addEventListener(`remedy-${name}`, () => openPanel === name || togglePanel(name));
  note();
  listAccepted();
}

/** Tells the report why a finding is accepted; null if it is not. */
function mark(id, reason) {
  const page = byId("report").contentDocument;
  const number = findingsOf(page).findings.findIndex((finding) => finding.id === id) + 1;
  if (number) page.dispatchEvent(new CustomEvent("accept", { detail: { number, reason } }));
  if (reason === null) reasons.delete(id);
  else reasons.set(id, reason);
  listAccepted();
  summarise(shown());
}

/** The finding as it can be accepted. Those of the structure cannot. */
const acceptable = (finding) => finding && shown().acceptAll.accepted.find(({ id }) => id === finding.id);

function describeChosen() {
  const { finding, features } = chosen ?? {};
  const who = finding?.features.map((number) => features[number][0] ?? features[number][1] ?? `feature ${number}`).join(", ");
  byId("chosen").textContent = finding
    ? `${finding.rule} ${finding.name}${who ? ` of ${who}` : ""}: ${finding.sentence ?? finding.message}${acceptable(finding) ? "" : " (Only findings of C1 to C7 can be accepted.)"}`
    : "Choose a finding in the list or on the map.";
  byId("accept").querySelector("[type=submit]").disabled = !acceptable(finding);
}

function listAccepted() {
  const items = accepted.all().map(({ id, rule, features, reason }) => {
    const remove = element("button", { type: "button", textContent: "Remove" });
    remove.setAttribute("aria-label", `Remove: ${rule} ${features.join(", ")}`);
    remove.addEventListener("click", () => {
      accepted.remove(id);
      mark(id, null);
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
  const own = isShapefile(files) ? "shapefile" : files[0].name.toLowerCase().endsWith(".fgb") ? "flatgeobuf" : "geojson";
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
  await show();
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
  const layer = await working("Writing the findings", (how) => twinedge.findings(files, { ...options, explain: true, accept: accepting(accepted), ...how }));
  if (!layer) return;
  const { warnings, ...collection } = layer;
  download(`${stemOf(history.now)}-findings.geojson`, JSON.stringify(collection));
}

async function saveReport() {
  await refresh(history.now);
  download(`${stemOf(history.now)}-report.html`, history.now.page, "text/html");
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

/** Covers the page, the report included, while files are dragged over it: the cover takes all that follows. */
function beginDrop(event) {
  event.preventDefault();
  byId("drop").hidden = false;
}

function addDrop() {
  const cover = byId("drop");
  addEventListener("dragenter", beginDrop);
  addEventListener("dragover", (event) => event.preventDefault());
  cover.addEventListener("dragleave", () => (cover.hidden = true));
  addEventListener("drop", async (event) => {
    event.preventDefault();
    cover.hidden = true;
    open(await dropped(event.dataTransfer));
  });
}

function undoKey(event) {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || event.target.matches?.("input")) return;
  event.preventDefault();
  byId(event.shiftKey ? "redo" : "undo").click();
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
    keep: async () => {
      history.add(preview);
      closePanel();
      await show();
      byId("undo").focus();
    },
    discard: () => {
      preview = null;
      byId("preview").hidden = true;
      show();
    },
    "save-map": saveMap,
    "save-findings": saveFindings,
    "save-report": saveReport,
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
    const finding = acceptable(chosen?.finding);
    const reason = field.value.trim();
    if (!finding || !reason) return;
    accepted.add(finding, reason);
    field.value = "";
    mark(finding.id, reason);
  });
  byId("name-from").addEventListener("change", ({ target }) => nameFrom(target.value));
  addEventListener("keydown", undoKey);
}

addDrop();
addButtons();
