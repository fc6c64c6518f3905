
-- The tests of a planar subdivision.

CREATE TEMPORARY VIEW cycle_starts AS
SELECT boundary, CASE WHEN vertex IS NULL THEN start_half_edge END AS start_half_edge FROM boundaries;

-- Each record is there once, and what is no link is not NULL.
CREATE TEMPORARY VIEW readable AS
SELECT half_edge AS record FROM half_edges GROUP BY half_edge HAVING count(*) > 1 OR half_edge IS NULL
UNION ALL SELECT half_edge FROM half_edges WHERE half_edge_rank IS NULL
UNION ALL SELECT vertex FROM vertices GROUP BY vertex HAVING count(*) > 1 OR vertex IS NULL
UNION ALL SELECT boundary FROM boundaries GROUP BY boundary HAVING count(*) > 1 OR boundary IS NULL
UNION ALL SELECT face FROM faces GROUP BY face HAVING count(*) > 1 OR face IS NULL
UNION ALL SELECT face FROM entries GROUP BY face, place HAVING count(*) > 1 OR face IS NULL OR place IS NULL;

CREATE TEMPORARY VIEW cycle_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
LEFT JOIN cycle_starts b ON b.boundary = h.boundary
WHERE n.boundary IS DISTINCT FROM h.boundary OR b.start_half_edge IS NULL;

-- A neighbour has a lower rank, or it is a root: the start of an inner boundary component of the unbounded face, or of a face
-- whose outer cycle starts with a lower rank.
CREATE TEMPORARY VIEW rank_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
LEFT JOIN half_edges p ON p.half_edge = h.prev_half_edge
LEFT JOIN half_edges t ON t.half_edge = h.twin
LEFT JOIN boundaries b ON b.boundary = h.boundary AND b.vertex IS NULL AND b.start_half_edge = h.half_edge
    AND b.place IS NOT NULL AND b.face IS NOT NULL
LEFT JOIN faces f ON f.face = b.face
LEFT JOIN cycle_starts o ON o.boundary = f.outer_boundary
LEFT JOIN half_edges s ON s.half_edge = o.start_half_edge
WHERE NOT (coalesce(n.half_edge_rank < h.half_edge_rank, FALSE)
    OR coalesce(p.half_edge_rank < h.half_edge_rank, FALSE)
    OR coalesce(t.half_edge_rank < h.half_edge_rank, FALSE)
    OR (b.boundary IS NOT NULL AND (f.outer_boundary IS NULL OR coalesce(s.half_edge_rank < h.half_edge_rank, FALSE))));

CREATE TEMPORARY VIEW vertex_ok AS
SELECT v.vertex AS record FROM vertices v
LEFT JOIN half_edges h ON h.half_edge = v.leaving
LEFT JOIN boundaries b ON b.boundary = v.isolated
WHERE CASE WHEN v.leaving IS NOT NULL THEN h.origin IS DISTINCT FROM v.vertex OR v.isolated IS NOT NULL
    ELSE b.vertex IS DISTINCT FROM v.vertex OR b.start_half_edge IS NOT NULL END;

CREATE TEMPORARY VIEW start_ok AS
SELECT b.boundary AS record FROM boundaries b
LEFT JOIN half_edges h ON h.half_edge = b.start_half_edge
LEFT JOIN vertices v ON v.vertex = b.vertex
WHERE CASE WHEN b.start_half_edge IS NOT NULL THEN h.boundary IS DISTINCT FROM b.boundary OR b.vertex IS NOT NULL
    ELSE v.vertex IS NULL OR v.leaving IS NOT NULL OR v.isolated IS DISTINCT FROM b.boundary OR b.place IS NULL END;

CREATE TEMPORARY VIEW place_ok AS
SELECT b.boundary AS record FROM boundaries b
LEFT JOIN faces f ON f.face = b.face
LEFT JOIN entries e ON e.face = f.face AND e.place = b.place
WHERE CASE WHEN b.place IS NULL THEN f.outer_boundary IS DISTINCT FROM b.boundary
    ELSE e.boundary IS DISTINCT FROM b.boundary END;

-- Lists have no gaps.
CREATE TEMPORARY VIEW face_ok AS
SELECT f.face AS record FROM faces f LEFT JOIN boundaries b ON b.boundary = f.outer_boundary
WHERE f.outer_boundary IS NOT NULL AND (b.face IS DISTINCT FROM f.face OR b.place IS NOT NULL)
UNION ALL
SELECT e.face FROM entries e
LEFT JOIN faces f ON f.face = e.face
LEFT JOIN boundaries b ON b.boundary = e.boundary
LEFT JOIN (SELECT face, count(*) AS listed FROM entries GROUP BY face) l ON l.face = e.face
WHERE f.face IS NULL OR b.face IS DISTINCT FROM e.face OR b.place IS DISTINCT FROM e.place
    OR e.place < 0 OR e.place >= l.listed;

CREATE TEMPORARY VIEW one_unbounded AS
SELECT unbounded AS record FROM (SELECT count(*) AS unbounded FROM faces WHERE outer_boundary IS NULL) u WHERE unbounded <> 1;

CREATE TEMPORARY VIEW euler_ok AS
SELECT half_edges AS record FROM
    (SELECT count(*) AS half_edges FROM half_edges) h,
    (SELECT count(*) AS rotations FROM vertices WHERE leaving IS NOT NULL) v,
    (SELECT count(*) AS cycles FROM cycle_starts WHERE start_half_edge IS NOT NULL) c,
    (SELECT count(*) AS roots FROM boundaries WHERE start_half_edge IS NOT NULL AND vertex IS NULL AND place IS NOT NULL) r
WHERE 2 * (rotations + cycles) <> half_edges + 4 * roots;
