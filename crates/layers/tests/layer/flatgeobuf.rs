//! FlatGeobuf: a file written by GDAL, round trips, and hostile files.

use crate::support::{from_bytes, from_text, read, scratch, through};
use twinedge_layers::{
    Cause, Crs, Dimensions, FieldKind, Format, Id, Layer, Loss, Place, ReadError, Shape, Value, losses, write,
    write_path,
};

/// Written by `pyogrio` 0.13 with GDAL 3.12.4, with an index: two polygons with heights, in EPSG:2056.
const PARCELS: &[u8] = include_bytes!("data/parcels.fgb");

fn written(layer: &Layer) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(layer, &mut bytes, Format::FlatGeobuf).unwrap();
    bytes
}

#[test]
fn what_gdal_wrote_is_read() {
    let layer = from_bytes(PARCELS).unwrap();
    assert_eq!(layer.header.name.as_deref(), Some("parcels"));
    let crs = layer.header.crs.as_ref().unwrap();
    assert_eq!(crs.code, Some(("EPSG".into(), 2056)));
    assert!(crs.wkt.as_ref().unwrap().contains("CH1903+"));
    let kinds: Vec<(&str, FieldKind)> = layer.header.fields.iter().map(|field| (&*field.name, field.kind)).collect();
    let [text, integer, real] = [FieldKind::Text, FieldKind::Integer, FieldKind::Real];
    let time = FieldKind::DateTime;
    assert_eq!(
        kinds,
        [
            ("zone", text),
            ("small", integer),
            ("count", integer),
            ("size", real),
            ("since", time),
            ("open", FieldKind::Bool)
        ]
    );
    // The index sorts features along a curve: the second feature comes first.
    assert_eq!(layer.features.len(), 2);
    let of = |small: i64| layer.features.iter().find(|one| one.get("small") == Some(&Value::Integer(small))).unwrap();
    let first = of(1);
    assert_eq!(first.get("zone"), Some(&Value::Text("Zürich".into())));
    assert_eq!(first.get("count"), Some(&Value::Integer(9_007_199_254_740_993)));
    assert_eq!(first.get("size"), Some(&Value::Real(1.5)));
    assert!(matches!(first.get("since"), Some(Value::DateTime(time)) if time.starts_with("2020-02-29T12:30:00")));
    assert_eq!(of(-5).get("zone"), Some(&Value::Null));
    let geometry = first.geometry.as_ref().unwrap();
    assert_eq!(geometry.dimensions, Dimensions::Xyz);
    let Shape::Polygon(rings) = &geometry.shape else { panic!("{geometry:?}") };
    assert_eq!(rings.iter().map(Vec::len).collect::<Vec<_>>(), [5, 4]);
    assert_eq!((rings[1][1].x, rings[1][1].y, &*rings[1][1].more), (1.0, 2.0, &[2.0][..]));
    assert_eq!(
        layer.features.iter().map(|one| one.id.clone()).collect::<Vec<_>>(),
        [Some(Id::Number(0.into())), Some(Id::Number(1.into()))]
    );
    // Everything read survives a round trip.
    let again = through(&layer, Format::FlatGeobuf);
    assert_eq!(again, layer);
    assert!(losses(&layer, Format::FlatGeobuf).is_empty(), "{:?}", losses(&layer, Format::FlatGeobuf));
}

#[test]
fn every_value_comes_back_and_what_does_not_is_reported() {
    let layer = from_text(
        r#"{"type":"FeatureCollection","title":"T","more":1,"features":[
        {"type":"Feature","properties":{"a":true,"b":-3,"c":0.5,"d":"ü","e":[1,{"x":null}],"f":7},"geometry":null},
        {"type":"Feature","properties":{"a":null,"b":9007199254740993,"c":-1e300,"d":"","e":{},"f":"seven"},"geometry":{"type":"Point","coordinates":[200,1]}}]}"#,
    );
    let again = through(&layer, Format::FlatGeobuf);
    assert_eq!(losses(&layer, Format::FlatGeobuf), [Loss::Members(vec!["more".into()])]);
    assert_eq!(again.header.members.keys().collect::<Vec<_>>(), ["title"]);
    for (before, after) in layer.features.iter().zip(&again.features) {
        for (name, value) in before.attributes.iter().filter(|(name, _)| **name != *"f") {
            assert_eq!(after.get(name), Some(value), "{name}");
        }
        assert_eq!(before.geometry, after.geometry);
    }
    // A column of numbers and texts becomes text.
    assert_eq!(again.features[0].get("f"), Some(&Value::Text("7".into())));
}

/// Polygons and multi-polygons with heights get a common type, which users of GDAL can open.
#[test]
fn differing_kinds_with_heights_are_declared_as_gdal_declares_them() {
    let polygon = "POLYGON Z((0 0 1,4 0 1,4 4 1,0 0 1))";
    let polygons = "MULTIPOLYGON Z(((5 5 1,6 5 1,6 6 1,5 5 1)))";
    let layer = from_text(&format!("{polygon}\n{polygons}\nPOLYGON Z EMPTY\n"));
    let as_several = "MULTIPOLYGON Z(((0 0 1,4 0 1,4 4 1,0 0 1)))";
    let expected = from_text(&format!("{as_several}\n{polygons}\nMULTIPOLYGON Z(EMPTY)\n"));
    let geometries = |layer: &Layer| layer.features.iter().map(|f| f.geometry.clone()).collect::<Vec<_>>();
    assert_eq!(geometries(&through(&layer, Format::FlatGeobuf)), geometries(&expected));
    // Without heights, each keeps its kind.
    let flat = from_text("POLYGON((0 0,4 0,4 4,0 0))\nMULTIPOLYGON(((5 5,6 5,6 6,5 5)))\n");
    assert_eq!(geometries(&through(&flat, Format::FlatGeobuf)), geometries(&flat));
    // A GeoPackage declares heights as allowed (2), not as required (1).
    let (_folder, path) = scratch("map.gpkg");
    write_path(&layer, &path, Format::GeoPackage).unwrap();
    let database = rusqlite::Connection::open(&path).unwrap();
    let declared: (String, i64) = database
        .query_row("SELECT geometry_type_name, z FROM gpkg_geometry_columns", [], |row| Ok((row.get(0)?, row.get(1)?)))
        .unwrap();
    assert_eq!(declared, ("GEOMETRY".to_owned(), 2));
    assert_eq!(geometries(&read(&path).unwrap()), geometries(&layer));
}

#[test]
fn a_reference_system_without_a_number_of_32_bits_is_reported() {
    let mut layer = from_text("POINT(1 2)\n");
    for (code, is_held) in [(2056, true), (1 << 31, false), (0, false)] {
        layer.header.crs = Some(Crs { code: Some(("EPSG".into(), code)), ..Crs::default() });
        assert_eq!(losses(&layer, Format::FlatGeobuf).is_empty(), is_held, "{code}");
        assert_eq!(through(&layer, Format::FlatGeobuf).header.crs == layer.header.crs, is_held, "{code}");
    }
}

#[test]
fn lengths_and_counts_beyond_the_data_are_refused() {
    let layer = from_text("POLYGON((0 0,4 0,4 4,0 0))\nPOLYGON((5 5,6 5,6 6,5 5))\n");
    let bytes = written(&layer);
    let with = |at: usize, new: &[u8]| {
        let mut bytes = bytes.clone();
        bytes[at..at + new.len()].copy_from_slice(new);
        from_bytes(&bytes).unwrap_err()
    };
    // The length of the header, and the length of the first feature.
    let error = with(8, &[0xFF; 4]);
    assert!(matches!(error, ReadError::Content { place: Place::Header, cause: Cause::TooMany { .. }, .. }), "{error}");
    // An index of three nodes lies between.
    let first = 12 + u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize + 3 * 40;
    let error = with(first, &[0xFF; 4]);
    assert!(
        matches!(error, ReadError::Content { place: Place::Feature(0), cause: Cause::Truncated(_), .. }),
        "{error}"
    );
    // An unknown version, and a missing file.
    assert!(with(3, &[9]).to_string().contains("version 9"));
    // One feature fewer, and one more.
    let length = u32::from_le_bytes(bytes[first..first + 4].try_into().unwrap()) as usize + 4;
    let error = from_bytes(&bytes[..first + length]).unwrap_err();
    assert!(matches!(error, ReadError::Content { cause: Cause::TooMany { count: 2, .. }, .. }), "{error}");
    let error = from_bytes(&[&bytes, &bytes[first..]].concat()).unwrap_err();
    assert!(error.to_string().contains("more features follow than the 2"), "{error}");
}
