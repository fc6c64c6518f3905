//! Losses of a format are announced, and then refused or incurred as announced.

use crate::support::{from_bytes, from_text, through};
use twinedge_layers::{Crs, Format, Layer, Loss, Shape, WriteError, losses, refuse_losses, write, write_path};

/// A layer of one point with these properties.
fn with_properties(properties: &str) -> Layer {
    from_text(&format!(
        r#"{{"type":"Feature","properties":{properties},"geometry":{{"type":"Point","coordinates":[200,1]}}}}"#
    ))
}

#[test]
fn names_of_columns_are_cut_to_ten_bytes_and_stay_distinct() {
    let layer = with_properties(r#"{"population_2020":1,"population_2021":2,"POPULATION_2022":3,"größenklasse":4}"#);
    let [Loss::Renamed(names)] = &losses(&layer, Format::Shapefile)[..] else { panic!("one loss") };
    let new: Vec<&str> = names.iter().map(|(_, new)| &**new).collect();
    assert_eq!(new, ["population", "populati_1", "POPULATI_2", "größenkl"]);
    assert!(matches!(refuse_losses(&layer, Format::Shapefile), Err(WriteError::Loss { .. })));
    let again = through(&layer, Format::Shapefile);
    let columns: Vec<&str> = again.header.fields.iter().map(|field| &*field.name).collect();
    assert_eq!(columns, new);
    assert_eq!(again.features[0].get("populati_1"), layer.features[0].get("population_2021"));
}

#[test]
fn texts_are_cut_to_254_bytes_between_characters() {
    let layer = with_properties(&format!(r#"{{"note":"{}"}}"#, "ü".repeat(200)));
    assert_eq!(losses(&layer, Format::Shapefile), [Loss::Cut { column: "note".into(), count: 1, bytes: 254 }]);
    let again = through(&layer, Format::Shapefile);
    assert_eq!(again.features[0].get("note").and_then(|note| note.text()).unwrap(), "ü".repeat(127));
}

#[test]
fn a_shapefile_has_one_kind_of_geometries() {
    let mixed = from_text("POINT(1 2)\nLINESTRING(0 0,1 1)\n");
    let (_folder, path) = crate::support::scratch("mixed.shp");
    let error = write_path(&mixed, &path, Format::Shapefile).unwrap_err();
    assert_eq!(error.to_string(), "Shapefile cannot hold points and lines in one file");
    let collection = from_text("GEOMETRYCOLLECTION(POINT(1 2))\n");
    assert!(matches!(write_path(&collection, &path, Format::Shapefile), Err(WriteError::Impossible { .. })));
}

#[test]
fn ids_members_and_reference_systems_are_not_lost_silently() {
    let text = r#"{"type":"FeatureCollection","source":"x","crs":{"type":"name","properties":{"name":"EPSG:2056"}},
        "features":[{"type":"Feature","id":"a","properties":{"b":1},"geometry":{"type":"Point","coordinates":[1,2]}}]}"#;
    let layer = from_text(text);
    let [ids, members, crs] = [Loss::Ids(1), Loss::Members(vec!["source".into()]), Loss::Crs("EPSG:2056".into())];
    assert!(losses(&layer, Format::GeoJson).is_empty());
    assert_eq!(losses(&layer, Format::GeoJsonSeq), [members.clone(), crs.clone()]);
    // Esri's definition of the system is known.
    assert_eq!(losses(&layer, Format::Shapefile), [ids.clone(), members.clone()]);
    assert_eq!(losses(&layer, Format::GeoPackage), [ids.clone(), members.clone()]);
    let unknown = from_text(&text.replace("2056", "99999"));
    assert_eq!(losses(&unknown, Format::Shapefile)[2], Loss::Crs("EPSG:99999".into()));
    let attributes = Loss::Attributes(vec!["b".into()]);
    assert_eq!(losses(&layer, Format::Wkt), [ids, members, crs, attributes]);
}

#[test]
fn a_definition_that_esri_does_not_read_is_not_written_silently() {
    let wkt2 = r#"PROJCRS["somewhere",BASEGEOGCRS["CH1903+"]]"#;
    let mut layer = from_text("POINT(1 2)\n");
    layer.header.crs = Some(Crs { wkt: Some(wkt2.into()), ..Crs::default() });
    assert_eq!(losses(&layer, Format::Shapefile), [Loss::Crs("somewhere".into())]);
    let (_folder, path) = crate::support::scratch("point.shp");
    write_path(&layer, &path, Format::Shapefile).unwrap();
    assert!(!path.with_extension("prj").exists());
    // The number identifies more than the text.
    layer.header.crs = Some(Crs { wkt: Some(wkt2.into()), ..Crs::epsg(2056) });
    assert!(losses(&layer, Format::Shapefile).is_empty());
    write_path(&layer, &path, Format::Shapefile).unwrap();
    let esri = std::fs::read_to_string(path.with_extension("prj")).unwrap();
    assert!(esri.starts_with("PROJCS[\"CH1903+_LV95\",GEOGCS[\"GCS_CH1903+\""), "{esri}");
    assert_eq!(through(&layer, Format::Shapefile).header.crs.unwrap().code, Some(("EPSG".into(), 2056)));
}

#[test]
fn names_of_reference_systems_in_geojson_become_numbers() {
    for (name, code) in [
        ("urn:ogc:def:crs:OGC:1.3:CRS84", 4326),
        ("EPSG:4326", 4326),
        ("urn:ogc:def:crs:EPSG::2056", 2056),
        ("http://www.opengis.net/def/crs/EPSG/0/3857", 3857),
    ] {
        let text = format!(
            r#"{{"type":"FeatureCollection","crs":{{"type":"name","properties":{{"name":"{name}"}}}},"features":[
            {{"type":"Feature","properties":{{}},"geometry":{{"type":"Point","coordinates":[1,2]}}}}]}}"#
        );
        for format in [Format::FlatGeobuf, Format::GeoPackage, Format::Shapefile] {
            let crs = through(&from_text(&text), format).header.crs.unwrap();
            assert_eq!(crs.code, Some(("EPSG".into(), code)), "{name} in {format}");
        }
    }
}

#[test]
fn measures_are_no_heights() {
    let layer = from_text("POINT M(1 2 3)\n");
    assert_eq!(losses(&layer, Format::GeoJson), [Loss::Measures(1)]);
    assert!(losses(&layer, Format::Wkb).is_empty());
}

#[test]
fn what_is_only_of_form_is_no_reason_to_refuse() {
    let layer = with_properties(r#"{"tags":[1]}"#);
    let found = losses(&layer, Format::GeoPackage);
    assert!(matches!(&found[..], [Loss::Type { .. }]) && found[0].is_minor(), "{found:?}");
    refuse_losses(&layer, Format::GeoPackage).unwrap();
}

#[test]
fn open_rings_are_closed_in_every_format_and_it_is_said() {
    let layer = from_text("MULTIPOLYGON(((0 0,1 0,1 1)),((5 0,6 0,6 1,5 0)))\n");
    let closed = from_text("MULTIPOLYGON(((0 0,1 0,1 1,0 0)),((5 0,6 0,6 1,5 0)))\n");
    let formats = [
        Format::GeoJson,
        Format::GeoJsonSeq,
        Format::Wkt,
        Format::Wkb,
        Format::Shapefile,
        Format::GeoPackage,
        Format::FlatGeobuf,
        Format::GeoParquet,
    ];
    for format in formats {
        assert_eq!(losses(&layer, format), [Loss::OpenRings(1)], "{format}");
        refuse_losses(&layer, format).unwrap();
        // A Shapefile has no order of polygons, and its holes have the opposite orientation.
        let positions = |layer: &Layer| {
            let mut count = 0;
            layer.features[0].geometry.as_ref().unwrap().shape.visit(&mut |_| count += 1);
            count
        };
        assert_eq!(positions(&through(&layer, format)), positions(&closed), "{format}");
    }
    assert_eq!(Loss::OpenRings(1).to_string(), "an open ring, which is closed");
}

/// PostGIS writes the equivalent of `MULTIPOINT (EMPTY, (1 2))` as hexadecimal digits.
#[test]
fn empty_points_of_multi_points_are_kept_or_said_to_be_lost() {
    let digits = "01040000000200000001010000000000000000\
00F87F000000000000F87F0101000000000000000000F03F0000000000000040";
    let layer = from_text("MULTIPOINT (EMPTY, (1 2))");
    assert_eq!(layer.features, from_text(digits).features);
    let Some(Shape::MultiPoint(points)) = layer.features[0].geometry.as_ref().map(|geometry| &geometry.shape) else {
        panic!("{:?}", layer.features)
    };
    assert_eq!(points.iter().map(Option::is_some).collect::<Vec<_>>(), [false, true]);
    for format in [Format::Wkt, Format::Wkb, Format::GeoPackage, Format::GeoParquet] {
        assert!(losses(&layer, format).is_empty(), "{format}");
        assert_eq!(through(&layer, format).features[0].geometry, layer.features[0].geometry, "{format}");
    }
    for format in [Format::GeoJson, Format::GeoJsonSeq, Format::Shapefile, Format::FlatGeobuf] {
        assert_eq!(losses(&layer, format), [Loss::EmptyParts(1)], "{format}");
        refuse_losses(&layer, format).unwrap();
        let again = through(&layer, format);
        let shape = again.features[0].geometry.as_ref().map(|geometry| &geometry.shape);
        assert!(matches!(shape, Some(Shape::MultiPoint(points)) if points.len() == 1), "{format}: {shape:?}");
    }
    // With heights, in a collection, and with only empty points.
    let text = "GEOMETRYCOLLECTION Z(MULTIPOINT Z(EMPTY,(1 2 3)))\nMULTIPOINT(EMPTY,EMPTY)\nPOINT EMPTY\n";
    let mut written = Vec::new();
    write(&from_text(text), &mut written, Format::Wkt).unwrap();
    assert_eq!(String::from_utf8(written).unwrap(), text);
    // NaN stands for an empty point, as in well-known binary.
    assert_eq!(from_text("POINT(nan NaN)").features, from_text("POINT EMPTY").features);
    assert!(from_bytes(b"LINESTRING(nan nan, 1 2)").unwrap_err().to_string().contains("out of range"));
}
