//! The errors of columns that form no structure.

use core::fmt;

/// The error of columns that form no structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ColumnsError {
    /// The length of a column differs from the number of records.
    Length {
        /// The link in the column.
        column: &'static str,
        /// The number of links in it.
        found: usize,
        /// The number of records.
        expected: usize,
    },
    /// A column exceeds its slice.
    OutOfSlice {
        /// The position of its first cell.
        first: usize,
        /// The number of cells from one link to the next.
        stride: isize,
        /// The number of links in it.
        len: usize,
        /// The length of the slice.
        cells: usize,
    },
}

impl fmt::Display for ColumnsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { column, found, expected } => {
                write!(f, "the column `{column}` has length {found}, where {expected} is expected")
            }
            Self::OutOfSlice { first, stride, len, cells } => {
                write!(f, "{len} cells from {first} in steps of {stride} are not in a slice of {cells}")
            }
        }
    }
}

impl core::error::Error for ColumnsError {}
