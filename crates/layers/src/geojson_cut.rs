//! Reading features of a collection faster, by cutting them out of the text.
//!
//! A parser that takes its bytes one by one from a stream takes 1.5 times as long as a parser with all bytes at hand.
//!
//! ```text
//!   {"type": "FeatureCollection", "features": [{…}, {…}, {…}], "name": "parcels"}
//!                                              ╰── cut out ─╯
//! ```
//!
//! The library's reader sees the rest, with an empty array. From the first faulty feature on, it sees everything, so that it
//! reports the errors; only their places are corrected for the cut text.

use super::error::ReadError;
use super::geojson_scan::{Array, Scan};
use crate::io::geojson::{Documents, Part};
use crate::io::{MAX_NESTED_COLLECTIONS, TextPlace, geojson};
use ::geojson::{Feature, GeometryValue, Position};
use std::cell::{Cell, RefCell};
use std::cmp::Ordering;
use std::io::{self, Cursor, ErrorKind, Read};

const CHUNK: usize = 1 << 16;

/// From this depth on, the library decides.
const DEEPEST: usize = 100;

const START: TextPlace = TextPlace { line: 1, column: Some(0) };

/// Stands for the cut features, if others follow in the text.
const MARKER: &[u8] = br#"{"type":"Feature","geometry":null}"#;

/// Reads a file like [`geojson::read_parts`]; if there is an error, later parts may already have been passed on.
pub(super) fn read_parts(
    reader: &mut dyn Read,
    documents: Documents,
    each: impl FnMut(Part) -> Result<(), ReadError>,
) -> Result<(), ReadError> {
    // One of several objects may be a collection, which would be held completely.
    if documents == Documents::Many {
        return geojson::read_parts(reader, documents, each);
    }
    let (each, refused, marks) = (RefCell::new(each), Cell::new(None), Cell::new(false));
    let take = |part| each.borrow_mut()(part).map_err(|error| refused.set(Some(error)));
    let mut cutter = Cutter::new(reader, &marks, |feature| take(Part::Feature(feature)).is_ok());
    let read = geojson::read_parts(&mut cutter, documents, |part| match part {
        Part::Feature(_) if marks.take() => Ok(()),
        // This error is discarded: the callback's error is returned.
        part => take(part).map_err(|()| ReadError::Empty),
    });
    refused.take().map_or_else(|| read.map_err(|error| cutter.original(error)), Err)
}

/// The text of a collection, without the cut features.
struct Cutter<'r, F> {
    reader: &'r mut dyn Read,
    /// Takes a feature, and returns true to continue.
    take: F,
    chunk: Vec<u8>,
    at: usize,
    scan: Scan,
    is_over: bool,
    /// The text since the last cut feature: the separator and the next feature, as far as it was read.
    held: Vec<u8>,
    /// The index of the next feature in it; `None` before it begins.
    start: Option<usize>,
    /// The bytes that the library will see next.
    seen_next: Cursor<Vec<u8>>,
    /// The error of the reader, reported after everything before it.
    error: Option<io::Error>,
    count: usize,
    has_marker: bool,
    /// True until the library has passed on the marker.
    marks: &'r Cell<bool>,
    /// The place after the bracket that opens the array, and the shift of all later places.
    opened: TextPlace,
    moved: TextPlace,
}

fn after(at: TextPlace, bytes: &[u8]) -> TextPlace {
    let lines: usize = bytes.iter().map(|byte| usize::from(*byte == b'\n')).sum();
    let column = match bytes.iter().rposition(|byte| *byte == b'\n') {
        Some(last) => bytes.len() - last - 1,
        None => at.column.unwrap_or(0) + bytes.len(),
    };
    TextPlace { line: at.line + lines, column: Some(column) }
}

impl<'r, F: FnMut(Box<Feature>) -> bool> Cutter<'r, F> {
    /// Wraps a reader, passing features to `take`. `marks` is true if the next feature of the library is the marker.
    fn new(reader: &'r mut dyn Read, marks: &'r Cell<bool>, take: F) -> Self {
        Self {
            reader,
            take,
            chunk: Vec::new(),
            at: 0,
            scan: Scan::default(),
            is_over: false,
            held: Vec::new(),
            start: None,
            seen_next: Cursor::default(),
            error: None,
            count: 0,
            has_marker: false,
            marks,
            opened: START,
            moved: START,
        }
    }

    /// Corrects an error of the library, as if it had seen the whole text.
    fn original(&self, mut error: ReadError) -> ReadError {
        if let ReadError::Text(error) = &mut error {
            error.place = self.place(error.place);
            if let Some(feature) = &mut error.feature {
                *feature += self.count - usize::from(self.has_marker);
            }
        }
        error
    }

    /// Converts a place in the text seen by the library to a place in the original text.
    fn place(&self, seen: TextPlace) -> TextPlace {
        let marker = if self.has_marker { MARKER.len() } else { 0 };
        let (column, opened) = (seen.column.unwrap_or(0), self.opened.column.unwrap_or(0) + marker);
        let line = seen.line.saturating_sub(self.opened.line) + self.moved.line;
        match seen.line.cmp(&self.opened.line) {
            Ordering::Less => seen,
            Ordering::Equal if column < opened => seen,
            Ordering::Equal => TextPlace { line, column: Some(column - opened + self.moved.column.unwrap_or(0)) },
            Ordering::Greater => TextPlace { line, column: seen.column },
        }
    }

    /// Consumes the bytes of the chunk in the array of features.
    fn cut(&mut self) {
        while let Some(byte) = self.chunk.get(self.at).copied() {
            let Some(start) = self.start else {
                match byte {
                    b' ' | b'\t' | b'\r' | b'\n' | b',' => self.held.push(byte),
                    b'{' if self.is_separated() => {
                        self.start = Some(self.held.len());
                        continue;
                    }
                    _ => return self.end(),
                }
                self.at += 1;
                continue;
            };
            let mut deepest = 0;
            let closed = self.chunk[self.at..].iter().position(|byte| {
                self.scan.take(*byte);
                deepest = deepest.max(self.scan.depth);
                self.scan.depth <= 2
            });
            let end = closed.map_or(self.chunk.len(), |place| self.at + place + 1);
            self.held.extend_from_slice(&self.chunk[self.at..end]);
            self.at = end;
            if deepest > DEEPEST {
                return self.end();
            }
            if closed.is_some() {
                let read = serde_json::from_slice::<Box<Feature>>(&self.held[start..]).ok();
                let Some(feature) = read.filter(|feature| feature.geometry.iter().all(|one| is_sound(&one.value, 0)))
                else {
                    return self.end();
                };
                self.count += 1;
                self.moved = after(self.moved, &self.held);
                self.held.clear();
                self.start = None;
                if !(self.take)(feature) {
                    self.is_over = true;
                    self.error = Some(io::Error::other("a feature was refused"));
                    return;
                }
            }
        }
    }

    fn is_cutting(&self) -> bool {
        !self.is_over && self.scan.features == Array::Inside
    }

    /// Reads the next chunk. Returns true if there is more to see.
    fn fill(&mut self) -> io::Result<bool> {
        self.at = 0;
        self.chunk.resize(CHUNK, 0);
        let read = self.reader.read(&mut self.chunk);
        self.chunk.truncate(*read.as_ref().unwrap_or(&0));
        match read {
            Ok(1..) => Ok(true),
            Err(error) if error.kind() == ErrorKind::Interrupted => Err(error),
            end if self.is_cutting() => {
                self.error = end.err();
                self.end();
                Ok(true)
            }
            end => end.map(|_| false),
        }
    }

    /// Returns true if the held text may stand before a feature.
    fn is_separated(&self) -> bool {
        let mut commas = self.held.iter().filter(|byte| **byte == b',');
        commas.next().is_some() == (self.count > 0) && commas.next().is_none()
    }

    fn end(&mut self) {
        self.is_over = true;
        let closes = self.start.is_none() && !self.held.contains(&b',') && self.chunk.get(self.at) == Some(&b']');
        if self.count > 0 && !closes {
            self.has_marker = true;
            self.marks.set(true);
            self.seen_next.get_mut().extend_from_slice(MARKER);
        }
        self.seen_next.get_mut().append(&mut self.held);
    }

    /// Returns the number of bytes of the chunk up to the bracket that opens the array of features, or all.
    fn before(&mut self, most: usize) -> usize {
        let bytes = &self.chunk[self.at..];
        let opens = bytes.iter().take(most).position(|byte| {
            self.scan.take(*byte);
            self.scan.features == Array::Inside
        });
        let length = opens.map_or(bytes.len().min(most), |place| place + 1);
        // The library does not count a byte order mark.
        let is_start = self.opened == START;
        let mark = bytes[..length].iter().take_while(|byte| is_start && b"\xEF\xBB\xBF".contains(byte)).count();
        self.opened = after(self.opened, &bytes[mark..length]);
        self.moved = self.opened;
        length
    }
}

impl<F: FnMut(Box<Feature>) -> bool> Read for Cutter<'_, F> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        loop {
            let seen = self.seen_next.read(out)?;
            if seen > 0 || out.is_empty() {
                return Ok(seen);
            }
            if let Some(error) = self.error.take() {
                return Err(error);
            }
            if self.at == self.chunk.len() {
                if !self.fill()? {
                    return Ok(0);
                }
                continue;
            }
            if self.is_cutting() {
                self.cut();
                continue;
            }
            let length = out.len().min(self.chunk.len() - self.at);
            let length = if self.is_over { length } else { self.before(length) };
            out[..length].copy_from_slice(&self.chunk[self.at..self.at + length]);
            self.at += length;
            return Ok(length);
        }
    }
}

/// Returns true if each position has two numbers, and collections are not nested too deep.
fn is_sound(value: &GeometryValue, depth: usize) -> bool {
    let has_two = |position: &Position| position.len() >= 2;
    match value {
        GeometryValue::Point { coordinates } => has_two(coordinates),
        GeometryValue::MultiPoint { coordinates } | GeometryValue::LineString { coordinates } => {
            coordinates.iter().all(has_two)
        }
        GeometryValue::MultiLineString { coordinates } | GeometryValue::Polygon { coordinates } => {
            coordinates.iter().flatten().all(has_two)
        }
        GeometryValue::MultiPolygon { coordinates } => coordinates.iter().flatten().flatten().all(has_two),
        GeometryValue::GeometryCollection { geometries } => {
            depth < MAX_NESTED_COLLECTIONS && geometries.iter().all(|one| is_sound(&one.value, depth + 1))
        }
    }
}
