//! Files that are truncated, changed or false lead to an error or a layer, but never to a panic or memory beyond the
//! data.

use crate::support::{from_bytes, from_text, read, scratch, world};
use std::fs;
use twinedge_layers::{Cause, Format, Layer, ReadError, write, write_path};

fn small() -> Layer {
    let mut layer = world();
    layer.features.truncate(2);
    layer
}

#[test]
fn every_beginning_of_binary_geometries_is_refused() {
    let mut bytes = vec![1, 6, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0];
    bytes.extend([0; 32]);
    assert_eq!(from_bytes(&bytes).unwrap().features.len(), 1);
    for end in 1..bytes.len() {
        let outcome = from_bytes(&bytes[..end]);
        assert!(outcome.is_err(), "{end} bytes: {outcome:?}");
    }
}

#[test]
fn counts_beyond_the_data_are_refused() {
    for kind in 2..=7_u8 {
        let bytes = [1, kind, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0];
        let error = from_bytes(&bytes).unwrap_err();
        assert!(matches!(error, ReadError::Content { cause: Cause::TooMany { .. }, .. }), "{error}");
    }
}

#[test]
fn nesting_has_a_bound() {
    let nested = |depth: usize| [[1, 7, 0, 0, 0, 1, 0, 0, 0].repeat(depth), vec![1, 7, 0, 0, 0, 0, 0, 0, 0]].concat();
    assert!(from_bytes(&nested(31)).is_ok());
    let error = from_bytes(&nested(100_000)).unwrap_err();
    assert!(matches!(error, ReadError::Content { cause: Cause::TooDeep, .. }), "{error}");
}

#[test]
fn wrong_digits_have_a_line() {
    let text = "0101000000000000000000F03F0000000000000040\n01zz\n";
    assert_eq!(
        from_bytes(text.as_bytes()).unwrap_err().to_string(),
        "well-known binary: line 2: not hexadecimal digits"
    );
}

/// Calls `each` with some changes of each byte of a file, and with each prefix; the reader must return.
fn changed(extension: &str, original: &[u8], mut each: impl FnMut(&[u8])) {
    let step = (original.len() / 400).max(1);
    for at in (0..original.len()).step_by(step) {
        each(&original[..at]);
        for value in [0, 0x7F, 0x80, 0xFF] {
            let mut bytes = original.to_vec();
            bytes[at] = value;
            each(&bytes);
        }
    }
    assert!(!original.is_empty(), "{extension}");
}

#[test]
fn a_shapefile_with_any_byte_changed_ends_in_an_error_or_a_layer() {
    let (_folder, path) = scratch("map.shp");
    write_path(&small(), &path, Format::Shapefile).unwrap();
    let mut errors = 0;
    for extension in ["shp", "shx", "dbf"] {
        let part = path.with_extension(extension);
        let original = fs::read(&part).unwrap();
        changed(extension, &original, |bytes| {
            fs::write(&part, bytes).unwrap();
            errors += usize::from(read(&path).is_err());
        });
        fs::write(&part, original).unwrap();
    }
    assert!(errors > 500, "{errors}");
    assert!(read(&path).is_ok());
}

#[test]
fn a_shapefile_that_promises_too_much_is_refused() {
    let (_folder, path) = scratch("map.shp");
    write_path(&from_text("LINESTRING(0 0,1 1)\n"), &path, Format::Shapefile).unwrap();
    let original = fs::read(&path).unwrap();
    // The number of parts, the number of points, the start of the part, the length of the record.
    for at in [144, 148, 152, 104] {
        let mut bytes = original.clone();
        bytes[at..at + 4].copy_from_slice(&[0xFF, 0xFF, 0xFF, 0x7F]);
        fs::write(&path, bytes).unwrap();
        assert!(matches!(read(&path), Err(ReadError::Content { .. })), "{at}");
    }
}

#[test]
fn a_geopackage_with_bytes_changed_ends_in_an_error_or_a_layer() {
    let (_folder, path) = scratch("map.gpkg");
    write_path(&from_text("POLYGON((0 0,4 0,4 4,0 0))\n"), &path, Format::GeoPackage).unwrap();
    let original = fs::read(&path).unwrap();
    let mut errors = 0;
    changed("gpkg", &original, |bytes| {
        fs::write(&path, bytes).unwrap();
        errors += usize::from(read(&path).is_err());
    });
    assert!(errors > 100, "{errors}");
}

#[test]
fn geometries_of_a_geopackage_are_checked() {
    let (_folder, path) = scratch("map.gpkg");
    write_path(&from_text("POINT(1 2)\n"), &path, Format::GeoPackage).unwrap();
    for geometry in
        ["'text'", "x'47'", "x'4750000100000000'", "x'47500021000000000101000000'", "x'4750000F00000000'", "7"]
    {
        let database = rusqlite::Connection::open(&path).unwrap();
        database.execute_batch(&format!("UPDATE map SET geom = {geometry}")).unwrap();
        drop(database);
        assert!(matches!(read(&path), Err(ReadError::Content { .. })), "{geometry}");
    }
}

#[test]
fn every_beginning_of_geojson_is_refused() {
    let mut text = Vec::new();
    write(&from_text("POLYGON((0 0,4 0,4 4,0 0))\n"), &mut text, Format::GeoJson).unwrap();
    // Without the final line break, the text is complete.
    for end in 0..text.len() - 1 {
        assert!(from_bytes(&text[..end]).is_err(), "{end}");
    }
}
