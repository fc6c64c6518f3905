//! Losses of a format are said, and then refused or suffered as said.

use crate::support::{from_text, through};
use twinedge_formats::layer::{Format, Layer, Loss, WriteError, losses, refuse_losses, write_path};

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
    assert_eq!(losses(&layer, Format::Shapefile), [ids.clone(), members.clone(), crs.clone()]);
    assert_eq!(losses(&layer, Format::GeoPackage), [ids.clone(), members.clone(), crs.clone()]);
    let attributes = Loss::Attributes(vec!["b".into()]);
    assert_eq!(losses(&layer, Format::Wkt), [ids, members, crs, attributes]);
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
