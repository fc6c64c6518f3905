//! Shapefiles from other programs: character sets, rings in any order, deleted records.

use crate::support::{from_text, read, scratch, through};
use std::fs;
use std::path::Path;
use twinedge_layers::{Cause, Crs, Format, Layer, Line, ReadError, Shape, Value, write_path};

/// A table with the column `name`, 8 bytes wide, and these records with their marks.
fn table(records: &[&[u8; 9]], charset_mark: u8) -> Vec<u8> {
    let mut bytes = vec![3, 95, 7, 26];
    bytes.extend((records.len() as u32).to_le_bytes());
    bytes.extend(65_u16.to_le_bytes());
    bytes.extend(9_u16.to_le_bytes());
    bytes.resize(29, 0);
    bytes.extend([charset_mark, 0, 0]);
    bytes.extend(b"name\0\0\0\0\0\0\0C\0\0\0\0\x08");
    bytes.resize(64, 0);
    bytes.push(0x0D);
    for record in records {
        bytes.extend(*record);
    }
    bytes
}

/// Reads two points with this table.
fn points(folder: &Path, table: &[u8]) -> Result<Vec<Option<String>>, ReadError> {
    let path = folder.join("points.shp");
    write_path(&from_text("POINT(1 2)\nPOINT(3 4)\n"), &path, Format::Shapefile).unwrap();
    fs::remove_file(path.with_extension("cpg")).unwrap();
    fs::write(path.with_extension("dbf"), table).unwrap();
    Ok(read(&path)?.features.iter().map(|feature| feature.get("name").and_then(Value::text)).collect())
}

#[test]
fn character_sets_are_those_that_are_named() {
    let (folder, path) = scratch("points.cpg");
    let folder = folder.path();
    let some = |text: &str| Some(text.to_owned());
    // Windows-1252 by its mark; without a mark, UTF-8 if the bytes are valid.
    assert_eq!(points(folder, &table(&[b" Z\xFCrich  ", b"         "], 0x57)).unwrap(), [some("Zürich"), None]);
    assert_eq!(
        points(folder, &table(&[b" Z\xC3\xBCrich ", b" Z\xFCrich  "], 0)).unwrap(),
        [some("Zürich"), some("Zürich")]
    );
    // The code page file takes precedence over the mark.
    fs::write(&path, "CP1251").unwrap();
    let bytes = table(&[b" \xCC\xEE\xF1\xEA\xE2\xE0  ", b"         "], 0x57);
    let shp = folder.join("points.shp");
    fs::write(shp.with_extension("dbf"), bytes).unwrap();
    assert_eq!(read(&shp).unwrap().features[0].get("name").and_then(Value::text), some("Москва"));
}

/// A record of 8 bytes that is not marked as deleted.
fn record(bytes: &[u8]) -> [u8; 9] {
    let mut record = [b' '; 9];
    record[1..=bytes.len()].copy_from_slice(bytes);
    record
}

#[test]
fn character_sets_have_many_names() {
    // The bytes were computed by Python's codecs.
    for (labels, bytes, text) in [
        (&["CP932", "932", "MS932", "Shift_JIS"][..], &b"\x93\x8C\x8B\x9E\x93\x73"[..], "東京都"),
        (&["CP936", "936", "GBK", "ANSI 936"][..], &b"\xB1\xB1\xBE\xA9\xCA\xD0"[..], "北京市"),
        (&["950", "CP950", "Big5"][..], &b"\xBB\x4F\xA5\x5F\xA5\xAB"[..], "臺北市"),
        (&["CP949", "949"][..], &b"\xBC\xAD\xBF\xEF\xBD\xC3"[..], "서울시"),
        (&["CP437", "437", "OEM 437"][..], &b"\x5A\x81\x72\x69\x63\x68\xAB"[..], "Zürich½"),
        (&["CP850", "850", "OEM 850"][..], &b"\x92\x72\x9B\x73\x6B\x9B\x62"[..], "Ærøskøb"),
        (&["OEM 866", "CP866", "866"][..], &b"\x8C\xAE\xE1\xAA\xA2\xA0"[..], "Москва"),
        (&["ISO 8859-2", "8859-2", "ISO-8859-2", "ISO88592", "88592"][..], &b"\xA3\xF3\x64\xBC"[..], "Łódź"),
        (&["ANSI 1252", "1252", "ISO 88591"][..], &b"\x5A\xFC\x72\x69\x63\x68"[..], "Zürich"),
        (&["UTF-8", "UTF8", "65001"][..], &b"\x5A\xC3\xBC\x72\x69\x63\x68"[..], "Zürich"),
    ] {
        for label in labels {
            let (folder, cpg) = scratch("points.cpg");
            points(folder.path(), &table(&[&record(bytes), &record(b"")], 0)).unwrap();
            std::fs::write(&cpg, label).unwrap();
            let layer = read(&cpg.with_extension("shp")).unwrap_or_else(|error| panic!("{label}: {error}"));
            assert_eq!(layer.features[0].get("name").and_then(Value::text).as_deref(), Some(text), "{label}");
        }
    }
}

#[test]
fn marks_of_tables_name_code_pages() {
    let (folder, _) = scratch("");
    for (mark, bytes, text) in
        [(0x01, &b"Z\x81rich"[..], "Zürich"), (0x4F, b"\xBB\x4F\xA5\x5F", "臺北"), (0x64, b"\x9D\xA2d\xAB", "Łódź")]
    {
        let found = points(folder.path(), &table(&[&record(bytes), &record(b"")], mark)).unwrap();
        assert_eq!(found[0].as_deref(), Some(text), "{mark}");
    }
}

#[test]
fn an_unknown_character_set_is_no_guess() {
    let (folder, cpg) = scratch("points.cpg");
    let with = |label: &str, bytes: &[u8], mark: u8| {
        points(folder.path(), &table(&[&record(bytes), &record(b"")], mark)).unwrap_or_default();
        fs::write(&cpg, label).unwrap();
        read(&cpg.with_extension("shp"))
    };
    let unknown = |outcome: Result<Layer, ReadError>, name: &str| match outcome {
        Err(ReadError::Content { cause: Cause::UnknownCharset(found), .. }) => assert_eq!(found, name),
        other => panic!("{other:?}"),
    };
    unknown(with("KLINGON", b"Z\xFCrich", 0), "KLINGON");
    unknown(with("", b"Z\xFCrich", 0x68), "language driver 0x68");
    // All known character sets agree on ASCII.
    assert!(with("KLINGON", b"Bern", 0).is_ok());
}

#[test]
fn deleted_records_are_left_out_with_their_shapes() {
    let (folder, _) = scratch("");
    assert_eq!(points(folder.path(), &table(&[b"*gone    ", b" here    "], 0)).unwrap(), [Some("here".to_owned())]);
}

#[test]
fn a_table_with_other_records_than_shapes_is_refused() {
    let (folder, _) = scratch("");
    for records in [&[b" a       "][..], &[b" a       ", b" b       ", b" c       "]] {
        assert!(matches!(points(folder.path(), &table(records, 0)), Err(ReadError::Content { .. })));
    }
}

#[test]
fn a_shapefile_needs_no_table_and_no_index() {
    let (_folder, path) = scratch("points.shp");
    write_path(&from_text("POINT(1 2)\nPOINT(3 4)\n"), &path, Format::Shapefile).unwrap();
    fs::remove_file(path.with_extension("dbf")).unwrap();
    fs::remove_file(path.with_extension("shx")).unwrap();
    assert_eq!(read(&path).unwrap().features.len(), 2);
}

fn ring_count(text: &str) -> Vec<usize> {
    let layer = through(&from_text(text), Format::Shapefile);
    match &layer.features[0].geometry.as_ref().unwrap().shape {
        Shape::Polygon(rings) => vec![rings.len()],
        Shape::MultiPolygon(polygons) => polygons.iter().map(Vec::<Line>::len).collect(),
        other => panic!("{}", other.name()),
    }
}

#[test]
fn holes_go_to_the_smallest_polygon_around_them() {
    // A polygon with a hole that contains an island with a hole, and another polygon.
    let text = "MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0),(1 1,1 8,8 8,8 1,1 1)),((20 0,21 0,21 1,20 0)),\
((2 2,7 2,7 7,2 7,2 2),(3 3,3 6,6 6,6 3,3 3)))\n";
    assert_eq!(ring_count(text), [2, 1, 2]);
    // A hole that touches its polygon at its first point.
    assert_eq!(ring_count("MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0),(0 0,1 2,2 1,0 0)),((20 0,21 0,21 1,20 0)))\n"), [2, 1]);
}

#[test]
fn rings_turn_as_a_shapefile_wants_it() {
    let layer = through(&from_text("POLYGON((0 0,9 0,9 9,0 9,0 0))\n"), Format::Shapefile);
    let Shape::Polygon(rings) = &layer.features[0].geometry.as_ref().unwrap().shape else { panic!("a polygon") };
    // Clockwise in the file, and reversed on reading, with the same first point.
    assert_eq!(rings[0].iter().map(|p| (p.x, p.y)).collect::<Vec<_>>()[..2], [(0.0, 0.0), (9.0, 0.0)]);
    let (_folder, path) = scratch("square.shp");
    write_path(&layer, &path, Format::Shapefile).unwrap();
    let bytes = fs::read(&path).unwrap();
    // The second point of the only record: after two headers, the type, the box, two counts and the start of the ring.
    let second = 100 + 8 + 4 + 32 + 8 + 4 + 16;
    let [x, y] = [0, 8].map(|at| f64::from_le_bytes(bytes[second + at..][..8].try_into().unwrap()));
    assert_eq!((x, y), (0.0, 9.0));
}

/// The areas of these rings overflow, or vanish by rounding of sums.
#[test]
fn rings_of_any_size_keep_their_direction() {
    for text in [
        "POLYGON((0 0,1e265 0,1e265 1e224,0 1e224,0 0))",
        "POLYGON((0 0,0 1e224,1e265 1e224,1e265 0,0 0))",
        "POLYGON((-1e308 -1e308,1e308 -1e308,1e308 1e308,-1e308 1e308,-1e308 -1e308))",
        "POLYGON((1e265 1,1e265 -1e224,0 1e224,3e265 7,1e265 1))",
        "POLYGON((0.1 0.1,0.2 0.2,0.3 0.3,0.7 0.7,0.1 0.1))",
        "POLYGON((0 0,1e265 1e224,0 0))",
    ] {
        let once = through(&from_text(text), Format::Shapefile);
        let twice = through(&once, Format::Shapefile);
        assert_eq!(once.features, twice.features, "{text}");
    }
    let square = "POLYGON((0 0,1e265 0,1e265 1e224,0 1e224,0 0))";
    let (square, again) = (from_text(square), through(&from_text(square), Format::Shapefile));
    assert_eq!(again.features[0].geometry, square.features[0].geometry);
}

#[test]
fn a_ring_whose_first_point_has_no_measure_is_closed_once() {
    let layer = from_text("POLYGON M((0 0 -nan,1 0 1,1 1 1,0 0 -nan))");
    let again = through(&layer, Format::Shapefile);
    let Shape::Polygon(rings) = &again.features[0].geometry.as_ref().unwrap().shape else { panic!("a polygon") };
    assert_eq!(rings[0].len(), 4);
}

/// GDAL wrote more digits of the flattening than Esri, and before version 3 fewer of the degree.
#[test]
fn definitions_with_other_digits_are_those_of_the_epsg() {
    let nad27 = |flattening: &str, degree: &str| {
        format!(
            "GEOGCS[\"GCS_North_American_1927\",DATUM[\"D_North_American_1927\",SPHEROID[\"Clarke_1866\",6378206.4,{flattening}]],PRIMEM[\"Greenwich\",0],UNIT[\"Degree\",{degree}]]"
        )
    };
    let code = |wkt: String| Crs::of_wkt(wkt).code;
    for flattening in ["294.9786982", "294.9786982138982", "294.978698213898"] {
        assert_eq!(code(nad27(flattening, "0.017453292519943295")), Some(("EPSG".into(), 4267)), "{flattening}");
    }
    assert_eq!(code(nad27("294.97870", "0.017453292519943295")), None);
}
