//! Features of GeoJSON are cut out of the text and read at once, with the same outcome as the library's reading byte by byte.

use std::io::{self, Read};
use twinedge_layers::io::geojson::{Documents, Part};
use twinedge_layers::io::{ReadError as TextError, ReadSummary, geojson};
use twinedge_layers::{Format, ReadError, ReadOptions, format_of, read, to_map};
use twinedge_map::Feature;

/// Collections with everything that may stand between, in and around features.
const TEXTS: [&str; 8] = [
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
];

/// The features, and the error, if any.
type Outcome = (Vec<Feature>, Option<String>);

fn whole(reader: impl Read) -> Outcome {
    let mut bytes = reader;
    let mut features = Vec::new();
    let options = ReadOptions { format: Some(Format::GeoJson), ..ReadOptions::default() };
    let read = read(&mut bytes, None, &options, &mut |feature| {
        features.push(to_map(&feature, &mut ReadSummary::default()));
        Ok(())
    });
    (features, read.err().map(|error| error.to_string()))
}

fn byte_by_byte(reader: impl Read) -> Outcome {
    let mut features = Vec::new();
    let read = geojson::read_parts(reader, Documents::One, |part| {
        if let Part::Feature(mut feature) = part {
            feature.foreign_members = None;
            features.extend(whole(feature.to_string().as_bytes()).0);
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

fn compare(text: &[u8]) {
    let (mut found, expected) = (whole(text), byte_by_byte(text));
    // The parser may read past an error.
    if expected.1.is_some() {
        found.0.truncate(expected.0.len());
    }
    assert_eq!(found, expected, "{}", String::from_utf8_lossy(text));
}

#[test]
fn right_texts_are_read_as_byte_by_byte() {
    for text in TEXTS {
        compare(text.as_bytes());
    }
    let (features, error) = whole(TEXTS[2].as_bytes());
    assert_eq!((features.len(), error), (3, None));
}

#[test]
fn wrong_texts_have_the_errors_and_places_of_byte_by_byte() {
    const BYTES: &[u8] = b"{}[]\",:\\ \n0-e.tn\x00\xff";
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut judged, mut failed) = (0, 0);
    for round in 0..2_500 {
        let mut text = TEXTS[round % TEXTS.len()].as_bytes().to_vec();
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
        let options = ReadOptions { format: Some(Format::GeoJson), ..ReadOptions::default() };
        if format_of(&text, None, &options).is_ok_and(|format| format == Format::GeoJson) {
            compare(&text);
            judged += 1;
            failed += usize::from(whole(&text[..]).1.is_some());
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
            let expected = byte_by_byte(pieces(1 << 13));
            assert_eq!(expected.1.is_none(), end == text.len() && !fails);
            for piece in [1 + 60 * number, 4_096, 1 << 20] {
                assert_eq!(whole(pieces(piece)), expected, "{end} {fails} {piece}");
            }
        }
    }
    // A byte order mark may be torn apart.
    let marked = TEXTS[2].as_bytes();
    let bytes = Pieces { bytes: marked, piece: 1, fails: false, was_interrupted: false };
    assert_eq!(byte_by_byte(bytes), byte_by_byte(marked));
}

#[test]
fn a_feature_far_behind_has_its_number_and_its_place() {
    let text = long().replace("[399,3.5]", "[399]");
    let (features, error) = whole(text.as_bytes());
    let line = text.lines().position(|line| line.contains("[399]")).map_or(0, |line| line + 1);
    let error = error.unwrap_or_default();
    assert!(error.starts_with(&format!("line {line}, column ")) && error.contains("feature 399"), "{error}");
    assert_eq!(features.len(), 399);
    compare(text.as_bytes());
}

#[test]
fn deep_nesting_is_judged_as_byte_by_byte() {
    for depth in 80..140 {
        let deep = ["[".repeat(depth), "]".repeat(depth)].concat();
        let text = format!(
            r#"{{"type":"FeatureCollection","features":[{{"type":"Feature","geometry":null}},{{"type":"Feature","geometry":null,"x":{deep}}}]}}"#
        );
        compare(text.as_bytes());
    }
    for depth in 28..36 {
        let open = r#"{"type":"GeometryCollection","geometries":["#.repeat(depth);
        let text = format!(
            r#"{{"type":"FeatureCollection","features":[{{"type":"Feature","geometry":{open}{}}}]}}"#,
            "]}".repeat(depth)
        );
        compare(text.as_bytes());
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
