// A map with an overlap, a gap and a sliver.

const square = (name, ring) => ({ type: "Feature", id: name, properties: { name }, geometry: { type: "Polygon", coordinates: [[...ring, ring[0]]] } });

/** The files of the example. */
export function example() {
  const features = [
    square("Meadow", [[0, 0], [40, 0], [40, 30], [0, 30]]),
    square("Orchard", [[37, 0], [80, 0], [80, 30], [40, 30]]),
    square("Village", [[0, 31], [39, 31], [39, 60], [0, 60]]),
    square("Forest", [[39, 30], [80, 30], [80, 60], [39, 60]]),
    square("Pond", [[50, 40], [60, 38], [64, 46], [55, 50]]),
  ];
  const bytes = new TextEncoder().encode(JSON.stringify({ type: "FeatureCollection", features }));
  return [{ name: "example.geojson", bytes }];
}
