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

/// The place with respect to texts.
#[derive(Clone, Copy, Default, PartialEq)]
enum Text {
    #[default]
    Outside,
    Inside,
    /// Behind a backslash.
    Escaped,
}

/// The place with respect to the array `features` of the outermost object.
#[derive(Clone, Copy, Default, PartialEq)]
enum Array {
    #[default]
    Before,
    Inside,
    Behind,
}

/// The state between two bytes.
#[derive(Default)]
struct Scan {
    found: Places,
    /// The number of objects and arrays that are open.
    depth: usize,
    text: Text,
    /// True if the next text is a name of the outermost object, and not in a value of it.
    is_name: bool,
    /// The name of the member of the outermost object, as far as it is looked for.
    name: Vec<u8>,
    /// The start of the outermost object, of the member of it, and of the element of `features`.
    starts: [u64; 3],
    features: Array,
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
        if self.text != Text::Outside {
            self.take_in_text(byte);
            return;
        }
        match byte {
            b'"' => {
                self.text = Text::Inside;
                if self.is_name {
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
            _ if self.text == Text::Escaped => self.text = Text::Inside,
            b'\\' => self.text = Text::Escaped,
            b'"' => {
                self.text = Text::Outside;
                return;
            }
            _ => {}
        }
        if self.is_name && self.name.len() <= LONGEST {
            self.name.push(byte);
        }
    }

    fn open(&mut self, byte: u8, at: u64) {
        match self.depth {
            0 => {
                self.features = Array::Before;
                self.is_name = true;
            }
            1 if byte == b'[' && self.name == b"features" => self.features = Array::Inside,
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
            (2, Some(place)) if self.features == Array::Inside => self.found.features.push(place),
            (1, _) if self.features == Array::Inside => self.features = Array::Behind,
            (1, place) if self.name == b"bbox" => self.found.bbox = place,
            (0, Some(place)) if self.features == Array::Before => {
                self.found.features.push(place);
                // A feature has a box of its own.
                self.found.bbox = None;
            }
            _ => {}
        }
    }
}
