//! Reading any format: recognizing the format, errors for unreadable content, and dropped parts.

use std::io::{self, Read};

use twinedge_geometry::Point;
use twinedge_layers::io::geojson::{Documents, read_parts};
use twinedge_layers::io::{ForeignFormat, Format, ReadCause, ReadError as TextError, ReadSummary, TextPlace, wkt};
use twinedge_layers::{ReadError, ReadOptions, format_of, read_for_map};
use twinedge_map::{Feature, Shape};

fn all(text: impl AsRef<[u8]>, format: Option<Format>) -> Result<(Vec<Feature>, ReadSummary), ReadError> {
    read_for_map(&mut text.as_ref(), &ReadOptions { format, ..ReadOptions::default() })
}

const POINT: &str = r#"{"type":"Point","coordinates":[1,2]}"#;

// -------------------------------------------------------------------------------------------- recognizing the format

#[test]
fn the_extension_tells_the_format() {
    for (name, format) in [
        ("a.geojson", Some(Format::GeoJson)),
        ("/maps/A.GeoJSON", Some(Format::GeoJson)),
        ("a.geojsonl", Some(Format::GeoJsonSeq)),
        ("a.geojsons", Some(Format::GeoJsonSeq)),
        ("a.ndjson", Some(Format::GeoJsonSeq)),
        ("a.wkt", Some(Format::Wkt)),
        // This could be anything.
        ("a.json", None),
        ("a.txt", None),
        ("a.geojson.gz", None),
        ("geojson", None),
        ("", None),
    ] {
        assert_eq!(Format::of_path(name), format, "{name}");
    }
    // The registry lists the formats in the order of the variants.
    for (format, extension) in
        Format::ALL.into_iter().zip(["geojson", "geojsonl", "wkt", "wkb", "shp", "gpkg", "topojson", "fgb", "parquet"])
    {
        assert_eq!(Format::of_path(format!("a.{extension}")), Some(format));
        assert!(!format.to_string().is_empty() && !format.feature().is_empty());
    }
}

#[test]
fn the_content_tells_the_format() {
    let two = format!("{POINT}\n{POINT}");
    let nested = r#"{"type":"Feature","properties":{"a":"{\"}","b":[{}]},"geometry":null}"#;
    for (text, format) in [
        (POINT, Some(Format::GeoJson)),
        (&format!("\u{FEFF} \n{POINT}\n"), Some(Format::GeoJson)),
        (nested, Some(Format::GeoJson)),
        (&format!("{nested} {nested}"), Some(Format::GeoJsonSeq)),
        (&format!("{nested}x"), Some(Format::GeoJson)),
        (&two, Some(Format::GeoJsonSeq)),
        (&two[..40], Some(Format::GeoJsonSeq)),
        (&two[..30], Some(Format::GeoJson)),
        ("\u{1E}{", Some(Format::GeoJsonSeq)),
        ("[1]", Some(Format::GeoJson)),
        ("point(1 2)", Some(Format::Wkt)),
        ("LINESTRINGZM EMPTY", Some(Format::Wkt)),
        ("SRID=4326;POINT(1 2)", Some(Format::Wkt)),
        ("# a comment", Some(Format::Wkt)),
        ("POINTS(1 2)", None),
        ("name,wkt\n", None),
        ("", None),
        (" \n", None),
    ] {
        assert_eq!(Format::of_content(text.as_bytes()), format, "{text}");
    }
}

#[test]
fn a_map_longer_than_what_is_looked_at() {
    let text = POINT.to_owned() + &"\n".repeat(100_000) + POINT;
    assert_eq!(all(&text, Some(Format::GeoJsonSeq)).unwrap().0.len(), 2);
    assert_eq!(all("POINT(1 2)\n".repeat(10_000), None).unwrap().0.len(), 10_000);
}

#[test]
fn each_format_is_read() {
    let point = Shape::Point(Point::new(1.0, 2.0));
    let two = format!("{POINT}\n{POINT}");
    for (text, format, count) in [
        (POINT, Format::GeoJson, 1),
        (&two, Format::GeoJsonSeq, 2),
        ("POINT(1 2)\nPOINT(1 2)", Format::Wkt, 2),
        ("0101000000000000000000F03F0000000000000040", Format::Wkb, 1),
    ] {
        for given in [None, Some(format)] {
            let (features, summary) = all(text, given).unwrap();
            assert_eq!((features.len(), summary.points), (count, count), "{text}");
            assert!(features.iter().all(|feature| feature.shapes == [point.clone()]), "{text}");
        }
    }
    // Sequences are often named like single objects.
    assert_eq!(all(&two, Some(Format::GeoJson)).unwrap().0.len(), 2);
    // A given format takes precedence over the content.
    assert!(
        matches!(all(POINT, Some(Format::Wkt)), Err(ReadError::Text(error)) if matches!(error.cause, ReadCause::Syntax { .. }))
    );
}

// ---------------------------------------------------------------------------- what GeoJSON and text have in common

/// Returns the features of the geometry as GeoJSON, whose beginning is left out, and as well-known text.
fn in_both(geojson: &str, wkt: &str) -> [(Vec<Feature>, ReadSummary); 2] {
    let geojson = format!("{{\"type\":{geojson}}}");
    [(&*geojson, Format::GeoJson), (wkt, Format::Wkt)].map(|(text, format)| all(text, Some(format)).unwrap())
}

#[test]
fn every_kind_of_geometry() {
    let p = |x, y| Shape::Point(Point { x, y });
    let line = |points: &[[f64; 2]]| points.iter().map(|&point| point.into()).collect::<Vec<Point>>();
    let long = Shape::Line(line(&[[1.0, 2.0], [3.0, 4.0]]));
    let outer = line(&[[0.0, 0.0], [9.0, 0.0], [0.0, 9.0], [0.0, 0.0]]);
    let hole = line(&[[1.0, 1.0], [1.0, 2.0], [2.0, 1.0]]);
    let polygon = Shape::Polygon(vec![outer, hole.clone()]);
    for (geojson, wkt, expected) in [
        (r#""Point","coordinates":[1,-2.5]"#, "POINT (1 -2.5)", vec![p(1.0, -2.5)]),
        (r#""MultiPoint","coordinates":[[1,2],[3,4]]"#, "multipoint((1 2),(3 4))", vec![p(1.0, 2.0), p(3.0, 4.0)]),
        (r#""MultiPoint","coordinates":[[1,2],[3e0,0.4]]"#, "MULTIPOINT(1 2,+3e0 .4)", vec![p(1.0, 2.0), p(3.0, 0.4)]),
        (r#""LineString","coordinates":[[1,2],[3,4]]"#, "LineString(1 2,3 4)", vec![long.clone()]),
        (
            r#""MultiLineString","coordinates":[[[1,2],[3,4]],[[5,6]]]"#,
            "MULTILINESTRING((1 2,3 4),(5 6))",
            vec![long, Shape::Line(line(&[[5.0, 6.0]]))],
        ),
        (
            r#""Polygon","coordinates":[[[0,0],[9,0],[0,9],[0,0]],[[1,1],[1,2],[2,1]]]"#,
            "POLYGON((0 0,9 0,0 9,0 0),(1 1,1 2,2 1))",
            vec![polygon.clone()],
        ),
        (
            r#""MultiPolygon","coordinates":[[[[1,1],[1,2],[2,1]]],[[[0,0],[9,0],[0,9],[0,0]],[[1,1],[1,2],[2,1]]]]"#,
            "MULTIPOLYGON(((1 1,1 2,2 1)),((0 0,9 0,0 9,0 0),(1 1,1 2,2 1)))",
            vec![Shape::Polygon(vec![hole]), polygon],
        ),
        (
            r#""GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]},
                {"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[3,4]}]}]"#,
            "GEOMETRYCOLLECTION(POINT(1 2),GEOMETRYCOLLECTION(POINT(3 4)))",
            vec![p(1.0, 2.0), p(3.0, 4.0)],
        ),
    ] {
        for (features, _) in in_both(geojson, wkt) {
            assert_eq!(features, [Feature { shapes: expected.clone(), ..Feature::default() }], "{wkt}");
        }
    }
}

#[test]
fn geometries_that_draw_nothing() {
    for (geojson, wkt) in [
        (r#""Feature","geometry":null"#, "POINT EMPTY"),
        (r#""Feature""#, "point z empty"),
        (r#""MultiPoint","coordinates":[]"#, "MULTIPOINT EMPTY"),
        (r#""LineString","coordinates":[]"#, "LINESTRING EMPTY"),
        (r#""MultiLineString","coordinates":[[],[]]"#, "MULTILINESTRING(EMPTY,EMPTY)"),
        (r#""Polygon","coordinates":[]"#, "POLYGON EMPTY"),
        (r#""MultiPolygon","coordinates":[]"#, "MULTIPOLYGON(EMPTY)"),
        (r#""GeometryCollection","geometries":[]"#, "GEOMETRYCOLLECTION EMPTY"),
        (r#""FeatureCollection","features":[{"type":"Feature"}]"#, "GEOMETRYCOLLECTION(POINT EMPTY)"),
    ] {
        for (features, summary) in in_both(geojson, wkt) {
            assert_eq!(features, [Feature::default()], "{wkt}");
            assert_eq!((summary.features, summary.without_geometry, summary.positions), (1, 1, 0), "{wkt}");
        }
    }
}

#[test]
fn extra_dimensions_are_dropped_and_counted() {
    let geojson = r#""LineString","coordinates":[[1,2,7],[3,4,7,8]]"#;
    for wkt in ["LINESTRING Z(1 2 7,3 4 7)", "LINESTRINGM(1 2 7,3 4 7)", "LINESTRING ZM (1 2 7 8,3 4 7 8)"] {
        for (features, summary) in in_both(geojson, wkt) {
            let line = vec![Point::new(1.0, 2.0), Point::new(3.0, 4.0)];
            assert_eq!(features[0].shapes, [Shape::Line(line)], "{wkt}");
            assert_eq!((summary.positions, summary.with_extra_dimensions), (2, 2), "{wkt}");
        }
    }
    let (_, summary) = all(r#"{"type":"MultiPoint","coordinates":[[1,2],[3,4,5],[6,7,8,9],[1,2]]}"#, None).unwrap();
    assert_eq!((summary.points, summary.positions, summary.with_extra_dimensions), (4, 4, 2));
}

#[derive(Debug)]
enum Mine {
    Read(TextError),
    Enough(usize),
}

impl From<TextError> for Mine {
    fn from(error: TextError) -> Self {
        Self::Read(error)
    }
}

#[test]
fn the_callback_can_stop_the_reading() {
    // The text after the second feature is never read.
    let geojson = r#"{"type":"FeatureCollection","features":[{"type":"Feature"},{"type":"Feature"},?"#;
    let text = "POINT(1 2)\nPOINT(1 2)\nnonsense";
    for (is_wkt, place) in [(false, TextPlace { line: 1, column: Some(79) }), (true, TextPlace::line(3))] {
        let stop_at = |limit: usize| {
            let mut count = 0;
            let mut next = || {
                count += 1;
                if count == limit { Err(Mine::Enough(count)) } else { Ok(()) }
            };
            if is_wkt {
                wkt::read_geometries(text.as_bytes(), |_| next())
            } else {
                read_parts(geojson.as_bytes(), Documents::One, |_| next())
            }
        };
        assert!(matches!(stop_at(1), Err(Mine::Enough(1))));
        assert!(matches!(stop_at(2), Err(Mine::Enough(2))));
        assert!(matches!(stop_at(3), Err(Mine::Read(error)) if error.place == place && error.feature.is_none()));
    }
}

// ------------------------------------------------------------------------------------------------------- sequences

fn sequence(text: &str) -> Result<(Vec<Feature>, ReadSummary), TextError> {
    read_parts(text.as_bytes(), Documents::Many, |_| Ok::<_, TextError>(()))?;
    Ok(all(text, Some(Format::GeoJsonSeq)).expect("its parts were read"))
}

#[test]
fn objects_in_a_row_are_read_as_in_a_collection() {
    let features: Vec<String> = (0..5)
        .map(|i| {
            let geometry = format!(r#"{{"type":"Point","coordinates":[{i},0,9]}}"#);
            format!("{{\"type\":\"Feature\",\n\"properties\":{{\"name\":\"{i}\"}},\"geometry\":{geometry}}}")
        })
        .collect();
    let collection = format!(r#"{{"type":"FeatureCollection","features":[{}]}}"#, features.join(","));
    let (expected, summary) = all(&collection, Some(Format::GeoJson)).unwrap();
    let records: String = features.iter().flat_map(|feature| ["\u{1E}", feature, "\n"]).collect();
    for text in [features.join("\n"), features.join(""), features.join("\r\n\r\n"), records, collection] {
        assert_eq!(sequence(&text).unwrap(), (expected.clone(), summary), "{text}");
    }
    assert_eq!(sequence("").unwrap(), (vec![], ReadSummary::default()));
    assert_eq!(sequence("\n \u{1E}\n").unwrap(), (vec![], ReadSummary::default()));
}

#[test]
fn faults_in_a_sequence_have_the_place_and_the_number_in_the_file() {
    let short = r#"{"type":"LineString","coordinates":[[1]]}"#;
    let error = sequence(&format!("{POINT}\n{POINT}\n{short}\n{POINT}")).unwrap_err();
    assert_eq!(error.place, TextPlace { line: 3, column: Some(short.len()) });
    assert_eq!(error.feature, Some(2));
    assert!(matches!(error.cause, ReadCause::ShortPosition { numbers: 1 }));
    for (rest, column) in [("x", 1), ("{\"type\"}", 8), ("]", 1)] {
        let error = sequence(&format!("{POINT}\n{rest}")).unwrap_err();
        assert!(matches!(error.cause, ReadCause::Syntax { .. }), "{rest}: {error:?}");
        assert_eq!(error.place, TextPlace { line: 2, column: Some(column) }, "{rest}");
    }
    let error = sequence(&format!("{POINT}\n{}", &POINT[..20])).unwrap_err();
    assert!(matches!(error.cause, ReadCause::Truncated), "{error:?}");
    let error = sequence(&format!("{POINT}\n{{}}")).unwrap_err();
    assert_eq!(error.to_string(), "line 2, column 2: not GeoJSON: missing field `type`");
}

// ------------------------------------------------------------------------------------------------- unreadable input

/// The first bytes of files of other formats. The binary ones come from the formats' specifications.
#[test]
fn other_formats_are_named() {
    let sqlite = |id: &[u8]| [b"SQLite format 3\0", &[0; 52][..], id].concat();
    let osm = b"\x00\x00\x00\x0E\x0A\x09OSMHeader\x18\x80";
    let utf16: Vec<u8> = "\u{FEFF}{}".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let esri = br#"{"displayFieldName":"x","geometryType":"esriGeometryPolygon","features":[]}"#;
    let gml = br#"<?xml version="1.0"?><wfs:FeatureCollection xmlns:gml="http://www.opengis.net/gml/3.2">"#;
    let kml = br#"<?xml version="1.0"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document>"#;
    let samples: Vec<(Vec<u8>, ForeignFormat)> = vec![
        (sqlite(b"\0\0\0\0"), ForeignFormat::Sqlite),
        (b"ARROW1\x00\x00".to_vec(), ForeignFormat::Arrow),
        (osm.to_vec(), ForeignFormat::OsmPbf),
        (esri.to_vec(), ForeignFormat::EsriJson),
        (kml.to_vec(), ForeignFormat::Kml),
        (gml.to_vec(), ForeignFormat::Gml),
        (b"\xEF\xBB\xBF\n<gpx version=\"1.1\">".to_vec(), ForeignFormat::Gpx),
        (b"<osm version=\"0.6\">".to_vec(), ForeignFormat::OsmXml),
        (b"<!DOCTYPE HTML><title>404".to_vec(), ForeignFormat::Html),
        (b"<svg>".to_vec(), ForeignFormat::Xml),
        (utf16, ForeignFormat::Utf16),
        (b"PK\x03\x04\x14".to_vec(), ForeignFormat::Zip),
        (b"\x1F\x8B\x08".to_vec(), ForeignFormat::Gzip),
        (b"BZh91AY".to_vec(), ForeignFormat::Bzip2),
        (b"\xFD7zXZ\x00".to_vec(), ForeignFormat::Xz),
        (b"\x28\xB5\x2F\xFD".to_vec(), ForeignFormat::Zstd),
    ];
    for (head, expected) in samples {
        for format in [None, Some(Format::GeoJson), Some(Format::Wkt)] {
            let error = format_of(&head, None, &ReadOptions { format, ..ReadOptions::default() }).unwrap_err();
            assert!(matches!(error, ReadError::Foreign(foreign) if foreign == expected), "{expected}: {error:?}");
            let says = error.to_string();
            let parts = [format!("this looks like {expected}, "), expected.advice().to_owned()];
            assert!(says.starts_with(&parts[0]) && says.ends_with(&parts[1]), "{says}");
        }
    }
    let topology: &[u8] = br#"{"objects":{"type":"x"},"type":"Topology","arcs":[]}"#;
    for (head, expected) in [
        (b"\x00\x00\x27\x0A\x00\x00\x00\x00", Format::Shapefile),
        (&sqlite(b"GPKG"), Format::GeoPackage),
        (b"fgb\x03fgb\x00", Format::FlatGeobuf),
        (b"PAR1\x15\x04", Format::GeoParquet),
        (b"\x01\x03\x00\x00\x00\x01", Format::Wkb),
        (b"\x00\x00\x00\x03\xEB\x00", Format::Wkb),
        (b"0103000020E6100000", Format::Wkb),
        (topology, Format::TopoJson),
    ] as [(&[u8], Format); 8]
    {
        for format in [None, Some(Format::GeoJson), Some(Format::Wkt), Some(expected)] {
            let found = format_of(head, None, &ReadOptions { format, ..ReadOptions::default() });
            assert!(found.is_ok_and(|found| found == expected), "{expected}");
        }
    }
    let says = all(b"ARROW1", None).unwrap_err().to_string();
    let expected = "this looks like Arrow, which is not read here: \
        convert it with `ogr2ogr -f GeoJSONSeq map.geojsonl FILE`";
    assert_eq!(says, expected);
}

/// Members of one format do not indicate another one.
#[test]
fn what_is_read_is_not_taken_for_another_format() {
    for text in [
        r#"{"type":"Feature","properties":{"type":"Topology","geometryType":"esriGeometryPoint"},"geometry":null}"#,
        r#"{"type":"Feature","properties":{"a":"\",\"type\":\"Topology\""},"geometry":null}"#,
        "# <kml> PK\nPOINT(1 2)",
        "POINT(1 2)",
        "0.5",
        "",
    ] {
        assert_eq!(ForeignFormat::of_content(text.as_bytes()), None, "{text}");
        assert!(!Format::of_content(text.as_bytes()).is_some_and(Format::is_certain), "{text}");
    }
    assert_eq!(Format::of_content(&[0, 0, 0, 0, 13]), None);
    assert_eq!(Format::of_content(&[2, 1, 0, 0, 0]), None);
}

#[test]
fn nothing_and_anything() {
    for blank in ["", " \n\t", "\u{FEFF}\n"] {
        assert!(matches!(all(blank, None), Err(ReadError::Empty)), "{blank:?}");
    }
    let error = all("id;x;y\n", None).unwrap_err();
    assert!(matches!(error, ReadError::Unrecognised));
    assert_eq!(
        error.to_string(),
        "the format is not recognised: GeoJSON, TopoJSON, well-known text and binary, Shapefiles, GeoPackages, GeoParquet and \
         FlatGeobuf are read; convert others with `ogr2ogr -f GPKG map.gpkg FILE`"
    );
}

struct Broken<'a>(&'a [u8]);

impl Read for Broken<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        match self.0.read(out)? {
            0 => Err(io::Error::new(io::ErrorKind::ConnectionReset, "the line went dead")),
            some => Ok(some),
        }
    }
}

#[test]
fn a_failing_reader() {
    for length in [0, 9, 70_000, 200_000] {
        let text = "#\nPOINT(1 2)".bytes().chain(core::iter::repeat(b' ')).take(length).collect::<Vec<_>>();
        let source = match read_for_map(&mut Broken(&text), &ReadOptions::default()) {
            Err(ReadError::Io(source)) if length < 1 << 16 => source,
            Err(ReadError::Text(TextError {
                place: TextPlace { line: 2, .. }, cause: ReadCause::Io(source), ..
            })) => source,
            other => panic!("{other:?}"),
        };
        assert_eq!(source.kind(), io::ErrorKind::ConnectionReset);
    }
    for (text, expected) in [("", 1), ("POINT(1 2)", 1), ("POINT(1 2)\n", 2), ("\n\nPOIN", 3)] {
        let error = wkt::read_geometries(Broken(text.as_bytes()), |_| Ok::<_, TextError>(())).unwrap_err();
        let ReadCause::Io(source) = error.cause else { panic!("{:?}", error.cause) };
        assert_eq!((error.place, source.kind()), (TextPlace::line(expected), io::ErrorKind::ConnectionReset), "{text}");
    }
}

// ----------------------------------------------------------------------------------------------------- dropped parts

#[test]
fn what_is_dropped_is_counted() {
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"name":"a","b":1,"c":{"d":2}},
         "geometry":{"type":"MultiLineString","coordinates":[[],[[1,2,3],[4,5]],[]]}},
        {"type":"Feature","properties":{"b":1},"geometry":{"type":"Polygon","coordinates":[]}},
        {"type":"Feature","properties":null,"geometry":null}]}"#;
    let (_, summary) = all(text, None).unwrap();
    assert_eq!((summary.features, summary.without_geometry, summary.positions), (3, 2, 2));
    assert_eq!((summary.with_extra_dimensions, summary.dropped_properties, summary.dropped_empty), (1, 3, 3));
    let text = "POINT EMPTY\nPOLYGON EMPTY\nMULTILINESTRING(EMPTY,(1 2,3 4))\nMULTIPOINT EMPTY";
    let (_, summary) = all(text, None).unwrap();
    assert_eq!((summary.features, summary.without_geometry, summary.dropped_empty), (4, 3, 3));
    assert_eq!((summary.dropped_properties, summary.with_extra_dimensions), (0, 0));
}
