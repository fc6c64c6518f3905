//! Errors of the reader.

use super::super::error::{Cause, Place, ReadError};
use crate::io::Format;
use std::io;

pub(super) fn content(place: Place, cause: Cause) -> ReadError {
    ReadError::Content { format: Format::Shapefile, place, cause }
}

/// Turns an early end into a content error; other errors belong to the file.
pub(super) fn truncated(error: io::Error, what: &'static str, failed: impl FnOnce(Cause) -> ReadError) -> ReadError {
    if error.kind() == io::ErrorKind::UnexpectedEof { failed(Cause::Truncated(what)) } else { ReadError::Io(error) }
}
