//! The memory used to read GeoJSON, counted by the allocator.

use crate::peak;
use ::geojson::{GeometryValue, Position};
use std::io::{self, Read};
use twinedge_layers::io::ReadError;
use twinedge_layers::io::geojson::{Documents, Part, read_parts};

/// A text generated while it is read: a head, a repeated part, a tail.
struct Repeated<'a> {
    head: &'a [u8],
    part: &'a [u8],
    left: usize,
    tail: &'a [u8],
}

impl Read for Repeated<'_> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        if self.head.is_empty() {
            if self.left > 0 {
                self.left -= 1;
                self.head = self.part;
            } else {
                self.head = std::mem::take(&mut self.tail);
            }
        }
        self.head.read(out)
    }
}

const SIZE: usize = 25_000_000;

/// Reads a text of at least 25 MB. Returns the numbers of features and positions, the size of the text and the peak memory.
fn measure(head: &str, part: &str, tail: &str) -> ([usize; 2], usize, usize) {
    let left = SIZE / part.len() + 1;
    let size = head.len() + left * part.len() + tail.len();
    let text = Repeated { head: head.as_bytes(), part: part.as_bytes(), left, tail: tail.as_bytes() };
    let (mut features, mut positions) = (0, 0);
    let count = |line: &Vec<Position>| line.iter().filter(|position| position.len() >= 2).count();
    let peak = peak(|| {
        read_parts(text, Documents::One, |part| {
            let Part::Feature(feature) = part else { return Ok(()) };
            features += 1;
            positions += match feature.geometry.map(|geometry| geometry.value) {
                Some(GeometryValue::Polygon { coordinates: rings }) => rings.iter().map(count).sum(),
                Some(GeometryValue::LineString { coordinates: line }) => count(&line),
                _ => 0,
            };
            Ok::<_, ReadError>(())
        })
        .unwrap();
    });
    ([features, positions], size, peak)
}

/// Features are not kept: many need no more memory than one.
#[test]
fn many_small_features() {
    let parcel = r#"{"type":"Feature","properties":{"name":"a parcel","area":12.5},"geometry":{"type":"Polygon",
        "coordinates":[[[0.25,0.25],[1.25,0.25],[1.25,1.25],[0.25,1.25],[0.25,0.25]]]}},"#;
    let (counts, size, peak) =
        measure(r#"{"type":"FeatureCollection","features":["#, parcel, r#"{"type":"Feature","geometry":null}]}"#);
    assert_eq!(counts, [SIZE / parcel.len() + 2, 5 * (SIZE / parcel.len() + 1)]);
    assert!(peak < 100_000, "{peak} bytes at the peak for {size} bytes of text");
}

/// The worst case for memory is a single feature that fills the file. Its coordinates are as long as in the maps of
/// `crates/cli/data` after rounding to five digits.
#[test]
fn one_large_feature() {
    let head = r#"{"type":"Feature","properties":{"name":"a coast"},"geometry":{"type":"Polygon","coordinates":[["#;
    let (counts, size, peak) = measure(head, "[105.12345,-33.98765],", "[0,0]]]}}");
    assert_eq!(counts, [1, SIZE / 22 + 2]);
    assert!(peak < 5 * size, "{peak} bytes at the peak for {size} bytes of text");
}

/// A third number moves the position out of its list.
#[test]
fn one_large_feature_with_heights() {
    let head = r#"{"type":"Feature","properties":{"name":"a coast"},"geometry":{"type":"Polygon","coordinates":[["#;
    let (counts, size, peak) = measure(head, "[105.12345,-33.98765,12.5],", "[0,0]]]}}");
    assert_eq!(counts, [1, SIZE / 27 + 2]);
    assert!(peak < 10 * size, "{peak} bytes at the peak for {size} bytes of text");
}

/// The bound also holds for the shortest possible coordinates.
#[test]
fn one_large_feature_of_single_digits() {
    let head = r#"{"geometry":{"coordinates":["#;
    let (counts, size, peak) = measure(head, "[0,0],", r#"[0,0]],"type":"LineString"},"type":"Feature"}"#);
    assert_eq!(counts, [1, SIZE / 6 + 2]);
    assert!(peak < 10 * size, "{peak} bytes at the peak for {size} bytes of text");
}
