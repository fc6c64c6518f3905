//! A reader that tracks its progress.

use core::cell::Cell;
use std::io::{self, BufRead, BufReader, ErrorKind, Read};

use crate::io::error::TextPlace;

#[derive(Clone, Copy)]
pub(super) struct Progress {
    pub(super) at: TextPlace,
    /// True if only white space has been read.
    pub(super) blank: bool,
    /// True if the text has ended or the reader has failed.
    pub(super) stopped: bool,
}

impl Progress {
    pub(super) const START: Self = Self { at: TextPlace::START, blank: true, stopped: false };

    fn pass(&mut self, bytes: &[u8]) {
        self.at = self.at.after(bytes);
        self.blank = self.blank && bytes.iter().all(|byte| matches!(byte, b' ' | b'\t' | b'\r' | b'\n'));
    }
}

/// Separates the texts of a sequence (RFC 8142).
const RECORD_SEPARATOR: u8 = 0x1E;

/// Buffers a reader, tracks its progress, and skips a byte order mark; optionally turns record separators into spaces.
pub(super) fn open<'p, R: Read + 'p>(
    reader: R,
    progress: &'p Cell<Progress>,
    is_sequence: bool,
) -> io::Result<impl BufRead + 'p> {
    let mut input = ProgressReader { reader, progress, is_sequence };
    let mut start = Vec::new();
    input.by_ref().take(3).read_to_end(&mut start)?;
    if start == b"\xEF\xBB\xBF" {
        start.clear();
        progress.set(Progress::START);
    }
    Ok(BufReader::new(io::Cursor::new(start).chain(input)))
}

struct ProgressReader<'p, R> {
    reader: R,
    progress: &'p Cell<Progress>,
    is_sequence: bool,
}

impl<R: Read> Read for ProgressReader<'_, R> {
    fn read(&mut self, out: &mut [u8]) -> io::Result<usize> {
        let mut progress = self.progress.get();
        if out.is_empty() || progress.stopped {
            return Ok(0);
        }
        // A reader might claim to have read more than there was room for.
        let result = self.reader.read(out).map(|len| len.min(out.len()));
        match &result {
            Ok(len) => {
                if self.is_sequence {
                    out[..*len].iter_mut().filter(|byte| **byte == RECORD_SEPARATOR).for_each(|byte| *byte = b' ');
                }
                progress.pass(&out[..*len]);
                progress.stopped = *len == 0;
            }
            Err(error) => progress.stopped = error.kind() != ErrorKind::Interrupted,
        }
        self.progress.set(progress);
        result
    }
}
