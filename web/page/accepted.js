// Findings that are meant: a lake, a disputed area. They are known again by rule, features and place.

/** Places that differ less than this, in parts of their size, are one. */
const DIGITS = 6;

const nameOf = (features, number) => features[number]?.[1] ?? features[number]?.[0] ?? `#${number}`;
const namesOf = (finding, features) => finding.features.map((number) => nameOf(features, number)).sort();
const keyOf = (rule, names, at) => JSON.stringify([rule, names, (at ?? []).map((x) => Number(x.toPrecision(DIGITS)))]);

export class AcceptedFindings {
  #all = new Map();
  /** How many findings of the report that is shown are accepted. */
  count = 0;

  clear() {
    this.#all.clear();
    this.count = 0;
  }

  add(finding, features, reason) {
    const names = namesOf(finding, features);
    const date = new Date().toISOString().slice(0, 10);
    this.#all.set(keyOf(finding.rule, names, finding.at), { rule: finding.rule, features: names, at: finding.at, reason, date });
  }

  remove(key) {
    this.#all.delete(key);
  }

  /** Why a finding is accepted; null if it is not. */
  reasonOf(finding, features) {
    return this.#all.get(keyOf(finding.rule, namesOf(finding, features), finding.at))?.reason ?? null;
  }

  all() {
    return [...this.#all];
  }

  text() {
    return JSON.stringify({ accepted: [...this.#all.values()] }, null, 2) + "\n";
  }

  /** Reads what `text` wrote. What has another form is passed over. */
  read(bytes) {
    const { accepted } = JSON.parse(new TextDecoder().decode(bytes));
    for (const one of Array.isArray(accepted) ? accepted : []) {
      const { rule, features, at, reason } = one;
      if (typeof rule === "string" && Array.isArray(features) && typeof reason === "string") this.#all.set(keyOf(rule, features, at), one);
    }
  }
}
