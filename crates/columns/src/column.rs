//! One column of links: cells of a slice at a fixed stride.

use crate::cell::Cell;
use crate::error::ColumnsError;
use twinedge::validate::Link;

/// Links by position.
pub(crate) trait Links: Copy {
    fn len(&self) -> usize;
    /// Returns the link at this position, which must not be past the end.
    fn at(&self, position: usize) -> Link;
    /// The links as a slice, if they lie in memory as a view lends them.
    fn numbers(&self) -> Option<&[u32]> {
        None
    }
}

/// A column of links in a slice of integers.
///
/// ```
/// use twinedge_columns::Column;
/// // Two records of three fields each. The column is the second field.
/// let records = [0_i32, 10, 0, 0, -1, 0];
/// let column = Column::strided(&records, 1, 3, 2)?;
/// assert_eq!((column.link(0), column.link(1), column.len()), (Some(10), None, 2));
/// # Ok::<(), twinedge_columns::ColumnsError>(())
/// ```
#[derive(Debug)]
pub struct Column<'a, T> {
    /// From the first cell of the column in memory to the last.
    cells: &'a [T],
    first: usize,
    /// A step of the stride, modulo the size of all positions: a negative step is added like a positive one.
    step: usize,
    len: usize,
}

impl<T> Clone for Column<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Column<'_, T> {}

impl<'a, T: Cell> Column<'a, T> {
    /// Returns the column of all cells.
    #[must_use]
    pub const fn new(cells: &'a [T]) -> Self {
        Self { cells, first: 0, step: 1, len: cells.len() }
    }

    /// Returns the column of the `len` cells at `first`, `first + stride`, `first + 2 · stride` and so on. A stride may be
    /// negative.
    ///
    /// # Errors
    /// [`ColumnsError::OutOfSlice`] if one of these is not in the slice.
    pub const fn strided(cells: &'a [T], first: usize, stride: isize, len: usize) -> Result<Self, ColumnsError> {
        let error = Err(ColumnsError::OutOfSlice { first, stride, len, cells: cells.len() });
        let Some(steps) = len.checked_sub(1) else { return Ok(Self::new(&[])) };
        let Some(span) = stride.unsigned_abs().checked_mul(steps) else { return error };
        let last = if stride < 0 { first.checked_sub(span) } else { first.checked_add(span) };
        let Some(last) = last else { return error };
        if first >= cells.len() || last >= cells.len() {
            return error;
        }
        let step = stride.unsigned_abs();
        let (lowest, first, step) =
            if stride < 0 { (last, span, 0_usize.wrapping_sub(step)) } else { (first, 0, step) };
        let cells = cells.split_at(lowest).1.split_at(span + 1).0;
        Ok(Self { cells, first, step, len })
    }

    /// Returns the number of links.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.len
    }

    /// Returns true if there are no links.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub(crate) const fn cells(&self) -> Option<&'a [T]> {
        if self.step == 1 || self.len == 0 { Some(self.cells) } else { None }
    }

    /// Returns the same column, if it goes forward in memory.
    pub(crate) const fn forward(&self) -> Option<Forward<'a, T>> {
        if self.first == 0 { Some(Forward { cells: self.cells, step: self.step, len: self.len }) } else { None }
    }

    /// Returns an error if the column of this name has an unexpected length.
    pub(crate) const fn expect_len(&self, column: &'static str, expected: usize) -> Result<(), ColumnsError> {
        if self.len == expected { Ok(()) } else { Err(ColumnsError::Length { column, found: self.len, expected }) }
    }

    /// Returns the link at this position; nil past the end.
    #[inline]
    #[must_use]
    pub fn link(&self, position: usize) -> Link {
        if position < self.len { self.at(position) } else { None }
    }

    /// Returns one more than the largest link, and 0 without links: the number of targets, if none dangles. O(n).
    #[must_use]
    pub fn slots(&self) -> usize {
        (0..self.len).filter_map(|i| self.link(i)).max().map_or(0, |largest| largest.saturating_add(1))
    }
}

impl<T: Cell> Links for Column<'_, T> {
    fn len(&self) -> usize {
        self.len
    }

    #[inline]
    fn at(&self, position: usize) -> Link {
        // Within the column nothing wraps: `strided` has checked both ends.
        self.cells.get(self.first.wrapping_add(position.wrapping_mul(self.step)))?.link()
    }

    fn numbers(&self) -> Option<&[u32]> {
        T::numbers(self.cells()?)
    }
}

impl<T: Cell> Links for &[T] {
    fn len(&self) -> usize {
        <[T]>::len(self)
    }

    #[inline]
    fn at(&self, position: usize) -> Link {
        self.get(position)?.link()
    }

    fn numbers(&self) -> Option<&[u32]> {
        T::numbers(self)
    }
}

/// A column that goes forward in memory: one addition less for each link.
#[derive(Debug)]
pub(crate) struct Forward<'a, T> {
    cells: &'a [T],
    step: usize,
    len: usize,
}

impl<T> Clone for Forward<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Forward<'_, T> {}

impl<T: Cell> Links for Forward<'_, T> {
    fn len(&self) -> usize {
        self.len
    }

    #[inline]
    fn at(&self, position: usize) -> Link {
        self.cells.get(position.wrapping_mul(self.step))?.link()
    }
}
