import type { load } from "./sync.js";

/** A link: the index of a record, or nil. */
export type Link = number | null;

/** A vertex, a half-edge, a boundary component or a face, by its index. */
export type StructureRecord = { vertex: number } | { half_edge: number } | { boundary: number } | { face: number };

/** A place at a vertex where an edge can be attached: to the left of a half-edge at its origin, or all around an isolated vertex. */
export type Corner = { halfEdge: number } | { vertex: number };

/** The tables. A row that is `null` is vacant. */
export interface Tables {
  vertices: ({ leaving: Link; isolated: Link } | null)[];
  half_edges: ({ origin: Link; twin: Link; next: Link; prev: Link; boundary: Link } | null)[];
  boundaries: ({ face: Link; start: { half_edge: number } | { vertex: number } | null; place: "outer" | { inner: number } | null } | null)[];
  faces: ({ outer: Link; inner: Link[] } | null)[];
}

export interface StructureState {
  /** The tables, with what was set by hand. */
  table: Tables;
  /** The tables without that. */
  sound: Tables;
  /** A key for each record. It tells a record from another one that has its index later. */
  keys: [string, StructureRecord][];
  /** The name of what can be undone. */
  undo: string | null;
  /** The name of what can be redone. */
  redo: string | null;
  /** The report on `table`, in the form `twinedge-report/1`. */
  report: Record<string, unknown> & { valid: boolean; counts: Record<string, number | null>; violation_count: number };
  rules: { id: string; name: string; statement: string; violations: number; unchecked: string | null }[];
  violations: { rule: string; kind: string; message: string; cause: string; remedy: string; records: StructureRecord[] }[];
}

/**
 * A doubly connected edge list with undoing and redoing, whose links can be set by hand to anything: for lectures and experiments.
 * Each method returns the state after it; an error is thrown and changes nothing.
 */
export class Structure {
  private constructor();
  readonly state: StructureState;
  addIsolatedVertex(face: number): StructureState;
  removeIsolatedVertex(vertex: number): StructureState;
  connect(from: Corner, to: Corner, split?: { newFace?: "left" | "right"; inner?: number[] }): StructureState;
  removeEdge(halfEdge: number): StructureState;
  splitEdge(halfEdge: number): StructureState;
  joinEdges(halfEdge: number): StructureState;
  splitVertex(from: Corner, to: Corner): StructureState;
  contractEdge(halfEdge: number): StructureState;
  flipEdge(halfEdge: number, turn?: "counter-clockwise" | "clockwise"): StructureState;
  moveInner(boundary: number, face: number): StructureState;
  set(record: StructureRecord, field: string, value: string): StructureState;
  undo(): StructureState;
  redo(): StructureState;
  forget(): StructureState;
  clear(): StructureState;
}

/** Loads the module `lecture.wasm`. */
export function loadStructure(source?: Parameters<typeof load>[0]): Promise<Structure>;
