//! The errors of reading a file, with their positions.

use super::Format;
use std::fmt;

/// The error of reading a mesh file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The file or stream itself could not be read.
    #[error("cannot read the file")]
    Io(#[from] std::io::Error),
    /// Neither the name nor the content indicates the format.
    #[error("neither the name nor the content of the file says which format it has")]
    UnknownFormat,
    /// The content violates the format.
    #[error("{format}, {position}: {cause}")]
    Content {
        /// The format that was expected.
        format: Format,
        /// The place where reading ended.
        position: Position,
        /// The error.
        cause: Cause,
    },
}

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Position {
    /// In text: the line, counted from 1.
    Line(u64),
    /// In binary data: the byte, counted from 0.
    Byte(u64),
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(n) => write!(f, "line {n}"),
            Self::Byte(n) => write!(f, "byte {n}"),
        }
    }
}

/// An error in a file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// Something else stands in this place.
    #[error("expected {what}, found `{found}`")]
    Expected {
        /// The expected text.
        what: &'static str,
        /// The text found, shortened.
        found: Box<str>,
    },
    /// The line or the file ends before this part.
    #[error("expected {what}, but there is nothing more")]
    Truncated {
        /// The missing part.
        what: &'static str,
    },
    /// A coordinate is not a finite number.
    #[error("the coordinate {found} is not finite")]
    NotFinite {
        /// The coordinate.
        found: f64,
    },
    /// A face lists a point that does not exist. The index is as in the file: OBJ counts from 1 (see
    /// [`IndexZero`](Self::IndexZero)), or backwards from −1.
    #[error("a face lists point {index}, but there {}", number_of_points(*points))]
    IndexOutOfRange {
        /// The index in the face.
        index: i64,
        /// The number of points; in OBJ, for a negative index, the number at this line.
        points: usize,
    },
    /// A face of an OBJ file lists point 0.
    #[error("a face lists point 0, but OBJ counts points from 1")]
    IndexZero,
    /// A part of the format that this reader does not support.
    #[error("{0} cannot be read")]
    Unsupported(&'static str),
    /// The header of a PLY file is malformed.
    #[error("the header is malformed: {0}")]
    Header(Box<str>),
    /// The header of a PLY file defines an element or property twice.
    #[error("an element or property is defined twice")]
    DefinedTwice,
    /// The file lacks this: a PLY file in its header, an OBJ file entirely.
    #[error("there is no {0}")]
    Missing(&'static str),
    /// There are more than 2³¹ − 2 points, corners or faces.
    #[error("more than 2,147,483,646 points, corners or faces")]
    TooLarge,
}

/// An error of a reader that does not know which format it reads.
#[derive(Debug)]
pub(super) struct Failure {
    pub(super) position: Position,
    pub(super) cause: Cause,
}

impl Failure {
    pub(super) fn new(position: Position, cause: Cause) -> Self {
        Self { position, cause }
    }
}

fn number_of_points(points: usize) -> String {
    match points {
        0 => "are no points".to_owned(),
        1 => "is 1 point".to_owned(),
        _ => format!("are {points} points"),
    }
}

/// The largest number of characters of a file in a message.
const SHOWN: usize = 32;

pub(super) fn excerpt(bytes: &[u8]) -> Box<str> {
    let start = &bytes[..bytes.len().min(4 * SHOWN)];
    let text = String::from_utf8_lossy(start);
    let mut shown: String = text.chars().take(SHOWN).flat_map(char::escape_debug).collect();
    if start.len() < bytes.len() || text.chars().count() > SHOWN {
        shown.push('…');
    }
    shown.into()
}
