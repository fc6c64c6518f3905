-- The maps that are audited, and `town`, which is corrupted.
SET client_min_messages = error;
CREATE EXTENSION postgis;
CREATE EXTENSION postgis_topology;
SET search_path = public, topology;

-- Two squares' worth of parcels with bends, a hole with an island, a dangling edge, a line by itself, isolated nodes, and two triangles
-- that share a node. Coordinates are binary fractions, so no line is moved.
SELECT CreateTopology('town');
SELECT TopoGeo_AddLineString('town', line::geometry) FROM (VALUES
  (1, 'LINESTRING(0 0,100 0,100 100,0 100,0 0)'),
  (2, 'LINESTRING(40 0,45 30,40 60)'),
  (3, 'LINESTRING(40 60,40 100)'),
  (4, 'LINESTRING(0 50,20 55,40 60)'),
  (5, 'LINESTRING(60 20,80 20,80 40,70 50,60 40,60 20)'),
  (6, 'LINESTRING(65 25,75 25,70 35,65 25)'),
  (7, 'LINESTRING(40 100,30 90,20 95)'),
  (8, 'LINESTRING(50 70,60 75,70 70)'),
  (9, 'LINESTRING(200 0,210 0,205 10,200 0)'),
  (10, 'LINESTRING(210 0,220 0,215 10,210 0)')
) lines(i, line) ORDER BY i;
SELECT TopoGeo_AddPoint('town', point::geometry) FROM (VALUES
  ('POINT(20 20)'), ('POINT(90 90)'), ('POINT(150 150)'), ('POINT(70 45)')) points(point);

-- Records of `town` by places, so that no id need be known.
CREATE SCHEMA at;
CREATE FUNCTION at.e(x float8, y float8) RETURNS int LANGUAGE sql STABLE AS
  'SELECT edge_id FROM town.edge_data WHERE ST_DWithin(geom, ST_Point(x, y), 0.01) ORDER BY 1 LIMIT 1';
CREATE FUNCTION at.n(x float8, y float8) RETURNS int LANGUAGE sql STABLE AS
  'SELECT node_id FROM town.node WHERE ST_DWithin(geom, ST_Point(x, y), 0.01) ORDER BY 1 LIMIT 1';
CREATE FUNCTION at.f(x float8, y float8) RETURNS int LANGUAGE sql STABLE AS
  'SELECT topology.GetFaceContainingPoint(''town'', ST_Point(x, y))';
-- The line of an edge with another point as its i-th (from 0).
CREATE FUNCTION at.bent(edge int, i int, x float8, y float8) RETURNS geometry LANGUAGE sql STABLE AS
  'SELECT ST_SetPoint(geom, i, ST_Point(x, y)) FROM town.edge_data WHERE edge_id = edge';

-- Nothing but face 0.
SELECT CreateTopology('nothing');
-- With a third dimension and a reference system; a name that must be quoted.
SELECT CreateTopology('Old Town', 4326, 0, true);
SELECT TopoGeo_AddLineString('Old Town', ST_GeomFromEWKT(line)) FROM (VALUES
  ('SRID=4326;LINESTRING Z(0 0 1,10 0 2,10 10 3,0 0 1)'), ('SRID=4326;LINESTRING Z(10 0 2,20 0 9,10 10 3)')) lines(line);
-- Coordinates that are no binary fractions. Points that are repeated within a line are legal, and counted.
SELECT CreateTopology('decimal');
SELECT TopoGeo_AddLineString('decimal', line::geometry) FROM (VALUES
  (1, 'LINESTRING(0.1 0.1,0.7 0.2,0.9 0.9,0.3 0.8,0.1 0.1)'), (2, 'LINESTRING(0.3 0.8,-0.4 0.9,-1.1 0.6,0.1 0.1)')
) lines(i, line) ORDER BY i;
UPDATE decimal.edge_data SET geom = ST_AddPoint(geom, ST_PointN(geom, 2), 1) WHERE ST_NPoints(geom) > 2;
-- Ids of 8 bytes that are far from 0, as PostGIS 3.6 has them.
SELECT CreateTopology('large_ids');
SELECT TopoGeo_AddLineString('large_ids', line::geometry) FROM (VALUES
  (1, 'LINESTRING(0 0,10 0,10 10,0 0)'), (2, 'LINESTRING(10 0,20 0,10 10)'), (3, 'LINESTRING(3 1,8 1,8 6,3 1)')) lines(i, line) ORDER BY i;
SELECT TopoGeo_AddPoint('large_ids', 'POINT(9 0.5)');
DROP VIEW large_ids.edge;
SET session_replication_role = replica;
ALTER TABLE large_ids.node ALTER node_id TYPE bigint, ALTER containing_face TYPE bigint;
ALTER TABLE large_ids.face ALTER face_id TYPE bigint;
ALTER TABLE large_ids.edge_data ALTER edge_id TYPE bigint, ALTER start_node TYPE bigint, ALTER end_node TYPE bigint,
  ALTER next_left_edge TYPE bigint, ALTER abs_next_left_edge TYPE bigint, ALTER next_right_edge TYPE bigint,
  ALTER abs_next_right_edge TYPE bigint, ALTER left_face TYPE bigint, ALTER right_face TYPE bigint;
UPDATE large_ids.node SET node_id = node_id * 10000000000, containing_face = containing_face * 30000000000;
UPDATE large_ids.face SET face_id = face_id * 30000000000;
UPDATE large_ids.edge_data SET edge_id = edge_id * 20000000000, start_node = start_node * 10000000000,
  end_node = end_node * 10000000000, next_left_edge = next_left_edge * 20000000000,
  abs_next_left_edge = abs_next_left_edge * 20000000000, next_right_edge = next_right_edge * 20000000000,
  abs_next_right_edge = abs_next_right_edge * 20000000000, left_face = left_face * 30000000000,
  right_face = right_face * 30000000000;
SET session_replication_role = origin;
