//! The errors of reading the streams, with their positions.

use std::fmt;

/// The error of reading a topology.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// The stream itself could not be read.
    #[error("cannot read the stream")]
    Io(#[from] std::io::Error),
    /// The content violates the format.
    #[error("byte {byte}, {place}: {cause}")]
    Content {
        /// The place where reading ended, counted from 0 over all streams.
        byte: u64,
        /// The table, row and column.
        place: Place,
        /// The error.
        cause: Cause,
    },
    /// The memory does not suffice for the topology.
    #[error("not enough memory")]
    OutOfMemory,
}

/// A place in the streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Place {
    /// The table.
    pub table: TableName,
    /// The row, counted from 1 in the order of the stream; 0 before the first.
    pub row: u64,
    /// The column, if the fault is in one.
    pub column: Option<&'static str>,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "table {}", self.table)?;
        if self.row > 0 {
            write!(f, ", row {}", self.row)?;
        }
        match self.column {
            Some(column) => write!(f, ", column {column}"),
            None => Ok(()),
        }
    }
}

/// A table of a topology, in the order of the streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "the names are those of the tables")]
pub enum TableName {
    Node,
    Face,
    EdgeData,
}

impl fmt::Display for TableName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Node => "node",
            Self::Face => "face",
            Self::EdgeData => "edge_data",
        })
    }
}

/// An error in a stream.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Cause {
    /// There is nothing.
    #[error("the stream is empty: `psql` has written nothing")]
    Empty,
    /// The stream does not begin like a binary COPY stream.
    #[error("no binary COPY stream begins here, but `{found}`")]
    Signature {
        /// The actual beginning.
        found: Box<str>,
    },
    /// The stream ends early: perhaps an error stopped `psql`.
    #[error("the stream ends here, before its end: has `psql` reported an error?")]
    Truncated,
    /// A flag of the header indicates another format.
    #[error("the header has flags {0:#x}, which this reader does not know")]
    Flags(u32),
    /// A row has another number of columns.
    #[error("a row of {found} columns, where {expected} are expected")]
    Columns {
        /// The number in the row.
        found: i16,
        /// The number in the table.
        expected: u16,
    },
    /// A value has a negative length.
    #[error("a value of {0} bytes")]
    Length(i32),
    /// An integer is neither of 4 nor of 8 bytes.
    #[error("an integer of {0} bytes, where 4 or 8 are expected")]
    Width(usize),
    /// A geometry has an invalid byte order.
    #[error("a geometry with byte order {0}, where 0 or 1 is expected")]
    ByteOrder(u8),
    /// A geometry ends early.
    #[error("the geometry ends before its end")]
    GeometryTruncated,
    /// A geometry ends before its value does.
    #[error("{0} bytes follow the end of the geometry")]
    GeometryTrailing(usize),
    /// There are more than 2³¹ − 2 rows in a table, or 2³² − 2 bends.
    #[error("more rows or bends than can be numbered")]
    TooLarge,
    /// Further data follows the last stream.
    #[error("something follows the last of the three streams")]
    Trailing,
}
