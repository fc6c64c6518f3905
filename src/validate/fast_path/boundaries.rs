//! The lists of the faces, and the cycles: B1, F1, F2 and the faces' half of B2.

use super::cycles::{Cycles, along};
use super::links::Links;
use super::marks::Marks;
use crate::validate::structure::{BoundaryPlace, Part, Start, View};
use crate::validate::subject::Extent;
use alloc::vec::Vec;
use core::ops::Range;

/// The lists of the faces, read.
#[derive(Default)]
pub(super) struct Boundaries {
    pub(super) faces: usize,
    /// The number of faces that have an outer boundary component.
    pub(super) outer: usize,
    pub(super) inner: Vec<Inner>,
    /// The number of inner boundary components that are isolated vertices.
    pub(super) at_vertex: usize,
    /// True if one of these is connected, or listed twice. Known only where there are no records for boundary components.
    pub(super) is_vertex_wrong: bool,
    pub(super) cycles: Cycles,
}

/// An inner boundary component: where it starts, and the face that lists it.
#[derive(Clone, Copy)]
pub(super) struct Inner {
    pub(super) vertex: u32,
    pub(super) face: u32,
}

/// The lists so far.
pub(super) struct Lists<'a, V: ?Sized, const WALKS: bool> {
    view: &'a V,
    extent: Extent,
    links: &'a Links,
    /// The number of boundary components listed so far, where these have records.
    pub(super) listed: usize,
    /// The number of half-edges visited so far.
    pub(super) visited: usize,
    pub(super) found: Boundaries,
}

/// Reads the lists of all faces, and walks along every cycle: from where it is listed, or if it names nothing, from its first half-edge.
/// Where some `next` is wrong there are no walks, and only the start of each cycle is looked at.
pub(super) fn read<V: View + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Boundaries> {
    // Decided once, and not at each cycle.
    if links.next_holds { read_and::<V, true>(view, extent, links) } else { read_and::<V, false>(view, extent, links) }
}

fn read_and<V: View + ?Sized, const WALKS: bool>(view: &V, extent: Extent, links: &Links) -> Option<Boundaries> {
    let mut lists = Lists::<V, WALKS>::new(view, extent, links);
    if extent.has(Part::BoundaryComponents) {
        let boundaries = extent.boundaries.all().filter(|b| view.is_boundary(*b)).count();
        lists.by_record(extent.faces.all(), boundaries)?;
        (lists.listed == boundaries).then_some(())?;
    } else {
        lists.by_label()?;
    }
    if WALKS && extent.expect.is_open() && lists.visited < links.half_edges {
        lists.unnamed()?;
    }
    let all_visited = lists.visited == links.half_edges || !WALKS;
    (all_visited && lists.found.has_unbounded(extent)).then_some(lists.found)
}

impl Boundaries {
    /// True if the number of faces without outer boundary component is as it should be.
    pub(super) fn has_unbounded(&self, extent: Extent) -> bool {
        self.faces - self.outer == usize::from(extent.has(Part::UnboundedFace))
    }
}

impl<'a, V: View + ?Sized, const WALKS: bool> Lists<'a, V, WALKS> {
    pub(super) fn new(view: &'a V, extent: Extent, links: &'a Links) -> Self {
        Self { view, extent, links, listed: 0, visited: 0, found: Boundaries::default() }
    }

    /// With records: each boundary component that these faces list, of so many in all, is listed once, by the face it names, at the
    /// place it says. Those that say places are not marked: what is listed at two places are two.
    #[inline(never)]
    pub(super) fn by_record(&mut self, faces: Range<usize>, boundaries: usize) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let mut listed = Marks::default();
        if !extent.has(Part::Places) {
            listed.make_room(extent.boundaries)?;
        }
        for f in faces.filter(|f| view.is_face(*f)) {
            self.found.faces += 1;
            let outer = view.outer(f);
            let inner = if extent.has(Part::Holes) { view.inner_count(f) } else { 0 };
            self.listed = self.listed.checked_add(inner)?.checked_add(usize::from(outer.is_some()))?;
            if self.listed > boundaries {
                return None;
            }
            if let Some(b) = outer {
                self.record(f, b, BoundaryPlace::Outer, &mut listed)?;
            }
            for i in 0..inner {
                self.record(f, view.inner(f, i)?, BoundaryPlace::Inner(i), &mut listed)?;
            }
        }
        Some(())
    }

    /// Reads a boundary component that this face lists.
    #[inline]
    fn record(&mut self, f: usize, b: usize, place: BoundaryPlace, listed: &mut Marks) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let is_there = extent.boundaries.has(b) && view.is_boundary(b) && view.boundary_face(b) == Some(f);
        is_there.then_some(())?;
        let is_new =
            if extent.has(Part::Places) { view.boundary_place(b) == Some(place) } else { listed.mark(b).is_some() };
        is_new.then_some(())?;
        let start = view.boundary_start(b)?;
        self.enter(f, start, place)?;
        if let Start::HalfEdge(start) = start {
            self.cycle(start, |h| (view.boundary(h) == Some(b)).then_some(()))?;
        }
        Some(())
    }

    /// Without records: every cycle is listed once, by the face that its half-edges name. Two cycles of different faces do
    /// not meet, so only those of a face with several are marked.
    #[inline(never)]
    fn by_label(&mut self) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        // Isolated vertices are listed, too.
        let most = self.links.half_edges.checked_add(extent.vertices.count())?;
        let mut entries = 0_usize;
        let mut passed = Marks::default();
        let mut listed = Marks::default();
        for f in extent.faces.all().filter(|f| view.is_face(*f)) {
            self.found.faces += 1;
            let outer = view.outer_half_edge(f);
            let inner = if extent.has(Part::Holes) { view.inner_count(f) } else { 0 };
            entries = entries.checked_add(inner).filter(|entries| *entries <= most)?;
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
                    Start::HalfEdge(start) if is_alone => self.cycle(start, of_f)?,
                    Start::HalfEdge(start) => self.cycle(start, |h| of_f(h).and_then(|()| passed.mark(h)))?,
                }
            }
        }
        Some(())
    }

    /// Walks along the cycles that name nothing, which no face lists. Each has twins, which bound something, or it bounds nothing.
    #[cold]
    #[inline(never)]
    fn unnamed(&mut self) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let mut passed = Marks::new(extent.half_edges)?;
        for start in extent.half_edges.all().filter(|h| view.is_half_edge(*h)) {
            if extent.name(view, start).is_some() || passed.has(start) {
                continue;
            }
            let is_border = |h| extent.name(view, h).is_none() && view.twin(h).is_some();
            let visit = |h| if is_border(h) { passed.mark(h) } else { None };
            self.visited += along(view, extent, start, self.links.half_edges - self.visited, visit)?;
            self.found.cycles.note_unnamed(extent.vertices.existing(view.origin(start))?)?;
        }
        Some(())
    }

    /// Walks along a cycle that a face lists, and counts it.
    #[inline]
    fn cycle(&mut self, start: usize, mut visit: impl FnMut(usize) -> Option<()>) -> Option<()> {
        if !WALKS {
            return visit(start);
        }
        self.visited += along(self.view, self.extent, start, self.links.half_edges - self.visited, visit)?;
        self.found.cycles.named += 1;
        Some(())
    }

    /// Notes an isolated vertex that a face lists.
    #[cold]
    fn isolated(&mut self, v: usize, listed: &mut Marks) -> Option<()> {
        listed.make_room(self.extent.vertices)?;
        self.found.is_vertex_wrong |= listed.mark(v).is_none() || self.links.leaving(self.view, v).is_some();
        Some(())
    }

    /// Counts a boundary component that a face lists.
    #[inline]
    fn enter(&mut self, f: usize, start: Start, place: BoundaryPlace) -> Option<()> {
        let vertex = match start {
            Start::HalfEdge(h) if self.extent.half_edges.has(h) && self.view.is_half_edge(h) => self.view.origin(h),
            Start::HalfEdge(_) => None,
            Start::Vertex(_) if place == BoundaryPlace::Outer => None,
            Start::Vertex(v) => Some(v).filter(|v| self.extent.vertices.has(*v) && self.view.is_vertex(*v)),
        };
        if place == BoundaryPlace::Outer {
            vertex?;
            self.found.outer += 1;
            return Some(());
        }
        self.found.at_vertex += usize::from(matches!(start, Start::Vertex(_)));
        self.found.inner.try_reserve(1).ok()?;
        self.found.inner.push(Inner { vertex: self.extent.vertices.existing(vertex)? as u32, face: f as u32 });
        Some(())
    }
}
