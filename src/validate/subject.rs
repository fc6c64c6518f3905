//! The structure under judgement, as the rules read it: links as slots in range, or nil.

use super::expectation::{Expectation, Surface};
use super::findings::{Flow, Halt};
use super::report::Unchecked;
use super::structure::{Link, Part, Parts, Start, View};
use crate::numbers::{self, NIL};
use alloc::vec::Vec;
use core::ops::Range;

/// A structure under judgement: its view, numbers of slots, claims, and the parts considered.
pub(crate) struct Subject<'a, V: ?Sized = dyn View + 'a> {
    pub(crate) view: &'a V,
    pub(crate) extent: Extent,
}

impl<V: ?Sized> Clone for Subject<'_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: ?Sized> Copy for Subject<'_, V> {}

/// The numbers of slots, the parts considered, and the claims, all read once.
#[derive(Clone, Copy)]
pub(crate) struct Extent {
    pub(crate) vertices: Slots,
    pub(crate) half_edges: Slots,
    pub(crate) boundaries: Slots,
    pub(crate) faces: Slots,
    pub(crate) expect: Expectation,
    pub(crate) parts: Parts,
}

impl Extent {
    /// Reads the extent of a structure under this expectation.
    ///
    /// # Errors
    /// [`Unchecked::TooLarge`] if there are more slots of a kind than the columns can number.
    pub(crate) fn of<V: View + ?Sized>(view: &V, expect: Expectation) -> Result<Self, Unchecked> {
        let parts = expect.looks_at(view.parts());
        let slots = |n: usize| match u32::try_from(n) {
            Ok(count) if count < NIL => Ok(Slots { count, ..Slots::NONE }),
            _ => Err(Unchecked::TooLarge),
        };
        Ok(Self {
            vertices: slots(view.vertex_slots())?,
            half_edges: slots(view.half_edge_slots())?,
            boundaries: if parts.has(Part::BoundaryComponents) { slots(view.boundary_slots())? } else { Slots::NONE },
            faces: if parts.has(Part::Faces) { slots(view.face_slots())? } else { Slots::NONE },
            expect,
            parts,
        })
    }

    pub(crate) const fn has(&self, part: Part) -> bool {
        self.parts.has(part)
    }

    pub(crate) const fn is_plane(&self) -> bool {
        matches!(self.expect.surface_kind(), Surface::Plane)
    }

    /// Returns the boundary component that the half-edge names, or without records for these the face.
    #[inline]
    pub(crate) fn name<V: View + ?Sized>(&self, view: &V, h: usize) -> Link {
        if self.has(Part::BoundaryComponents) { view.boundary(h) } else { view.face(h) }
    }
}

/// The number of slots of one kind.
///
/// With 32 bits, and links stored in 32 bits with nil as all ones, one comparison shows that a link is not nil and that its slot
/// exists.
#[derive(Clone, Copy)]
pub(crate) struct Slots {
    pub(crate) count: u32,
    /// No slot before this one is live.
    first: u32,
    /// True if all slots from `first` on are known to be live.
    are_live: bool,
}

impl Slots {
    const NONE: Self = Self { count: 0, first: 0, are_live: false };

    #[inline]
    pub(crate) const fn count(self) -> usize {
        self.count as usize
    }

    /// Finds the first live slot, and whether all slots from there on are live.
    fn surveyed(self, is_live: impl Fn(usize) -> bool) -> Self {
        let first = self.all().find(|slot| is_live(*slot)).unwrap_or(self.count());
        Self { first: first as u32, are_live: (first..self.count()).all(is_live), ..self }
    }

    /// Returns the first live slot, if all slots from there on are known to be live.
    pub(crate) fn live_from(self) -> Option<u32> {
        self.are_live.then_some(self.first)
    }

    /// Returns true if the slot exists and is live. Calls `ask` only if the live slots are not known.
    #[inline]
    pub(crate) fn is_live(self, slot: usize, ask: impl FnOnce(usize) -> bool) -> bool {
        self.has(slot) && slot >= self.first as usize && (self.are_live || ask(slot))
    }

    fn live(self, ask: impl Fn(usize) -> bool) -> impl Iterator<Item = usize> {
        (self.first as usize..self.count()).filter(move |slot| self.are_live || ask(*slot))
    }

    #[inline]
    pub(crate) const fn all(self) -> Range<usize> {
        0..self.count()
    }

    #[inline]
    pub(crate) const fn has(self, slot: usize) -> bool {
        slot < self.count()
    }

    /// Returns a link, if its slot exists.
    #[inline]
    pub(crate) fn existing(self, link: Link) -> Link {
        link.filter(|slot| self.has(*slot))
    }

    /// Converts a link into a number in range, or [`NIL`].
    #[inline]
    pub(crate) fn number(self, link: Link) -> u32 {
        self.existing(link).map_or(NIL, |slot| slot as u32)
    }

    pub(crate) fn nils(self) -> Option<Vec<u32>> {
        column(self.count, NIL).ok()
    }
}

impl<'a, V: View + ?Sized> Subject<'a, V> {
    /// Surveys the live slots, so that the rules can skip asking where all slots from the first live one on are live.
    pub(crate) fn surveyed(self) -> Self {
        let Self { view, mut extent } = self;
        extent.vertices = extent.vertices.surveyed(|v| view.is_vertex(v));
        extent.half_edges = match view.half_edge_columns().and_then(|columns| columns.live_edges) {
            Some(live) => extent.half_edges.surveyed(|h| live.get(h / 2).is_some_and(|edge| edge % 2 == 1)),
            None => extent.half_edges.surveyed(|h| view.is_half_edge(h)),
        };
        extent.boundaries = extent.boundaries.surveyed(|b| view.is_boundary(b));
        extent.faces = extent.faces.surveyed(|f| view.is_face(f));
        Self { view, extent }
    }

    #[inline]
    pub(crate) fn is_vertex(&self, v: usize) -> bool {
        self.extent.vertices.is_live(v, |v| self.view.is_vertex(v))
    }

    #[inline]
    pub(crate) fn is_half_edge(&self, h: usize) -> bool {
        self.extent.half_edges.is_live(h, |h| self.view.is_half_edge(h))
    }

    #[inline]
    pub(crate) fn is_boundary(&self, b: usize) -> bool {
        self.extent.boundaries.is_live(b, |b| self.view.is_boundary(b))
    }

    #[inline]
    pub(crate) fn is_face(&self, f: usize) -> bool {
        self.extent.faces.is_live(f, |f| self.view.is_face(f))
    }

    pub(crate) fn vertices(self) -> impl Iterator<Item = usize> + 'a {
        self.extent.vertices.live(move |v| self.view.is_vertex(v))
    }

    pub(crate) fn half_edges(self) -> impl Iterator<Item = u32> + 'a {
        self.extent.half_edges.live(move |h| self.view.is_half_edge(h)).map(|h| h as u32)
    }

    pub(crate) fn boundaries(self) -> impl Iterator<Item = usize> + 'a {
        self.extent.boundaries.live(move |b| self.view.is_boundary(b))
    }

    pub(crate) fn faces(self) -> impl Iterator<Item = usize> + 'a {
        self.extent.faces.live(move |f| self.view.is_face(f))
    }

    pub(crate) fn has(&self, part: Part) -> bool {
        self.extent.has(part)
    }

    pub(crate) const fn is_open(&self) -> bool {
        self.extent.expect.is_open()
    }

    #[inline]
    pub(crate) fn origin(&self, h: u32) -> u32 {
        self.extent.vertices.number(self.view.origin(h as usize))
    }

    #[inline]
    pub(crate) fn twin(&self, h: u32) -> u32 {
        self.extent.half_edges.number(self.view.twin(h as usize))
    }

    #[inline]
    pub(crate) fn next(&self, h: u32) -> u32 {
        self.extent.half_edges.number(self.view.next(h as usize))
    }

    #[inline]
    pub(crate) fn is_live_vertex(&self, v: u32) -> bool {
        self.is_vertex(v as usize)
    }

    #[inline]
    pub(crate) fn is_live_half_edge(&self, h: u32) -> bool {
        self.is_half_edge(h as usize)
    }

    pub(crate) fn live_half_edge(&self, link: Link) -> Option<usize> {
        self.extent.half_edges.existing(link).filter(|h| self.is_half_edge(*h))
    }

    pub(crate) fn live_boundary(&self, link: Link) -> Option<usize> {
        self.extent.boundaries.existing(link).filter(|b| self.is_boundary(*b))
    }

    pub(crate) fn target_by_next(&self, h: u32) -> u32 {
        match self.next(h) {
            NIL => NIL,
            n => self.origin(n),
        }
    }

    pub(crate) fn target(&self, h: u32) -> u32 {
        match self.twin(h) {
            NIL => self.target_by_next(h),
            t => self.origin(t),
        }
    }

    /// Returns the vertices at the ends of an edge, the smaller one first.
    pub(crate) fn ends(&self, h: u32) -> [u32; 2] {
        let (origin, target) = (self.origin(h), self.target(h));
        [origin.min(target), origin.max(target)]
    }

    /// Returns true if the face link of a half-edge is live, or legally nil.
    pub(crate) fn is_sound_face_link(&self, link: Link) -> bool {
        link.map_or(self.is_open(), |f| self.is_face(f))
    }

    /// Returns true if the structure has faces and the half-edge has none, or no boundary component. A cycle of such half-edges is a
    /// border loop.
    pub(crate) fn lacks_face(&self, h: usize) -> bool {
        self.has(Part::Faces) && self.extent.name(self.view, h).is_none()
    }

    /// Returns the outer boundary component, or half-edge, named by the face.
    pub(crate) fn outer(&self, f: usize) -> Link {
        if self.has(Part::BoundaryComponents) { self.view.outer(f) } else { self.view.outer_half_edge(f) }
    }

    pub(crate) fn outer_start(&self, f: usize) -> Option<Start> {
        if self.has(Part::BoundaryComponents) {
            self.view.boundary_start(self.extent.boundaries.existing(self.view.outer(f))?)
        } else {
            self.view.outer_half_edge(f).map(Start::HalfEdge)
        }
    }

    /// Calls `visit` with each face, position and start of the inner lists, for structures without boundary components. Reads at most
    /// `budget` entries.
    pub(crate) fn for_each_inner_start(
        &self,
        mut budget: usize,
        mut visit: impl FnMut(usize, usize, Start) -> Flow,
    ) -> Flow {
        if !self.has(Part::Holes) {
            return Ok(());
        }
        for f in self.faces() {
            let listed = self.view.inner_count(f).min(budget);
            budget -= listed;
            for i in 0..listed {
                if let Some(start) = self.view.inner_start(f, i) {
                    visit(f, i, start)?;
                }
            }
        }
        Ok(())
    }

    pub(crate) fn component_at<'c>(&self, components: &'c mut Components, h: u32) -> Option<&'c mut Component> {
        let c = components.of.get(self.origin(h) as usize).copied()?;
        components.all.get_mut(c as usize)
    }

    /// Returns the component number of a start. `of` has the component number of each vertex.
    pub(crate) fn component_of_start(&self, of: &[u32], start: Option<Start>) -> Option<usize> {
        let vertex = match start? {
            Start::HalfEdge(h) if self.extent.half_edges.has(h) => self.origin(h as u32) as usize,
            Start::HalfEdge(_) => return None,
            Start::Vertex(v) => v,
        };
        of.get(vertex).filter(|c| **c != NIL).map(|c| *c as usize)
    }
}

/// A column of `n` entries.
///
/// # Errors
/// [`Halt::OutOfMemory`] if memory runs out.
pub(crate) fn column<T: Clone>(n: u32, value: T) -> Result<Vec<T>, Halt> {
    numbers::column(n as usize, value).ok_or(Halt::OutOfMemory)
}

#[derive(Clone, Copy)]
pub(crate) struct Component {
    /// Its first vertex, which names it in reports.
    pub(crate) vertex: u32,
    pub(crate) vertices: u32,
    /// Half-edges with and without a twin: there are `paired / 2 + unpaired` edges.
    pub(crate) paired: u32,
    pub(crate) unpaired: u32,
    /// The number of its cycles of `next`, plus one for an isolated vertex, plus one for each open boundary.
    pub(crate) cycles: u32,
    /// True if some half-edge lacks its twin or its face, so the outside of the component may be there.
    pub(crate) open: bool,
}

impl Component {
    pub(crate) const fn at(vertex: u32) -> Self {
        Self { vertex, vertices: 0, paired: 0, unpaired: 0, cycles: 0, open: false }
    }

    pub(crate) const fn edges(&self) -> usize {
        self.paired as usize / 2 + self.unpaired as usize
    }
}

pub(crate) struct Components {
    /// By vertex: the number of its component; nil if not live.
    pub(crate) of: Vec<u32>,
    pub(crate) all: Vec<Component>,
    /// True if there are neither loops nor parallel edges.
    pub(crate) simple: bool,
}
