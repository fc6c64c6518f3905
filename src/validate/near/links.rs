//! The links of records as rows of 32-bit numbers, and their reader.

use super::column::Row;
use crate::numbers::NIL;
use crate::validate::expectation::Expectation;
use crate::validate::structure::{BoundaryPlace, Part, Parts, Start, View};

/// The first number of a vacant row.
pub(super) const VACANT: u32 = NIL - 1;
/// The place of an outer boundary component.
pub(super) const OUTER: u32 = NIL;

/// Returns the link in a column, unless it is nil.
#[must_use]
pub fn index(link: u32) -> Option<usize> {
    (link < VACANT).then_some(link as usize)
}

pub(super) fn link(index: Option<usize>) -> u32 {
    index.map_or(NIL, |i| i as u32)
}

/// The links of a half-edge. Its *label* is its boundary component, or its face where there are no boundary components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HalfEdge {
    /// The vertex where it starts.
    pub origin: u32,
    /// Its twin.
    pub twin: u32,
    /// The next half-edge.
    pub next: u32,
    /// The previous half-edge.
    pub prev: u32,
    /// Its label.
    pub label: u32,
}

impl Row for HalfEdge {
    const VACANT: Self = Self { origin: VACANT, twin: NIL, next: NIL, prev: NIL, label: NIL };
}

/// A vertex: a half-edge that leaves it, or nil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vertex {
    /// A half-edge that leaves it.
    pub leaving: u32,
    /// The boundary component of an isolated vertex.
    pub isolated: u32,
}

impl Row for Vertex {
    const VACANT: Self = Self { leaving: VACANT, isolated: NIL };
}

/// The boundary component or face of a label: its start, and the face and place where it is listed. Without records for boundary
/// components it is a face with only a start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// An isolated vertex, or a half-edge.
    starts_at: u32,
    is_vertex: bool,
    /// The face that lists it.
    pub face: u32,
    /// Its place in the list of that face.
    pub place: u32,
}

impl Row for Label {
    const VACANT: Self = Self { starts_at: 0, is_vertex: true, face: VACANT, place: OUTER };
}

impl Label {
    fn new(start: Start, face: u32, place: u32) -> Self {
        match start {
            Start::HalfEdge(h) => Self { starts_at: h as u32, is_vertex: false, face, place },
            Start::Vertex(v) => Self { starts_at: v as u32, is_vertex: true, face, place },
        }
    }
    /// Returns the half-edge or isolated vertex where it starts.
    #[must_use]
    pub const fn start(&self) -> Start {
        let at = self.starts_at as usize;
        if self.is_vertex { Start::Vertex(at) } else { Start::HalfEdge(at) }
    }
    /// Returns the isolated vertex of a live label.
    #[must_use]
    pub fn vertex(&self) -> Option<usize> {
        (self.is_live() && self.is_vertex).then_some(self.starts_at as usize)
    }
    /// Returns the face that lists it as an inner boundary component, with the position.
    #[must_use]
    pub fn inner(&self) -> Option<(usize, usize)> {
        (self.is_live() && self.place != OUTER).then_some((self.face as usize, self.place as usize))
    }
}

/// A face, if boundary components are records: its outer boundary component, or nil, and the number of inner ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Its outer boundary component.
    pub outer: u32,
    /// The number of inner boundary components.
    pub inner: u32,
}

impl Row for Face {
    const VACANT: Self = Self { outer: VACANT, inner: 0 };
}

/// Reads the current links of a structure: its view, numbers of slots, and parts.
pub(super) struct LinkReader<'a, V: ?Sized> {
    pub(super) view: &'a V,
    pub(super) expect: Expectation,
    parts: Parts,
    pub(super) vertices: usize,
    pub(super) half_edges: usize,
    pub(super) labels: usize,
    pub(super) faces: usize,
}

impl<'a, V: View + ?Sized> LinkReader<'a, V> {
    /// Returns `None` if there are more slots than 32-bit numbers.
    pub(super) fn new(view: &'a V, expect: Expectation) -> Option<Self> {
        let (vertices, half_edges) = (view.vertex_slots(), view.half_edge_slots());
        let parts = expect.looks_at(view.parts());
        let faces = if parts.has(Part::Faces) { view.face_slots() } else { 0 };
        let labels = if parts.has(Part::BoundaryComponents) { view.boundary_slots() } else { faces };
        let fits = [vertices, half_edges, labels, faces].iter().all(|slots| *slots < VACANT as usize);
        fits.then_some(Self { view, expect, parts, vertices, half_edges, labels, faces })
    }

    pub(super) const fn has(&self, part: Part) -> bool {
        self.parts.has(part)
    }
    pub(super) fn is_vertex(&self, v: usize) -> bool {
        v < self.vertices && self.view.is_vertex(v)
    }
    pub(super) fn is_half_edge(&self, h: usize) -> bool {
        h < self.half_edges && self.view.is_half_edge(h)
    }
    pub(super) fn is_label(&self, b: usize) -> bool {
        let is_live = if self.has(Part::BoundaryComponents) { V::is_boundary } else { V::is_face };
        b < self.labels && is_live(self.view, b)
    }
    pub(super) fn is_face(&self, f: usize) -> bool {
        f < self.faces && self.view.is_face(f)
    }

    /// Returns a half-edge with its links, vacant if the slot is; `None` if a link does not lead to a live record.
    pub(super) fn half_edge(&self, h: usize) -> Option<HalfEdge> {
        if !self.is_half_edge(h) {
            return Some(HalfEdge::VACANT);
        }
        let half_edge = |link: Option<usize>| link.filter(|h| self.is_half_edge(*h)).map(|h| h as u32);
        let origin = self.view.origin(h).filter(|v| self.is_vertex(*v))? as u32;
        let (twin, next) = (half_edge(self.view.twin(h))?, half_edge(self.view.next(h))?);
        let prev = if self.has(Part::Prev) { half_edge(self.view.prev(h))? } else { NIL };
        let label = if self.has(Part::Faces) { self.label_of(h).filter(|b| self.is_label(*b))? as u32 } else { NIL };
        Some(HalfEdge { origin, twin, next, prev, label })
    }

    /// Returns the current `next`. A view that changes its answers may return any link.
    pub(super) fn next(&self, h: usize) -> Option<usize> {
        if h < self.half_edges { self.view.next(h) } else { None }
    }

    pub(super) fn clockwise(&self, h: usize) -> Option<usize> {
        if h < self.half_edges { self.next(self.view.twin(h)?) } else { None }
    }

    pub(super) fn label_of(&self, h: usize) -> Option<usize> {
        if self.has(Part::BoundaryComponents) { self.view.boundary(h) } else { self.view.face(h) }
    }

    /// Returns the boundary component named by an isolated vertex; `None` for a vacant slot.
    pub(super) fn isolated(&self, v: usize) -> Option<usize> {
        let names = self.has(Part::BoundaryComponents) && self.has(Part::Holes) && self.is_vertex(v);
        if names { self.view.isolated(v) } else { None }
    }

    pub(super) fn start(&self, b: usize) -> Option<Start> {
        if self.has(Part::BoundaryComponents) {
            self.view.boundary_start(b)
        } else {
            self.view.outer_half_edge(b).map(Start::HalfEdge)
        }
    }

    /// Returns a face with the length of its list, vacant if the slot is; `None` if its outer boundary component is not live.
    pub(super) fn face(&self, f: usize) -> Option<Face> {
        if !self.is_face(f) {
            return Some(Face::VACANT);
        }
        let outer = match self.view.outer(f) {
            Some(b) => self.is_label(b).then_some(b as u32)?,
            None => NIL,
        };
        let inner = if self.has(Part::Holes) { u32::try_from(self.view.inner_count(f)).ok()? } else { 0 };
        Some(Face { outer, inner })
    }

    /// Returns a label with its links, vacant if the slot is; `None` if a link does not lead to a live record.
    pub(super) fn label(&self, b: usize) -> Option<Label> {
        if !self.is_label(b) {
            return Some(Label::VACANT);
        }
        let start = self.start(b)?;
        let is_live = match start {
            Start::HalfEdge(h) => self.is_half_edge(h),
            Start::Vertex(v) => self.is_vertex(v),
        };
        if !is_live {
            return None;
        }
        if !self.has(Part::BoundaryComponents) {
            return Some(Label::new(start, b as u32, OUTER));
        }
        let face = self.view.boundary_face(b).filter(|f| self.is_face(*f))? as u32;
        let place = match self.has(Part::Places).then(|| self.view.boundary_place(b)) {
            None | Some(Some(BoundaryPlace::Outer)) => OUTER,
            Some(Some(BoundaryPlace::Inner(i))) => u32::try_from(i).ok().filter(|i| *i < VACANT)?,
            Some(None) => return None,
        };
        Some(Label::new(start, face, place))
    }
}
