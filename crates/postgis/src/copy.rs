//! Binary COPY streams, one after another.

use super::error::{Cause, Place, ReadError, TableName};
use std::io::{BufRead, Read};

/// The first bytes of every binary COPY stream.
pub(super) const SIGNATURE: &[u8; 11] = b"PGCOPY\n\xff\r\n\0";
/// These flags change the format; the others may be ignored.
const CRITICAL: u32 = 0xffff_0000;
/// The number of bytes of foreign content that are shown.
const SHOWN: usize = 24;

pub(super) struct CopyReader<R> {
    input: R,
    byte: u64,
    place: Place,
    value: Vec<u8>,
}

impl<R: BufRead> CopyReader<R> {
    pub(super) fn new(input: R) -> Self {
        let place = Place { table: TableName::Node, row: 0, column: None };
        Self { input, byte: 0, place, value: Vec::new() }
    }

    pub(super) fn error(&self, cause: Cause) -> ReadError {
        ReadError::Content { byte: self.byte, place: self.place, cause }
    }

    pub(super) fn row(&self) -> u64 {
        self.place.row
    }

    pub(super) fn begin(&mut self, table: TableName) -> Result<(), ReadError> {
        self.place = Place { table, row: 0, column: None };
        self.take(SIGNATURE.len() as u64)?;
        if self.value != SIGNATURE {
            if self.value.is_empty() && table == TableName::Node {
                return Err(self.error(Cause::Empty));
            }
            if SIGNATURE.starts_with(&self.value) {
                return Err(self.error(Cause::Truncated));
            }
            // The rest of the line makes the message clearer.
            let mut more = Vec::new();
            (&mut self.input).take(SHOWN as u64).read_to_end(&mut more)?;
            self.value.extend(more);
            let text = String::from_utf8_lossy(&self.value);
            let found: String = text.chars().take(SHOWN).flat_map(char::escape_debug).collect();
            return Err(self.error(Cause::Signature { found: found.into() }));
        }
        self.byte += SIGNATURE.len() as u64;
        let flags = u32::from_be_bytes(self.bytes()?);
        if flags & CRITICAL != 0 {
            return Err(self.error(Cause::Flags(flags)));
        }
        let extension = u64::from(u32::from_be_bytes(self.bytes()?));
        self.take(extension)?;
        self.advance(extension)
    }

    /// Begins the next row; false at the end of the stream.
    pub(super) fn next_row(&mut self, columns: u16) -> Result<bool, ReadError> {
        self.place.column = None;
        self.place.row += 1;
        match i16::from_be_bytes(self.bytes()?) {
            -1 => Ok(false),
            found if u16::try_from(found) == Ok(columns) => Ok(true),
            found => Err(self.error(Cause::Columns { found, expected: columns })),
        }
    }

    /// Reads an integer of 4 or 8 bytes; `None` for null.
    pub(super) fn integer(&mut self, column: &'static str) -> Result<Option<i64>, ReadError> {
        self.place.column = Some(column);
        match i32::from_be_bytes(self.bytes()?) {
            4 => Ok(Some(i32::from_be_bytes(self.bytes()?).into())),
            8 => Ok(Some(i64::from_be_bytes(self.bytes()?))),
            -1 => Ok(None),
            length => Err(self.error(usize::try_from(length).map_or(Cause::Length(length), Cause::Width))),
        }
    }

    /// Reads the bytes of a value; `None` for null. Memory grows with the actual bytes, not with the stated length.
    pub(super) fn value(&mut self, column: &'static str) -> Result<Option<&[u8]>, ReadError> {
        self.place.column = Some(column);
        let length = i32::from_be_bytes(self.bytes()?);
        match u64::try_from(length) {
            Ok(length) => {
                self.take(length)?;
                self.advance(length)?;
                Ok(Some(&self.value))
            }
            Err(_) if length == -1 => Ok(None),
            Err(_) => Err(self.error(Cause::Length(length))),
        }
    }

    pub(super) fn end(&mut self) -> Result<(), ReadError> {
        if self.input.fill_buf()?.is_empty() { Ok(()) } else { Err(self.error(Cause::Trailing)) }
    }

    /// Takes up to `count` bytes, fewer at the end of the input.
    fn take(&mut self, count: u64) -> Result<(), ReadError> {
        self.value.clear();
        (&mut self.input).take(count).read_to_end(&mut self.value)?;
        Ok(())
    }

    /// Moves past the taken bytes, if all of them were there.
    fn advance(&mut self, count: u64) -> Result<(), ReadError> {
        self.byte += self.value.len() as u64;
        if (self.value.len() as u64) < count { Err(self.error(Cause::Truncated)) } else { Ok(()) }
    }

    fn bytes<const N: usize>(&mut self) -> Result<[u8; N], ReadError> {
        let mut bytes = [0; N];
        match self.input.read_exact(&mut bytes) {
            Ok(()) => {
                self.byte += N as u64;
                Ok(bytes)
            }
            Err(error) if error.kind() == std::io::ErrorKind::UnexpectedEof => Err(self.error(Cause::Truncated)),
            Err(error) => Err(error.into()),
        }
    }
}
