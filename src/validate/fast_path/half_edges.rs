//! Half-edges as the walks read them: asked of a view, or from the columns that it lends.

use super::starts::Starts;
use crate::validate::columns::NIL;
use crate::validate::structure::{HalfEdgeColumns, Link, Part, View};
use crate::validate::subject::{Extent, Slots};

/// The links of half-edges as numbers. Nil is [`NIL`]; where a link leads past the last slot, the number is no slot either.
pub(super) trait HalfEdges: Copy {
    /// True if there is such a slot, and it is live.
    fn is_live(self, h: u32) -> bool;
    fn origin(self, h: u32) -> u32;
    fn twin(self, h: u32) -> u32;
    fn next(self, h: u32) -> u32;
    fn prev(self, h: u32) -> u32;
    /// The boundary component that the half-edge names, or the face.
    fn name(self, h: u32) -> u32;

    /// L1: the twin of a live half-edge, if it is another live half-edge, whose twin is this one.
    #[inline]
    fn twin_back(self, h: u32) -> Option<u32> {
        let t = self.twin(h);
        (t != h && self.is_live(t) && self.twin(t) == h).then_some(t)
    }
}

/// The half-edges of a view.
pub(super) struct Asked<'a, V: ?Sized> {
    pub(super) view: &'a V,
    pub(super) extent: Extent,
}

impl<V: ?Sized> Clone for Asked<'_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V: ?Sized> Copy for Asked<'_, V> {}

/// A link as a number. All that leads past the last slot is one number, which is no slot.
#[inline]
fn number(link: Link) -> u32 {
    link.map_or(NIL, |slot| u32::try_from(slot).unwrap_or(NIL).min(NIL - 1))
}

impl<V: View + ?Sized> HalfEdges for Asked<'_, V> {
    #[inline]
    fn is_live(self, h: u32) -> bool {
        self.extent.half_edges.has(h as usize) && self.view.is_half_edge(h as usize)
    }
    #[inline]
    fn origin(self, h: u32) -> u32 {
        number(self.view.origin(h as usize))
    }
    #[inline]
    fn twin(self, h: u32) -> u32 {
        number(self.view.twin(h as usize))
    }
    #[inline]
    fn next(self, h: u32) -> u32 {
        number(self.view.next(h as usize))
    }
    #[inline]
    fn prev(self, h: u32) -> u32 {
        number(self.view.prev(h as usize))
    }
    #[inline]
    fn name(self, h: u32) -> u32 {
        number(self.extent.name(self.view, h as usize))
    }
}

/// The half-edges in columns that a view lends. Every column has an entry for each slot.
#[derive(Clone, Copy)]
pub(super) struct Lent<'a> {
    origin: &'a [u32],
    next: &'a [u32],
    prev: &'a [u32],
    name: &'a [u32],
    /// The first live slot. The live slots are one range up to the last, and no edge is divided by its ends.
    first: u32,
}

impl<'a> Lent<'a> {
    /// The columns of a structure in which the twin of `h` is `h ^ 1`, and the live half-edges are one range. `None` if it lends no such
    /// columns.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "the lengths of the columns are known to be the same in the caller, too")]
    pub(super) fn of<V: View + ?Sized>(view: &'a V, extent: Extent, starts: &Starts) -> Option<Self> {
        let HalfEdgeColumns { origin, twin, next, prev, boundary, face, .. } = view.half_edge_columns()?;
        let name = if extent.has(Part::BoundaryComponents) { boundary } else { face };
        let Slots(slots) = extent.half_edges;
        let n = slots as usize;
        let first = slots.checked_sub(starts.half_edges as u32)?;
        let is_range =
            twin.is_none() && slots % 2 == 0 && first % 2 == 0 && (0..first).all(|h| !view.is_half_edge(h as usize));
        is_range.then_some(())?;
        Some(Self { origin: origin.get(..n)?, next: next.get(..n)?, prev: prev.get(..n)?, name: name.get(..n)?, first })
    }
}

#[allow(clippy::inline_always, reason = "each is one instruction or two")]
impl HalfEdges for Lent<'_> {
    #[inline(always)]
    fn is_live(self, h: u32) -> bool {
        h >= self.first && (h as usize) < self.next.len()
    }
    #[inline(always)]
    fn origin(self, h: u32) -> u32 {
        self.origin[h as usize]
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
        self.next[h as usize]
    }
    #[inline(always)]
    fn prev(self, h: u32) -> u32 {
        self.prev[h as usize]
    }
    #[inline(always)]
    fn name(self, h: u32) -> u32 {
        self.name[h as usize]
    }
}
