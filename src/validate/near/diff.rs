//! The records written by a change, and their links before and after it.

use super::column::{Column, Row};
use super::links::{Face, HalfEdge, Label, LinkReader, Vertex};
use crate::numbers::NIL;
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
