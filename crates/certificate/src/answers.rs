//! The structure as the tests read it: each link from the structure if stored there, otherwise from the labels.

use super::columns::{Column, Labels, MOST_SLOTS};
use super::storage::{Columns, Entries as _, Numbers as _};
use twinedge::validate::{BoundaryPlace, Link, Part, Parts, Start, View};

/// A structure together with labels. Vacant or missing slots answer nil.
pub(super) struct Answers<'a, V: ?Sized, C = Labels> {
    pub(super) view: &'a V,
    pub(super) labels: &'a C,
    parts: Parts,
    /// The numbers of slots, read once.
    pub(super) vertices: usize,
    pub(super) half_edges: usize,
    pub(super) boundaries: usize,
    pub(super) faces: usize,
}

impl<'a, V: View + ?Sized, C: Columns> Answers<'a, V, C> {
    pub(super) fn new(view: &'a V, labels: &'a C) -> Self {
        let parts = view.parts();
        let by_record = parts.has(Part::BoundaryComponents);
        let length = |column| labels.column(column).count();
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

    /// Returns true if each half-edge has a rank, and numbers fit into columns.
    pub(super) fn readable(&self) -> bool {
        let slots = [self.vertices, self.half_edges, self.boundaries, self.faces];
        self.labels.column(Column::HalfEdgeRank).count() == self.half_edges && slots.iter().all(|n| *n <= MOST_SLOTS)
    }

    #[inline(always)]
    pub(super) fn stores(&self, part: Part) -> bool {
        self.parts.has(part)
    }

    /// Returns true if the structure has records for boundary components.
    #[inline(always)]
    pub(super) fn by_record(&self) -> bool {
        self.parts.has(Part::BoundaryComponents)
    }

    /// Returns true if half-edges and faces name each other, without boundary components.
    #[inline(always)]
    pub(super) fn by_name(&self) -> bool {
        self.parts.has(Part::Faces) && !self.by_record()
    }

    #[inline(always)]
    pub(super) fn is_vertex(&self, v: usize) -> bool {
        has(self.vertices, v) && self.view.is_vertex(v)
    }

    #[inline(always)]
    pub(super) fn is_half_edge(&self, h: usize) -> bool {
        has(self.half_edges, h) && self.view.is_half_edge(h)
    }

    #[inline(always)]
    pub(super) fn is_boundary(&self, b: usize) -> bool {
        has(self.boundaries, b) && (!self.by_record() || self.view.is_boundary(b))
    }

    #[inline(always)]
    pub(super) fn is_face(&self, f: usize) -> bool {
        has(self.faces, f) && (!self.parts.has(Part::Faces) || self.view.is_face(f))
    }

    #[inline(always)]
    pub(super) fn origin(&self, h: usize) -> Link {
        if self.is_half_edge(h) { self.view.origin(h) } else { None }
    }

    #[inline(always)]
    pub(super) fn twin(&self, h: usize) -> Link {
        if self.is_half_edge(h) { self.view.twin(h) } else { None }
    }

    #[inline(always)]
    pub(super) fn next(&self, h: usize) -> Link {
        if self.is_half_edge(h) { self.view.next(h) } else { None }
    }

    #[inline(always)]
    pub(super) fn prev(&self, h: usize) -> Link {
        match self.is_half_edge(h) {
            false => None,
            true if self.parts.has(Part::Prev) => self.view.prev(h),
            true => self.labels.link(Column::HalfEdgePrev, h),
        }
    }

    #[inline(always)]
    pub(super) fn links(&self, h: usize) -> [Link; 3] {
        [self.twin(h), self.next(h), self.prev(h)]
    }

    #[inline(always)]
    pub(super) fn kept(&self, h: usize) -> Link {
        self.leaving(self.origin(h)?)
    }

    #[inline(always)]
    pub(super) fn boundary(&self, h: usize) -> Link {
        match self.is_half_edge(h) {
            false => None,
            true if self.by_record() => self.view.boundary(h),
            true => self.labels.link(Column::HalfEdgeBoundary, h),
        }
    }

    #[inline(always)]
    pub(super) fn leaving(&self, v: usize) -> Link {
        match self.is_vertex(v) {
            false => None,
            true if self.parts.has(Part::Leaving) => self.view.leaving(v),
            true => self.labels.link(Column::VertexLeaving, v),
        }
    }

    #[inline(always)]
    pub(super) fn isolated(&self, v: usize) -> Link {
        match self.is_vertex(v) {
            false => None,
            true if self.by_record() => self.view.isolated(v),
            true => self.labels.link(Column::VertexIsolated, v),
        }
    }

    #[inline(always)]
    pub(super) fn boundary_face(&self, b: usize) -> Link {
        match self.is_boundary(b) {
            false => None,
            true if self.by_record() => self.view.boundary_face(b),
            true => self.labels.link(Column::BoundaryFace, b),
        }
    }

    #[inline(always)]
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

    #[inline(always)]
    pub(super) fn place(&self, b: usize) -> Option<BoundaryPlace> {
        match self.is_boundary(b) {
            false => None,
            true if self.parts.has(Part::Places) => self.view.boundary_place(b),
            true => Some(self.labels.link(Column::BoundaryPlace, b).map_or(BoundaryPlace::Outer, BoundaryPlace::Inner)),
        }
    }

    #[inline(always)]
    pub(super) fn outer(&self, f: usize) -> Link {
        match self.is_face(f) {
            false => None,
            true if self.by_record() => self.view.outer(f),
            true => self.labels.link(Column::FaceOuter, f),
        }
    }

    #[inline(always)]
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

    #[inline(always)]
    pub(super) fn inner(&self, f: usize, i: usize) -> Link {
        if i >= self.inner_count(f) {
            None
        } else if self.by_record() {
            self.view.inner(f, i)
        } else {
            self.labels.link(Column::FaceInner, self.labels.list(f).0.checked_add(i)?)
        }
    }

    /// Returns the half-edge at the start of the boundary component, if it is a cycle.
    #[inline(always)]
    pub(super) fn cycle_start(&self, b: usize) -> Link {
        match self.start(b) {
            Some(Start::HalfEdge(h)) => Some(h),
            _ => None,
        }
    }

    #[inline(always)]
    pub(super) fn is_inner(&self, b: usize) -> bool {
        matches!(self.place(b), Some(BoundaryPlace::Inner(_)))
    }

    /// Returns true if the link leads to a half-edge with a lower rank than `h`.
    #[inline(always)]
    pub(super) fn is_lower(&self, link: Link, h: usize) -> bool {
        let rank = self.labels.column(Column::HalfEdgeRank);
        link.and_then(|l| rank.at(l)).zip(rank.at(h)).is_some_and(|(l, h)| l < h)
    }
}

/// Returns true if there is a slot with this number. In 32 bits: for a structure that stores links in 32 bits, with all bits set
/// for nil, one comparison then decides that a link is not nil and that its slot exists.
#[inline(always)]
const fn has(slots: usize, i: usize) -> bool {
    i < slots as u32 as usize
}
