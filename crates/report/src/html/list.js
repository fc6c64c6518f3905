// The list of findings, its filters, and the panel with the chosen one.

/** How many findings are added to the list at a time, and how many names the input of the filter suggests. */
const PAGE = 300;
const MOST_NAMES = 5000;

function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

function labelOf(features, number) {
  const [name, id] = features[number];
  if (name === null) return id === null ? "feature " + number : "id " + id;
  return id === null || id === name ? name : name + " (id " + id + ")";
}

class FindingList {
  /**
   * `onChoose` is called with the finding that is chosen, or null; `onFilter` with those that are left, and with the features and
   * the half-edge that the filter names.
   */
  constructor(data, structure, onChoose, onFilter) {
    Object.assign(this, { data, structure, onChoose, onFilter, chosen: null, rendered: 0 });
    this.list = document.getElementById("list");
    this.all = data.findings.map((finding, number) => Object.assign(finding, { number: number + 1 }));
    this.following = new Map();
    for (const { follows } of this.all) this.following.set(follows, (this.following.get(follows) ?? 0) + 1);
    this.left = this.all;
    this.rulesOff = new Set();
    this.makeFilters();
    this.list.addEventListener("click", (event) => {
      const option = event.target.closest("[role=option]");
      if (option) this.choose(this.left[Number(option.dataset.place)]);
    });
    this.list.addEventListener("keydown", (event) => this.key(event));
    document.getElementById("more").addEventListener("click", () => this.render());
    this.filter();
  }

  makeFilters() {
    const counts = new Map();
    for (const { rule, name } of this.all) counts.set(rule, { name, count: (counts.get(rule)?.count || 0) + 1 });
    const rules = document.getElementById("rules");
    for (const [rule, { name, count }] of counts) {
      const box = element("input", { type: "checkbox", checked: true, value: rule });
      box.addEventListener("change", () => {
        if (box.checked) this.rulesOff.delete(rule);
        else this.rulesOff.add(rule);
        this.filter();
      });
      const of = this.data.rules.find((one) => one.id === rule);
      rules.append(element("label", { title: of?.statement?.replaceAll("`", "") ?? "" }, box, ` ${rule} ${name} (${count})`));
    }
    rules.closest("fieldset").hidden = counts.size === 0;
    const following = this.all.length - (this.following.get(null) ?? 0);
    const follow = document.getElementById("follow");
    follow.hidden = following === 0;
    follow.querySelector("span").textContent = `Show the ${following.toLocaleString("en")} that follow from others`;
    document.getElementById("follow-on").addEventListener("change", () => this.filter());
    const input = document.getElementById("feature");
    const { features } = this.data;
    input.hidden = document.querySelector("label[for=feature]").hidden = this.structure.chains === 0;
    const names = new Set(features.slice(0, MOST_NAMES).map(([name, id]) => name ?? id ?? ""));
    document.getElementById("names").append(...[...names].map((value) => element("option", { value })));
    input.addEventListener("input", () => this.filter());
  }

  /** Leaves the findings of the rules that are checked, of features that match. */
  filter() {
    const { features, total } = this.data;
    const text = document.getElementById("feature").value.trim().toLowerCase();
    const matches = (number) => {
      const [name, id] = features[number];
      return (name ?? "").toLowerCase().includes(text) || id?.toLowerCase() === text || "#" + number === text;
    };
    const matching = new Set(text === "" ? [] : [...features.keys()].filter(matches));
    const half = text === "" ? -1 : halfEdgeCalled(this.structure, text);
    const isNamed = (one) =>
      one.features.some((number) => matching.has(number)) ||
      (half >= 0 && one.records.some((record) => isSameEdge(this.structure, half, halfEdgeCalled(this.structure, record))));
    // Whoever names a feature or an edge is told of all that is about it.
    const isUnfolded = document.getElementById("follow-on").checked || text !== "";
    const drawn = this.all.filter((one) => !this.rulesOff.has(one.rule) && (text === "" || isNamed(one)));
    this.left = drawn.filter((one) => one.follows === null || isUnfolded);
    const told = isUnfolded ? this.all.length : (this.following.get(null) ?? 0);
    const listed = this.all.length < total ? ` (${total.toLocaleString("en")} were found; --list N lists more)` : "";
    document.getElementById("shown").textContent =
      this.all.length === 0 ? "Nothing was found." : `${this.left.length} of ${told} findings shown${listed}`;
    this.list.replaceChildren();
    this.rendered = 0;
    this.render();
    if (this.chosen && !drawn.includes(this.chosen)) this.choose(null);
    this.mark();
    this.onFilter(drawn, matching, half);
  }

  /** Adds the next findings to the list, up to one of them. */
  render(upTo = this.rendered) {
    const end = Math.min(this.left.length, Math.ceil((upTo + 1) / PAGE) * PAGE);
    for (; this.rendered < end; this.rendered++) this.list.append(this.option(this.left[this.rendered], this.rendered));
    if (this.left.length === 0) {
      const why = this.all.length === 0 ? this.data.verdict : "No finding matches the filter.";
      this.list.replaceChildren(element("li", { className: "empty", role: "presentation", textContent: why }));
    }
    const more = document.getElementById("more");
    more.hidden = this.rendered >= this.left.length;
    more.textContent = `Show more (${(this.left.length - this.rendered).toLocaleString("en")})`;
  }

  option(finding, place) {
    const { rule, name, message, sentence, features, violation } = finding;
    const option = element(
      "li",
      { id: "finding-" + finding.number, className: violation ? "violation" : "finding" },
      element("span", { className: "rule", textContent: rule }),
      ` ${name}`,
    );
    option.setAttribute("role", "option");
    option.setAttribute("aria-selected", "false");
    option.dataset.place = place;
    if (features.length) {
      const names = features.slice(0, 4).map((number) => labelOf(this.data.features, number));
      const who = element("span", { className: "who" });
      names.forEach((text, i) => who.append(i ? ", " : "", element("bdi", { textContent: text })));
      if (features.length > 4) who.append(` and ${features.length - 4} more`);
      option.append(who);
    }
    option.append(element("span", { className: "what", textContent: sentence ?? message }));
    const following = this.following.get(finding.number - 1);
    if (following) option.append(element("span", { className: "follow", textContent: following === 1 ? "1 other follows from it." : `${following.toLocaleString("en")} others follow from it.` }));
    option.classList.toggle("follows", finding.follows !== null);
    if (finding.accepted) option.append(element("span", { className: "accepted", textContent: `Accepted: ${finding.accepted}` }));
    return option;
  }

  /** Chooses a finding; null for none. */
  choose(finding) {
    this.chosen = finding;
    if (finding && !this.left.includes(finding)) {
      document.getElementById("follow-on").checked = true;
      this.filter();
    }
    // The panel takes room from the list.
    this.describe();
    this.mark();
    this.onChoose(finding);
  }

  /** Notes why a finding is accepted; null if it is not. */
  accept(number, reason) {
    const finding = this.all[number - 1];
    if ((finding.accepted ?? null) === reason) return;
    finding.accepted = reason;
    const option = document.getElementById("finding-" + number);
    option?.replaceWith(this.option(finding, Number(option.dataset.place)));
    this.mark();
  }

  /** Chooses the finding so many places further on. */
  step(by) {
    if (this.left.length === 0) return;
    const at = this.left.indexOf(this.chosen);
    const to = at < 0 ? (by > 0 ? 0 : this.left.length - 1) : Math.min(Math.max(at + by, 0), this.left.length - 1);
    this.choose(this.left[to]);
  }

  mark() {
    for (const option of this.list.querySelectorAll("[aria-selected=true]")) option.setAttribute("aria-selected", "false");
    const place = this.left.indexOf(this.chosen);
    if (place < 0) {
      this.list.removeAttribute("aria-activedescendant");
      return;
    }
    if (place >= this.rendered) this.render(place);
    const option = this.list.children[place];
    option.setAttribute("aria-selected", "true");
    this.list.setAttribute("aria-activedescendant", option.id);
    option.scrollIntoView({ block: "nearest" });
  }

  key(event) {
    const far = this.left.length;
    const steps = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10, Home: -far, End: far };
    if (event.key in steps) this.step(steps[event.key]);
    else if (event.key === "Enter" && this.chosen) this.onChoose(this.chosen, true);
    else if (event.key === "Escape") this.choose(null);
    else return;
    event.preventDefault();
  }

  /** All that is known of the chosen finding. */
  describe() {
    const panel = document.getElementById("detail");
    panel.replaceChildren();
    if (!this.chosen) return;
    const { rule, name, message, sentence, features, records, at, violation, cause, remedy, number } = this.chosen;
    const facts = element("dl");
    const fact = (what, text) => {
      if (!text) return;
      facts.append(element("div", {}, element("dt", { textContent: what }), element("dd", {}, ...[text].flat())));
    };
    const named = features.flatMap((one, i) => [i ? ", " : "", element("bdi", { textContent: labelOf(this.data.features, one) })]);
    fact("Features", named.length ? named : null);
    for (const what of ["area", "width", "length"]) {
      const value = this.chosen[what];
      const unit = `${what === "area" ? "square " : ""}${this.data.unit}`;
      if (value !== null) fact(what === "length" ? "Borders" : what[0].toUpperCase() + what.slice(1), `${format(value)} ${unit}`);
    }
    fact("Records", records.join(", "));
    fact("Place", at ? `(${at[0]}, ${at[1]})` : "none: the record has no coordinates");
    fact("Cause", cause);
    const isSite = window.self !== window.top;
    fact("Remedy", isSite && remedy?.includes("twinedge clean") ? [remedyButton("repair", "Repair…"), " ", remedyButton("accept", "Accept…")] : remedy);
    const counted = violation ? "a violation" : "a finding that does not make the map invalid";
    const statement = this.data.rules.find((one) => one.id === rule)?.statement?.replaceAll("`", "");
    panel.append(element("h2", { textContent: `${rule} ${name}` }), element("p", { textContent: sentence ?? message }));
    if (sentence) panel.append(element("p", { textContent: `In the structure: ${message}.` }));
    if (this.chosen.follows !== null) {
      const source = this.all[this.chosen.follows];
      panel.append(element("p", { textContent: `It follows from number ${source.number}: ${source.rule} ${source.name}.` }));
    }
    if (statement) panel.append(element("p", { textContent: `Rule: ${statement}.` }));
    panel.append(facts, element("p", { textContent: `Number ${number} of ${this.all.length}: ${counted}.` }));
  }
}

/** A button for what the page around this one does. */
function remedyButton(name, textContent) {
  const button = element("button", { type: "button", textContent });
  button.addEventListener("click", () => document.dispatchEvent(new CustomEvent(`remedy-${name}`)));
  return button;
}

/** A measure with seven digits. */
function format(value) {
  return String(Number(value.toPrecision(7)));
}
