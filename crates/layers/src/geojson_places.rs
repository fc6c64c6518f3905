//! The ranges of features in a GeoJSON text, without parsing their contents.
//!
//! The reader must have accepted the text; nothing is checked here. Memory holds only the ranges.

use super::geojson_scan::{Array, Scan, Turn};
use std::io::{self, BufRead};
use std::ops::Range;

/// The ranges of features and of the collection's box, in bytes.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Places {
    pub(super) features: Vec<Range<u64>>,
    /// The member `bbox` of the collection, if there is exactly one collection with it.
    pub(super) bbox: Option<Range<u64>>,
}

/// Finds the ranges in a text of one object, or of several successive ones. O(bytes).
pub(super) fn places(mut text: impl BufRead) -> io::Result<Places> {
    let (mut scan, mut found, mut at) = (Scan::default(), Places::default(), 0);
    // The starts of the outermost object, of its current member, and of the current element of `features`.
    let mut starts = [0; 3];
    loop {
        let bytes = text.fill_buf()?;
        if bytes.is_empty() {
            return Ok(found);
        }
        for (place, byte) in (at..).zip(bytes) {
            match scan.take(*byte) {
                Turn::Opens => {
                    if let Some(start) = starts.get_mut(scan.depth - 1) {
                        *start = place;
                    }
                }
                Turn::Closes => {
                    let start = starts.get(scan.depth).copied();
                    found.close(&scan, start.map(|start| start..place + 1));
                }
                Turn::Neither => {}
            }
        }
        let length = bytes.len();
        at += length as u64;
        text.consume(length);
    }
}

impl Places {
    fn close(&mut self, scan: &Scan, place: Option<Range<u64>>) {
        match (scan.depth, place) {
            (2, Some(place)) if scan.features == Array::Inside => self.features.push(place),
            (1, place) if scan.name == b"bbox" => self.bbox = place,
            (0, Some(place)) if scan.features == Array::Before => {
                self.features.push(place);
                // A feature has its own box.
                self.bbox = None;
            }
            _ => {}
        }
    }
}
