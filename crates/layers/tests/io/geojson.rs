//! Input that `io::geojson` accepts or refuses, and the place of each error.

use std::error::Error;
use std::io::{self, Read};

use crate::read_geojson as read;
use twinedge_geometry::Point;
use twinedge_layers::io::geojson::{Documents, Part, read_parts};
use twinedge_layers::io::{MAX_NESTED_COLLECTIONS, ReadCause, ReadError, TextPlace};
use twinedge_map::{Feature, Shape};

fn shapes(text: &str) -> Vec<Shape> {
    let (features, _) = read(text).unwrap();
    assert_eq!(features.len(), 1);
    features.into_iter().next().unwrap().shapes
}

fn line(points: &[[f64; 2]]) -> Vec<Point> {
    points.iter().map(|&point| point.into()).collect()
}

fn at(line: usize, column: usize) -> TextPlace {
    TextPlace { line, column: Some(column) }
}

/// Returns true if the error is at this place and concerns no feature.
fn is_at(error: &ReadError, place: TextPlace) -> bool {
    error.place == place && error.feature.is_none()
}

// --------------------------------------------------------------------------------------------------- accepted input

#[test]
fn members_may_come_in_any_order() {
    let polygon = [Shape::Polygon(vec![line(&[[1.0, 2.0]]), vec![], line(&[[3.0, 4.0]])])];
    assert_eq!(shapes(r#"{"coordinates":[[[1,2]],[],[[3,4]]],"type":"Polygon"}"#), polygon);
    let with_empty_ring = [Shape::Polygon(vec![line(&[[1.0, 2.0]]), vec![]])];
    assert_eq!(shapes(r#"{"coordinates":[[[[1,2]],[]],[]],"type":"MultiPolygon"}"#), with_empty_ring);
    let collection = r#"{"properties":{"name":"of the collection"},"coordinates":[1,2,3],"features":[
        {"geometry":{"coordinates":[[[1,2]],[],[[3,4]]],"type":"Polygon"},"id":"a","type":"Feature"}
        ],"bbox":[1,2,3,4],"type":"FeatureCollection"}"#;
    let (features, summary) = read(collection).unwrap();
    assert_eq!(features, [Feature { name: None, id: Some("a".into()), shapes: polygon.to_vec() }]);
    assert_eq!((summary.features, summary.polygons, summary.positions), (1, 1, 2));
    assert_eq!(summary.with_extra_dimensions, 0);
}

#[test]
fn foreign_members_are_skipped_whatever_they_hold() {
    let deep = "[".repeat(100) + &"]".repeat(100);
    let text = format!(
        r#"{{"bbox":[[[]]],"crs":{{"type":7,"features":[1]}},"deep":{deep},"type":"Feature",
            "geometry":{{"bbox":null,"type":"Point","foreign":[3],"coordinates":[1,2]}},"properties":{{"x":{{}}}}}}"#
    );
    assert_eq!(shapes(&text), [Shape::Point(Point { x: 1.0, y: 2.0 })]);
}

#[test]
fn names_are_taken_from_properties() {
    let name = |properties: &str| {
        let text = format!(r#"{{"type":"Feature","geometry":null,"id":"not this","properties":{properties}}}"#);
        read(text).unwrap().0.remove(0).name
    };
    let keys = ["name", "NAME", "Name", "ADMIN", "admin", "title", "id"];
    for first in 0..keys.len() {
        // The members are in reverse, to show that rank counts and not order.
        let members: Vec<_> = keys[first..].iter().rev().map(|key| format!(r#""{key}":"{key}!""#)).collect();
        assert_eq!(name(&format!("{{{}}}", members.join(","))), Some(format!("{}!", keys[first])));
    }
    assert_eq!(name(r#"{"name":null,"NAME":true,"Name":{"x":1},"ADMIN":["y"],"admin":17}"#), Some("17".into()));
    assert_eq!(name(r#"{"name":"a","NAME":"b","name":"c"}"#), Some("c".into()));
    assert_eq!(name(r#"{"name":1.50}"#), Some("1.5".into()));
    assert_eq!(name(r#"{"name":-3}"#), Some("-3".into()));
    assert_eq!(name(r#"{"name":"\u00c5land \"\ud83d\ude00\""}"#), Some("Åland \"😀\"".into()));
    for none in ["{}", "null", r#"{"NaMe":"x"}"#] {
        assert_eq!(name(none), None);
    }
}

#[test]
fn a_name_does_not_leak_into_the_next_feature() {
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","id":7,"properties":{"name":"a"},"geometry":null},{"type":"Feature","geometry":null}]}"#;
    let (features, _) = read(text).unwrap();
    assert_eq!(features[0], Feature { name: Some("a".into()), id: Some("7".into()), shapes: vec![] });
    assert_eq!(features[1], Feature::default());
}

#[test]
fn a_byte_order_mark_is_skipped_and_not_counted() {
    let good = r#"{"type":"Point","coordinates":[1,2]}"#;
    assert_eq!(read(format!("\u{FEFF}{good}")).unwrap(), read(good).unwrap());
    let error = |text: &[u8], place| {
        let error = read(text).unwrap_err();
        assert!(is_at(&error, place), "{error:?}");
        error.cause
    };
    assert!(matches!(error("\u{FEFF}[".as_bytes(), at(1, 1)), ReadCause::Malformed { .. }));
    assert!(matches!(error("\u{FEFF}\n ".as_bytes(), at(2, 1)), ReadCause::Empty));
    assert!(matches!(error("\u{FEFF}\u{FEFF}{}".as_bytes(), at(1, 1)), ReadCause::Syntax { .. }));
    assert!(matches!(error(b"\xEF{}", at(1, 1)), ReadCause::Syntax { .. }));
}

#[test]
fn numbers_are_read_to_the_last_bit() {
    // With the default settings of serde_json, the first one is too large by one unit in the last place.
    for digits in ["31.245270191439438", "121.48791951161945", "9007199254740993", "-1.7976931348623157e308", "5e-324"]
    {
        let expected = Shape::Point(Point { x: digits.parse().unwrap(), y: 0.0 });
        assert_eq!(shapes(&format!(r#"{{"type":"Point","coordinates":[{digits},0]}}"#)), [expected]);
    }
}

/// The countries of the world, with figures counted outside of this crate (see `crates/cli/data`).
#[test]
fn the_world() {
    let (features, summary) = read(include_bytes!("../../../cli/data/world-110m.geojson")).unwrap();
    assert_eq!((features.len(), summary.features, summary.polygons), (177, 177, 285));
    assert_eq!((summary.positions, summary.with_extra_dimensions, summary.without_geometry), (10_596, 0, 0));
    assert_eq!((features[0].name.as_deref(), features[0].id.as_deref()), (Some("Fiji"), Some("242")));
    assert_eq!((features[176].name.as_deref(), features[176].id.as_deref()), (Some("S. Sudan"), Some("728")));
    let south_africa = features.iter().find(|feature| feature.name.as_deref() == Some("South Africa")).unwrap();
    let [Shape::Polygon(rings)] = &south_africa.shapes[..] else { panic!("South Africa is one polygon") };
    assert_eq!(rings.len(), 2);
}

// ---------------------------------------------------------------------------------------------------- refused input

#[test]
fn empty() {
    for (text, place) in [("", at(1, 0)), (" \t\r\n\n  ", at(3, 2)), ("\u{FEFF}", at(1, 0))] {
        let error = read(text).unwrap_err();
        assert!(matches!(error.cause, ReadCause::Empty) && is_at(&error, place), "{text:?}: {error:?}");
        let read_some = place != at(1, 0);
        assert_eq!(
            error.to_string(),
            ["the input is empty", "line 3, column 2: the input is empty"][usize::from(read_some)]
        );
    }
}

/// Every proper prefix of a document is reported as too short, at its end.
#[test]
fn truncated_anywhere() {
    let text = r#" {"type":"FeatureCollection", "bbox":[-1.5e2, 0, 1, true, false, null],
        "features":[{"type":"Feature","id":1,"properties":{"name":"a\u00e9\ud83d\ude00b","x":{"y":[]}},
        "geometry":{"type":"Polygon","coordinates":[[[0,0],[1.25e-1,0,7],[0,-1],[0,0]]]}}, {"type":"Feature",
        "geometry":{"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]}]}}]}"#;
    assert_eq!(read(text).unwrap().0.len(), 2);
    for end in 2..text.len() {
        let start = &text[..end];
        let error = read(start).unwrap_err();
        let line = start.matches('\n').count() + 1;
        let column = start.len() - start.rfind('\n').map_or(0, |newline| newline + 1);
        assert!(matches!(error.cause, ReadCause::Truncated) && is_at(&error, at(line, column)), "{start}: {error:?}");
    }
}

#[test]
fn syntax() {
    for (text, place) in [
        ("geojson", at(1, 1)),
        ("{\"type\":\n \"Point\", coordinates:[1,2]}", at(2, 11)),
        ("{\"type\":\"Point\",\"coordinates\":[1,2,]}", at(1, 36)),
        ("{\"type\":\"Point\",\"coordinates\":[1,02]}", at(1, 35)),
        ("{\"type\":\"Point\",\"coordinates\":[1,NaN]}", at(1, 34)),
        ("{\"type\":\"FeatureCollection\",\"features\":[\n{\"type\":\"Feature\"}\n{}]}", at(3, 1)),
        ("{\"foreign\":[1 2]}", at(1, 15)),
        // `serde_json` takes this for a syntax error.
        ("{\"type\":null}", at(1, 9)),
        ("{\"type\":\"FeatureCollection\",\"features\":[{\"id\":-x}", at(1, 48)),
    ] {
        let error = read(text).unwrap_err();
        assert!(matches!(error.cause, ReadCause::Syntax { .. }) && is_at(&error, place), "{text}: {error:?}");
    }
    let error = read("{\"type\" \"Point\"}").unwrap_err();
    assert_eq!(error.to_string(), "line 1, column 9: syntax error: expected `:`");
}

#[test]
fn trailing() {
    let point = r#"{"type":"Point","coordinates":[1,2]}"#;
    assert!(read(format!("{point} \n\t ")).is_ok());
    for (rest, place) in [("x", at(1, 37)), ("\n  {}", at(2, 3)), (",", at(1, 37)), ("\0", at(1, 37))] {
        let error = read(format!("{point}{rest}")).unwrap_err();
        assert!(matches!(error.cause, ReadCause::Trailing { .. }) && is_at(&error, place), "{rest:?}: {error:?}");
    }
}

/// A reader that returns a text, fails, and then continues with another text.
struct Failing<'a> {
    before: &'a [u8],
    failed: bool,
    after: &'a [u8],
}

impl Read for Failing<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        if !self.before.is_empty() {
            return self.before.read(out);
        }
        if !self.failed {
            self.failed = true;
            return Err(io::Error::new(io::ErrorKind::ConnectionReset, "the line went dead"));
        }
        self.after.read(out)
    }
}

#[test]
fn io_errors() {
    let text = b"{\"type\":\n\"Point\",\"coordinates\":[1,2]}";
    for (end, place) in [(0, at(1, 0)), (9, at(2, 0)), (20, at(2, 11)), (text.len(), at(2, text.len() - 9))] {
        // Text that could be read after the failure makes no difference.
        for after in [&b""[..], b"]}", b"}", &text[end..]] {
            let reader = Failing { before: &text[..end], failed: false, after };
            let error = read_parts(reader, Documents::One, |_| Ok::<_, ReadError>(())).unwrap_err();
            let read_some = if end > 0 { format!("{place}: ") } else { String::new() };
            assert_eq!(error.to_string(), format!("{read_some}the line went dead"));
            assert!(is_at(&error, place) && error.source().is_some(), "{error:?}");
            let ReadCause::Io(source) = error.cause else { panic!("{:?}", error.cause) };
            assert_eq!(source.kind(), io::ErrorKind::ConnectionReset);
            assert_eq!(source.to_string(), "the line went dead");
        }
    }
}

/// The outermost object is invalid. The messages are those of the `geojson` crate.
#[test]
fn not_geojson() {
    for (text, place, says) in [
        ("[1,[2]]", at(1, 1), "expected a GeoJSON object"),
        ("\n null", at(2, 5), "expected a GeoJSON object"),
        ("\"Point\"", at(1, 7), "expected a GeoJSON object"),
        ("{}", at(1, 2), "missing field `type`"),
        (" {\"features\":[]\n}", at(2, 1), "missing field `type`"),
        ("{\"type\":\"Topology\",\"objects\":{}}", at(1, 18), "unknown variant `Topology`"),
        ("{\"type\":\"FeatureCollection\"}", at(1, 28), "missing field `features`"),
        ("{\"type\":\"FeatureCollection\",\"features\":{}}", at(1, 40), "expected an array of features"),
        ("{\"features\":[],\"features\":[]}", at(1, 26), "duplicate field `features`"),
        ("{\"features\":[],\"type\":\"Feature\"}", at(1, 32), "type `FeatureCollection`, found `Feature`"),
        ("{\"type\":\"Point\"}", at(1, 16), "no `coordinates` key"),
        ("{\"type\":\"Point\",\"coordinates\":[1]}", at(1, 34), "two or more elements"),
    ] {
        let error = read(text).unwrap_err();
        let ReadCause::Malformed { message } = &error.cause else { panic!("{text}: {error:?}") };
        assert!(is_at(&error, place) && message.contains(says), "{text}: {error:?}");
        assert_eq!(error.to_string(), format!("{place}: not GeoJSON: {message}"));
    }
    let error = read("{\"type\":\"Point\",\n\"coordinates\":[1,1e999]}").unwrap_err();
    assert_eq!(error.to_string(), "line 2, column 23: a number out of range");
    let long = format!(r#"{{"type":"{}"}}"#, "é".repeat(1000));
    let ReadCause::Malformed { message } = read(long).unwrap_err().cause else { panic!() };
    assert_eq!(message.chars().count(), 200);
}

/// Reads three features, the second of which has this geometry in line 3. Returns the place and the cause of the
/// error.
fn fault_of(geometry: &str) -> (TextPlace, ReadCause) {
    let good = r#"{"type":"Feature","properties":{"name":"good"},"geometry":null}"#;
    let text = format!(
        "{{\"features\":[{good},{{\"properties\":{{\"name\":\"b\"}},\n\"geometry\":\n{geometry},\
         \"type\":\"Feature\"\n}},\n{good}],\"type\":\"FeatureCollection\"}}",
    );
    let mut count = 0;
    let error = read_parts(text.as_bytes(), Documents::One, |part| {
        count += usize::from(matches!(part, Part::Feature(_)));
        Ok::<_, ReadError>(())
    });
    let Err(ReadError { place, feature: Some(index), cause, .. }) = error else { panic!("{geometry}: {error:?}") };
    assert_eq!((index, count), (1, 1), "{geometry}");
    (place, cause)
}

/// Errors that the crate detects are placed where it detects them.
#[test]
fn malformed_geometries() {
    for (geometry, column, says) in [
        ("3.5", 4, "invalid type: floating point"),
        (r#"{"coordinates":[1,2]}"#, 21, "missing field `type`"),
        (r#"{"type":"Circle","coordinates":[1,2]}"#, 16, "unknown variant `Circle`"),
        (r#"{"type":"Feature","geometry":null}"#, 17, "unknown variant `Feature`"),
        (r#"{"coordinates":[1,2],"coordinates":[1,2]}"#, 35, "duplicate field `coordinates`"),
        (r#"{"type":"Point","coordinates":7}"#, 32, "expected array, got number"),
        (r#"{"type":"GeometryCollection","geometries":[null]}"#, 47, "expected Geometry object"),
        (r#"{"type":"Point","coordinates":[1,"2"]}"#, 36, "invalid type: string"),
        (r#"{"type":"LineString","coordinates":[[1,2],{"x":1,"y":2}]}"#, 43, "invalid type: map"),
        (r#"{"type":"LineString","coordinates":[[1,2],[[3,4]]]}"#, 44, "invalid type: sequence"),
        // These two are only detected after the geometry.
        (r#"{"type":"Point"}"#, 17, "no `coordinates` key"),
        (r#"{"type":"LineString","coordinates":[1,2]}"#, 42, "unexpected coordinates dimensions: 0"),
    ] {
        let (place, fault) = fault_of(geometry);
        let ReadCause::Malformed { message } = fault else { panic!("{geometry}: {fault:?}") };
        assert_eq!(place, at(3, column), "{geometry}: {message}");
        assert!(message.contains(says), "{geometry}: {message}");
    }
    let (place, cause) = fault_of(r#"{"type":"Point","coordinates":[1,1e400]}"#);
    assert!(place == at(3, 39) && matches!(cause, ReadCause::OutOfRange), "{place}: {cause:?}");
}

/// Errors detected after the crate's parsing have the place of the closing brace of the feature.
#[test]
fn short_positions() {
    for (geometry, numbers) in [
        (r#"{"type":"LineString","coordinates":[[1,2],[3],[]]}"#, 1),
        (r#"{"type":"MultiPoint","coordinates":[[1,2,3],[]]}"#, 0),
        (r#"{"type":"MultiLineString","coordinates":[[[1]]]}"#, 1),
        (r#"{"type":"Polygon","coordinates":[[],[[1,2],[]]]}"#, 0),
        (r#"{"type":"MultiPolygon","coordinates":[[[[1]]]]}"#, 1),
        (r#"{"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":[[1]]}]}"#, 1),
    ] {
        let (place, cause) = fault_of(geometry);
        assert_eq!(place, at(4, 1), "{geometry}");
        assert!(matches!(cause, ReadCause::ShortPosition { numbers: n } if n == numbers), "{geometry}: {cause:?}");
    }
    // A feature or geometry without a collection is feature 0.
    let error = read("{\n\"coordinates\":[[1,2],[3]],\"type\":\"LineString\"}").unwrap_err();
    assert_eq!(error.to_string(), "line 2, column 46: feature 0: a position needs two numbers, this one has 1");
    let text = r#"{"geometry":{"type":"Polygon","coordinates":[[[7]]]},
        "type":"Feature","properties":{"name":"Nowhere"}}"#;
    let error = read(text).unwrap_err();
    let expected = "line 2, column 57: feature 0: a position needs two numbers, this one has 1";
    assert_eq!(error.to_string(), expected);
}

#[test]
fn malformed_features() {
    for (feature, column, says) in [
        ("null", 4, "expected a feature"),
        ("{}", 2, "missing field `type`"),
        (r#"{"type":"Point","coordinates":[1,2]}"#, 15, "unknown variant `Point`"),
        (r#"{"type":"Feature","geometry":null,"geometry":null}"#, 45, "duplicate field `geometry`"),
        (r#"{"id":[],"type":"Feature"}"#, 9, "must be a string or a number"),
        (r#"{"properties":7,"type":"Feature"}"#, 16, "expected a map"),
    ] {
        let text = format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{feature}]}}");
        let error = read(text).unwrap_err();
        assert_eq!(error.feature, Some(0), "{feature}");
        let ReadCause::Malformed { message } = error.cause else { panic!("{feature}: {:?}", error.cause) };
        assert_eq!((error.place, message.contains(says)), (at(2, column), true), "{feature}: {message}");
    }
}

fn nested_collections(depth: usize) -> String {
    let start = r#"{"type":"GeometryCollection","geometries":["#.repeat(depth);
    format!(r#"{start}{{"type":"Point","coordinates":[1,2]}}{}"#, "]}".repeat(depth))
}

#[test]
fn deep_nesting_is_an_error() {
    let in_collection = |depth: usize| {
        let geometry = nested_collections(depth);
        format!(r#"{{"type":"FeatureCollection","features":[{{"type":"Feature","geometry":{geometry}}}]}}"#)
    };
    assert_eq!(shapes(&nested_collections(MAX_NESTED_COLLECTIONS)).len(), 1);
    assert_eq!(shapes(&in_collection(MAX_NESTED_COLLECTIONS)).len(), 1);
    for depth in [MAX_NESTED_COLLECTIONS + 1, 10_000, 100_000] {
        let error = read(in_collection(depth)).unwrap_err();
        assert!(matches!(error.cause, ReadCause::TooDeep) && error.feature.is_some(), "{error:?}");
    }
    let text = nested_collections(MAX_NESTED_COLLECTIONS + 1);
    let error = read(&text).unwrap_err();
    assert_eq!(error.to_string(), format!("line 1, column {}: feature 0: nested too deep", text.len()));
    // Here the crate does not reach the end.
    let coordinates = "[".repeat(100_000) + &"]".repeat(100_000);
    for text in [nested_collections(10_000), format!(r#"{{"type":"Polygon","coordinates":{coordinates}}}"#)] {
        let error = read(text).unwrap_err();
        assert!(matches!(error.cause, ReadCause::TooDeep) && error.feature.is_none(), "{error:?}");
    }
    let error = read("[".repeat(100_000)).unwrap_err();
    assert!(matches!(error.cause, ReadCause::Malformed { .. }) && error.feature.is_none(), "{error:?}");
}
