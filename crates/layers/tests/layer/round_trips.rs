//! Written layers are read back unchanged.

use crate::support::{from_text, through, to_geojson, world};
use std::sync::Arc;
use twinedge_layers::{
    Crs, Dimensions, Feature, Field, FieldKind, Format, Geometry, Id, Layer, Loss, Position, ReadError, Shape, Value,
    losses, write,
};
use twinedge_layers::{ReadOptions, read_path, write_path};

const EVERYTHING: &str = r#"{"type":"FeatureCollection",
"name":"parcels",
"crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2056"}},
"source":{"z":1,"a":[true,null]},
"features":[
{"type":"Feature","id":"A-1","bbox":[0,0,4,4],"rights":"none","properties":{"zone":"W2","area":16.0,"count":3,"since":"2020-01-31","tags":["x",{"y":1}]},"geometry":{"type":"Polygon","coordinates":[[[0,0,5],[4,0,5.5],[4,4,6],[0,4,-0.0],[0,0,5]]]}},
{"type":"Feature","id":7,"properties":{"zone":null},"geometry":{"type":"MultiPolygon","coordinates":[[[[5,0],[6,0],[6,1],[5,0]]],[[[8,0],[9,0],[9,1],[8,0]]]]}},
{"type":"Feature","properties":{},"geometry":{"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1e-7,1.5e+300]},{"type":"LineString","coordinates":[[0,0],[0.1,0.2]]},{"type":"MultiPoint","coordinates":[[0.3,1.8446744073709552e+19]]},{"type":"MultiLineString","coordinates":[[[0,0],[1,1]]]}]}},
{"type":"Feature","properties":{"zone":"\u0000\"ü"},"geometry":null},
{"type":"Feature","properties":{},"geometry":{"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2],"bbox":[1,2,1,2],"accuracy":0.1}],"surveyed":{"by":"Meier"}}}
]}
"#;

#[test]
fn geojson_keeps_everything_to_the_byte() {
    let layer = from_text(EVERYTHING);
    assert_eq!(layer.features[0].id, Some(Id::Text("A-1".into())));
    assert_eq!(layer.features[1].id, Some(Id::Number(7.into())));
    assert_eq!(layer.features[0].get("count"), Some(&Value::Integer(3)));
    assert_eq!(layer.features[0].get("area"), Some(&Value::Real(16.0)));
    let text = to_geojson(&layer);
    assert_eq!(text, EVERYTHING);
    assert_eq!(through(&layer, Format::GeoJsonSeq).features, layer.features);
    assert!(losses(&layer, Format::GeoJson).is_empty());
}

#[test]
fn foreign_members_of_a_feature_alone_are_its_own() {
    let text = "{\"type\":\"Feature\",\"id\":1,\"rights\":\"none\",\"properties\":{\"a\":1},\"geometry\":null}\n";
    for layer in [from_text(text), from_text(&text.repeat(2))] {
        assert_eq!(layer.features[0].members.get("rights"), Some(&"none".into()));
        assert!(layer.header.members.is_empty());
    }
}

#[test]
fn text_of_empty_parts_is_written_and_read_again() {
    // MULTIPOLYGON (EMPTY), as GDAL writes it in binary.
    let digits = "010600000001000000010300000000000000\n";
    let text = "MULTIPOLYGON(EMPTY)\nMULTIPOLYGON(EMPTY,((0 0,1 0,1 1,0 0)))\nPOLYGON((0 0,1 0,1 1,0 0),EMPTY)\n\
MULTILINESTRING(EMPTY,(0 0,1 1))\nPOLYGON Z EMPTY\nGEOMETRYCOLLECTION Z(MULTIPOLYGON Z(EMPTY,((0 0 1,1 0 1,1 1 1,0 0 1))))\n";
    let layer = from_text(text);
    assert_eq!(layer.features[0].geometry, from_text(digits).features[0].geometry);
    let mut written = Vec::new();
    write(&layer, &mut written, Format::Wkt).unwrap();
    assert_eq!(String::from_utf8(written).unwrap(), text);
    assert_eq!(through(&layer, Format::Wkb).features, layer.features);
}

#[test]
fn a_reference_system_before_the_text_is_that_of_the_layer() {
    let layer = from_text("SRID=2056;POINT(1 2)\nPOINT(3 4 5)\n");
    assert_eq!(layer.header.crs, Some(Crs::epsg(2056)));
    assert_eq!(layer.features[1].geometry.as_ref().unwrap().dimensions, Dimensions::Xyz);
}

#[test]
fn binary_geometries_are_read_as_bytes_big_endian_and_extended() {
    // POINT(1 2), big-endian; then as PostGIS writes it, with a reference system.
    let mut bytes = vec![0, 0, 0, 0, 1];
    bytes.extend(1.0_f64.to_be_bytes());
    bytes.extend(2.0_f64.to_be_bytes());
    bytes.extend([1, 1, 0, 0, 0x20]);
    bytes.extend(2056_u32.to_le_bytes());
    bytes.extend(1.0_f64.to_le_bytes());
    bytes.extend(2.0_f64.to_le_bytes());
    let layer = crate::support::from_bytes(&bytes).unwrap();
    assert_eq!(layer.features.len(), 2);
    assert_eq!(layer.features[0].geometry, layer.features[1].geometry);
    assert_eq!(layer.header.crs.unwrap().code, Some(("EPSG".into(), 2056)));
}

/// A layer with every type of attribute found in tables.
fn attributes() -> Layer {
    let square = |x: f64| {
        let ring = [(x, 0.0), (x + 1.0, 0.0), (x + 1.0, 1.0), (x, 1.0), (x, 0.0)];
        let ring = ring.map(|(x, y)| Position::new(x, y)).to_vec();
        Geometry::new(Dimensions::Xy, Shape::Polygon(vec![ring]))
    };
    let names: [Arc<str>; 6] = ["zone", "count", "size", "built", "open", "none"].map(Into::into);
    let values = [
        vec![
            Value::Text("Zürich".into()),
            Value::Integer(i64::MIN),
            Value::Real(0.1 + 0.2),
            Value::Date("2020-02-29".into()),
            Value::Bool(true),
            Value::Null,
        ],
        vec![
            Value::Text(" a".into()),
            Value::Integer(9_007_199_254_740_993),
            Value::Real(-1.797_693_134_862_315_7e308),
            Value::Null,
            Value::Bool(false),
            Value::Null,
        ],
        vec![Value::Null, Value::Null, Value::Real(5e-324), Value::Null, Value::Null, Value::Null],
    ];
    let features = values.into_iter().enumerate().map(|(i, values)| Feature {
        geometry: (i != 2).then(|| square(i as f64)),
        attributes: names.iter().cloned().zip(values).collect(),
        ..Feature::default()
    });
    let mut layer = Layer { features: features.collect(), ..Layer::default() };
    layer.header.crs = Some(Crs { code: Some(("EPSG".into(), 4326)), ..Crs::default() });
    layer
}

#[test]
fn tables_keep_every_value_and_its_type() {
    let layer = attributes();
    for format in [Format::Shapefile, Format::GeoPackage] {
        assert!(losses(&layer, format).is_empty(), "{format}: {:?}", losses(&layer, format));
        let again = through(&layer, format);
        for (before, after) in layer.features.iter().zip(&again.features) {
            assert_eq!(before.attributes, after.attributes, "{format}");
            assert_eq!(before.geometry, after.geometry, "{format}");
        }
        assert!(!again.header.crs.unwrap().is_other());
        let kinds: Vec<FieldKind> = again.header.fields.iter().map(|field| field.kind).collect();
        let [text, integer, real] = [FieldKind::Text, FieldKind::Integer, FieldKind::Real];
        assert_eq!(kinds, [text, integer, real, FieldKind::Date, FieldKind::Bool, text], "{format}");
    }
}

#[test]
fn of_several_layers_one_must_be_chosen() {
    let (_folder, path) = crate::support::scratch("two.gpkg");
    let named = |name: &str| {
        let mut layer = attributes();
        layer.header.name = Some(name.to_owned());
        layer
    };
    write_path(&named("one"), &path, Format::GeoPackage).unwrap();
    let database = rusqlite::Connection::open(&path).unwrap();
    database
        .execute_batch(
            "CREATE TABLE two AS SELECT * FROM one;
             INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES ('two', 'features', 'two', 4326);
             INSERT INTO gpkg_geometry_columns VALUES ('two', 'geom', 'POLYGON', 4326, 0, 0);",
        )
        .unwrap();
    drop(database);
    let read = |layer: Option<&str>| {
        read_path(&path, &ReadOptions { layer: layer.map(str::to_owned), ..ReadOptions::default() })
    };
    assert!(matches!(read(None), Err(ReadError::Layers { wanted: None, layers }) if layers == ["one", "two"]));
    assert!(matches!(read(Some("three")), Err(ReadError::Layers { wanted: Some(_), .. })));
    assert_eq!(read(Some("two")).unwrap().features.len(), 3);
}

#[test]
fn a_view_without_a_key_is_read() {
    let (_folder, path) = crate::support::scratch("view.gpkg");
    let mut layer = attributes();
    layer.header.name = Some("one".to_owned());
    write_path(&layer, &path, Format::GeoPackage).unwrap();
    let database = rusqlite::Connection::open(&path).unwrap();
    database
        .execute_batch(
            "CREATE VIEW seen AS SELECT fid, geom, 2 * fid AS twice FROM one ORDER BY fid DESC;
             INSERT INTO gpkg_contents (table_name, data_type, identifier, srs_id) VALUES ('seen', 'features', 'seen', 4326);
             INSERT INTO gpkg_geometry_columns VALUES ('seen', 'geom', 'POLYGON', 4326, 0, 0);",
        )
        .unwrap();
    drop(database);
    let seen = read_path(&path, &ReadOptions { layer: Some("seen".to_owned()), ..ReadOptions::default() }).unwrap();
    let twice: Vec<_> = seen.features.iter().map(|feature| feature.get("twice").cloned()).collect();
    assert_eq!(twice, [6, 4, 2].map(|n| Some(Value::Integer(n))));
    assert!(seen.features.iter().all(|feature| feature.id.is_none()));
}

#[test]
fn ids_that_a_geopackage_would_change_are_lost_and_said_to_be() {
    for ids in [&[None, Some(1)][..], &[Some(5), None, Some(3)], &[Some(5), Some(3)], &[Some(2), Some(2)]] {
        let mut layer = Layer::default();
        for (number, id) in (0..).zip(ids) {
            let id = id.map(|id: i64| Id::Number(id.into()));
            let attributes = vec![("number".into(), Value::Integer(number))];
            layer.features.push(Feature { id, attributes, ..Feature::default() });
        }
        let given = ids.iter().flatten().count();
        assert_eq!(losses(&layer, Format::GeoPackage), [Loss::Ids(given)], "{ids:?}");
        let again = through(&layer, Format::GeoPackage);
        let numbers: Vec<_> = again.features.iter().map(|feature| feature.get("number").cloned()).collect();
        let expected: Vec<_> = (0..).take(ids.len()).map(|number| Some(Value::Integer(number))).collect();
        assert_eq!(numbers, expected, "{ids:?}");
    }
}

#[test]
fn columns_are_those_of_the_header_and_then_those_of_features() {
    let mut layer = from_text(EVERYTHING);
    layer.header.fields.push(Field { name: "tags".into(), kind: FieldKind::Json, width: None, decimals: None });
    let fields = layer.fields();
    let names: Vec<&str> = fields.iter().map(|field| &*field.name).collect();
    assert_eq!(names, ["tags", "zone", "area", "count", "since"]);
    assert_eq!(fields[2].kind, FieldKind::Real);
}

#[test]
fn every_geometry_comes_back_from_each_format_that_holds_it() {
    use Format::{FlatGeobuf, GeoPackage, GeoParquet, Shapefile, Wkb, Wkt};
    let flat = "POINT(1 2)\nPOINT EMPTY\nMULTIPOINT((1 2),(3 4))\nLINESTRING(0 0,1 1)\nLINESTRING EMPTY\n\
MULTILINESTRING((0 0,1 1),(2 2,3 3))\nPOLYGON((0 0,4 0,4 4,0 0),(2 1,3 1,3 2,2 1))\nPOLYGON EMPTY\n\
MULTIPOLYGON(((0 0,4 0,4 4,0 0)),((5 5,6 5,6 6,5 5),(1 1,2 2,1 2,1 1)))\nMULTIPOLYGON EMPTY\n\
GEOMETRYCOLLECTION(POINT(1 2),GEOMETRYCOLLECTION(LINESTRING(0 0,1 1)))\nGEOMETRYCOLLECTION(POINT(1 2),GEOMETRYCOLLECTION EMPTY)\n\
GEOMETRYCOLLECTION EMPTY\n";
    let mixed = "POINT Z(1 2 3)\nPOINT M(1 2 3)\nPOINT ZM(1 2 3 4)\nLINESTRING Z(0 0 1,1 1 2)\n\
MULTIPOLYGON M(((0 0 1,4 0 1,4 4 1,0 0 1)),((5 5 2,6 5 2,6 6 2,5 5 2)))\nMULTIPOLYGON ZM(((0 0 1 2,4 0 3 4,4 4 5 6,0 0 1 2)))\n";
    for (text, formats) in [
        (flat, &[Wkt, Wkb, GeoPackage, GeoParquet, FlatGeobuf][..]),
        (mixed, &[Wkt, Wkb, GeoPackage, GeoParquet]),
        // One type and one kind of coordinates in a file.
        ("POINT Z(1 2 3)\n", &[FlatGeobuf, Shapefile]),
        ("LINESTRING Z(0 0 1,1 1 2)\n", &[FlatGeobuf, Shapefile]),
        ("LINESTRING M(1 2 3,4 5 6)\n", &[FlatGeobuf, Shapefile]),
        ("LINESTRING ZM(0 0 1 5,1 1 2 6)\n", &[FlatGeobuf, Shapefile]),
        ("POINT ZM(0 0 1 5)\n", &[FlatGeobuf, Shapefile]),
        ("MULTIPOINT Z((0 0 1),(1 1 2))\n", &[FlatGeobuf, Shapefile]),
        ("MULTIPOLYGON ZM(((0 0 1 2,4 0 3 4,4 4 5 6,0 0 1 2)))\n", &[FlatGeobuf]),
    ] {
        let layer = from_text(text);
        let geometries = |layer: &Layer| layer.features.iter().map(|f| f.geometry.clone()).collect::<Vec<_>>();
        for format in formats {
            assert_eq!(losses(&layer, *format), [], "{format}: {text}");
            assert_eq!(geometries(&through(&layer, *format)), geometries(&layer), "{format}: {text}");
        }
    }
}

#[test]
fn the_world_comes_back_from_every_format_that_holds_it() {
    let world = world();
    for format in [Format::GeoJson, Format::GeoJsonSeq, Format::GeoPackage, Format::FlatGeobuf] {
        let again = through(&world, format);
        assert_eq!(again.features.len(), 177);
        for (before, after) in world.features.iter().zip(&again.features) {
            assert_eq!((&before.geometry, &before.attributes), (&after.geometry, &after.attributes), "{format}");
        }
    }
    // Its ids are the numbers of countries; three countries have none.
    assert_eq!(losses(&world, Format::FlatGeobuf), [Loss::Ids(174)]);
}
