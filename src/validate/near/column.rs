//! Rows by index, before and after a change.

use alloc::vec::Vec;

/// An entry of a column.
pub trait Row: Copy + PartialEq {
    /// The row of a vacant slot.
    const VACANT: Self;

    /// Returns false for a vacant slot.
    #[inline]
    fn is_live(&self) -> bool {
        *self != Self::VACANT
    }
}

/// Before or after a change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Time {
    /// Before the change.
    Before,
    /// After it.
    After,
}

/// Both times, in order.
pub const TIMES: [Time; 2] = [Time::Before, Time::After];

/// Rows by index, vacant beyond the end, and the new state of changed rows. Finding a row takes O(1) at both times.
#[derive(Clone, Debug)]
pub struct Column<R> {
    /// Each row with its position in `after`, from 1 on, or 0.
    before: Vec<(R, u32)>,
    /// Rows that may differ, without repetitions, with their indices.
    after: Vec<(u32, R)>,
}

impl<R> Default for Column<R> {
    fn default() -> Self {
        Self { before: Vec::new(), after: Vec::new() }
    }
}

impl<R: Row> Column<R> {
    /// Extends the column to this number of slots.
    pub fn fit(&mut self, slots: usize) {
        if self.before.len() < slots {
            self.before.resize(slots, (R::VACANT, 0));
        }
    }

    /// Returns the number of rows. O(1).
    #[must_use]
    pub fn slots(&self) -> usize {
        self.before.len()
    }

    /// Returns the row before the change. O(1).
    #[inline]
    #[must_use]
    pub fn before(&self, index: usize) -> R {
        self.before.get(index).map_or(R::VACANT, |row| row.0)
    }

    /// Returns the row after the change. O(1).
    #[inline]
    #[must_use]
    pub fn after(&self, index: usize) -> R {
        match self.before.get(index) {
            Some((row, 0)) => *row,
            Some((_, position)) => self.after[*position as usize - 1].1,
            None => R::VACANT,
        }
    }

    /// Returns the row before or after the change. O(1).
    #[inline]
    #[must_use]
    pub fn at(&self, time: Time, index: usize) -> R {
        match time {
            Time::Before => self.before(index),
            Time::After => self.after(index),
        }
    }

    /// Returns true if the row may differ.
    #[inline]
    #[must_use]
    pub fn may_differ(&self, index: usize) -> bool {
        self.before.get(index).is_some_and(|row| row.1 != 0)
    }

    /// Returns the row after the change, marking it as possibly different; `None` if the column has no such row, because it
    /// is and was vacant.
    #[inline]
    pub fn change(&mut self, index: usize) -> Option<&mut R> {
        let (row, position) = self.before.get_mut(index)?;
        if *position == 0 {
            self.after.push((index as u32, *row));
            *position = self.after.len() as u32;
        }
        self.after.get_mut(*position as usize - 1).map(|row| &mut row.1)
    }

    #[inline]
    pub(super) fn note(&mut self, index: usize) {
        let _ = self.change(index);
    }

    pub(super) fn note_all(&mut self, indices: &[usize]) {
        for index in indices {
            self.note(*index);
        }
    }

    pub(super) fn len(&self) -> usize {
        self.after.len()
    }

    #[inline]
    pub(super) fn index(&self, position: usize) -> usize {
        self.after[position].0 as usize
    }

    #[inline]
    pub(super) fn put(&mut self, position: usize, row: R) {
        self.after[position].1 = row;
    }

    /// Returns all rows that may differ: index, before, after.
    pub fn changes(&self) -> impl Iterator<Item = (usize, R, R)> + '_ {
        self.after.iter().map(|(index, row)| (*index as usize, self.before(*index as usize), *row))
    }

    pub(super) fn growth(&self, term: impl Fn(R) -> i64) -> i64 {
        self.changes().map(|(_, before, after)| term(after) - term(before)).sum()
    }

    /// Forgets the changes, but keeps the memory.
    pub fn clear(&mut self) {
        for (index, _) in self.after.drain(..) {
            self.before[index as usize].1 = 0;
        }
    }

    /// Replaces the rows by their state after the change. If most rows changed, frees the memory for changes.
    pub fn commit(&mut self) {
        for (index, row) in self.after.drain(..) {
            self.before[index as usize] = (row, 0);
        }
        if self.after.capacity() > self.before.len() / 2 {
            self.after = Vec::new();
        }
    }
}
