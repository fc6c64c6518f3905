//! The format that a file has.

use crate::support::{from_bytes, from_text, scratch};
use twinedge_formats::layer::{Format, ReadError, ReadOptions, Shape, read, read_path};

#[test]
fn content_tells_the_format_of_a_stream() {
    assert_eq!(from_text("POINT(1 2)").features.len(), 1);
    assert_eq!(
        from_text("{\"type\":\"Point\",\"coordinates\":[1,2]}\n{\"type\":\"Point\",\"coordinates\":[3,4]}")
            .features
            .len(),
        2
    );
    let point = from_text("0101000000000000000000F03F0000000000000040");
    assert!(
        matches!(&point.features[0].geometry.as_ref().unwrap().shape, Shape::Point(Some(p)) if (p.x, p.y) == (1.0, 2.0))
    );
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
    // The Shapefile of that name is looked for, and is not there.
    let error = read_path(&path, &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("parcels.shp is missing"), "{error}");
}

#[test]
fn what_is_not_read_is_named_with_what_to_do() {
    assert!(matches!(from_bytes(b" \n"), Err(ReadError::Empty)));
    assert!(matches!(from_bytes(b"id,name\n1,a"), Err(ReadError::Unrecognised)));
    let error = from_bytes(b"ARROW1..").unwrap_err().to_string();
    assert!(error.contains("Arrow") && error.contains("ogr2ogr"), "{error}");
}

#[test]
fn formats_of_files_are_refused_as_streams() {
    for head in [&b"\0\0\x27\x0A"[..], b"PAR1", &[b"SQLite format 3\0".as_slice(), &[0; 52], b"GPKG"].concat()] {
        let mut bytes = head;
        let outcome = read(&mut bytes, None, &ReadOptions::default(), &mut |_| Ok(()));
        assert!(matches!(outcome, Err(ReadError::NeedsFile(format)) if format.needs_file()));
    }
    assert!(!Format::GeoJson.needs_file());
}
