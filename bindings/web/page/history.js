// The versions of a map, from the file that was opened to what is looked at.

export class History {
  #versions = [];
  #at = -1;

  /** The version that is looked at. */
  get now() {
    return this.#versions[this.#at] ?? null;
  }

  get canUndo() {
    return this.#at > 0;
  }

  get canRedo() {
    return this.#at < this.#versions.length - 1;
  }

  clear() {
    [this.#versions, this.#at] = [[], -1];
  }

  begin(version) {
    [this.#versions, this.#at] = [[version], 0];
  }

  /** Adds a version. Those that were undone are gone. */
  add(version) {
    this.#versions.splice(this.#at + 1, Infinity, version);
    this.#at++;
  }

  undo() {
    if (!this.canUndo) return false;
    this.#at--;
    return true;
  }

  redo() {
    if (!this.canRedo) return false;
    this.#at++;
    return true;
  }
}
