// The findings about a layer of polygons, as layers of a map by MapLibre GL:
//
//     const map = new maplibregl.Map({ … });
//     map.on("load", () => showFindings(map, "parcels.geojson", (lngLat, text) => new maplibregl.Popup().setLngLat(lngLat).setText(text).addTo(map)));

import { findings } from "twinedge";

const RED = "#c81e1e";
const only = (type) => ["==", ["geometry-type"], type];

/** The layers of the style: areas, such as overlaps and gaps; lines; places, such as crossings. */
export const LAYERS = [
  { id: "findings-areas", type: "fill", source: "findings", filter: only("Polygon"), paint: { "fill-color": RED, "fill-opacity": 0.4 } },
  { id: "findings-lines", type: "line", source: "findings", filter: ["!=", ["geometry-type"], "Point"], paint: { "line-color": RED, "line-width": 2 } },
  { id: "findings-places", type: "circle", source: "findings", filter: only("Point"), paint: { "circle-color": RED, "circle-radius": 6, "circle-opacity": 0.7 } },
];

/** The text of a popup about a finding. MapLibre hands over lists as text. */
export const textOf = ({ rule, name, features, message }) => `${rule} ${name} of ${JSON.parse(features).join(", ")}: ${message}`;

/** Puts the findings of a layer on the map, in place of others. `popup` is told where somebody clicked, and what is wrong there. */
export async function showFindings(map, url, popup) {
  const bytes = await (await fetch(url)).arrayBuffer();
  const data = await findings(bytes, { name: url });
  const source = map.getSource("findings");
  if (source) {
    source.setData(data);
    return data;
  }
  map.addSource("findings", { type: "geojson", data });
  for (const layer of LAYERS) {
    map.addLayer(layer);
    map.on("click", layer.id, ({ lngLat, features }) => popup(lngLat, textOf(features[0].properties)));
  }
  return data;
}
