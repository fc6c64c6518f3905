// Draws a TopoJSON file with d3, and its faults in red; in a projection of d3, or flat:
//
//     node topojson-map.mjs counties.topojson counties geoAlbersUsa > counties.svg

import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import * as d3 from "d3-geo";
import { feature, mesh } from "topojson-client";
import { close, findings } from "twinedge";

const escaped = (text) => text.replace(/[&<>]/g, (sign) => `&#${sign.charCodeAt(0)};`);

const titleOf = ({ rule, name, features, message }) => `${rule} ${name} of ${features.join(", ")}: ${message}`;

/** The layer of a topology as SVG: its borders, and overlaps, gaps and crossings with their sentences. */
export async function picture(topology, name, projection = d3.geoIdentity().reflectY(true)) {
  const layer = topology.objects[name];
  // On the globe d3 fills what lies to the right of a ring.
  const { features } = await findings(topology, { layer: name, winding: "d3" });
  const path = d3.geoPath(projection.fitExtent([[10, 10], [950, 590]], feature(topology, layer)));
  const faults = features.map((one) => `<path d="${path(one)}" fill="red" fill-opacity=".5" stroke="red"><title>${escaped(titleOf(one.properties))}</title></path>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 600"><path d="${path(mesh(topology, layer))}" fill="none" stroke="black"/>${faults.join("")}</svg>`;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [file, name, projection] = process.argv.slice(2);
  console.log(await picture(JSON.parse(await readFile(file, "utf8")), name, projection && d3[projection]()));
  await close();
}
