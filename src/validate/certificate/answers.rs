//! The structure as the tests read it: each link from the structure if it stores it, and from the labels if not.

use super::columns::{Column, Labels};
use crate::validate::structure::{BoundaryPlace, Link, Part, Parts, Start, View};

/// A structure together with labels. What is asked of a slot that is vacant, or not there, is nil.
pub(super) struct Answers<'a, V: ?Sized> {
    pub(super) view: &'a V,
    pub(super) labels: &'a Labels,
    parts: Parts,
    /// The numbers of slots, asked for once.
    pub(super) vertices: usize,
    pub(super) half_edges: usize,
    pub(super) boundaries: usize,
    pub(super) faces: usize,
}

impl<'a, V: View + ?Sized> Answers<'a, V> {
    pub(super) fn new(view: &'a V, labels: &'a Labels) -> Self {
        let parts = view.parts();
        let by_record = parts.has(Part::BoundaryComponents);
        let length = |column| labels.column(column).len();
        Self {
            view,
            labels,
            parts,
            vertices: view.vertex_slots(),
            half_edges: view.half_edge_slots(),
            boundaries: if by_record { view.boundary_slots() } else { length(Column::BoundaryFace) },
            faces: if parts.has(Part::Faces) { view.face_slots() } else { length(Column::FaceOuter) },
        }
    }

    /// True if the structure has records for boundary components.
    pub(super) fn by_record(&self) -> bool {
        self.parts.has(Part::BoundaryComponents)
    }

    /// True if half-edges and faces name each other, without boundary components.
    pub(super) fn by_name(&self) -> bool {
        self.parts.has(Part::Faces) && !self.by_record()
    }

    pub(super) fn is_vertex(&self, v: usize) -> bool {
        v < self.vertices && self.view.is_vertex(v)
    }

    pub(super) fn is_half_edge(&self, h: usize) -> bool {
        h < self.half_edges && self.view.is_half_edge(h)
    }

    pub(super) fn is_boundary(&self, b: usize) -> bool {
        b < self.boundaries && (!self.by_record() || self.view.is_boundary(b))
    }

    pub(super) fn is_face(&self, f: usize) -> bool {
        f < self.faces && (!self.parts.has(Part::Faces) || self.view.is_face(f))
    }

    pub(super) fn origin(&self, h: usize) -> Link {
        if self.is_half_edge(h) { self.view.origin(h) } else { None }
    }

    pub(super) fn twin(&self, h: usize) -> Link {
        if self.is_half_edge(h) { self.view.twin(h) } else { None }
    }

    pub(super) fn next(&self, h: usize) -> Link {
        if self.is_half_edge(h) { self.view.next(h) } else { None }
    }

    pub(super) fn prev(&self, h: usize) -> Link {
        match self.is_half_edge(h) {
            false => None,
            true if self.parts.has(Part::Prev) => self.view.prev(h),
            true => self.labels.link(Column::HalfEdgePrev, h),
        }
    }

    pub(super) fn boundary(&self, h: usize) -> Link {
        match self.is_half_edge(h) {
            false => None,
            true if self.by_record() => self.view.boundary(h),
            true => self.labels.link(Column::HalfEdgeBoundary, h),
        }
    }

    pub(super) fn leaving(&self, v: usize) -> Link {
        match self.is_vertex(v) {
            false => None,
            true if self.parts.has(Part::Leaving) => self.view.leaving(v),
            true => self.labels.link(Column::VertexLeaving, v),
        }
    }

    pub(super) fn isolated(&self, v: usize) -> Link {
        match self.is_vertex(v) {
            false => None,
            true if self.by_record() => self.view.isolated(v),
            true => self.labels.link(Column::VertexIsolated, v),
        }
    }

    pub(super) fn boundary_face(&self, b: usize) -> Link {
        match self.is_boundary(b) {
            false => None,
            true if self.by_record() => self.view.boundary_face(b),
            true => self.labels.link(Column::BoundaryFace, b),
        }
    }

    pub(super) fn start(&self, b: usize) -> Option<Start> {
        if !self.is_boundary(b) {
            return None;
        }
        if self.by_record() {
            return self.view.boundary_start(b);
        }
        match (self.labels.link(Column::BoundaryStart, b), self.labels.link(Column::BoundaryVertex, b)) {
            (Some(h), None) => Some(Start::HalfEdge(h)),
            (None, Some(v)) => Some(Start::Vertex(v)),
            _ => None,
        }
    }

    pub(super) fn place(&self, b: usize) -> Option<BoundaryPlace> {
        match self.is_boundary(b) {
            false => None,
            true if self.parts.has(Part::Places) => self.view.boundary_place(b),
            true => Some(self.labels.link(Column::BoundaryPlace, b).map_or(BoundaryPlace::Outer, BoundaryPlace::Inner)),
        }
    }

    pub(super) fn outer(&self, f: usize) -> Link {
        match self.is_face(f) {
            false => None,
            true if self.by_record() => self.view.outer(f),
            true => self.labels.link(Column::FaceOuter, f),
        }
    }

    pub(super) fn inner_count(&self, f: usize) -> usize {
        match self.is_face(f) {
            false => 0,
            true if self.by_record() => self.view.inner_count(f),
            true => {
                let (begin, end) = self.labels.list(f);
                end.saturating_sub(begin)
            }
        }
    }

    pub(super) fn inner(&self, f: usize, i: usize) -> Link {
        if i >= self.inner_count(f) {
            None
        } else if self.by_record() {
            self.view.inner(f, i)
        } else {
            self.labels.link(Column::FaceInner, self.labels.list(f).0.checked_add(i)?)
        }
    }
}
