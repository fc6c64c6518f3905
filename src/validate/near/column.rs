//! Rows by index, each of which can be marked, and lists of those that are.

use alloc::vec::Vec;

/// What a column has for each index.
pub(super) trait Row: Copy {
    /// What a vacant slot has.
    const VACANT: Self;
}

/// Rows by index, vacant beyond the end. Each has the place that it takes in a list of [`Seen`] ones, from 1 on, or 0.
#[derive(Clone, Debug)]
pub(super) struct Column<R> {
    rows: Vec<(R, u32)>,
}

impl<R> Default for Column<R> {
    fn default() -> Self {
        Self { rows: Vec::new() }
    }
}

impl<R: Row> Column<R> {
    #[inline]
    pub(super) fn get(&self, index: usize) -> R {
        self.rows.get(index).map_or(R::VACANT, |row| row.0)
    }

    pub(super) fn row_mut(&mut self, index: usize) -> Option<&mut R> {
        self.rows.get_mut(index).map(|row| &mut row.0)
    }

    pub(super) fn push(&mut self, row: R) {
        self.rows.push((row, 0));
    }

    /// All rows, by index.
    #[cfg(feature = "geometry")]
    pub(super) fn iter(&self) -> impl Iterator<Item = (usize, R)> + '_ {
        self.rows.iter().map(|row| row.0).enumerate()
    }

    #[cfg(feature = "geometry")]
    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Makes it as long as there are slots, if it is shorter.
    pub(super) fn fit(&mut self, slots: usize) {
        if self.rows.len() < slots {
            self.rows.resize(slots, (R::VACANT, 0));
        }
    }

    /// Where a slot is in the list of seen ones.
    #[inline]
    pub(super) fn position(&self, index: usize) -> Option<usize> {
        self.rows.get(index).and_then(|row| (row.1 as usize).checked_sub(1))
    }
}

/// Some slots of a column, each once, in the order in which they were seen, with what is known of them. Finding one is O(1), as
/// the column has its position.
#[derive(Clone, Debug)]
pub(super) struct Seen<T> {
    rows: Vec<(u32, T)>,
}

impl<T> Default for Seen<T> {
    fn default() -> Self {
        Self { rows: Vec::new() }
    }
}

impl<T> Seen<T> {
    /// The position of a slot, with `what` if it is a new one. Nothing if the column has no such row: it is, and was, vacant.
    #[inline]
    pub(super) fn see<R: Row>(&mut self, column: &mut Column<R>, index: usize, what: T) -> Option<usize> {
        let (_, mark) = column.rows.get_mut(index)?;
        if *mark == 0 {
            self.rows.push((index as u32, what));
            *mark = self.rows.len() as u32;
        }
        Some(*mark as usize - 1)
    }

    /// Forgets all of them. Keeps the memory. O(their number).
    pub(super) fn clear<R: Row>(&mut self, column: &mut Column<R>) {
        for (index, _) in self.rows.drain(..) {
            if let Some(row) = column.rows.get_mut(index as usize) {
                row.1 = 0;
            }
        }
    }

    #[cfg(feature = "geometry")]
    #[inline]
    pub(super) fn find<R: Row>(&self, column: &Column<R>, index: usize) -> Option<&T> {
        self.rows.get(column.position(index)?).map(|row| &row.1)
    }

    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// The slot at a position below the length.
    #[inline]
    pub(super) fn slot(&self, position: usize) -> usize {
        self.rows[position].0 as usize
    }

    #[inline]
    pub(super) fn at(&self, position: usize) -> &T {
        &self.rows[position].1
    }

    #[inline]
    pub(super) fn at_mut(&mut self, position: usize) -> &mut T {
        &mut self.rows[position].1
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = (usize, &T)> + '_ {
        self.rows.iter().map(|(index, what)| (*index as usize, what))
    }
}
