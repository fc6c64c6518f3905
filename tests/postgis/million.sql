-- A grid of squares with about a million edges, written as PostGIS would write it.
SET client_min_messages = error;
SET search_path = public, topology;
SET session_replication_role = replica;
SELECT CreateTopology('million');
-- Nodes (x, y) for 0 <= x, y <= n; edges to the right have the numbers of their left nodes, edges up those behind them; squares are faces.
CREATE FUNCTION at.grid(n int) RETURNS void LANGUAGE plpgsql AS $$
BEGIN
  INSERT INTO million.node SELECT y * (n + 1) + x + 1, NULL, ST_Point(x, y)
    FROM generate_series(0, n) y, generate_series(0, n) x;
  INSERT INTO million.face SELECT y * n + x + 1, ST_MakeEnvelope(x, y, x + 1, y + 1)
    FROM generate_series(0, n - 1) y, generate_series(0, n - 1) x;
  -- Half-edges turn left where they can, which is what keeps a square to their left; outside they keep to the border.
  INSERT INTO million.edge_data
    SELECT right_id, node, node + 1,
      left_next, abs(left_next), right_next, abs(right_next),
      CASE WHEN y < n THEN y * n + x + 1 ELSE 0 END, CASE WHEN y > 0 THEN (y - 1) * n + x + 1 ELSE 0 END,
      ST_MakeLine(ST_Point(x, y), ST_Point(x + 1, y))
    FROM (SELECT x, y, y * n + x + 1 AS right_id, y * (n + 1) + x + 1 AS node,
        -- Edge up at (x, y): n * (n + 1) + y * (n + 1) + x + 1.
        CASE WHEN y < n THEN n * (n + 1) + y * (n + 1) + x + 2
             WHEN x + 1 < n THEN y * n + x + 2 ELSE -(n * (n + 1) + (y - 1) * (n + 1) + x + 2) END AS left_next,
        CASE WHEN y > 0 THEN -(n * (n + 1) + (y - 1) * (n + 1) + x + 1)
             WHEN x > 0 THEN -(y * n + x) ELSE n * (n + 1) + 1 END AS right_next
      FROM generate_series(0, n) y, generate_series(0, n - 1) x) edges;
  INSERT INTO million.edge_data
    SELECT up_id, node, node + n + 1,
      left_next, abs(left_next), right_next, abs(right_next),
      CASE WHEN x > 0 THEN y * n + x ELSE 0 END, CASE WHEN x < n THEN y * n + x + 1 ELSE 0 END,
      ST_MakeLine(ST_Point(x, y), ST_Point(x, y + 1))
    FROM (SELECT x, y, n * (n + 1) + y * (n + 1) + x + 1 AS up_id, y * (n + 1) + x + 1 AS node,
        CASE WHEN x > 0 THEN -((y + 1) * n + x)
             WHEN y + 1 < n THEN n * (n + 1) + (y + 1) * (n + 1) + x + 1 ELSE n * n + 1 END AS left_next,
        CASE WHEN x < n THEN y * n + x + 1
             WHEN y > 0 THEN -(n * (n + 1) + (y - 1) * (n + 1) + x + 1) ELSE -n END AS right_next
      FROM generate_series(0, n - 1) y, generate_series(0, n) x) edges;
END $$;
DROP INDEX million.edge_gist, million.edge_end_node_idx, million.edge_start_node_idx, million.edge_left_face_idx,
  million.edge_right_face_idx, million.edge_data_abs_next_left_edge_idx, million.edge_data_abs_next_right_edge_idx,
  million.face_gist, million.node_gist;
SELECT at.grid(707);
SELECT count(*) || ' edges' FROM million.edge_data;
