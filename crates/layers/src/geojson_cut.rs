//! Reading features faster: each is parsed from a buffer, where it stands in the text.
//!
//! A parser that takes its bytes one by one from a stream takes 1.5 times as long as a parser with all bytes at hand.
//!
//! ```text
//!   {"type": "FeatureCollection", "features": [{…}, {…}, {…}], "name": "parcels"}
//!                                              ╰── parsed ─╯
//! ```
//!
//! The reader of [`geojson`] sees the rest, with an empty array. From the first feature on that is not in its usual form, it
//! sees everything, so that it reports the errors; only their places are corrected for the text that it did not see.

use super::error::ReadError;
use super::geojson_feature::FeatureText;
use super::geojson_scan::{Array, Scan};
use crate::io::geojson::{Documents, Part};
use crate::io::{TextPlace, geojson};
use std::cell::{Cell, RefCell};
use std::cmp::Ordering;
use std::io::{self, Cursor, ErrorKind, Read};

/// The number of bytes that are asked for at once.
const CHUNK: usize = 1 << 16;

const START: TextPlace = TextPlace { line: 1, column: Some(0) };

const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";

/// Separates the texts of a sequence (RFC 8142).
const RECORD_SEPARATOR: u8 = 0x1E;

/// Stands for the parsed features, if others follow in the text.
const MARKER: &[u8] = br#"{"type":"Feature","geometry":null}"#;

/// A feature as this reader parses it, or a part as the reader of [`geojson`] passes it on.
#[expect(clippy::large_enum_variant, reason = "it is not kept")]
pub(super) enum Piece<'t> {
    Feature(FeatureText<'t>),
    Part(Part),
}

/// Reads a file like [`geojson::read_parts`]; if there is an error, later parts may already have been passed on. `each` returns
/// false to leave a feature to the reader of [`geojson`].
pub(super) fn read_parts(
    reader: &mut dyn Read,
    documents: Documents,
    each: impl FnMut(Piece<'_>) -> Result<bool, ReadError>,
) -> Result<(), ReadError> {
    let (each, refused, marks) = (RefCell::new(each), Cell::new(None), Cell::new(false));
    let take = |piece: Piece<'_>| each.borrow_mut()(piece).map_err(|error| refused.set(Some(error)));
    let mut cutter = Cutter::new(reader, documents, &marks, |feature| take(Piece::Feature(feature)));
    let read = geojson::read_parts(&mut cutter, documents, |part| match part {
        Part::Feature(_) if marks.take() => Ok(()),
        // This error is discarded: the callback's error is returned.
        part => take(Piece::Part(part)).map(drop).map_err(|()| ReadError::Empty),
    });
    refused.take().map_or_else(|| read.map_err(|error| cutter.original(error)), Err)
}

/// The text without the parsed features.
struct Cutter<'r, F> {
    reader: &'r mut dyn Read,
    documents: Documents,
    /// Takes a feature: true if it was taken, false if it is left to the other reader.
    take: F,
    /// The bytes that were read; those before `at` have been parsed or passed on.
    text: Vec<u8>,
    at: usize,
    /// The number of unparsed bytes from which on it is worth looking for a feature.
    wanted: usize,
    /// True after the last byte, or after an error of the reader.
    is_exhausted: bool,
    scan: Scan,
    /// True if no more features are parsed here.
    is_over: bool,
    /// The bytes that the other reader sees before the text.
    seen_next: Cursor<Vec<u8>>,
    /// The error of the reader, reported after everything before it.
    error: Option<io::Error>,
    count: usize,
    has_marker: bool,
    /// True until the other reader has passed on the marker.
    marks: &'r Cell<bool>,
    /// The place after the bracket that opens the array, and the shift of all later places.
    opened: TextPlace,
    moved: TextPlace,
}

fn after(at: TextPlace, bytes: &[u8]) -> TextPlace {
    let lines = memchr::memchr_iter(b'\n', bytes).count();
    let column = match memchr::memrchr(b'\n', bytes) {
        Some(last) => bytes.len() - last - 1,
        None => at.column.unwrap_or(0) + bytes.len(),
    };
    TextPlace { line: at.line + lines, column: Some(column) }
}

/// The bytes before the next feature.
enum Next {
    Starts(usize),
    /// The text ends before it.
    MoreText,
    NoFeature,
}

impl<'r, F: FnMut(FeatureText<'_>) -> Result<bool, ()>> Cutter<'r, F> {
    /// Wraps a reader, passing features to `take`. `marks` is true if the next feature of the other reader is the marker.
    fn new(reader: &'r mut dyn Read, documents: Documents, marks: &'r Cell<bool>, take: F) -> Self {
        Self {
            reader,
            documents,
            take,
            text: Vec::new(),
            at: 0,
            wanted: 0,
            is_exhausted: false,
            scan: Scan::default(),
            is_over: false,
            seen_next: Cursor::default(),
            error: None,
            count: 0,
            has_marker: false,
            marks,
            opened: START,
            moved: START,
        }
    }

    /// Corrects an error of the other reader, as if it had seen the whole text.
    fn original(&self, mut error: ReadError) -> ReadError {
        if let ReadError::Text(error) = &mut error {
            error.place = self.place(error.place);
            if let Some(feature) = &mut error.feature {
                *feature += self.count - usize::from(self.has_marker);
            }
        }
        error
    }

    /// Converts a place in the text seen by the other reader to a place in the original text.
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

    fn is_cutting(&self) -> bool {
        !self.is_over && (self.documents == Documents::Many || self.scan.features == Array::Inside)
    }

    /// Parses the features in the text, reading more as needed.
    fn cut(&mut self) -> io::Result<()> {
        while self.is_cutting() {
            let rest = &self.text[self.at..];
            if rest.len() < self.wanted && !self.is_exhausted {
                self.fill()?;
                continue;
            }
            // Bytes are looked at again at most log n times, however few of them come at once.
            let twice = 2 * rest.len() + 1;
            let start = match self.next(rest) {
                Next::Starts(start) => start,
                Next::MoreText if !self.is_exhausted => {
                    self.wanted = twice;
                    continue;
                }
                _ => {
                    self.end();
                    continue;
                }
            };
            let mut parsed = serde_json::Deserializer::from_slice(&rest[start..]).into_iter();
            let taken = match parsed.next() {
                Some(Ok(feature)) => (self.take)(feature),
                Some(Err(error)) if error.is_eof() && !self.is_exhausted => {
                    self.wanted = twice;
                    continue;
                }
                _ => Ok(false),
            };
            match taken {
                Ok(true) => {
                    self.at += start + parsed.byte_offset();
                    (self.count, self.wanted) = (self.count + 1, 0);
                }
                Ok(false) => self.end(),
                Err(()) => {
                    (self.is_over, self.is_exhausted, self.at) = (true, true, self.text.len());
                    self.error = Some(io::Error::other("a feature was refused"));
                }
            }
        }
        Ok(())
    }

    fn next(&self, rest: &[u8]) -> Next {
        let is_first = self.count == 0;
        let mut commas = usize::from(self.documents == Documents::One && !is_first);
        let start = match rest.strip_prefix(BYTE_ORDER_MARK) {
            Some(_) if self.documents == Documents::Many && is_first => BYTE_ORDER_MARK.len(),
            _ => 0,
        };
        for (place, byte) in rest.iter().enumerate().skip(start) {
            match byte {
                b' ' | b'\t' | b'\r' | b'\n' => {}
                &RECORD_SEPARATOR if self.documents == Documents::Many => {}
                b',' if commas > 0 => commas -= 1,
                b'{' if commas == 0 => return Next::Starts(place),
                _ => return Next::NoFeature,
            }
        }
        Next::MoreText
    }

    /// Reads more bytes.
    fn fill(&mut self) -> io::Result<()> {
        self.pass();
        let length = self.text.len();
        self.text.resize(length + CHUNK, 0);
        let read = self.reader.read(&mut self.text[length..]);
        self.text.truncate(length + *read.as_ref().unwrap_or(&0));
        match read {
            Err(error) if error.kind() == ErrorKind::Interrupted => return Err(error),
            Ok(1..) => {}
            end => (self.is_exhausted, self.error) = (true, end.err()),
        }
        Ok(())
    }

    /// Drops the bytes that are parsed, and shifts the places of what follows.
    fn pass(&mut self) {
        if self.is_cutting() {
            let passed = &self.text[..self.at];
            let mark = if self.moved == START { BYTE_ORDER_MARK } else { b"" };
            self.moved = after(self.moved, passed.strip_prefix(mark).unwrap_or(passed));
        }
        self.text.drain(..self.at);
        self.at = 0;
    }

    /// Leaves the rest of the text to the other reader.
    fn end(&mut self) {
        self.pass();
        self.is_over = true;
        let closes = self.text.trim_ascii_start().starts_with(b"]");
        if self.documents == Documents::One && self.count > 0 && !closes {
            self.has_marker = true;
            self.marks.set(true);
            self.seen_next.get_mut().extend_from_slice(MARKER);
        }
    }

    /// Returns the number of bytes of the text up to the bracket that opens the array of features, or all.
    fn before(&mut self, most: usize) -> usize {
        let bytes = &self.text[self.at..];
        let opens = bytes.iter().take(most).position(|byte| {
            self.scan.take(*byte);
            self.scan.features == Array::Inside
        });
        let length = opens.map_or(bytes.len().min(most), |place| place + 1);
        // The other reader does not count a byte order mark.
        let is_start = self.opened == START;
        let mark = bytes[..length].iter().take_while(|byte| is_start && BYTE_ORDER_MARK.contains(byte)).count();
        self.opened = after(self.opened, &bytes[mark..length]);
        self.moved = self.opened;
        length
    }
}

impl<F: FnMut(FeatureText<'_>) -> Result<bool, ()>> Read for Cutter<'_, F> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        loop {
            let seen = self.seen_next.read(out)?;
            if seen > 0 || out.is_empty() {
                return Ok(seen);
            }
            if self.is_cutting() {
                self.cut()?;
            } else if self.at < self.text.len() {
                let length = out.len().min(self.text.len() - self.at);
                let length = if self.is_over { length } else { self.before(length) };
                out[..length].copy_from_slice(&self.text[self.at..self.at + length]);
                self.at += length;
                if self.is_cutting() {
                    self.text.drain(..self.at);
                    self.at = 0;
                }
                return Ok(length);
            } else if let Some(error) = self.error.take() {
                return Err(error);
            } else if self.is_exhausted {
                return Ok(0);
            } else {
                self.fill()?;
            }
        }
    }
}
