// Draws a TopoJSON file with d3, and on it in red what is wrong:
//
//     node topojson-map.mjs counties.topojson counties > counties.svg

import { readFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";
import { geoIdentity, geoPath } from "d3-geo";
import { feature, mesh } from "topojson-client";
import { close, findings } from "twinedge";

const escaped = (text) => text.replace(/[&<>]/g, (sign) => `&#${sign.charCodeAt(0)};`);

const titleOf = ({ rule, name, features, message }) => `${rule} ${name} of ${features.join(", ")}: ${message}`;

/** The layer of a topology as SVG: its borders, and overlaps, gaps and crossings with their sentences. */
export async function picture(topology, name) {
  const layer = topology.objects[name];
  const { features } = await findings(topology, { layer: name });
  const path = geoPath(geoIdentity().reflectY(true).fitExtent([[10, 10], [950, 590]], feature(topology, layer)));
  const faults = features.map((one) => `<path d="${path(one)}" fill="red" fill-opacity=".5" stroke="red"><title>${escaped(titleOf(one.properties))}</title></path>`);
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 960 600"><path d="${path(mesh(topology, layer))}" fill="none" stroke="black"/>${faults.join("")}</svg>`;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [file, name] = process.argv.slice(2);
  console.log(await picture(JSON.parse(await readFile(file, "utf8")), name));
  await close();
}
