//! The links of a structure before a change and after it.

use super::column::{Column, Row};
use super::links::{Face, HalfEdge, Label, LinkReader, Vertex};
use crate::validate::columns::NIL;
use crate::validate::structure::{Part, View};

/// Sums over a whole structure.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sums {
    /// Unbounded faces.
    pub(super) unbounded: i64,
    /// 2V − 2E + 2F less two for each inner boundary component.
    pub(super) euler: i64,
}

/// The links of a structure that was right, and of each record that may differ, its links now. With coordinates, the places of
/// vertices, too. Every check near a change reads only this.
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
    /// Nothing has changed, and there is room for the records that there are now.
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

    /// Adds up the sums after the change.
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

    /// Lets all be as it is after the change.
    pub(super) fn commit(&mut self) {
        self.before = self.after;
        self.half_edges.commit();
        self.vertices.commit();
        self.labels.commit();
        self.faces.commit();
    }

    /// The half-edge that followed clockwise in the rotation.
    pub(super) fn clockwise_before(&self, h: usize) -> usize {
        self.half_edges.before(self.half_edges.before(h).twin as usize).next as usize
    }

    /// One of the half-edges on an orbit of before that still `stay` there. It costs a step for each that does not, and these may all
    /// differ.
    pub(super) fn remaining(
        &self,
        first: Option<usize>,
        step: impl Fn(usize) -> usize,
        stays: impl Fn(HalfEdge) -> bool,
    ) -> Option<usize> {
        let orbit = core::iter::successors(first, |h| Some(step(*h)).filter(|next| Some(*next) != first));
        // No longer than there are some that may differ, in case the structure before was not right because something was not named.
        let stays = |h: &usize| !self.half_edges.may_differ(*h) || stays(self.half_edges.after(*h));
        orbit.take(self.half_edges.len() + 1).find(stays)
    }
}
