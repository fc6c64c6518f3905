//! The records written by a change, and rows of links by index before and after it.

use super::links::{Face, HalfEdge, Label, LinkReader, Vertex};
use crate::slots::NIL;
use crate::validate::structure::{Part, View};
use alloc::vec::Vec;

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    pub(super) unbounded: i64,
    /// 2V − 2E + 2F − 2 · (inner boundary components).
    pub(super) euler: i64,
}

/// The links of a valid structure, and the new links of each record that may differ. With coordinates, also the places of vertices.
/// Every check near a change reads only this.
#[derive(Clone, Debug, Default)]
pub struct Diff {
    /// Half-edges.
    pub half_edges: Column<HalfEdge>,
    /// Vertices.
    pub vertices: Column<Vertex>,
    /// Boundary components, or faces where there are none.
    pub labels: Column<Label>,
    /// Faces, where there are boundary components.
    pub faces: Column<Face>,
    before: Sums,
    after: Sums,
}

impl Diff {
    /// Forgets the changes, and makes room for the current records.
    pub(super) fn clear<V: View + ?Sized>(&mut self, now: &LinkReader<'_, V>) {
        self.half_edges.clear();
        self.vertices.clear();
        self.labels.clear();
        self.faces.clear();
        self.half_edges.fit(now.half_edges);
        self.vertices.fit(now.vertices);
        self.labels.fit(now.labels);
        if now.has(Part::BoundaryComponents) {
            self.faces.fit(now.faces);
        }
    }

    pub(super) fn add_up(&mut self) -> Sums {
        let half_edges = self.half_edges.growth(|row| i64::from(row.is_live()));
        let vertices = self.vertices.growth(|row| i64::from(row.is_live()));
        let faces = self.faces.growth(|row| i64::from(row.is_live()) - i64::from(row.inner));
        let unbounded = self.faces.growth(|row| i64::from(row.outer == NIL));
        self.after = Sums {
            unbounded: self.before.unbounded + unbounded,
            euler: self.before.euler + 2 * (vertices + faces) - half_edges,
        };
        self.after
    }

    pub(super) fn commit(&mut self) {
        self.before = self.after;
        self.half_edges.commit();
        self.vertices.commit();
        self.labels.commit();
        self.faces.commit();
    }

    pub(super) fn clockwise_before(&self, h: usize) -> usize {
        self.half_edges.before(self.half_edges.before(h).twin as usize).next as usize
    }

    /// Finds a half-edge on an old orbit for which `stays` holds. Costs a step for each other half-edge; all of these may differ.
    pub(super) fn remaining(
        &self,
        first: Option<usize>,
        step: impl Fn(usize) -> usize,
        stays: impl Fn(HalfEdge) -> bool,
    ) -> Option<usize> {
        let orbit = core::iter::successors(first, |h| Some(step(*h)).filter(|next| Some(*next) != first));
        // Limited to the number of half-edges that may differ, in case an unnamed change made the previous structure invalid.
        let stays = |h: &usize| !self.half_edges.may_differ(*h) || stays(self.half_edges.after(*h));
        orbit.take(self.half_edges.len() + 1).find(stays)
    }
}

/// The write set of a change, by index: all records that were added or removed, or whose links changed, since the structure was
/// last found valid. It also contains vertices that moved and half-edges with new bends.
///
/// Repetitions are allowed. Naming an unchanged record costs time but does no harm. If a changed record is missing, the answer
/// of [`validate_near`](super::validate_near) is meaningless.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WriteSet {
    /// Vertices.
    pub vertices: Vec<usize>,
    /// Half-edges.
    pub half_edges: Vec<usize>,
    /// Boundary components.
    pub boundaries: Vec<usize>,
    /// Faces whose outer boundary component or list length has changed.
    pub faces: Vec<usize>,
    /// Written entries of the lists of inner boundary components: the face and the position.
    pub listed: Vec<(usize, usize)>,
}

impl WriteSet {
    /// Removes all records, but keeps the memory.
    pub fn clear(&mut self) {
        self.vertices.clear();
        self.half_edges.clear();
        self.boundaries.clear();
        self.faces.clear();
        self.listed.clear();
    }

    /// Adds the records of another write set. O(records).
    pub fn extend(&mut self, more: Self) {
        self.vertices.extend(more.vertices);
        self.half_edges.extend(more.half_edges);
        self.boundaries.extend(more.boundaries);
        self.faces.extend(more.faces);
        self.listed.extend(more.listed);
    }

    /// Returns true if there are no records.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        let Self { vertices, half_edges, boundaries, faces, listed } = self;
        vertices.is_empty() && half_edges.is_empty() && boundaries.is_empty() && faces.is_empty() && listed.is_empty()
    }
}

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
