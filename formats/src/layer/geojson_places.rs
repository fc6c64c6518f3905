//! The places of features in a text of GeoJSON, without reading what they hold.
//!
//! The text is one that the reader has taken; nothing is checked here. Memory is that of the places.

use std::io::{self, BufRead};
use std::ops::Range;

/// The places of features and of the box around all, in bytes.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Places {
    pub(super) features: Vec<Range<u64>>,
    /// The member `bbox` of the collection, if there is one collection that has it.
    pub(super) bbox: Option<Range<u64>>,
}

/// The longest name that is looked for.
const LONGEST: usize = b"features".len();

/// The state between two bytes.
#[derive(Default)]
struct Scan {
    found: Places,
    /// The number of objects and arrays that are open.
    depth: usize,
    is_text: bool,
    is_escaped: bool,
    /// True if the next text of the outermost object is a name.
    is_name: bool,
    /// The name of the member of the outermost object, as far as it is looked for.
    name: Vec<u8>,
    /// The start of the outermost object, of the member of it, and of the element of `features`.
    starts: [u64; 3],
    /// True inside of the array `features`.
    is_inside: bool,
    /// True if the outermost object has that array.
    is_collection: bool,
}

/// The places in a text of one object, or of several one after the other. O(bytes).
pub(super) fn places(mut text: impl BufRead) -> io::Result<Places> {
    let (mut scan, mut at) = (Scan::default(), 0);
    loop {
        let bytes = text.fill_buf()?;
        if bytes.is_empty() {
            return Ok(scan.found);
        }
        for (place, byte) in (at..).zip(bytes) {
            scan.take(*byte, place);
        }
        let length = bytes.len();
        at += length as u64;
        text.consume(length);
    }
}

impl Scan {
    fn take(&mut self, byte: u8, at: u64) {
        if self.is_text {
            self.take_in_text(byte);
            return;
        }
        match byte {
            b'"' => {
                self.is_text = true;
                if self.depth == 1 && self.is_name {
                    self.name.clear();
                }
            }
            b',' if self.depth == 1 => self.is_name = true,
            b':' if self.depth == 1 => self.is_name = false,
            b'{' | b'[' => self.open(byte, at),
            b'}' | b']' => self.close(at + 1),
            _ => {}
        }
    }

    fn take_in_text(&mut self, byte: u8) {
        match byte {
            _ if self.is_escaped => self.is_escaped = false,
            b'\\' => self.is_escaped = true,
            b'"' => {
                self.is_text = false;
                return;
            }
            _ => {}
        }
        if self.depth == 1 && self.is_name && self.name.len() <= LONGEST {
            self.name.push(byte);
        }
    }

    fn open(&mut self, byte: u8, at: u64) {
        match self.depth {
            0 => {
                self.is_collection = false;
                self.is_name = true;
            }
            1 => self.is_inside = byte == b'[' && self.name == b"features",
            _ => {}
        }
        if let Some(start) = self.starts.get_mut(self.depth) {
            *start = at;
        }
        self.depth += 1;
    }

    fn close(&mut self, end: u64) {
        self.depth = self.depth.saturating_sub(1);
        let place = self.starts.get(self.depth).map(|start| *start..end);
        match (self.depth, place) {
            (2, Some(place)) if self.is_inside => self.found.features.push(place),
            (1, _) if self.is_inside => {
                self.is_inside = false;
                self.is_collection = true;
            }
            (1, place) if self.name == b"bbox" => self.found.bbox = place,
            (0, Some(place)) if !self.is_collection => {
                self.found.features.push(place);
                // A feature has a box of its own.
                self.found.bbox = None;
            }
            _ => {}
        }
    }
}
