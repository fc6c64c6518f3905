//! Errors of readers: the place in the file, and the fault.

use core::fmt;
use std::io;
use thiserror::Error;

/// The greatest number of geometry collections that a reader accepts around a geometry, to limit the stack. RFC 7946 advises
/// against nesting them.
pub const MAX_NESTED_COLLECTIONS: usize = 32;

/// A place in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextPlace {
    /// The line, counted from 1.
    pub line: usize,
    /// The byte of the line, from 1; 0 is the line break before it. A byte order mark is not counted. `None` if unknown.
    pub column: Option<usize>,
}

impl TextPlace {
    pub(super) const START: Self = Self { line: 1, column: Some(0) };

    /// Creates the place of a whole line.
    #[must_use]
    pub const fn line(line: usize) -> Self {
        Self { line, column: None }
    }

    pub(super) fn after(self, bytes: &[u8]) -> Self {
        bytes.iter().fold(self, |at, byte| match byte {
            b'\n' => Self { line: at.line + 1, column: Some(0) },
            _ => Self { line: at.line, column: Some(at.column.unwrap_or(0) + 1) },
        })
    }
}

impl fmt::Display for TextPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.column {
            Some(column) => write!(f, "line {}, column {column}", self.line),
            None => write!(f, "line {}", self.line),
        }
    }
}

/// The error of all readers of [`io`](crate::io): the place in the file, and the fault.
///
/// For GeoJSON the place is the byte that `serde_json` had reached when the fault appeared. For a value of an invalid type, this
/// is its last byte, its opening bracket or the following byte. A fault that appears only when an object is complete, such as a
/// missing member or a short position, has the place of the closing brace of the feature or the outermost object; a fault in a
/// geometry inside a feature has the place of the geometry's closing brace or of the following byte.
#[derive(Debug)]
#[non_exhaustive]
pub struct ReadError {
    /// The place in the file.
    pub place: TextPlace,
    /// The index of the faulty feature, counted from 0, if the fault is inside one.
    pub feature: Option<usize>,
    /// The error at that place.
    pub cause: ReadCause,
}

impl ReadError {
    /// Creates an error without a feature.
    #[must_use]
    pub const fn new(place: TextPlace, cause: ReadCause) -> Self {
        Self { place, feature: None, cause }
    }

    /// Adds the feature of the error.
    #[must_use]
    pub fn in_feature(self, feature: usize) -> Self {
        Self { feature: Some(feature), ..self }
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The place before the first byte is left out of the message.
        if self.place != TextPlace::START {
            write!(f, "{}: ", self.place)?;
        }
        match (&self.feature, &self.cause) {
            (Some(feature), cause) => write!(f, "feature {feature}: {cause}"),
            (None, ReadCause::Malformed { message }) => write!(f, "not GeoJSON: {message}"),
            (None, cause) => cause.fmt(f),
        }
    }
}

impl std::error::Error for ReadError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.cause {
            ReadCause::Io(error) => Some(error),
            _ => None,
        }
    }
}

/// A fault in a file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadCause {
    /// The underlying reader failed. The place is the last byte, or the last line, that could be read.
    #[error("{0}")]
    Io(io::Error),
    /// The file contains only white space.
    #[error("the input is empty")]
    Empty,
    /// The input ends inside its outermost object.
    #[error("the input ends too early")]
    Truncated,
    /// The text is not UTF-8.
    #[error("not UTF-8")]
    NotUtf8,
    /// The text breaks the grammar of its format. In GeoJSON, this includes a `"type"` that is not a string.
    #[error("syntax error: {message}")]
    Syntax {
        /// A description of the error and the expected input.
        message: String,
    },
    /// An unsupported type of geometries.
    #[error("{message}")]
    Unread {
        /// The type, the reason, and a remedy.
        message: String,
    },
    /// The outermost object, or the geometry of a line, is followed by more text.
    #[error("text after the end of the {what}")]
    Trailing {
        /// The completed object.
        what: &'static str,
    },
    /// The text is JSON, but an object does not have the form required by its type.
    #[error("{message}")]
    Malformed {
        /// The message of the `geojson` crate, cut after 200 characters.
        message: String,
    },
    /// A number is NaN, infinite, or beyond the range of 64-bit floats.
    #[error("a number out of range")]
    OutOfRange,
    /// A position has fewer than two numbers. In a GeoJSON `Point` this is [`ReadCause::Malformed`], since the crate detects it.
    #[error("a position needs two numbers, this one has {numbers}")]
    ShortPosition {
        /// The number of numbers in it.
        numbers: usize,
    },
    /// A geometry inside more than [`MAX_NESTED_COLLECTIONS`] geometry collections; in JSON also arrays and objects nested more
    /// than about 128 deep.
    #[error("nested too deep")]
    TooDeep,
}
