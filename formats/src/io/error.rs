//! Errors of readers: the place in the file, and what is wrong there.

use super::foreign::ForeignFormat;
use super::format::Format;
use core::fmt;
use std::io;
use thiserror::Error;

/// The greatest number of geometry collections that a reader accepts around one geometry. RFC 7946 advises against nesting them
/// at all; the bound keeps the stack small.
pub const MAX_NESTED_COLLECTIONS: usize = 32;

/// A place in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TextPlace {
    /// The line, the first being 1.
    pub line: usize,
    /// The byte of the line, the first being 1; 0 stands for the line break before it. A byte order mark is not counted.
    /// None, if the reader knows the line only.
    pub column: Option<usize>,
}

impl TextPlace {
    /// The place before the first byte.
    pub(super) const START: Self = Self { line: 1, column: Some(0) };

    /// A line as a whole.
    #[must_use]
    pub const fn line(line: usize) -> Self {
        Self { line, column: None }
    }

    /// The place after these bytes as well.
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

/// One feature among those of a file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct FeatureLabel {
    /// Its place among the others, the first being 0.
    pub index: usize,
    /// Its name, if it has one and could be read as a whole.
    pub name: Option<String>,
}

impl fmt::Display for FeatureLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "feature {}", self.index)?;
        match &self.name {
            Some(name) => write!(f, " ({name})"),
            None => Ok(()),
        }
    }
}

/// The error of all readers of [`io`](crate::io): the place in the file, and what is wrong there.
///
/// For GeoJSON the place is the byte that `serde_json` had reached when the fault showed. For a value of the wrong type,
/// this is its last byte, its opening bracket or the byte behind that. What shows only when an object is complete, such as
/// a missing member or a short position, has the place of the closing brace of the feature or the outermost object; what a
/// geometry inside a feature lacks, that of its own closing brace or of what follows it.
///
/// ```
/// use twinedge_formats::io;
/// use twinedge_formats::io::{Format, ReadCause, ReadError};
///
/// let error = io::read("PK\u{3}\u{4}...".as_bytes(), None, |_| Ok::<_, ReadError>(())).unwrap_err();
/// assert!(matches!(error.cause, ReadCause::Foreign(_)));
/// assert_eq!(error.to_string(), "this looks like a zip archive, which is not read here: unpack it first");
/// ```
#[derive(Debug)]
#[non_exhaustive]
pub struct ReadError {
    /// The place in the file.
    pub place: TextPlace,
    /// The feature at fault, if the fault is inside one.
    pub feature: Option<FeatureLabel>,
    /// The error at that place.
    pub cause: ReadCause,
}

impl ReadError {
    /// An error that concerns no feature.
    #[must_use]
    pub const fn new(place: TextPlace, cause: ReadCause) -> Self {
        Self { place, feature: None, cause }
    }

    /// The error with the feature that it concerns.
    #[must_use]
    pub fn in_feature(self, feature: FeatureLabel) -> Self {
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
            (Some(feature), cause) => write!(f, "{feature}: {cause}"),
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

/// An error in a file.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadCause {
    /// The reader underneath failed. The place is that of the last byte, or the line, that could be read.
    #[error("{0}")]
    Io(io::Error),
    /// There is nothing but white space.
    #[error("the input is empty")]
    Empty,
    /// The input ends before its outermost object does.
    #[error("the input ends too early")]
    Truncated,
    /// The text is not UTF-8.
    #[error("not UTF-8")]
    NotUtf8,
    /// The text breaks the grammar of its format. In GeoJSON, a `"type"` that is not a string counts as such, too:
    /// `serde_json` makes no difference.
    #[error("syntax error: {message}")]
    Syntax {
        /// A description of the error, and of what was expected.
        message: String,
    },
    /// A type of geometries that is not read.
    #[error("{message}")]
    Unread {
        /// The type, why it is not read, and what to do.
        message: String,
    },
    /// Something follows the end of the outermost object, or of the geometry of a line.
    #[error("text after the end of the {what}")]
    Trailing {
        /// The text that has ended.
        what: &'static str,
    },
    /// This is JSON, but an object is not of the form that its type asks for.
    #[error("{message}")]
    Malformed {
        /// The message of the `geojson` crate, cut after 200 characters.
        message: String,
    },
    /// A number that is none, or infinite, or that no 64-bit float comes near to.
    #[error("a number out of range")]
    OutOfRange,
    /// A position with one number, or none. That of a GeoJSON `Point` is [`ReadCause::Malformed`], since the crate
    /// notices it.
    #[error("a position needs two numbers, this one has {numbers}")]
    ShortPosition {
        /// The number of numbers in it.
        numbers: usize,
    },
    /// A geometry inside more than [`MAX_NESTED_COLLECTIONS`] geometry collections; in JSON also arrays and objects inside
    /// each other more than about 128 deep.
    #[error("nested too deep")]
    TooDeep,
    /// The content is of a format that is known by its first bytes, but not read here.
    #[error("this looks like {0}, which is not read here: {advice}", advice = .0.advice())]
    Foreign(ForeignFormat),
    /// The content, or the format that was given, is one that `twinedge-formats` reads.
    #[error(
        "this looks like {0}, which is read by twinedge-formats and the program; \
             or convert it with `ogr2ogr -f GeoJSONSeq map.geojsonl FILE`"
    )]
    Elsewhere(Format),
    /// The content is of no known format.
    #[error(
        "the format is not recognised: GeoJSON and well-known text are read; \
         convert others with `ogr2ogr -f GeoJSONSeq map.geojsonl FILE`"
    )]
    Unrecognised,
    /// The library was built without the feature that reads this format.
    #[error("{0} is read with the feature `{feature}` of the library, which is off", feature = .0.feature())]
    FeatureOff(Format),
}
