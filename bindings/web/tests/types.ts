// The types say what the functions take and give.

import { acceptAll, audit, check, clean, convert, findings, type Geometry, type InputError, neighbours, validate, voronoi } from "../package/index.js";
import { loadStructure } from "../package/structure.js";
import { load } from "../package/sync.js";

export async function used(topology: { type: "Topology" }, bytes: Uint8Array, error: InputError): Promise<void> {
  const report = await audit(topology, { layer: "counties", gapWidth: 0.1, signal: AbortSignal.timeout(1000) });
  const accept = await acceptAll(topology, { reason: "a lake" });
  const accepted: string | undefined = (await audit(topology, { accept })).coverage?.findings[0]?.accepted;
  const overlaps: number | undefined = report.coverage?.overlaps;
  const { layer } = await clean(bytes, { overlap: "first" });
  const { file } = await clean(bytes, { to: "shapefile" });
  const name: string = file.name + layer.features.length + overlaps;
  const { losses } = await convert({ name, bytes }, { to: "wkt", lossy: true });
  const lines: string[] = losses;
  const { valid } = await validate({ origin: new Int32Array(2), next: [1, 0] }, "surface asking closed");
  const { failures } = await check({ "claim.txt": bytes });
  const { pairs } = await neighbours("POINT(0 0)", { geodesic: true });
  const cells = await voronoi([[0, 0]], { bounds: [0, 0, 1, 1] });
  const sync = await load();
  const now: boolean = sync.audit(bytes).valid;
  const place: number | undefined = error.place?.line;
  const first: Geometry | undefined = (await findings(topology, { winding: "d3" })).features[0]?.geometry;
  const several = await audit([{ type: "Feature" }, { type: "Feature" }], { coverage: true });
  const fileCount: number = (await audit(new File([], "a.geojson"))).violation_count;
  console.log(first, several.headline, several.coverage?.verdict, fileCount);
  console.log(accepted, lines, valid, failures, pairs[0]?.length, cells.features, now, place);
  const structure = await loadStructure(bytes);
  const next: number | null | undefined = structure.connect({ vertex: 1 }, { halfEdge: 2 }).table.half_edges[2]?.next;
  const broken: string[] = structure.set({ half_edge: 2 }, "next", "h3").violations.map(({ rule }) => rule);
  console.log(next, broken);
  // @ts-expect-error a corner is at a half-edge or at a vertex
  structure.connect({ face: 1 }, { vertex: 1 });
  // @ts-expect-error there is no such format
  await convert(bytes, { to: "geopackage" });
  // @ts-expect-error there is no such option
  await audit(bytes, { gapWith: 1 });
  // @ts-expect-error half-edges have a next one
  await validate({ origin: [0] });
}
