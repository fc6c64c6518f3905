//! What can be wrong with a GeoJSON file, and where.

use core::fmt;
use std::io;

use thiserror::Error;

/// A place in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// The line, the first being 1.
    pub line: usize,
    /// The byte of the line, the first being 1; 0 stands for the line break before it. A byte order mark is not
    /// counted.
    pub column: usize,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}", self.line, self.column)
    }
}

/// Why a GeoJSON file could not be read. Every variant says where.
///
/// For a fault of an array or object the place is its opening bracket, for one of a number or string the byte at which
/// its end was noticed. Where an object stands instead of something else, it is the end of its first key.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The reader underneath failed.
    #[error("{at}: {source}")]
    Io {
        /// The last byte that could be read.
        at: Place,
        /// What the reader said.
        source: io::Error,
    },
    /// There is nothing but white space.
    #[error("{at}: the input is empty")]
    Empty {
        /// Where it ends.
        at: Place,
    },
    /// The input ends before its outermost object does.
    #[error("{at}: the input ends too early")]
    Truncated {
        /// Where it ends.
        at: Place,
    },
    /// This is not JSON.
    #[error("{at}: not JSON: {message}")]
    Syntax {
        /// Where it stops being JSON.
        at: Place,
        /// What was expected there.
        message: String,
    },
    /// The outermost object is followed by something else.
    #[error("{at}: text after the end of the GeoJSON object")]
    Trailing {
        /// Where that begins.
        at: Place,
    },
    /// This is JSON, but not GeoJSON.
    #[error("{at}: not GeoJSON: {fault}")]
    NotGeoJson {
        /// Where that shows.
        at: Place,
        /// What is wrong.
        fault: Fault,
    },
    /// One feature is wrong.
    #[error("{at}: feature {index}{}: {fault}", Named(.name.as_deref()))]
    Feature {
        /// The place of the feature among the others, the first being 0.
        index: usize,
        /// Its name, if one stands in front of the fault or anywhere in the rest of the feature.
        name: Option<String>,
        /// Where in the file.
        at: Place,
        /// What is wrong.
        fault: Fault,
    },
}

impl ReadError {
    /// Where in the file.
    #[must_use]
    pub fn place(&self) -> Place {
        match *self {
            Self::Io { at, .. }
            | Self::Empty { at }
            | Self::Truncated { at }
            | Self::Syntax { at, .. }
            | Self::Trailing { at }
            | Self::NotGeoJson { at, .. }
            | Self::Feature { at, .. } => at,
        }
    }
}

/// What is wrong with an object of a GeoJSON file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Fault {
    /// Something else stands where an object should.
    #[error("expected an object")]
    NotAnObject,
    /// Something else stands where an array should.
    #[error("\"{member}\" is not an array")]
    NotAnArray {
        /// The name of the member.
        member: &'static str,
    },
    /// The object does not say what it is.
    #[error("an object without \"type\"")]
    NoType,
    /// The type is unknown, or does not belong here.
    #[error("objects of type {found:?} do not belong here")]
    Type {
        /// The type, cut after 40 characters.
        found: String,
    },
    /// A member that this type must have is not there.
    #[error("\"{member}\" is missing")]
    Missing {
        /// The name of the member.
        member: &'static str,
    },
    /// A member is there twice.
    #[error("\"{member}\" is given twice")]
    Repeated {
        /// The name of the member.
        member: &'static str,
    },
    /// A member that this type must not have.
    #[error("\"{member}\" does not belong to an object of this type")]
    Misplaced {
        /// The name of the member.
        member: &'static str,
    },
    /// Among coordinates there is something else than numbers.
    #[error("something else than a number among the coordinates")]
    NotANumber,
    /// A number that no 64-bit float comes near to.
    #[error("a number out of range")]
    OutOfRange,
    /// A position with one number, or none.
    #[error("a position needs two numbers, this one has {numbers}")]
    ShortPosition {
        /// How many numbers it has.
        numbers: usize,
    },
    /// The brackets around a position are too few or too many.
    #[error("a position at level {found} of the coordinates, expected at level {expected}")]
    Nesting {
        /// The level of brackets at which positions of this geometry stand, the outermost being 1.
        expected: usize,
        /// The level at which this one stands.
        found: usize,
    },
    /// A geometry inside more than [`MAX_NESTED_COLLECTIONS`](crate::io::MAX_NESTED_COLLECTIONS) geometry collections.
    #[error("geometry collections are nested too deep")]
    TooDeep,
}

/// A name in brackets, or nothing.
struct Named<'a>(Option<&'a str>);

impl fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |name| write!(f, " ({name})"))
    }
}
