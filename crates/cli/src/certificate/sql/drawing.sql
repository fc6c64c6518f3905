
-- The tests of a drawing. Darts 3 i, 3 i + 1 and 3 i + 2 are the sides of triangle i.

CREATE TEMPORARY VIEW darts AS
SELECT 3 * triangle + side AS dart,
    3 * triangle + CASE WHEN side = 2 THEN 0 ELSE side + 1 END AS next_dart,
    3 * triangle + CASE WHEN side = 0 THEN 2 ELSE side - 1 END AS prev_dart,
    triangle, side, twin, point, half_edge, ahead, face, dart_rank
FROM sides;

CREATE TEMPORARY VIEW drawing_readable AS
SELECT triangle AS record FROM sides GROUP BY triangle HAVING count(*) <> 3 OR triangle IS NULL
UNION ALL SELECT triangle FROM sides GROUP BY triangle, side HAVING count(*) > 1
UNION ALL SELECT triangle FROM sides
WHERE side IS NULL OR NOT side IN (0, 1, 2) OR ahead IS NULL OR face IS NULL OR dart_rank IS NULL
UNION ALL SELECT point FROM points GROUP BY point HAVING count(*) > 1 OR point IS NULL
-- Points are numbered from 0 on, with no gap.
UNION ALL SELECT point FROM points WHERE point < 0 OR point >= (SELECT count(*) FROM points)
UNION ALL SELECT point FROM points WHERE x IS NULL OR y IS NULL
    OR x < -9007199254740992 OR x > 9007199254740991 OR y < -9007199254740992 OR y > 9007199254740991
UNION ALL SELECT d.point FROM sides d LEFT JOIN points p ON p.point = d.point WHERE p.point IS NULL;

CREATE TEMPORARY VIEW dart_twin_ok AS
SELECT d.dart AS record FROM darts d LEFT JOIN darts t ON t.dart = d.twin
WHERE t.twin IS DISTINCT FROM d.dart;

CREATE TEMPORARY VIEW dart_point_ok AS
SELECT d.dart AS record FROM darts d
LEFT JOIN darts n ON n.dart = d.next_dart
LEFT JOIN darts t ON t.dart = d.twin
WHERE n.point IS DISTINCT FROM t.point;

CREATE TEMPORARY VIEW dart_half_edge_ok AS
SELECT d.dart AS record FROM darts d
LEFT JOIN darts t ON t.dart = d.twin
LEFT JOIN half_edges h ON h.half_edge = d.half_edge
WHERE CASE WHEN d.half_edge IS NOT NULL THEN h.dart IS DISTINCT FROM d.dart ELSE t.half_edge IS NOT NULL END;

-- The next dart counter-clockwise around the same point is the twin of the one before in the triangle.
CREATE TEMPORARY VIEW dart_ahead_ok AS
SELECT d.dart AS record FROM darts d
LEFT JOIN darts p ON p.dart = d.prev_dart
LEFT JOIN darts t ON t.dart = p.twin
WHERE d.ahead IS DISTINCT FROM coalesce(d.half_edge, t.ahead);

CREATE TEMPORARY VIEW dart_face_ok AS
SELECT d.dart AS record FROM darts d
LEFT JOIN darts n ON n.dart = d.next_dart
LEFT JOIN darts t ON t.dart = d.twin
LEFT JOIN half_edges h ON h.half_edge = d.half_edge
LEFT JOIN boundaries b ON b.boundary = h.boundary
WHERE n.face IS DISTINCT FROM d.face
    OR CASE WHEN d.half_edge IS NOT NULL THEN b.face IS DISTINCT FROM d.face ELSE t.face IS DISTINCT FROM d.face END;

CREATE TEMPORARY VIEW dart_rank_ok AS
SELECT d.dart AS record FROM darts d
LEFT JOIN darts n ON n.dart = d.next_dart
LEFT JOIN darts t ON t.dart = d.twin
LEFT JOIN faces f ON f.face = d.face
WHERE NOT (coalesce(n.dart_rank < d.dart_rank, FALSE)
    OR (d.half_edge IS NULL AND coalesce(t.dart_rank < d.dart_rank, FALSE))
    OR coalesce(f.dart = d.dart, FALSE));

-- Differences have at most 17 digits, so products and their difference fit into 38.
CREATE TEMPORARY VIEW turning AS
SELECT a.triangle,
    CAST(pa.x - pc.x AS DECIMAL(38, 0)) * CAST(pb.y - pc.y AS DECIMAL(38, 0)) AS plus,
    CAST(pb.x - pc.x AS DECIMAL(38, 0)) * CAST(pa.y - pc.y AS DECIMAL(38, 0)) AS minus
FROM darts a
LEFT JOIN darts b ON b.dart = a.next_dart
LEFT JOIN darts c ON c.dart = a.prev_dart
LEFT JOIN points pa ON pa.point = a.point
LEFT JOIN points pb ON pb.point = b.point
LEFT JOIN points pc ON pc.point = c.point
WHERE a.side = 0;

CREATE TEMPORARY VIEW triangle_ok AS
SELECT triangle AS record FROM turning
WHERE NOT coalesce(CASE WHEN triangle = 0 THEN plus < minus ELSE plus > minus END, FALSE);

CREATE TEMPORARY VIEW half_edge_dart_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN darts d ON d.dart = h.dart
LEFT JOIN half_edges t ON t.half_edge = h.twin
WHERE d.half_edge IS DISTINCT FROM h.half_edge OR d.point IS DISTINCT FROM h.origin
    OR t.dart IS NULL OR t.dart IS DISTINCT FROM d.twin;

CREATE TEMPORARY VIEW rotation_ok AS
SELECT h.half_edge AS record FROM half_edges h
LEFT JOIN half_edges p ON p.half_edge = h.prev_half_edge
LEFT JOIN darts d ON d.dart = h.dart
LEFT JOIN darts e ON e.dart = d.prev_dart
LEFT JOIN darts t ON t.dart = e.twin
WHERE p.twin IS NULL OR p.twin IS DISTINCT FROM t.ahead;

CREATE TEMPORARY VIEW vertex_dart_ok AS
SELECT v.vertex AS record FROM vertices v
LEFT JOIN darts d ON d.dart = v.dart
LEFT JOIN boundaries b ON b.boundary = v.isolated
WHERE d.point IS DISTINCT FROM v.vertex OR (v.isolated IS NOT NULL AND b.face IS DISTINCT FROM d.face);
