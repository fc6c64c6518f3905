//! A reader that knows how far it has got.

use core::cell::Cell;
use std::io::{self, BufRead, BufReader, ErrorKind, Read};

use super::Place;

/// How far a text has been read.
#[derive(Clone, Copy)]
pub(super) struct Progress {
    /// The last byte read.
    pub(super) at: Place,
    /// Whether there was nothing but white space so far.
    pub(super) blank: bool,
    /// Whether the text has ended or the reader has failed.
    pub(super) stopped: bool,
}

impl Progress {
    pub(super) const START: Self = Self { at: Place { line: 1, column: 0 }, blank: true, stopped: false };

    fn pass(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.at = match byte {
                b'\n' => Place { line: self.at.line + 1, column: 0 },
                _ => Place { line: self.at.line, column: self.at.column + 1 },
            };
            self.blank = self.blank && matches!(byte, b' ' | b'\t' | b'\r' | b'\n');
        }
    }
}

/// Buffers a reader, keeps its progress, and skips a byte order mark.
pub(super) fn open<'p, R: Read + 'p>(reader: R, progress: &'p Cell<Progress>) -> io::Result<impl BufRead + 'p> {
    let mut input = Tracked { reader, progress };
    let mut start = Vec::new();
    input.by_ref().take(3).read_to_end(&mut start)?;
    if start == b"\xEF\xBB\xBF" {
        start.clear();
        progress.set(Progress::START);
    }
    Ok(BufReader::new(io::Cursor::new(start).chain(input)))
}

struct Tracked<'p, R> {
    reader: R,
    progress: &'p Cell<Progress>,
}

impl<R: Read> Read for Tracked<'_, R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let mut progress = self.progress.get();
        if out.is_empty() || progress.stopped {
            return Ok(0);
        }
        // Nothing keeps a reader from claiming more than there was room for.
        let result = self.reader.read(out).map(|len| len.min(out.len()));
        match &result {
            Ok(len) => {
                progress.pass(&out[..*len]);
                progress.stopped = *len == 0;
            }
            Err(error) => progress.stopped = error.kind() != ErrorKind::Interrupted,
        }
        self.progress.set(progress);
        result
    }
}
