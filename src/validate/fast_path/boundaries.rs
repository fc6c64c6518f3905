//! The lists of the faces: F1, F2, the starts of B1, and the faces' half of B2.

use super::cycles::{Marks, along};
use super::rotations::Starts;
use crate::validate::structure::{BoundaryPlace, Part, Start, View};
use crate::validate::subject::Extent;
use alloc::vec::Vec;

#[derive(Default)]
pub(super) struct Boundaries {
    pub(super) faces: usize,
    /// The number of faces with an outer boundary component.
    pub(super) outer: usize,
    pub(super) inner: Vec<Inner>,
    /// The number of inner boundary components that are isolated vertices.
    pub(super) at_vertex: usize,
}

/// An inner boundary component: its start, and the face that lists it.
#[derive(Clone, Copy)]
pub(super) struct Inner {
    pub(super) vertex: u32,
    pub(super) face: u32,
}

impl Boundaries {
    /// The number of listed cycles, all of them different.
    pub(super) fn cycles(&self) -> usize {
        self.outer + self.inner.len() - self.at_vertex
    }
}

struct Lists<'a, V: ?Sized> {
    view: &'a V,
    extent: Extent,
    starts: &'a Starts,
    found: Boundaries,
}

/// Reads the lists of all faces, and the starts of boundary components. `next` must be a permutation along which the names of
/// half-edges are constant.
#[inline(never)]
pub(super) fn read<V: View + ?Sized>(view: &V, extent: Extent, starts: &Starts) -> Option<Boundaries> {
    let mut lists = Lists { view, extent, starts, found: Boundaries::default() };
    if extent.has(Part::BoundaryComponents) {
        lists.by_record()?;
    } else {
        lists.by_label()?;
    }
    let without_outer = lists.found.faces - lists.found.outer;
    (without_outer == usize::from(extent.has(Part::UnboundedFace))).then_some(lists.found)
}

impl<V: View + ?Sized> Lists<'_, V> {
    /// With records: checks that every boundary component is listed once, by the face it names, at the place it claims. Stored places
    /// need no marks: two places mean two boundary components.
    fn by_record(&mut self) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let boundaries = extent.boundaries.all().filter(|b| view.is_boundary(*b)).count();
        let mut unlisted = boundaries;
        let mut listed = Marks::default();
        if !extent.has(Part::Places) {
            listed.make_room(extent.boundaries)?;
        }
        for f in extent.faces.all().filter(|f| view.is_face(*f)) {
            self.found.faces += 1;
            let outer = view.outer(f);
            let inner = if extent.has(Part::Holes) { view.inner_count(f) } else { 0 };
            unlisted = unlisted.checked_sub(inner)?.checked_sub(usize::from(outer.is_some()))?;
            if let Some(b) = outer {
                self.list(f, b, BoundaryPlace::Outer, &mut listed)?;
                self.outer(view.boundary_start(b)?, |h| view.boundary(h) == Some(b))?;
            }
            for i in 0..inner {
                let b = view.inner(f, i)?;
                self.list(f, b, BoundaryPlace::Inner(i), &mut listed)?;
                self.inner(f, view.boundary_start(b)?, |h| view.boundary(h) == Some(b))?;
            }
        }
        (unlisted == 0).then_some(())
    }

    /// Checks that a boundary component is listed by the face it names, at the place it claims.
    #[inline]
    fn list(&self, f: usize, b: usize, place: BoundaryPlace, listed: &mut Marks) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let is_there = extent.boundaries.has(b) && view.is_boundary(b) && view.boundary_face(b) == Some(f);
        is_there.then_some(())?;
        let is_new =
            if extent.has(Part::Places) { view.boundary_place(b) == Some(place) } else { listed.mark(b).is_some() };
        is_new.then_some(())
    }

    /// Without records: checks that each start names the face that lists it, and that no cycle is listed twice. Cycles of different
    /// faces differ, so only the cycles of a face with several are walked and marked.
    fn by_label(&mut self) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        // Isolated vertices are also listed.
        let mut entries_left = self.starts.half_edges.checked_add(extent.vertices.count())?;
        let mut passed = Marks::default();
        let mut listed = Marks::default();
        for f in extent.faces.all().filter(|f| view.is_face(*f)) {
            self.found.faces += 1;
            let outer = view.outer_half_edge(f);
            let inner = if extent.has(Part::Holes) { view.inner_count(f) } else { 0 };
            entries_left = entries_left.checked_sub(inner)?;
            let is_alone = inner == usize::from(outer.is_none());
            if !is_alone {
                passed.make_room(extent.half_edges)?;
            }
            let is_named = |h| view.face(h) == Some(f);
            let mut is_new = |h| if is_alone { Some(()) } else { along(view, extent, h, |h| passed.mark(h)) };
            if let Some(start) = outer {
                self.outer(Start::HalfEdge(start), is_named)?;
                is_new(start)?;
            }
            for i in 0..inner {
                let start = view.inner_start(f, i)?;
                self.inner(f, start, is_named)?;
                match start {
                    Start::Vertex(v) => {
                        listed.make_room(extent.vertices)?;
                        let is_isolated = self.starts.leaving(view, v).is_none();
                        (is_isolated && listed.mark(v).is_some()).then_some(())?;
                    }
                    Start::HalfEdge(start) => is_new(start)?,
                }
            }
        }
        Some(())
    }

    /// Counts an outer boundary component that starts at a live half-edge for which `is_named` holds.
    #[inline]
    fn outer(&mut self, start: Start, is_named: impl Fn(usize) -> bool) -> Option<()> {
        let Start::HalfEdge(h) = start else { return None };
        let is_right = self.extent.half_edges.has(h) && self.view.is_half_edge(h) && is_named(h);
        self.found.outer += 1;
        is_right.then_some(())
    }

    /// Counts an inner boundary component that starts at such a half-edge or at a live vertex.
    fn inner(&mut self, f: usize, start: Start, is_named: impl Fn(usize) -> bool) -> Option<()> {
        let (view, extent) = (self.view, self.extent);
        let vertex = match start {
            Start::HalfEdge(h) => {
                (extent.half_edges.has(h) && view.is_half_edge(h) && is_named(h)).then_some(())?;
                view.origin(h)?
            }
            Start::Vertex(v) => {
                (extent.vertices.has(v) && view.is_vertex(v)).then_some(())?;
                self.found.at_vertex += 1;
                v
            }
        };
        self.found.inner.try_reserve(1).ok()?;
        self.found.inner.push(Inner { vertex: vertex as u32, face: f as u32 });
        Some(())
    }
}
