//! Features of GeoJSON are parsed from a buffer, with the same outcome as reading them byte by byte.

use std::io::{self, Read};
use twinedge_layers::io::geojson::{Documents, Part};
use twinedge_layers::io::{ReadError as TextError, geojson};
use twinedge_layers::{Feature, Format, ReadError, ReadOptions, format_of, read};

/// Collections with everything that may stand between, in and around features.
const TEXTS: [&str; 10] = [
    r#"{"type":"FeatureCollection","features":[]}"#,
    r#"{"type":"FeatureCollection","features":[ {"type":"Feature","properties":{"name":"a"},"geometry":{"type":"Point","coordinates":[1,2]}}]}"#,
    "\u{feff}{\"type\": \"FeatureCollection\", \"name\": \"{[\\\"\", \"bbox\": [0, 0, 1, 1],\n \"features\": [\n  {\"type\": \"Feature\", \"id\": 7, \
     \"properties\": {\"name\": \"}]\\\\\", \"n\": {\"features\": [{}]}}, \"geometry\": null},\n\n  {\"type\": \"Feature\", \"properties\": null,\n\
     \"geometry\": {\"type\": \"LineString\", \"coordinates\": [[0, 0], [1.5e0, -2, 3]]}} ,\n {\"type\":\"Feature\",\"geometry\":null}\n ],\r\n \
     \"crs\": null}\n",
    r#"{"features":[{"geometry":{"coordinates":[[[0,0],[1,0],[0,1],[0,0]]],"type":"Polygon"},"type":"Feature","bbox":[0,0,1,1],"x":[]},{"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[0,1]},{"type":"GeometryCollection","geometries":[]}]}}],"type":"FeatureCollection"}"#,
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":null}],"features":[{"type":"Feature","geometry":null,"id":"é"}]}"#,
    r#"{"type":"FeatureCollection","fe\u0061tures":[{"type":"Feature","geometry":null}]}"#,
    r#"{"type":"Feature","features":[{"type":"Feature","geometry":null}],"geometry":{"type":"Point","coordinates":[1,2]}}"#,
    r#"{"type":"FeatureCollection","x":{"features":[{"type":"Feature","geometry":null}]},"features":[{"type":"Feature","geometry":{"type":"MultiPoint","coordinates":[[1,2],[3,4]]}},{"type":"Feature","geometry":null}]}"#,
    // Values of all kinds, columns that differ and one that is repeated.
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","id":-1,"properties":{"a":1,"b":null},"geometry":null},{"type":"Feature","id":"x\\n","properties":{"c\\u0064":-0,"b":1e3},"geometry":null},{"type":"Feature","id":0.5,"properties":{"a":18446744073709551615,"b":[1,{"c":true}]},"geometry":null,"features":null},{"type":"Feature","id":null,"properties":{"a":false,"b":"é\\u00e9","a":"last"},"geometry":null},{"type":"Feature","properties":{},"geometry":null}]}"#,
    // Boxes, foreign members and empty coordinates of geometries.
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"bbox":[0,0,1,1],"type":"LineString","x":{"y":1},"coordinates":[]},"bbox":null,"z":2},{"type":"Feature","geometry":{"coordinates":[[],[[1,2]]],"type":"Polygon"}},{"type":"Feature","geometry":{"type":"MultiPolygon","coordinates":[]}},{"type":"Feature","geometry":{"type":"MultiPolygon","coordinates":[[[[1,2,3],[4,5,6]],[]],[]]}},{"type":"Feature","geometry":{"type":"MultiLineString","coordinates":[[[1,2]],[]]}},{"type":"Feature","geometry":{"type":"Polygon","coordinates":[]}}]}"#,
];

/// Commas that are missing or too many.
const WRONG_COMMAS: [&str; 5] = [
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":null}{"type":"Feature","geometry":null}]}"#,
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":null} {"type":"Feature","geometry":null}]}"#,
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":null},,{"type":"Feature","geometry":null}]}"#,
    r#"{"type":"FeatureCollection","features":[,{"type":"Feature","geometry":null}]}"#,
    r#"{"type":"FeatureCollection","features":[{"type":"Feature","geometry":null},]}"#,
];

/// Several objects, in lines or after record separators, some of which are no features.
const SEQUENCES: [&str; 3] = [
    "\u{feff}{\"type\":\"Feature\",\"geometry\":null,\"properties\":{\"a\":1}}\n\n{\"type\":\"Feature\",\"properties\":{\"a\":[2]},\"geometry\":{\"type\":\"Point\",\"coordinates\":[1,2]}} ",
    "\u{1e}{\"type\":\"Feature\",\"geometry\":null,\"id\":1}\r\n\u{1e}{\"type\":\"Feature\",\"geometry\":null,\"id\":2}\u{1e}\n{\"type\":\"Point\",\"coordinates\":[1,2]}\n{\"type\":\"Feature\",\"geometry\":null}",
    "{\"type\":\"Feature\",\"geometry\":null}\n{\"features\":[{\"type\":\"Feature\",\"geometry\":null,\"id\":\"x\"}],\"type\":\"FeatureCollection\"}\n{\"type\":\"Feature\",\"geometry\":null}\n",
];

fn texts() -> impl Iterator<Item = (&'static str, Format)> + Clone {
    let sequences = SEQUENCES.into_iter().map(|text| (text, Format::GeoJsonSeq));
    TEXTS.into_iter().map(|text| (text, Format::GeoJson)).chain(sequences)
}

/// The features, and the error, if any.
type Outcome = (Vec<Feature>, Option<String>);

fn whole(reader: impl Read, format: Format) -> Outcome {
    let mut bytes = reader;
    let mut features = Vec::new();
    let options = ReadOptions { format: Some(format), ..ReadOptions::default() };
    let read = read(&mut bytes, None, &options, &mut |mut feature| {
        // A feature alone with members of this name is read in another way.
        feature.members.retain(|name, _| !["bbox", "features"].contains(&name.as_str()));
        features.push(feature);
        Ok(())
    });
    (features, read.err().map(|error| error.to_string()))
}

fn byte_by_byte(reader: impl Read, format: Format) -> Outcome {
    let mut features = Vec::new();
    let documents = if format == Format::GeoJson { Documents::One } else { Documents::Many };
    let read = geojson::read_parts(reader, documents, |part| {
        if let Part::Feature(mut feature) = part {
            feature.foreign_members.iter_mut().for_each(|members| drop(members.shift_remove("features")));
            features.extend(whole(feature.to_string().as_bytes(), Format::GeoJson).0);
        }
        Ok::<_, TextError>(())
    });
    (features, read.err().map(|error| error.to_string()))
}

/// Numbers from a fixed seed (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as usize % bound
    }
}

/// A reader that returns a limited number of bytes at a time, is interrupted before each, and can fail at the end.
struct Pieces<'a> {
    bytes: &'a [u8],
    piece: usize,
    fails: bool,
    was_interrupted: bool,
}

impl Read for Pieces<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        self.was_interrupted = !self.was_interrupted;
        if self.was_interrupted {
            return Err(io::ErrorKind::Interrupted.into());
        }
        if self.bytes.is_empty() && self.fails {
            return Err(io::Error::other("the disk is gone"));
        }
        let length = self.piece.min(out.len());
        self.bytes.read(&mut out[..length])
    }
}

fn compare(text: &[u8], format: Format) {
    let (mut found, expected) = (whole(text, format), byte_by_byte(text, format));
    // The parser may read past an error.
    if expected.1.is_some() {
        found.0.truncate(expected.0.len());
    }
    assert_eq!(found, expected, "{}", String::from_utf8_lossy(text));
}

#[test]
fn right_texts_are_read_as_byte_by_byte() {
    for (text, format) in texts() {
        compare(text.as_bytes(), format);
    }
    let (features, error) = whole(TEXTS[2].as_bytes(), Format::GeoJson);
    assert_eq!((features.len(), error), (3, None));
}

#[test]
fn wrong_texts_have_the_errors_and_places_of_byte_by_byte() {
    const BYTES: &[u8] = b"{}[]\",:\\ \n0-e.tn\x00\xff";
    for text in WRONG_COMMAS {
        assert!(whole(text.as_bytes(), Format::GeoJson).1.is_some(), "{text}");
        compare(text.as_bytes(), Format::GeoJson);
    }
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut judged, mut failed) = (0, 0);
    for (text, format) in texts().cycle().take(2_500) {
        let mut text = text.as_bytes().to_vec();
        for _ in 0..=random.below(2) {
            let at = random.below(text.len());
            match random.below(5) {
                0 => text.truncate(at.max(1)),
                1 => drop(text.remove(at)),
                2 => text.insert(at, BYTES[random.below(BYTES.len())]),
                3 => text[at] = BYTES[random.below(BYTES.len())],
                // A part of the text is repeated or removed.
                _ => {
                    let other = random.below(text.len());
                    let part = text[at.min(other)..at.max(other)].to_vec();
                    let at = random.below(text.len());
                    drop(text.splice(at..at, part));
                }
            }
            if text.is_empty() {
                text.push(b' ');
            }
        }
        // The reader does not get other formats.
        let options = ReadOptions { format: Some(format), ..ReadOptions::default() };
        if format_of(&text, None, &options).is_ok_and(|found| found == format) {
            compare(&text, format);
            judged += 1;
            failed += usize::from(whole(&text[..], format).1.is_some());
        }
    }
    assert!(judged > 1_800 && failed > 1_250, "{judged} {failed}");
}

/// A text longer than the beginning that decides the format.
fn long() -> String {
    let feature = |i: usize| {
        let line: Vec<String> = (0..i % 40).map(|k| format!("[{i},{k}.5]")).collect();
        let break_here = if i.is_multiple_of(3) { "\n" } else { "" };
        format!(
            "{{\"type\":\"Feature\",\"properties\":{{\"name\":\"{i}\"}},{break_here}\"geometry\":{{\"type\":\"LineString\",\"coordinates\":[{}]}}}}",
            line.join(",")
        )
    };
    let features: Vec<String> = (0..400).map(feature).collect();
    format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n],\"name\":\"long\"}}\n", features.join(",\n"))
}

#[test]
fn pieces_and_failures_of_the_reader_are_as_byte_by_byte() {
    let text = long();
    assert!(text.len() > 5 << 14);
    let text = text.as_bytes();
    let ends = [1 << 16, (1 << 16) + 1, 70_001, text.len() - 17, text.len()];
    for (number, end) in ends.into_iter().enumerate() {
        for fails in [false, true] {
            let pieces = |piece| Pieces { bytes: &text[..end], piece, fails, was_interrupted: false };
            let expected = byte_by_byte(pieces(1 << 13), Format::GeoJson);
            assert_eq!(expected.1.is_none(), end == text.len() && !fails);
            for piece in [1 + 60 * number, 4_096, 1 << 20] {
                assert_eq!(whole(pieces(piece), Format::GeoJson), expected, "{end} {fails} {piece}");
            }
        }
    }
    // A byte order mark may be torn apart.
    let marked = TEXTS[2].as_bytes();
    let bytes = Pieces { bytes: marked, piece: 1, fails: false, was_interrupted: false };
    assert_eq!(byte_by_byte(bytes, Format::GeoJson), byte_by_byte(marked, Format::GeoJson));
}

#[test]
fn a_feature_far_behind_has_its_number_and_its_place() {
    let text = long().replace("[399,3.5]", "[399]");
    let (features, error) = whole(text.as_bytes(), Format::GeoJson);
    let line = text.lines().position(|line| line.contains("[399]")).map_or(0, |line| line + 1);
    let error = error.unwrap_or_default();
    assert!(error.starts_with(&format!("line {line}, column ")) && error.contains("feature 399"), "{error}");
    assert_eq!(features.len(), 399);
    compare(text.as_bytes(), Format::GeoJson);
}

#[test]
fn deep_nesting_is_judged_as_byte_by_byte() {
    for depth in 80..140 {
        let deep = ["[".repeat(depth), "]".repeat(depth)].concat();
        let text = format!(
            r#"{{"type":"FeatureCollection","features":[{{"type":"Feature","geometry":null}},{{"type":"Feature","geometry":null,"x":{deep}}}]}}"#
        );
        compare(text.as_bytes(), Format::GeoJson);
    }
    for depth in 28..36 {
        let open = r#"{"type":"GeometryCollection","geometries":["#.repeat(depth);
        let text = format!(
            r#"{{"type":"FeatureCollection","features":[{{"type":"Feature","geometry":{open}{}}}]}}"#,
            "]}".repeat(depth)
        );
        compare(text.as_bytes(), Format::GeoJson);
    }
}

#[test]
fn a_feature_that_is_refused_ends_the_reading_with_that_error() {
    for text in [TEXTS[2], TEXTS[3], TEXTS[7]] {
        let mut count = 0;
        let refused = read(&mut text.as_bytes(), None, &ReadOptions::default(), &mut |_| {
            count += 1;
            if count == 2 { Err(ReadError::Refused("no more".into())) } else { Ok(()) }
        });
        assert_eq!((refused.unwrap_err().to_string(), count), ("no more".to_owned(), 2));
    }
}
