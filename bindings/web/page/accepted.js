// Findings that are meant: a lake, a disputed area. The list is that of `twinedge audit --accept`, which twinedge makes and judges.

const SCHEMA = "twinedge-accepted/1";

function parsed(bytes) {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return null;
  }
}

export class AcceptedFindings {
  #all = new Map();

  constructor(list = { accepted: [] }) {
    for (const one of list.accepted) this.#all.set(one.id, one);
  }

  /**
   * These and those of files; later ones take the place of earlier ones.
   * @throws {Error} if a file is no such list.
   */
  with(files) {
    const lists = files.map(({ name, bytes }) => {
      const list = parsed(bytes);
      if (list?.schema !== SCHEMA || !Array.isArray(list.accepted)) throw new Error(`${name}: no list of accepted findings`);
      return list;
    });
    return new AcceptedFindings({ accepted: [...this.all(), ...lists.flatMap(({ accepted }) => accepted)] });
  }

  /** Accepts a finding, as `acceptAll` has it. */
  add(finding, reason) {
    const date = new Date().toISOString().slice(0, 10);
    this.#all.set(finding.id, { ...finding, reason, date });
  }

  remove(id) {
    this.#all.delete(id);
  }

  all() {
    return [...this.#all.values()];
  }

  /** The list, as `audit` takes it. */
  list() {
    return { schema: SCHEMA, accepted: this.all() };
  }

  text() {
    return JSON.stringify(this.list(), null, 2) + "\n";
  }
}
