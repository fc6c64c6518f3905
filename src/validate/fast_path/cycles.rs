//! The cycles of `next`, counted half-edge by half-edge.

use super::links::Links;
use super::marks::Marks;
use crate::validate::structure::{Part, View};
use crate::validate::subject::Extent;
use alloc::vec::Vec;

/// The cycles of `next`.
#[derive(Default)]
pub(super) struct Cycles {
    /// The number of cycles that name a boundary component or a face; all where there are none.
    pub(super) named: usize,
    /// A vertex of each of the others, which are border loops.
    pub(super) unnamed: Vec<u32>,
}

impl Cycles {
    /// Notes a vertex of a border loop.
    pub(super) fn note_unnamed(&mut self, vertex: usize) -> Option<()> {
        self.unnamed.try_reserve(1).ok()?;
        self.unnamed.push(vertex as u32);
        Some(())
    }
}

/// A count of the cycles, made while each half-edge is passed once, in any order.
pub(super) trait Pass {
    /// Takes a half-edge and its next. Returns how many cycles are counted by it.
    fn pass<V: View + ?Sized>(&mut self, view: &V, extent: Extent, corner: [usize; 2]) -> Option<usize>;
}

/// Counts nothing, where the cycles are read from the lists of the faces.
pub(super) struct NoCount;

impl Pass for NoCount {
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "there is nothing to call")]
    fn pass<V: View + ?Sized>(&mut self, _: &V, _: Extent, _: [usize; 2]) -> Option<usize> {
        Some(0)
    }
}

/// Counts the short cycles, where `next` is a permutation, and marks the half-edges of the others.
#[derive(Default)]
pub(super) struct Short {
    long: Marks,
}

impl Pass for Short {
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "a call for each half-edge costs more than what it asks")]
    fn pass<V: View + ?Sized>(&mut self, view: &V, extent: Extent, corner: [usize; 2]) -> Option<usize> {
        self.is_first_of_short(view, extent, corner).map(usize::from)
    }
}

impl Short {
    /// True if the half-edge has the smallest number on its cycle, and the cycle is short; if it is not short, marks the
    /// half-edge. It is given with its next.
    ///
    /// Most cycles are short. So the next ones are read, without a branch for each and without marks.
    #[inline(always)]
    #[allow(clippy::inline_always, reason = "a call for each half-edge costs more than what it asks")]
    fn is_first_of_short<V: View + ?Sized>(
        &mut self,
        view: &V,
        extent: Extent,
        [start, second]: [usize; 2],
    ) -> Option<bool> {
        let third = extent.half_edges.existing(view.next(second))?;
        let fourth = extent.half_edges.existing(view.next(third))?;
        if fourth == start {
            return Some(start <= second.min(third));
        }
        self.is_first_of_four(view, extent, [start, second, third, fourth])
    }

    /// The same where there are not one or three on its cycle: if there are two or four, the next of the fourth is the first one.
    #[inline(never)]
    fn is_first_of_four<V: View + ?Sized>(
        &mut self,
        view: &V,
        extent: Extent,
        [start, second, third, fourth]: [usize; 4],
    ) -> Option<bool> {
        if view.next(fourth) == Some(start) {
            return Some(start <= fourth.min(third).min(second));
        }
        self.long.make_room(extent.half_edges)?;
        self.long.mark(start)?;
        Some(false)
    }

    /// Walks along the cycles that are not short, all of whose half-edges must have been passed, and calls `visit` with the first
    /// half-edge of each.
    fn walk<V: View + ?Sized>(
        &mut self,
        view: &V,
        extent: Extent,
        limit: usize,
        mut visit: impl FnMut(usize) -> Option<()>,
    ) -> Option<()> {
        let mut from = 0;
        while let Some(h) = self.long.first_from(from) {
            visit(h)?;
            along(view, extent, h, limit, |h| self.long.clear(h))?;
            from = h;
        }
        Some(())
    }

    /// The cycles, where there are no faces to tell border loops from others, and `short` ones were counted.
    pub(super) fn all<V: View + ?Sized>(
        mut self,
        view: &V,
        extent: Extent,
        short: usize,
        limit: usize,
    ) -> Option<Cycles> {
        let mut named = short;
        self.walk(view, extent, limit, |_| {
            named += 1;
            Some(())
        })?;
        Some(Cycles { named, unnamed: Vec::new() })
    }
}

/// Counts the cycles, where `next` is known to be a permutation.
#[inline(never)]
pub(super) fn count<V: View + ?Sized>(view: &V, extent: Extent, links: &Links) -> Option<Cycles> {
    let mut cycles = Cycles::default();
    let tells_borders = extent.expect.is_open() && extent.has(Part::Faces);
    let mut counted = Short::default();
    let mut visit = |h: usize, is_first: bool| {
        if tells_borders && is_first && extent.name(view, h).is_none() {
            cycles.note_unnamed(extent.vertices.existing(view.origin(h))?)?;
        } else {
            cycles.named += usize::from(is_first);
        }
        Some(())
    };
    for h in extent.half_edges.all() {
        if view.is_half_edge(h) {
            let next = extent.half_edges.existing(view.next(h))?;
            visit(h, counted.is_first_of_short(view, extent, [h, next])?)?;
        }
    }
    counted.walk(view, extent, links.half_edges, |h| visit(h, true))?;
    Some(cycles)
}

/// Walks along one cycle, all of whose half-edges may be visited, and returns how many these are; none if they are more than
/// `limit`.
#[inline]
pub(super) fn along<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    start: usize,
    limit: usize,
    mut visit: impl FnMut(usize) -> Option<()>,
) -> Option<usize> {
    let mut h = start;
    for visited in 0..limit {
        visit(h)?;
        h = extent.half_edges.existing(view.next(h))?;
        if h == start {
            return Some(visited + 1);
        }
    }
    None
}
