//! Errors of the reader.

use super::super::error::{Cause, Place, ReadError};
use crate::io::Format;
use std::io;

/// The error that the content is not what the format demands.
pub(super) fn content(place: Place, cause: Cause) -> ReadError {
    ReadError::Content { format: Format::Shapefile, place, cause }
}

/// An early end is an error of the content; others are those of the file.
pub(super) fn truncated(error: io::Error, what: &'static str, failed: impl FnOnce(Cause) -> ReadError) -> ReadError {
    if error.kind() == io::ErrorKind::UnexpectedEof { failed(Cause::Truncated(what)) } else { ReadError::Io(error) }
}
