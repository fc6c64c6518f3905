// The faults of a mesh as red lines, for three.js:
//
//     const { report, lines } = await faultLines(mesh.geometry);
//     mesh.add(lines);

import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments } from "three";
import { audit } from "twinedge";

/** The triangles of a geometry as OFF. Vertices at the same place are one: three.js has copies, for normals and textures. */
function offOf(geometry) {
  const position = geometry.getAttribute("position");
  const numbers = new Map();
  const points = [];
  const vertex = (i) => {
    const point = [position.getX(i), position.getY(i), position.getZ(i)];
    const place = point.join(" ");
    if (!numbers.has(place)) {
      numbers.set(place, points.length);
      points.push(point);
    }
    return numbers.get(place);
  };
  const { index } = geometry;
  const corners = Array.from({ length: index?.count ?? position.count }, (_, i) => vertex(index ? index.getX(i) : i));
  const triangles = Array.from({ length: corners.length / 3 }, (_, i) => `3 ${corners.slice(3 * i, 3 * i + 3).join(" ")}`);
  return { points, text: `OFF\n${points.length} ${triangles.length} 0\n${points.map((point) => point.join(" ")).join("\n")}\n${triangles.join("\n")}\n` };
}

/** The report on a mesh, and lines along the edges at fault: with three triangles or more, or with one if the mesh has to be closed. */
export async function faultLines(geometry, options = { closed: true }) {
  const { points, text } = offOf(geometry);
  const report = await audit(text, { name: "mesh.off", explain: true, ...options });
  const edges = [...report.findings, ...report.violations.map(({ fields }) => fields)].map(({ vertices }) => vertices).filter((ends) => ends?.length === 2);
  const place = new BufferAttribute(new Float32Array(edges.flat().flatMap((v) => points[v])), 3);
  const material = new LineBasicMaterial({ color: 0xc81e1e, depthTest: false });
  return { report, lines: new LineSegments(new BufferGeometry().setAttribute("position", place), material) };
}
