// A half-edge structure to try things on: operators, tables, links set by hand, and what the validator says.

import { Engine } from "./engine.js";
import { moduleOf } from "./sync.js";

/** Loads the module, from where this file is unless something else is given: bytes, a module, a URL or a response. */
export async function loadStructure(source = new URL("./lecture.wasm", import.meta.url)) {
  return new Structure(new Engine(await moduleOf(await source)));
}

/** A corner: `{ halfEdge }` or `{ vertex }`. */
const corner = ({ halfEdge, vertex }) => (halfEdge === undefined ? { vertex } : { half_edge: halfEdge });

/** A structure. Each method gives the state after it, or throws and changes nothing. */
export class Structure {
  #engine;

  constructor(engine) {
    this.#engine = engine;
    this.state = this.#ask({ op: "state" });
  }

  #ask(request) {
    return (this.state = this.#engine.call(request));
  }

  addIsolatedVertex(face) {
    return this.#ask({ op: "add_isolated_vertex", face });
  }

  removeIsolatedVertex(vertex) {
    return this.#ask({ op: "remove_isolated_vertex", vertex });
  }

  connect(from, to, { newFace = "left", inner = [] } = {}) {
    return this.#ask({ op: "connect", from: corner(from), to: corner(to), new_face: newFace === "right" ? "Right" : "Left", inner });
  }

  removeEdge(halfEdge) {
    return this.#ask({ op: "remove_edge", half_edge: halfEdge });
  }

  splitEdge(halfEdge) {
    return this.#ask({ op: "split_edge", half_edge: halfEdge });
  }

  joinEdges(halfEdge) {
    return this.#ask({ op: "join_edges", half_edge: halfEdge });
  }

  splitVertex(from, to) {
    return this.#ask({ op: "split_vertex", from: corner(from), to: corner(to) });
  }

  contractEdge(halfEdge) {
    return this.#ask({ op: "contract_edge", half_edge: halfEdge });
  }

  flipEdge(halfEdge, turn = "counter-clockwise") {
    return this.#ask({ op: "flip_edge", half_edge: halfEdge, turn: turn === "clockwise" ? "Clockwise" : "CounterClockwise" });
  }

  moveInner(boundary, face) {
    return this.#ask({ op: "move_inner", boundary, face });
  }

  /** Sets a field of a record by hand, to anything: `set({ half_edge: 3 }, "next", "h5")`; `-` is nil. */
  set(record, field, value) {
    return this.#ask({ op: "set", record, field, value });
  }

  undo() {
    return this.#ask({ op: "undo" });
  }

  redo() {
    return this.#ask({ op: "redo" });
  }

  /** Forgets what could be undone and redone by operators. */
  forget() {
    return this.#ask({ op: "forget" });
  }

  /** Begins anew, with one unbounded face and nothing in it. */
  clear() {
    return this.#ask({ op: "clear" });
  }
}
