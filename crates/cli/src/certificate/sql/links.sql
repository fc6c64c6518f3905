
-- Each view has the records that fail the test of its name, and must be empty. What a link does not lead to is NULL, as joins are outer
-- ones; NULL is equal to NULL alone.

CREATE TEMPORARY VIEW twin_ok AS
SELECT h.half_edge AS record FROM half_edges h LEFT JOIN half_edges t ON t.half_edge = h.twin
WHERE t.twin IS DISTINCT FROM h.half_edge OR h.twin IS NOT DISTINCT FROM h.half_edge;

CREATE TEMPORARY VIEW next_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
LEFT JOIN half_edges p ON p.half_edge = h.prev_half_edge
WHERE n.prev_half_edge IS DISTINCT FROM h.half_edge OR p.next_half_edge IS DISTINCT FROM h.half_edge;

CREATE TEMPORARY VIEW target_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges n ON n.half_edge = h.next_half_edge
LEFT JOIN half_edges t ON t.half_edge = h.twin
WHERE n.origin IS DISTINCT FROM t.origin;

CREATE TEMPORARY VIEW origin_ok AS
SELECT h.half_edge AS record FROM half_edges h LEFT JOIN vertices v ON v.vertex = h.origin
WHERE v.leaving IS NULL;
