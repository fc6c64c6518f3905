//! Files that are truncated, changed or false lead to an error or a layer, but never to a panic or memory beyond the
//! data.

use crate::support::{from_bytes, from_text, read, scratch, to_geojson};
use crate::topojson::EXAMPLE;
use std::fs;
use std::path::Path;
use twinedge_layers::{
    Cause, Dimensions, Files, Format, Geometry, Layer, Place, ReadError, Shape, write, write_files, write_path,
};

/// Written by GDAL and by `geopandas`.
const FLATGEOBUF: &[u8] = include_bytes!("data/parcels.fgb");
const GEOPARQUET: &[u8] = include_bytes!("data/parcels.parquet");

#[test]
fn counts_beyond_the_data_are_refused() {
    for kind in 2..=7_u8 {
        let bytes = [1, kind, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0];
        let error = from_bytes(&bytes).unwrap_err();
        assert!(matches!(error, ReadError::Content { cause: Cause::TooMany { .. }, .. }), "{error}");
    }
}

#[test]
fn wrong_digits_have_a_line() {
    let text = "0101000000000000000000F03F0000000000000040\n01zz\n";
    assert_eq!(
        from_bytes(text.as_bytes()).unwrap_err().to_string(),
        "well-known binary: line 2: not hexadecimal digits"
    );
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

/// A file of one feature or a few, and the lengths of prefixes that are refused.
type Truncated<'a> = (&'a str, &'a [u8], std::ops::Range<usize>, usize);

#[test]
fn every_beginning_is_refused() {
    let mut binary = vec![1, 6, 0, 0, 0, 1, 0, 0, 0, 1, 3, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0];
    binary.extend([0; 32]);
    let geojson = to_geojson(&from_text("POLYGON((0 0,4 0,4 4,0 0))\n"));
    // Without the final line break, the text is complete. The metadata of GeoParquet are at its end.
    let files: [Truncated<'_>; 5] = [
        ("map.wkb", &binary, 1..binary.len(), 1),
        ("map.geojson", geojson.as_bytes(), 0..geojson.len() - 1, 1),
        ("map.topojson", EXAMPLE.as_bytes(), 1..EXAMPLE.len(), 1),
        ("map.fgb", FLATGEOBUF, 1..FLATGEOBUF.len(), 1),
        ("map.parquet", GEOPARQUET, 4..GEOPARQUET.len(), 197),
    ];
    for (name, bytes, ends, step) in files {
        let (_folder, path) = scratch(name);
        let outcome = |end: usize| {
            if name != "map.parquet" {
                return from_bytes(&bytes[..end]);
            }
            fs::write(&path, &bytes[..end]).unwrap();
            read(&path)
        };
        assert!(outcome(bytes.len()).is_ok(), "{name}");
        for end in ends.step_by(step) {
            let error = outcome(end).expect_err(name);
            let in_header = matches!(error, ReadError::Content { place: Place::Header, .. });
            assert!(in_header || name != "map.parquet", "{name}, {end} bytes: {error}");
        }
    }
    let error = from_bytes(&EXAMPLE.as_bytes()[..200]).unwrap_err();
    assert!(matches!(error, ReadError::Content { cause: Cause::Truncated(_), .. }), "{error}");
}

/// Some changes of each of at most 400 bytes of a file, and each prefix that ends there: the reader must return.
#[test]
fn a_file_with_any_byte_changed_ends_in_an_error_or_a_layer() {
    let folder = tempfile::tempdir().unwrap();
    let mut parcels = from_text(
        r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"name":"a","lot":1.5},"geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]],[[2,1],[3,2],[3,1],[2,1]]]}},
        {"type":"Feature","properties":{"name":"ü","lot":null},"geometry":{"type":"MultiPolygon","coordinates":[[[[5,5],[6,5],[6,6],[5,5]]],[[[8,5],[9,5],[9,6],[8,5]]]]}}]}"#,
    );
    // The name of a reference system takes longer to look up than all else.
    parcels.header.crs = None;
    let nested = "GEOMETRYCOLLECTION(POINT(1 2),MULTIPOLYGON(((0 0,4 0,4 4,0 0)),((5 5,6 5,6 6,5 5))))\n";
    let of = |layer: &Layer, name: &str, format| write_files(layer, Path::new(name), format).unwrap();
    let shapefile = of(&parcels, "map.shp", Format::Shapefile);
    let nested = of(&from_text(nested), "nested.fgb", Format::FlatGeobuf);
    let given = |name: &str, bytes: &[u8]| -> Files { [(name.into(), bytes.to_vec())].into_iter().collect() };
    let path = folder.path().join("map.gpkg");
    write_path(&parcels, &path, Format::GeoPackage).unwrap();
    let geopackage = given("map.gpkg", &fs::read(&path).unwrap());
    let (flatgeobuf, geoparquet) = (given("map.fgb", FLATGEOBUF), given("map.parquet", GEOPARQUET));
    // The files, the changed one, the number of places, and the least share of errors.
    for (files, part, places, share) in [
        (&shapefile, "map.shp", 100, 0.2),
        (&shapefile, "map.shx", 400, 0.2),
        (&shapefile, "map.dbf", 400, 0.1),
        (&geopackage, "map.gpkg", 120, 0.05),
        (&flatgeobuf, "map.fgb", 400, 0.2),
        (&nested, "nested.fgb", 400, 0.2),
        (&geoparquet, "map.parquet", 120, 0.05),
    ] {
        let original = files.get(Path::new(part)).unwrap();
        let main = if files.get(Path::new("map.shp")).is_some() { "map.shp" } else { part };
        for (name, bytes) in files.iter() {
            fs::write(folder.path().join(name), bytes).unwrap();
        }
        let outcome = |bytes: &[u8]| {
            if matches!(part, "map.fgb" | "nested.fgb") {
                return from_bytes(bytes);
            }
            fs::write(folder.path().join(part), bytes).unwrap();
            read(&folder.path().join(main))
        };
        let whole = outcome(original).unwrap();
        let (mut all, mut errors, mut changed) = (0, 0, 0);
        let mut judge = |bytes: &[u8]| {
            all += 1;
            match outcome(bytes) {
                Ok(layer) => changed += usize::from(layer != whole),
                Err(ReadError::Content { .. }) => errors += 1,
                Err(error) => {
                    assert!(part != "map.parquet" || bytes.len() < 4, "{error}");
                    errors += 1;
                }
            }
        };
        for at in (0..original.len()).step_by((original.len() / places).max(1)) {
            judge(&original[..at]);
            for value in [0, 1, 0x7F, 0x80, 0xFF, original[at] ^ 4] {
                let mut bytes = original.to_vec();
                bytes[at] = value;
                judge(&bytes);
            }
        }
        assert!(
            f64::from(errors) > share * f64::from(all) && (changed > 2 || part == "map.shx"),
            "{part}: {errors}, {changed} of {all}"
        );
    }
}

/// Collections in collections, in each format that nests them.
#[test]
fn nesting_has_a_bound() {
    let binary = |depth: usize| [[1, 7, 0, 0, 0, 1, 0, 0, 0].repeat(depth), vec![1, 7, 0, 0, 0, 0, 0, 0, 0]].concat();
    let topojson = |depth: usize| {
        let (open, close) = (r#"{"type":"GeometryCollection","geometries":["#.repeat(depth), "]}".repeat(depth));
        let text = format!(r#"{{"type":"Topology","arcs":[],"objects":{{"a":{open}{{"type":null}}{close}}}}}"#);
        text.into_bytes()
    };
    // Deeper ones cannot be read from text or binary; these layers are constructed.
    let flatgeobuf = |depth: usize| {
        let mut layer = from_text("POINT(1 2)\n");
        for _ in 0..depth {
            let inner = layer.features[0].geometry.take().unwrap();
            layer.features[0].geometry = Some(Geometry::new(Dimensions::Xy, Shape::Collection(vec![inner])));
        }
        let mut bytes = Vec::new();
        write(&layer, &mut bytes, Format::FlatGeobuf).unwrap();
        bytes
    };
    // The outermost collection of TopoJSON is the layer.
    for right in [binary(31), topojson(33), flatgeobuf(20), flatgeobuf(32)] {
        assert!(from_bytes(&right).is_ok());
    }
    for wrong in [binary(100_000), topojson(34)] {
        assert!(matches!(from_bytes(&wrong), Err(ReadError::Content { cause: Cause::TooDeep, .. })));
    }
    assert!(matches!(from_bytes(&flatgeobuf(100)), Err(ReadError::Content { .. })));
    assert!(from_bytes(&topojson(100_000)).unwrap_err().to_string().contains("recursion limit"));
}
