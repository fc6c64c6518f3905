//! The walks along the cycles: L2, B1, F1, F2 and the faces' half of B2.

use super::extent::{Extent, existing};
use super::links::Links;
use super::marks::Marks;
use crate::validate::expectation::Part;
use crate::validate::view::{BoundaryPlace, Start, View};
use alloc::vec::Vec;

/// What the walks along the cycles find.
pub(super) struct Boundaries {
    pub(super) faces: usize,
    /// How many faces have an outer boundary component.
    pub(super) outer: usize,
    pub(super) inner: Vec<Inner>,
    /// How many of the inner boundary components are isolated vertices.
    pub(super) at_vertex: usize,
    pub(super) cycles: usize,
}

/// An inner boundary component: where it starts, and the face that lists it.
#[derive(Clone, Copy)]
pub(super) struct Inner {
    pub(super) vertex: u32,
    pub(super) face: u32,
}

/// The walks so far.
struct Walks<'a, V: ?Sized> {
    view: &'a V,
    extent: Extent,
    links: &'a Links,
    /// How many half-edges were visited.
    visited: usize,
    found: Boundaries,
}

/// Walks along every cycle, from where faces list it.
pub(super) fn walk<V: View + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Boundaries> {
    let found = Boundaries { faces: 0, outer: 0, inner: Vec::new(), at_vertex: 0, cycles: 0 };
    let mut walks = Walks { view, extent, links, visited: 0, found };
    if !extent.has(Part::Faces) {
        walks.every_cycle()?;
    } else if extent.has(Part::BoundaryComponents) {
        walks.by_record()?;
    } else {
        walks.by_label()?;
    }
    let unbounded = walks.found.faces - walks.found.outer;
    let complete = walks.visited == links.half_edges && unbounded == usize::from(extent.has(Part::UnboundedFace));
    complete.then_some(walks.found)
}

impl<V: View + ?Sized> Walks<'_, V> {
    /// Without faces: from the first half-edge of each cycle.
    #[inline(never)]
    fn every_cycle(&mut self) -> Option<()> {
        let mut passed = Marks::new(self.extent.half_edges)?;
        for start in 0..self.extent.half_edges {
            if !passed.has(start) && self.view.is_half_edge(start) {
                self.along(start, |h| passed.mark(h))?;
            }
        }
        Some(())
    }

    /// With records: every boundary component is listed once, by the face it names, at the place it says.
    #[inline(never)]
    fn by_record(&mut self) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let boundaries = (0..extent.boundaries).filter(|b| view.is_boundary(*b)).count();
        let mut listed = Marks::new(extent.boundaries)?;
        let mut entries = 0_usize;
        for f in (0..extent.faces).filter(|f| view.is_face(*f)) {
            self.found.faces += 1;
            let outer = view.outer(f);
            let inner = if extent.has(Part::Holes) { view.inner_count(f) } else { 0 };
            entries = entries.checked_add(inner)?.checked_add(usize::from(outer.is_some()))?;
            if entries > boundaries {
                return None;
            }
            if let Some(b) = outer {
                self.record(f, b, BoundaryPlace::Outer, &mut listed)?;
            }
            for i in 0..inner {
                self.record(f, view.inner(f, i)?, BoundaryPlace::Inner(i), &mut listed)?;
            }
        }
        (entries == boundaries).then_some(())
    }

    /// Walks along a boundary component that this face lists.
    #[inline]
    fn record(&mut self, f: usize, b: usize, place: BoundaryPlace, listed: &mut Marks) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let is_there = b < extent.boundaries && view.is_boundary(b) && view.boundary_face(b) == Some(f);
        if !is_there || extent.has(Part::Places) && view.boundary_place(b) != Some(place) {
            return None;
        }
        listed.mark(b)?;
        let start = view.boundary_start(b)?;
        self.enter(f, start, place)?;
        if let Start::HalfEdge(start) = start {
            self.along(start, |h| (view.boundary(h) == Some(b)).then_some(()))?;
        }
        Some(())
    }

    /// Without records: every cycle is listed once, by the face that its half-edges name. Two cycles of different faces do
    /// not meet, so only those of a face with several are marked.
    #[inline(never)]
    fn by_label(&mut self) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let mut passed = Marks::default();
        let mut listed = Marks::default();
        for f in (0..extent.faces).filter(|f| view.is_face(*f)) {
            self.found.faces += 1;
            let outer = view.outer_half_edge(f);
            let inner = if extent.has(Part::Holes) { view.inner_count(f) } else { 0 };
            let of_f = |h| (view.face(h) == Some(f)).then_some(());
            let is_alone = inner == usize::from(outer.is_none());
            if !is_alone {
                passed.make_room(extent.half_edges)?;
            }
            let outer = outer.map(|start| (Some(Start::HalfEdge(start)), BoundaryPlace::Outer));
            let inner = (0..inner).map(|i| (view.inner_start(f, i), BoundaryPlace::Inner(i)));
            for (start, place) in outer.into_iter().chain(inner) {
                let start = start?;
                self.enter(f, start, place)?;
                match start {
                    Start::Vertex(v) => self.isolated(v, &mut listed)?,
                    Start::HalfEdge(start) if is_alone => self.along(start, of_f)?,
                    Start::HalfEdge(start) => self.along(start, |h| of_f(h).and_then(|()| passed.mark(h)))?,
                }
            }
        }
        Some(())
    }

    /// Walks along one cycle, all of whose half-edges may be visited.
    #[inline]
    fn along(&mut self, start: usize, mut visit: impl FnMut(usize) -> Option<()>) -> Option<()> {
        let (view, half_edges, with_prev) = (self.view, self.extent.half_edges, self.extent.has(Part::Prev));
        let mut h = existing(Some(start), half_edges).filter(|h| view.is_half_edge(*h))?;
        for visited in self.visited + 1..=self.links.half_edges {
            visit(h)?;
            let n = existing(view.next(h), half_edges)?;
            if with_prev && view.prev(n) != Some(h) {
                return None;
            }
            if n == start {
                self.visited = visited;
                self.found.cycles += 1;
                return Some(());
            }
            h = n;
        }
        None
    }

    /// Notes an isolated vertex that a face lists.
    #[cold]
    fn isolated(&self, v: usize, listed: &mut Marks) -> Option<()> {
        listed.make_room(self.extent.vertices)?;
        listed.mark(v)?;
        (self.view.is_vertex(v) && self.links.leaving(self.view, v).is_none()).then_some(())
    }

    /// Counts a boundary component that a face lists.
    #[inline]
    fn enter(&mut self, f: usize, start: Start, place: BoundaryPlace) -> Option<()> {
        let vertex = match start {
            Start::HalfEdge(h) => self.view.origin(existing(Some(h), self.extent.half_edges)?),
            Start::Vertex(_) if place == BoundaryPlace::Outer => None,
            Start::Vertex(v) => Some(v),
        };
        let vertex = existing(vertex, self.extent.vertices)? as u32;
        if place == BoundaryPlace::Outer {
            self.found.outer += 1;
            return Some(());
        }
        self.found.at_vertex += usize::from(matches!(start, Start::Vertex(_)));
        self.found.inner.try_reserve(1).ok()?;
        self.found.inner.push(Inner { vertex, face: f as u32 });
        Some(())
    }
}
