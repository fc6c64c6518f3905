/** A file with its name. */
export interface NamedFile {
  name: string;
  bytes: Uint8Array | ArrayBuffer | Blob;
}

/** An object of GeoJSON or TopoJSON: a `FeatureCollection`, a `Topology`. */
export interface JsonObject {
  type: string;
}

/**
 * A text, bytes, an object of GeoJSON or TopoJSON, features or geometries of GeoJSON, or a file, or the files of one Shapefile. Several maps are an error,
 * unless the option `layer` is the name of one of them. The functions without a worker take no `File` or `Blob`.
 */
export type Input = string | Uint8Array | ArrayBuffer | Blob | JsonObject | JsonObject[] | NamedFile | (NamedFile | File)[];

export type Position = [number, number];

/** How work is watched and cancelled. */
export interface Work {
  /** Is told which stage of the work begins. */
  progress?: (stage: string) => void;
  /** Cancels the work: the promise is rejected with its reason. */
  signal?: AbortSignal;
}

/** Options of everything that reads an input. */
export interface InputOptions extends Work {
  /** The name of the input, in messages; its extension tells the format, where the content does not. */
  name?: string;
  /** The layer of a file with several: the object of a TopoJSON, the file of a zip archive; the name of one of several files. */
  layer?: string;
}

export interface MapOptions extends InputOptions {
  /** Cut segments where they meet, and round all points to a grid: the finest one, or one with cells of this width at most. */
  snap?: "auto" | number;
  /** Take the names of features from this column. */
  nameFrom?: string;
  /** Accept a file without lines and polygons. */
  allowEmpty?: boolean;
  /** Lengths in metres along geodesics, and areas in square metres; of longitudes and latitudes only. */
  geodesic?: boolean;
}

/** Limits of coverages. */
export interface GapOptions {
  /** Greatest width of a gap that is reported or filled, and of a near miss. */
  gapWidth?: number;
  /** Gaps that are wider are lakes, and accepted. */
  lakeWidth?: number;
  /** The gaps around these points are accepted. */
  acceptGaps?: Position[];
  /** Area below which a thin part of a feature is a sliver. */
  sliver?: number;
}

/** The way in which rings of the result turn. */
export interface WindingOptions {
  /**
   * `"rfc7946"`, the default: outer rings turn counter-clockwise on the map. `"d3"`: clockwise, as the spherical projections of d3 want them, which fill
   * everything but the inside of other rings. `clean` without it keeps the way in which the rings of each feature turn.
   */
  winding?: "rfc7946" | "d3";
}

export interface AuditOptions extends MapOptions, GapOptions {
  /** Count what breaks C1 … C7 as violations. */
  coverage?: boolean;
  /** These findings break nothing, as long as they do not grow. All findings are listed then. */
  accept?: AcceptedFindings;
  /** Greatest number of findings to list of each kind. Default: 1000. */
  list?: number;
  /** Say the usual cause of each finding, and its remedy. */
  explain?: boolean;
  /** The shape of edges between longitudes and latitudes: straight on the map, the default, or arcs of great circles. */
  edges?: "straight" | "geodesic";
  /** Parts make up their parents exactly (X4): the column that names the parent of each part, `COLUMN` or `COLUMN=KEY`. */
  parentColumn?: string;
  /** Judge the arcs of TopoJSON as they are shared. */
  arcs?: boolean;
  /** The input is a topology of PostGIS, as `psql` writes it. */
  postgis?: boolean;
  /** What a mesh must be. */
  closed?: boolean;
  borders?: number;
  genus?: number;
  components?: number;
  triangles?: boolean;
  sides?: number;
  /** No edge is a loop, and no two edges have the same ends. */
  simple?: boolean;
  noUnusedVertices?: boolean;
  /** No face has all its corners on one line (M9). */
  noZeroArea?: boolean;
  /** Faces meet in common corners and edges only (M10). */
  noCrossings?: boolean;
  /** The faces of closed components face outwards, or inwards around a cavity (M11). */
  outward?: boolean;
}

/** Options of `acceptAll`. */
export interface AcceptOptions extends AuditOptions {
  /** The reason. Default: `accepted as it is`. */
  reason?: string;
}

/** Findings of C1 to C7 that are meant, as `twinedge audit --accept` reads and `--accept-all` writes them. */
export interface AcceptedFindings {
  schema: "twinedge-accepted/1";
  accepted: {
    id: string;
    reason?: string;
    date?: string;
    rule?: string;
    features?: string[];
    at?: Position;
    area?: number;
    length?: number;
    missing?: number;
    defects?: number;
  }[];
}

/** A feature in a finding. */
export interface FeatureName {
  number: number;
  id?: string | null;
  name?: string | null;
}

export interface Finding {
  id?: string;
  /** The reason for which it was accepted. */
  accepted?: string;
  rule: string;
  kind: string;
  message: string;
  /** The message in words about features, of borders that cross. */
  sentence?: string;
  /** The rule and the id of the finding from which it follows. A finding without it is a cause. */
  follows_from?: string;
  follows_from_id?: string;
  features?: FeatureName[];
  at?: Position | Position[] | null;
  area?: number;
  width?: number;
  length?: number;
  cause?: string;
  remedy?: string;
  [key: string]: unknown;
}

export interface Coverage {
  /** The verdict on C1 to C7 alone, whether they count as violations or not. */
  verdict: "valid" | "invalid" | "unknown";
  overlaps: number;
  gaps: number;
  near_misses: number;
  slivers: number;
  duplicates: number;
  ogc_invalid: number;
  mismatches: number;
  unit: string;
  not_checked?: string;
  gap_width?: number;
  sliver_area?: number;
  wider_gaps: number;
  accepted_gaps: number;
  findings: Finding[];
  [key: string]: unknown;
}

/** A report: `docs/report.md` of twinedge describes it. */
export interface Report {
  schema?: "twinedge-report/1";
  /** `unknown` if a rule could not be checked or a part was not read. `valid` is true for the first alone. */
  verdict: "valid" | "invalid" | "unknown";
  valid: boolean;
  /** The verdict in a sentence, of a map on the structure and on the coverage; not there for half-edges in columns. */
  headline?: string;
  /** The number of listed findings that follow from no other one, and of those that do; not there for half-edges in columns. */
  causes?: number;
  consequences?: number;
  /** The first rule that fails, with the id of its finding and its place. */
  first?: { rule: string | null; id: string; at: Position | null } | null;
  /** The bytes that were judged. */
  judged?: { sha256: string; bytes: number } | null;
  counts: Record<string, number | null>;
  rules: { id: string; checked: number; violations: number; unchecked: unknown }[];
  violation_count: number;
  violations: Finding[];
  finding_count?: number;
  findings?: Finding[];
  coverage?: Coverage;
  warnings?: string[];
  [key: string]: unknown;
}

/** A geometry of GeoJSON, as `@types/geojson` has it. */
export type Geometry =
  | { type: "Point"; coordinates: number[] }
  | { type: "MultiPoint" | "LineString"; coordinates: number[][] }
  | { type: "MultiLineString" | "Polygon"; coordinates: number[][][] }
  | { type: "MultiPolygon"; coordinates: number[][][][] }
  | { type: "GeometryCollection"; geometries: Geometry[] };

export interface Feature {
  type: "Feature";
  id?: string | number;
  /** Typed as never missing, as `GeoJSON.Feature` is; a finding without a place has `null`. */
  geometry: Geometry;
  properties: Record<string, any> | null;
}

export interface FeatureCollection {
  type: "FeatureCollection";
  features: Feature[];
}

export type Format = "geojson" | "geojsonl" | "wkt" | "wkb" | "shapefile" | "flatgeobuf";

export interface WriteOptions {
  /** Keep ids in this column, where the format cannot hold them. */
  idColumn?: string;
  /** Write even what the format cannot hold. */
  lossy?: boolean;
}

export interface CleanOptions extends InputOptions, GapOptions, WriteOptions, WindingOptions {
  /** The format of the result. Without one it is an object of GeoJSON. */
  to?: Format;
  snap?: "auto" | number;
  nameFrom?: string;
  /** The feature that gets what several claim. Default: the one inside. */
  overlap?: "inner" | "larger" | "smaller" | "first" | "last";
}

export interface CleanReport {
  clean: boolean;
  changes: { kind: "overlap" | "gap" | "sliver"; from: FeatureName[]; to: FeatureName | null; area: number; width: number; at: Position }[];
  changed: { number: number; id?: string; name?: string; area_before: number; area_after: number; reasons: string[] }[];
  left?: { findings: Finding[]; [key: string]: unknown };
  warnings: string[];
  [key: string]: unknown;
}

export interface ConvertOptions extends InputOptions, WriteOptions {
  to: Format;
}

/** A column of links: −1 is nil. */
export type Column = Int32Array | Uint32Array | ArrayLike<number | bigint | null>;

/** Half-edges in columns. One of `origin` and `target` is there; without `twin` the twin of `h` is `h ^ 1`. */
export interface Columns {
  origin?: Column;
  target?: Column;
  twin?: Column;
  next: Column;
  prev?: Column;
  face?: Column;
  leaving?: Column;
  outerHalfEdge?: Column;
  /** How many there are. Default: one more than the greatest index, or the length of the column. */
  vertices?: number;
  faces?: number;
}

export interface ValidateOptions extends Work {
  list?: number;
}

export interface Certificate {
  valid: boolean;
  /** What is certified, in words. */
  claim: string | null;
  /** The tests that fail, each with the first record that fails it. */
  failures: string[];
}

export interface Neighbours {
  input: string;
  unit: string;
  pairs: {
    number: number;
    id: string | null;
    name: string;
    other_number: number;
    other_id: string | null;
    other_name: string;
    length: number;
    shared: number;
    lines: number;
    overlap: number;
  }[];
}

export interface VoronoiOptions extends InputOptions, WindingOptions {
  /** The box that closes the cells: x0, y0, x1, y1. */
  bounds?: [number, number, number, number];
  /** Make the triangles instead. */
  delaunay?: boolean;
  /** Points that are too close to each other for doubles to tell their cells apart share a cell, whose property `merged` names them. Without it they are an error. */
  mergeClose?: boolean;
}

/** Where in an input an error is. */
export interface Place {
  input?: string;
  feature?: number;
  line?: number;
  column?: number | null;
  byte?: number;
  arc?: number;
  table?: string;
  row?: number;
  header?: true;
  layers?: string[];
}

/** Something that could not be done. */
export class TwinedgeError extends Error {
  readonly code: string;
  readonly place: Place | null;
}
/** The input cannot be read, or is not what was asked about. */
export class InputError extends TwinedgeError {}
/** An option or an argument is none that there is. */
export class OptionError extends TwinedgeError {}
/** The input is larger than the memory that a page has. */
export class TooLargeError extends TwinedgeError {}
/** An error of twinedge itself. */
export class InternalError extends TwinedgeError {}

/** The functions, done in a worker. */
export interface Functions {
  /** Judges a map, a mesh, a topology or tables. */
  audit(input: Input, options?: AuditOptions): Promise<Report>;
  /** The same as a page of HTML, which shows the map and what was found. */
  auditPage(input: Input, options?: AuditOptions): Promise<string>;
  /** Both, and the findings that are listed, as `acceptAll` has them. */
  auditWithPage(input: Input, options?: AcceptOptions): Promise<{ report: Report; page: string; acceptAll: AcceptedFindings }>;
  /** All findings of C1 to C7, as accepted ones. Those in `accept` keep their reason and date. */
  acceptAll(input: Input, options?: AcceptOptions): Promise<AcceptedFindings>;
  /** What was found as a layer of points, lines and polygons, with warnings about it. */
  findings(input: Input, options?: AuditOptions & WindingOptions): Promise<FeatureCollection & { warnings: string[] }>;
  /** Repairs a layer of polygons. */
  clean(input: Input, options: CleanOptions & { to: Format }): Promise<{ report: CleanReport; file: NamedFile }>;
  clean(input: Input, options?: CleanOptions): Promise<{ report: CleanReport; layer: FeatureCollection }>;
  /** A layer in another format; a Shapefile is zipped. */
  convert(input: Input, options: ConvertOptions): Promise<{ name: string; bytes: Uint8Array; losses: string[] }>;
  /** All pairs of features with a border or an overlap. */
  neighbours(input: Input, options?: MapOptions): Promise<Neighbours>;
  /** The cells of points, as polygons. */
  voronoi(points: Position[] | Input, options?: VoronoiOptions): Promise<FeatureCollection>;
  /** Judges half-edges in columns by a line such as `plane` or `surface asking closed genus 0`. */
  validate(columns: Columns, expectation?: string, options?: ValidateOptions): Promise<Report>;
  /** Checks the files of a certificate. */
  check(files: Record<string, Uint8Array | ArrayBuffer | string>, options?: Work): Promise<Certificate>;
}

export const audit: Functions["audit"];
export const auditPage: Functions["auditPage"];
export const auditWithPage: Functions["auditWithPage"];
export const acceptAll: Functions["acceptAll"];
export const findings: Functions["findings"];
export const clean: Functions["clean"];
export const convert: Functions["convert"];
export const neighbours: Functions["neighbours"];
export const voronoi: Functions["voronoi"];
export const validate: Functions["validate"];
export const check: Functions["check"];

/** Ends the worker that the functions share. The next call starts another one. */
export function close(): Promise<void>;

/** The functions over a worker of their own. `source` is the module: bytes, a URL or a response. */
export interface TwinedgeWorker extends Functions {
  close(): Promise<void>;
}
export const TwinedgeWorker: new (
  source?: WebAssembly.Module | Uint8Array | ArrayBuffer | Response | URL | string | Promise<Response>,
  spawn?: () => Worker,
) => TwinedgeWorker;
