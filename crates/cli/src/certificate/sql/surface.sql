
-- The tests of surfaces. A boundary component without face is a hole.

-- Each record is there once, and what is no link is not NULL.
CREATE TEMPORARY VIEW readable AS
SELECT half_edge AS record FROM half_edges GROUP BY half_edge HAVING count(*) > 1 OR half_edge IS NULL
UNION ALL SELECT half_edge FROM half_edges
WHERE half_edge_rank IS NULL OR turn IS NULL OR step IS NULL OR component IS NULL
UNION ALL SELECT vertex FROM vertices GROUP BY vertex HAVING count(*) > 1 OR vertex IS NULL
UNION ALL SELECT boundary FROM boundaries GROUP BY boundary HAVING count(*) > 1 OR boundary IS NULL
UNION ALL SELECT face FROM faces GROUP BY face HAVING count(*) > 1 OR face IS NULL;

CREATE TEMPORARY VIEW cycle_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
LEFT JOIN boundaries b ON b.boundary = h.boundary
WHERE n.boundary IS DISTINCT FROM h.boundary OR b.start_half_edge IS NULL;

-- What the certificate proves if no test fails: four times the genus, by Euler's formula, and counts.
CREATE TEMPORARY VIEW surface_sums AS
SELECT half_edges + 4 * roots - 2 * (rotations + cycles) AS four_genus, roots, holes FROM
    (SELECT count(*) AS half_edges FROM half_edges) h,
    (SELECT count(*) AS roots FROM half_edges WHERE component = half_edge) r,
    (SELECT count(*) AS rotations FROM vertices WHERE leaving IS NOT NULL) v,
    (SELECT count(*) AS cycles FROM boundaries WHERE start_half_edge IS NOT NULL) c,
    (SELECT count(*) AS holes FROM boundaries WHERE face IS NULL) o;

-- Unless the genus is 0, the next half-edge around the origin is the one that the origin keeps, or has a greater turn.
CREATE TEMPORARY VIEW turn_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN vertices v ON v.vertex = h.origin
LEFT JOIN half_edges t ON t.half_edge = h.twin
LEFT JOIN half_edges g ON g.half_edge = t.next_half_edge
WHERE (SELECT four_genus FROM surface_sums) >= 4
    AND NOT (coalesce(t.next_half_edge = v.leaving, FALSE) OR coalesce(h.turn < g.turn, FALSE));

-- Unless the genus is 0, the next half-edge on the cycle is the one with which it starts, or has a greater step.
CREATE TEMPORARY VIEW step_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN boundaries b ON b.boundary = h.boundary
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
WHERE (SELECT four_genus FROM surface_sums) >= 4
    AND NOT (coalesce(h.next_half_edge = b.start_half_edge, FALSE) OR coalesce(h.step < n.step, FALSE));

-- Neighbours have one component, and one of them a lower rank, but for the root.
CREATE TEMPORARY VIEW component_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
LEFT JOIN half_edges p ON p.half_edge = h.prev_half_edge
LEFT JOIN half_edges t ON t.half_edge = h.twin
WHERE n.component IS DISTINCT FROM h.component OR t.component IS DISTINCT FROM h.component
    OR NOT (coalesce(h.component = h.half_edge, FALSE)
        OR coalesce(n.half_edge_rank < h.half_edge_rank, FALSE)
        OR coalesce(p.half_edge_rank < h.half_edge_rank, FALSE)
        OR coalesce(t.half_edge_rank < h.half_edge_rank, FALSE));

-- A half-edge of a hole is the only one at its origin, and its twin bounds a face.
CREATE TEMPORARY VIEW border_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN boundaries b ON b.boundary = h.boundary
LEFT JOIN vertices v ON v.vertex = h.origin
LEFT JOIN half_edges t ON t.half_edge = h.twin
LEFT JOIN boundaries o ON o.boundary = t.boundary
WHERE b.face IS NULL AND (v.border IS DISTINCT FROM h.half_edge OR o.face IS NULL);

CREATE TEMPORARY VIEW surface_vertex_ok AS
SELECT v.vertex AS record FROM vertices v LEFT JOIN half_edges h ON h.half_edge = v.leaving
WHERE v.leaving IS NOT NULL AND h.origin IS DISTINCT FROM v.vertex;

CREATE TEMPORARY VIEW surface_boundary_ok AS
SELECT b.boundary AS record FROM boundaries b
LEFT JOIN half_edges h ON h.half_edge = b.start_half_edge
LEFT JOIN faces f ON f.face = b.face
WHERE h.boundary IS DISTINCT FROM b.boundary OR (b.face IS NOT NULL AND f.outer_boundary IS DISTINCT FROM b.boundary);

CREATE TEMPORARY VIEW surface_face_ok AS
SELECT f.face AS record FROM faces f LEFT JOIN boundaries b ON b.boundary = f.outer_boundary
WHERE b.face IS DISTINCT FROM f.face;

CREATE TEMPORARY VIEW genus_ok AS
SELECT four_genus AS record FROM surface_sums WHERE four_genus < 0 OR four_genus % 4 <> 0;

CREATE TEMPORARY VIEW surface_counts AS
SELECT CAST(four_genus / 4 AS BIGINT) AS genus, roots AS components, holes FROM surface_sums;

SELECT * FROM surface_counts;
