-- Kinds of corruption: each is made in a transaction of its own, with foreign keys switched off, and rolled back.
--: next_left_edge of an edge elsewhere
UPDATE town.edge_data SET next_left_edge = at.e(205,10), abs_next_left_edge = at.e(205,10) WHERE edge_id = at.e(40,80);
--: next_right_edge of an edge elsewhere
UPDATE town.edge_data SET next_right_edge = -at.e(205,10), abs_next_right_edge = at.e(205,10) WHERE edge_id = at.e(40,80);
--: next_left_edge with the other sign
UPDATE town.edge_data SET next_left_edge = -next_left_edge WHERE edge_id = at.e(40,80);
--: next_right_edge with the other sign
UPDATE town.edge_data SET next_right_edge = -next_right_edge WHERE edge_id = at.e(45,30);
--: next_left_edge is the edge itself
UPDATE town.edge_data SET next_left_edge = edge_id, abs_next_left_edge = edge_id WHERE edge_id = at.e(20,55);
--: next_left_edge turns back
UPDATE town.edge_data SET next_left_edge = -edge_id, abs_next_left_edge = edge_id WHERE edge_id = at.e(20,55);
--: next_left_edge names no edge
UPDATE town.edge_data SET next_left_edge = 999, abs_next_left_edge = 999 WHERE edge_id = at.e(20,55);
--: next_right_edge names no edge
UPDATE town.edge_data SET next_right_edge = -999, abs_next_right_edge = 999 WHERE edge_id = at.e(20,55);
--: next_left_edge is 0
UPDATE town.edge_data SET next_left_edge = 0, abs_next_left_edge = 0 WHERE edge_id = at.e(20,55);
--: next_left_edge is null
ALTER TABLE town.edge_data ALTER next_left_edge DROP NOT NULL, ALTER abs_next_left_edge DROP NOT NULL;
UPDATE town.edge_data SET next_left_edge = NULL, abs_next_left_edge = NULL WHERE edge_id = at.e(20,55);
--: next_left_edge and next_right_edge exchanged
UPDATE town.edge_data SET next_left_edge = next_right_edge, abs_next_left_edge = abs_next_right_edge,
  next_right_edge = next_left_edge, abs_next_right_edge = abs_next_left_edge WHERE edge_id = at.e(45,30);
--: next edges of two edges at a node exchanged, so that the rotation falls apart
WITH arriving AS (SELECT edge_id AS e, next_left_edge AS next, true AS is_left FROM town.edge_data WHERE end_node = at.n(40,100)
    UNION ALL SELECT edge_id, next_right_edge, false FROM town.edge_data WHERE start_node = at.n(40,100)),
  numbered AS (SELECT *, row_number() OVER (ORDER BY e, is_left) AS i FROM arriving),
  exchanged AS (SELECT a.e, a.is_left, b.next FROM numbered a JOIN numbered b ON (a.i, b.i) IN ((1, 2), (2, 1)))
UPDATE town.edge_data SET
  next_left_edge = coalesce((SELECT next FROM exchanged WHERE e = edge_id AND is_left), next_left_edge),
  next_right_edge = coalesce((SELECT next FROM exchanged WHERE e = edge_id AND NOT is_left), next_right_edge);
UPDATE town.edge_data SET abs_next_left_edge = abs(next_left_edge), abs_next_right_edge = abs(next_right_edge);
--: abs_next_left_edge is another edge
UPDATE town.edge_data SET abs_next_left_edge = at.e(205,10) WHERE edge_id = at.e(40,80);
--: abs_next_right_edge is another edge
UPDATE town.edge_data SET abs_next_right_edge = at.e(205,10) WHERE edge_id = at.e(40,80);
--: abs_next_left_edge is null
ALTER TABLE town.edge_data ALTER abs_next_left_edge DROP NOT NULL;
UPDATE town.edge_data SET abs_next_left_edge = NULL WHERE edge_id = at.e(40,80);
--: start_node is another node
UPDATE town.edge_data SET start_node = at.n(200,0) WHERE edge_id = at.e(40,80);
--: end_node is another node
UPDATE town.edge_data SET end_node = at.n(200,0) WHERE edge_id = at.e(40,80);
--: start_node and end_node exchanged
UPDATE town.edge_data SET start_node = end_node, end_node = start_node WHERE edge_id = at.e(40,80);
--: start_node names no node
UPDATE town.edge_data SET start_node = 999 WHERE edge_id = at.e(40,80);
--: start_node is null
ALTER TABLE town.edge_data ALTER start_node DROP NOT NULL;
UPDATE town.edge_data SET start_node = NULL WHERE edge_id = at.e(40,80);
--: node with edges deleted
DELETE FROM town.node WHERE node_id = at.n(40,60);
--: all nodes deleted
DELETE FROM town.node;
--: node with edges moved
UPDATE town.node SET geom = 'POINT(41 61)' WHERE node_id = at.n(40,60);
--: node with edges without point
UPDATE town.node SET geom = NULL WHERE node_id = at.n(40,60);
--: isolated node without point
UPDATE town.node SET geom = NULL WHERE node_id = at.n(20,20);
--: node with an empty point
UPDATE town.node SET geom = 'POINT EMPTY' WHERE node_id = at.n(20,20);
--: isolated node at infinity
UPDATE town.node SET geom = ST_Point('Infinity', 3) WHERE node_id = at.n(20,20);
--: node id twice
ALTER TABLE town.edge_data DROP CONSTRAINT start_node_exists, DROP CONSTRAINT end_node_exists;
ALTER TABLE town.node DROP CONSTRAINT node_primary_key;
INSERT INTO town.node SELECT node_id, 0, 'POINT(170 170)' FROM town.node WHERE node_id = at.n(40,60);
--: edge id twice
ALTER TABLE town.edge_data DROP CONSTRAINT next_left_edge_exists, DROP CONSTRAINT next_right_edge_exists;
ALTER TABLE town.edge_data DROP CONSTRAINT edge_data_pkey;
INSERT INTO town.edge_data SELECT * FROM town.edge_data WHERE edge_id = at.e(40,80);
--: edge id is negative
UPDATE town.edge_data SET edge_id = -edge_id WHERE edge_id = at.e(40,80);
--: edge deleted
DELETE FROM town.edge_data WHERE edge_id = at.e(40,80);
--: dangling edge deleted, its node left behind and nothing else changed
DELETE FROM town.edge_data WHERE edge_id = at.e(30,90);
--: all edges deleted
DELETE FROM town.edge_data;
--: edge copied
INSERT INTO town.edge_data SELECT 500, start_node, end_node, next_left_edge, abs_next_left_edge, next_right_edge, abs_next_right_edge,
  left_face, right_face, geom FROM town.edge_data WHERE edge_id = at.e(40,80);
--: left_face is another face
UPDATE town.edge_data SET left_face = at.f(205,3) WHERE edge_id = at.e(45,30);
--: right_face is another face
UPDATE town.edge_data SET right_face = at.f(205,3) WHERE edge_id = at.e(45,30);
--: left_face is face 0
UPDATE town.edge_data SET left_face = 0 WHERE edge_id = at.e(45,30);
--: left_face names no face
UPDATE town.edge_data SET left_face = 999 WHERE edge_id = at.e(45,30);
--: left_face is null
ALTER TABLE town.edge_data ALTER left_face DROP NOT NULL;
UPDATE town.edge_data SET left_face = NULL WHERE edge_id = at.e(45,30);
--: left_face and right_face exchanged
UPDATE town.edge_data SET left_face = right_face, right_face = left_face WHERE edge_id = at.e(45,30);
--: faces of a ring exchanged
UPDATE town.edge_data SET left_face = right_face, right_face = left_face WHERE edge_id = at.e(75,25);
--: two faces with exchanged ids
WITH f AS (SELECT at.f(20,10) AS a, at.f(20,80) AS b)
UPDATE town.edge_data SET
  left_face = CASE left_face WHEN f.a THEN f.b WHEN f.b THEN f.a ELSE left_face END,
  right_face = CASE right_face WHEN f.a THEN f.b WHEN f.b THEN f.a ELSE right_face END FROM f;
--: two faces with one id
WITH f AS (SELECT at.f(20,10) AS a, at.f(205,3) AS b)
UPDATE town.edge_data SET left_face = CASE left_face WHEN f.b THEN f.a ELSE left_face END,
  right_face = CASE right_face WHEN f.b THEN f.a ELSE right_face END FROM f;
--: hole assigned to the face next door
UPDATE town.edge_data SET
  left_face = CASE left_face WHEN at.f(60,5) THEN at.f(20,80) ELSE left_face END,
  right_face = CASE right_face WHEN at.f(60,5) THEN at.f(20,80) ELSE right_face END WHERE edge_id = at.e(80,30);
--: component assigned to the face inside itself
UPDATE town.edge_data SET
  left_face = CASE left_face WHEN 0 THEN at.f(205,3) ELSE left_face END,
  right_face = CASE right_face WHEN 0 THEN at.f(205,3) ELSE right_face END WHERE edge_id IN (at.e(205,10), at.e(215,10));
--: face with edges deleted
DELETE FROM town.face WHERE face_id = at.f(205,3);
--: face 0 deleted
DELETE FROM town.face WHERE face_id = 0;
--: all faces but face 0 deleted
DELETE FROM town.face WHERE face_id > 0;
--: face without edges
INSERT INTO town.face VALUES (500, ST_MakeEnvelope(300, 300, 310, 310));
--: face without edges, in the box of others
INSERT INTO town.face VALUES (500, ST_MakeEnvelope(1, 1, 2, 2));
--: mbr is null
UPDATE town.face SET mbr = NULL WHERE face_id = at.f(205,3);
--: mbr of all faces is null
UPDATE town.face SET mbr = NULL;
--: mbr is too large
UPDATE town.face SET mbr = ST_Envelope(ST_Expand(mbr, 1)) WHERE face_id = at.f(205,3);
--: mbr is too small
UPDATE town.face SET mbr = ST_MakeEnvelope(201, 0, 210, 10) WHERE face_id = at.f(205,3);
--: mbr is that of another face
UPDATE town.face SET mbr = ST_MakeEnvelope(210, 0, 220, 10) WHERE face_id = at.f(205,3);
--: mbr is a triangle
UPDATE town.face SET mbr = 'POLYGON((200 0,210 0,205 10,200 0))' WHERE face_id = at.f(205,3);
--: mbr is empty
UPDATE town.face SET mbr = 'POLYGON EMPTY' WHERE face_id = at.f(205,3);
--: mbr of face 0
UPDATE town.face SET mbr = ST_MakeEnvelope(0, 0, 220, 100) WHERE face_id = 0;
--: isolated node in no face
UPDATE town.node SET containing_face = NULL WHERE node_id = at.n(20,20);
--: isolated node in another face
UPDATE town.node SET containing_face = at.f(205,3) WHERE node_id = at.n(20,20);
--: isolated node in face 0 instead of its own
UPDATE town.node SET containing_face = 0 WHERE node_id = at.n(70,45);
--: containing_face names no face
UPDATE town.node SET containing_face = 999 WHERE node_id = at.n(20,20);
--: node with edges has a containing_face
UPDATE town.node SET containing_face = at.f(20,10) WHERE node_id = at.n(40,60);
--: isolated node moved to another face
UPDATE town.node SET geom = 'POINT(60 5)' WHERE node_id = at.n(20,20);
--: isolated node on an edge
UPDATE town.node SET geom = 'POINT(40 80)' WHERE node_id = at.n(20,20);
--: isolated node at a bend
UPDATE town.node SET geom = 'POINT(45 30)' WHERE node_id = at.n(20,20);
--: isolated node at another node
UPDATE town.node SET geom = 'POINT(40 60)' WHERE node_id = at.n(20,20);
--: two isolated nodes at one place
INSERT INTO town.node VALUES (500, at.f(20,20), 'POINT(20 20)');
--: edge without line
ALTER TABLE town.edge_data ALTER geom DROP NOT NULL;
UPDATE town.edge_data SET geom = NULL WHERE edge_id = at.e(45,30);
--: dangling edge without line
ALTER TABLE town.edge_data ALTER geom DROP NOT NULL;
UPDATE town.edge_data SET geom = NULL WHERE edge_id = at.e(30,90);
--: edge with an empty line
UPDATE town.edge_data SET geom = 'LINESTRING EMPTY' WHERE edge_id = at.e(45,30);
--: edge with a multi-line
DROP VIEW town.edge CASCADE;
ALTER TABLE town.edge_data ALTER geom TYPE geometry;
UPDATE town.edge_data SET geom = ST_Multi(geom) WHERE edge_id = at.e(45,30);
CREATE VIEW town.edge AS SELECT edge_id, start_node, end_node, next_left_edge, next_right_edge, left_face, right_face, geom FROM town.edge_data;
--: line drawn backwards
UPDATE town.edge_data SET geom = ST_Reverse(geom) WHERE edge_id = at.e(45,30);
--: ring drawn backwards
UPDATE town.edge_data SET geom = ST_Reverse(geom) WHERE edge_id = at.e(75,25);
--: line starts elsewhere
UPDATE town.edge_data SET geom = at.bent(edge_id, 0, 41, 1) WHERE edge_id = at.e(45,30);
--: line ends elsewhere
UPDATE town.edge_data SET geom = at.bent(edge_id, 2, 41, 59) WHERE edge_id = at.e(45,30);
--: bend at infinity
UPDATE town.edge_data SET geom = at.bent(edge_id, 1, 'Infinity', 30) WHERE edge_id = at.e(45,30);
--: bend that is no number
UPDATE town.edge_data SET geom = at.bent(edge_id, 1, 'NaN', 'NaN') WHERE edge_id = at.e(45,30);
--: bend moved across another edge
UPDATE town.edge_data SET geom = at.bent(edge_id, 1, 70, 30) WHERE edge_id = at.e(45,30);
--: bend moved onto another edge
UPDATE town.edge_data SET geom = at.bent(edge_id, 1, 60, 30) WHERE edge_id = at.e(45,30);
--: bend moved onto a node
UPDATE town.edge_data SET geom = at.bent(edge_id, 1, 60, 20) WHERE edge_id = at.e(45,30);
--: bend moved onto a bend
UPDATE town.edge_data SET geom = at.bent(edge_id, 1, 60, 40) WHERE edge_id = at.e(45,30);
--: line crosses itself
UPDATE town.edge_data SET geom = 'LINESTRING(60 20,80 20,62 45,70 50,80 40,60 20)' WHERE edge_id = at.e(80,30);
--: line turns back along itself
UPDATE town.edge_data SET geom = 'LINESTRING(40 60,40 90,40 80,40 100)' WHERE edge_id = at.e(40,80);
--: ring that encloses nothing
UPDATE town.edge_data SET geom = 'LINESTRING(65 25,75 25,65 25)' WHERE edge_id = at.e(75,25);
--: ring that is a point
UPDATE town.edge_data SET geom = 'LINESTRING(65 25,65 25,65 25)' WHERE edge_id = at.e(75,25);
--: bends dropped, so that edges cross
UPDATE town.edge_data SET geom = 'LINESTRING(60 20,80 20,80 40,60 40,60 20)' WHERE edge_id = at.e(80,30);
UPDATE town.edge_data SET geom = 'LINESTRING(65 25,75 25,70 45,65 25)' WHERE edge_id = at.e(75,25);
--: line drawn along another edge
UPDATE town.edge_data SET geom = 'LINESTRING(40 100,40 80,20 95)' WHERE edge_id = at.e(30,90);
--: dangling edge drawn on the other side of an edge
UPDATE town.edge_data SET geom = 'LINESTRING(40 100,60 90,70 95)' WHERE edge_id = at.e(30,90);
UPDATE town.node SET geom = 'POINT(70 95)' WHERE node_id = at.n(20,95);
--: line by itself moved to another face
UPDATE town.edge_data SET geom = 'LINESTRING(10 70,15 75,20 70)' WHERE edge_id = at.e(60,75);
UPDATE town.node SET geom = 'POINT(10 70)' WHERE node_id = at.n(50,70);
UPDATE town.node SET geom = 'POINT(20 70)' WHERE node_id = at.n(70,70);
--: hole moved out of its face, with its island, node and mbr
UPDATE town.edge_data SET geom = ST_Translate(geom, 200, 200) WHERE edge_id IN (at.e(80,30), at.e(75,25));
UPDATE town.node SET geom = ST_Translate(geom, 200, 200) WHERE node_id IN (at.n(60,20), at.n(65,25), at.n(70,45));
UPDATE town.face SET mbr = ST_Translate(mbr, 200, 200) WHERE face_id IN (at.f(62,38), at.f(70,28));
--: island moved out of its hole
UPDATE town.edge_data SET geom = ST_Translate(geom, -60, -20) WHERE edge_id = at.e(75,25);
UPDATE town.node SET geom = ST_Translate(geom, -60, -20) WHERE node_id = at.n(65,25);
UPDATE town.face SET mbr = ST_Translate(mbr, -60, -20) WHERE face_id = at.f(70,28);
--: map drawn in a mirror
UPDATE town.edge_data SET geom = ST_Scale(geom, -1, 1);
UPDATE town.node SET geom = ST_Scale(geom, -1, 1);
UPDATE town.face SET mbr = ST_Envelope(ST_Scale(mbr, -1, 1));
--: an edge in another reference system
UPDATE town.edge_data SET geom = ST_SetSRID(geom, 4326) WHERE edge_id = at.e(45,30);
