//! Detecting the format of a file.

use crate::support::{from_bytes, from_text, scratch, write_as};
use twinedge_layers::io::ForeignFormat;
use twinedge_layers::{ArchiveError, Format, ReadError, ReadOptions, WriteError, format_of, read, read_path};

#[test]
fn a_missing_feature_is_named_with_the_flag_of_the_program() {
    let read = ReadError::FeatureOff(Format::GeoPackage).to_string();
    let written = WriteError::FeatureOff(Format::GeoParquet).to_string();
    let archive = ArchiveError::FeatureOff.to_string();
    for (error, feature) in [(read, "geopackage"), (written, "geoparquet"), (archive, "archive")] {
        let named = format!("the feature `{feature}` of twinedge-layers, which is off");
        assert!(error.contains(&named) && error.contains("--features full"), "{error}");
    }
}

#[test]
fn a_mesh_in_ply_is_no_map() {
    for head in ["ply\n", "ply\r\n"] {
        let found = format_of(head.as_bytes(), None, &ReadOptions::default());
        assert!(matches!(found, Err(ReadError::Foreign(ForeignFormat::Ply))), "{found:?}");
    }
}

#[test]
fn newline_delimited_geojson_may_be_named_as_one_object() {
    let (_folder, path) = scratch("points.geojson");
    let point = "{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,2]}}\n";
    std::fs::write(&path, point.repeat(3)).unwrap();
    assert_eq!(read_path(&path, &ReadOptions::default()).unwrap().features.len(), 3);
}

#[test]
fn binary_content_is_what_it_is_whatever_the_name() {
    let (_folder, path) = scratch("parcels.geojson");
    std::fs::write(&path, b"\0\0\x27\x0A").unwrap();
    // The reader looks for a Shapefile of that name, which does not exist.
    let error = read_path(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("parcels.shp is missing"), "{error}");
}

#[test]
fn formats_of_files_are_refused_as_streams() {
    for head in [&b"\0\0\x27\x0A"[..], b"PAR1", &[b"SQLite format 3\0".as_slice(), &[0; 52], b"GPKG"].concat()] {
        let mut bytes = head;
        let outcome = read(&mut bytes, None, &ReadOptions::default(), &mut |_| Ok(()));
        assert!(matches!(outcome, Err(ReadError::NeedsFile(_))));
    }
}

/// By the application id in `GeoPackage` 1.0 and 1.1, and by the tables, because other programs write 0.
#[test]
fn geopackages_of_all_versions_are_recognised() {
    let (_folder, path) = scratch("layer.gpkg");
    let (_other, named) = scratch("layer.data");
    write_as(&from_text("POINT(1 2)"), &path, Format::GeoPackage);
    for id in [i32::from_be_bytes(*b"GP10"), i32::from_be_bytes(*b"GP11"), 0] {
        let database = rusqlite::Connection::open(&path).unwrap();
        database.pragma_update(None, "application_id", id).unwrap();
        drop(database);
        std::fs::copy(&path, &named).unwrap();
        assert_eq!(read_path(&named, &ReadOptions::default()).unwrap().features.len(), 1, "{id}");
    }
    // Another database is not a GeoPackage.
    let (_third, path) = scratch("notes.gpkg");
    rusqlite::Connection::open(&path).unwrap().execute_batch("CREATE TABLE notes (text)").unwrap();
    assert!(matches!(read_path(&path, &ReadOptions::default()), Err(ReadError::Foreign(_))));
}

#[test]
fn types_that_are_not_read_are_named_with_the_way_out() {
    let error = |bytes: &[u8]| from_bytes(bytes).unwrap_err().to_string();
    let curve = error(b"CURVEPOLYGON(CIRCULARSTRING(0 0,1 1,2 0,1 -1,0 0))");
    assert!(curve.contains("CurvePolygon has curves") && curve.contains("-nlt CONVERT_TO_LINEAR"), "{curve}");
    let inside = error(b"GEOMETRYCOLLECTION(POINT(1 2),COMPOUNDCURVE Z((0 0 1,1 1 1)))");
    assert!(inside.contains("CompoundCurve has curves"), "{inside}");
    // An empty CircularString, and an empty TIN in a collection.
    let binary = error(&[1, 8, 0, 0, 0, 0, 0, 0, 0]);
    assert!(binary.contains("CircularString has curves"), "{binary}");
    let tin = error(&[1, 7, 0, 0, 0, 1, 0, 0, 0, 1, 16, 0, 0, 0, 0, 0, 0, 0]);
    assert!(tin.contains("TIN is not read") && tin.contains("MULTIPOLYGON"), "{tin}");
    let gltf = error(br#"{"asset": {"version": "2.0"}, "bufferViews": []}"#);
    assert!(gltf.contains("glTF") && gltf.contains("export it as OBJ"), "{gltf}");
}
