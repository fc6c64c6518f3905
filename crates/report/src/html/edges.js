// Finds edges by what a report calls them.

/** The half-edge with this name (`h26825`, `half-edge 26825`, `edge +17`); -1 if there is none. */
function halfEdgeCalled(s, text) {
  const name = text.trim().toLowerCase().replace(/^(half-)?edge\s+/, "h").replace(/^h(?=[+-])/, "");
  const { own, ids } = s.names;
  if (own) return own.half_edges.findIndex((one) => one.toLowerCase() === name || "h" + one.toLowerCase() === name);
  if (ids) {
    const edge = ids.edges.findIndex((one) => String(one) === name.replace(/^[h+-]/, ""));
    return edge < 0 ? -1 : 2 * edge;
  }
  const number = name.match(/^h(\d+)$/);
  return number ? Number(number[1]) : -1;
}

/** Whether two half-edges are sides of one edge. */
function isSameEdge(s, a, b) {
  if (a < 0 || b < 0) return false;
  return s.names.own ? a === b || s.names.own.twins[a] === b : a >> 1 === b >> 1;
}

/** The points of the edge of a half-edge; null if it is not on the map. */
function lineOf(s, half) {
  for (let c = 0; c < s.chains && half >= 0; c++) {
    for (let p = s.start[c]; p + 1 < s.start[c + 1]; p++) {
      if (!isSameEdge(s, s.half[p], half)) continue;
      let end = p + 1;
      while (end + 1 < s.start[c + 1] && s.half[end] === s.half[p] && s.vertex[end] < 0) end += 1;
      return Array.from({ length: end - p + 1 }, (_, i) => [s.x[p + i], s.y[p + i]]);
    }
  }
  return null;
}
