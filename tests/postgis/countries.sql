-- The countries of the built-in map, and a winding road of 500 edges. `file` is the GeoJSON.
SET client_min_messages = error;
SET search_path = public, topology;
\set content `cat :'file'`
SELECT CreateTopology('countries');
SELECT count(topogeom) || ' countries' FROM (
  SELECT TopoGeo_AddPolygon('countries', part.geom) AS topogeom
  FROM json_array_elements((:'content')::json -> 'features') feature,
    LATERAL ST_Dump(ST_SetSRID(ST_GeomFromGeoJSON(feature ->> 'geometry'), 0)) part) added;
-- Each edge has 40 bends, and the next begins where it ends.
SELECT CreateTopology('road');
SELECT count(*) || ' stretches' FROM generate_series(0, 499) i,
  LATERAL TopoGeo_AddLineString('road', ST_MakeLine(ARRAY(
    SELECT ST_Point(i * 41 + j, 16 * (j % 2)) FROM generate_series(0, 41) j))) added;
