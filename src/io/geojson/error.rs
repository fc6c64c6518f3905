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

/// The place before a message, unless that is the very beginning, which tells nobody anything.
struct Behind(Place);

impl fmt::Display for Behind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(at) = self;
        if (at.line, at.column) == (1, 0) { Ok(()) } else { write!(f, "{at}: ") }
    }
}

/// Why a GeoJSON file could not be read. Every variant says where.
///
/// The place is the byte that `serde_json` had got to when the fault showed. Of a value that cannot stand where it
/// stands this is its last byte, its opening bracket or the byte behind that. What only shows when an object is
/// complete, such as a missing member or a short position, has the place of the closing brace of the feature or the
/// outermost object; what a geometry inside a feature lacks, that of its own closing brace or of what follows it.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The reader underneath failed.
    #[error("{}{source}", Behind(*at))]
    Io {
        /// The last byte that could be read.
        at: Place,
        /// What the reader said.
        source: io::Error,
    },
    /// There is nothing but white space.
    #[error("{}the input is empty", Behind(*at))]
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
    /// This is not JSON, or has a `"type"` that is not a string, between which `serde_json` makes no difference.
    #[error("{at}: syntax error: {message}")]
    Syntax {
        /// Where that shows.
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
    /// This is JSON, but its outermost object is not GeoJSON.
    #[error("{at}: not GeoJSON: {fault}")]
    NotGeoJson {
        /// Where that shows.
        at: Place,
        /// What is wrong.
        fault: Fault,
    },
    /// One element of `"features"` is wrong, or the positions or collections of a feature or geometry on its own.
    #[error("{at}: feature {index}{}: {fault}", Named(.name.as_deref()))]
    Feature {
        /// The place of the feature among the others, the first being 0.
        index: usize,
        /// Its name, if it has one and could be read as a whole: faults of the form have no name.
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
    /// The object is not of the form that its type asks for.
    #[error("{message}")]
    Malformed {
        /// What the `geojson` crate says, cut after 200 characters.
        message: String,
    },
    /// A number that no 64-bit float comes near to.
    #[error("a number out of range")]
    OutOfRange,
    /// A position with one number, or none. That of a `Point` is [`Fault::Malformed`], since the crate sees to it.
    #[error("a position needs two numbers, this one has {numbers}")]
    ShortPosition {
        /// How many numbers it has.
        numbers: usize,
    },
    /// A geometry inside more than [`MAX_NESTED_COLLECTIONS`](crate::io::MAX_NESTED_COLLECTIONS) geometry collections,
    /// or arrays and objects inside each other more than about 128 deep.
    #[error("nested too deep")]
    TooDeep,
}

/// A name in brackets, or nothing.
struct Named<'a>(Option<&'a str>);

impl fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.map_or(Ok(()), |name| write!(f, " ({name})"))
    }
}
