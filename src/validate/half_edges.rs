//! Half-edges as the fast path and the rules read them: by calls to a view, or from columns that it lends.

use super::structure::{HalfEdgeColumns, Link, Part, View};
use super::subject::Extent;
use crate::numbers::NIL;

/// The links of half-edges as numbers. Nil is [`NIL`]; a link past the last slot becomes a number that is no slot.
pub(crate) trait HalfEdges: Copy {
    /// Returns true if the slot exists and is live.
    fn is_live(self, h: u32) -> bool;
    fn origin(self, h: u32) -> u32;
    fn twin(self, h: u32) -> u32;
    fn next(self, h: u32) -> u32;
    fn prev(self, h: u32) -> u32;
    /// Returns the boundary component that the half-edge names, or else the face.
    fn name(self, h: u32) -> u32;

    /// L1: returns the twin of a live half-edge, if it is a different live half-edge whose twin is this one.
    #[inline]
    fn twin_back(self, h: u32) -> Option<u32> {
        let t = self.twin(h);
        (t != h && self.is_live(t) && self.twin(t) == h).then_some(t)
    }
}

/// Half-edges read by calls to a view.
pub(crate) struct Asked<'a, V: ?Sized> {
    pub(crate) view: &'a V,
    pub(crate) extent: Extent,
}

impl<V: ?Sized> Clone for Asked<'_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: ?Sized> Copy for Asked<'_, V> {}

/// A link as a number. All links past the last slot become the same number, which is no slot.
#[inline]
fn number(link: Link) -> u32 {
    link.map_or(NIL, |slot| u32::try_from(slot).unwrap_or(NIL).min(NIL - 1))
}

impl<V: View + ?Sized> Asked<'_, V> {
    /// Returns the view's answer, if the slot exists.
    #[inline]
    fn ask(self, h: u32, link: impl FnOnce(&V, usize) -> Link) -> u32 {
        if self.extent.half_edges.has(h as usize) { number(link(self.view, h as usize)) } else { NIL }
    }
}

impl<V: View + ?Sized> HalfEdges for Asked<'_, V> {
    #[inline]
    fn is_live(self, h: u32) -> bool {
        self.extent.half_edges.is_live(h as usize, |h| self.view.is_half_edge(h))
    }
    #[inline]
    fn origin(self, h: u32) -> u32 {
        self.ask(h, V::origin)
    }
    #[inline]
    fn twin(self, h: u32) -> u32 {
        self.ask(h, V::twin)
    }
    #[inline]
    fn next(self, h: u32) -> u32 {
        self.ask(h, V::next)
    }
    #[inline]
    fn prev(self, h: u32) -> u32 {
        self.ask(h, V::prev)
    }
    #[inline]
    fn name(self, h: u32) -> u32 {
        self.ask(h, |view, h| self.extent.name(view, h))
    }
}

/// Half-edges in columns lent by a view. Every column has an entry for each slot.
#[derive(Clone, Copy)]
pub(crate) struct Lent<'a> {
    origin: &'a [u32],
    next: &'a [u32],
    prev: &'a [u32],
    name: &'a [u32],
    /// The first live slot, and the number of live slots from there to the end. Both are even.
    first: u32,
    live: u32,
}

impl<'a> Lent<'a> {
    /// Returns the columns of a structure in which all half-edges from `first` on are live. `None` if the view lends no such columns.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "the lengths of the columns are known to be the same in the caller, too")]
    pub(crate) fn of<V: View + ?Sized>(view: &'a V, extent: Extent, first: u32) -> Option<Self> {
        let HalfEdgeColumns { origin, next, prev, boundary, face, .. } = view.half_edge_columns()?;
        let name = if extent.has(Part::BoundaryComponents) { boundary } else { face };
        let n = extent.half_edges.count();
        (n % 2 == 0 && first % 2 == 0).then_some(())?;
        let live = extent.half_edges.count.checked_sub(first)?;
        Some(Self {
            origin: origin.get(..n)?,
            next: next.get(..n)?,
            prev: prev.get(..n)?,
            name: name.get(..n)?,
            first,
            live,
        })
    }
}

/// Reads an entry of a column, or nil past its end: a view may lend links that differ from its answers.
#[inline(always)]
#[allow(clippy::inline_always, reason = "called for each link")]
fn entry(column: &[u32], h: u32) -> u32 {
    column.get(h as usize).copied().unwrap_or(NIL)
}

#[allow(clippy::inline_always, reason = "each is one instruction or two")]
impl HalfEdges for Lent<'_> {
    #[inline(always)]
    fn is_live(self, h: u32) -> bool {
        h.wrapping_sub(self.first) < self.live
    }
    #[inline(always)]
    fn origin(self, h: u32) -> u32 {
        entry(self.origin, h)
    }
    #[inline(always)]
    fn twin(self, h: u32) -> u32 {
        h ^ 1
    }
    #[inline(always)]
    fn twin_back(self, h: u32) -> Option<u32> {
        Some(h ^ 1)
    }
    #[inline(always)]
    fn next(self, h: u32) -> u32 {
        entry(self.next, h)
    }
    #[inline(always)]
    fn prev(self, h: u32) -> u32 {
        entry(self.prev, h)
    }
    #[inline(always)]
    fn name(self, h: u32) -> u32 {
        entry(self.name, h)
    }
}
