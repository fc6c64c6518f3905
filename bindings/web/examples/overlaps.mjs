// Prints the overlaps and gaps of a TopoJSON file:
//
//     node overlaps.mjs counties.topojson counties

import { readFile } from "node:fs/promises";
import { audit, close } from "twinedge";

const [file, layer] = process.argv.slice(2);
const topology = JSON.parse(await readFile(file, "utf8"));
const { coverage } = await audit(topology, layer ? { layer } : {});
for (const { rule, kind, message, features, at } of coverage.findings) {
  console.log(rule, kind, features.map(({ name, id }) => name ?? id).join(", "), message, at);
}
await close();
