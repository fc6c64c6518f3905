//! The scan over the half-edges: L1 and L3, R1 of `twin` and `next`, and L2 where there is `prev`.

use crate::validate::columns::NIL;
use crate::validate::structure::{Link, Part, View};
use crate::validate::subject::{Extent, Slots};
use alloc::vec::Vec;
use core::ops::Range;

/// With more half-edges in doubt than these, all are.
pub(super) const MOST_DOUBTS: usize = 1024;

/// The result of the scan.
pub(super) struct Links {
    /// The number of live half-edges.
    pub(super) half_edges: usize,
    /// The number of live half-edges without twin.
    pub(super) unpaired: usize,
    /// Per vertex a half-edge that leaves it, or nil, where vertices keep none. If the links are right, one that is the next of some
    /// half-edge.
    leaving: Option<Vec<u32>>,
    /// Per vertex a half-edge without twin that ends there, or nil; empty if all have one.
    pub(super) into: Vec<u32>,
    /// True if no two half-edges without twin end at one vertex.
    pub(super) one_into_each: bool,
    /// The half-edges at which something is wrong, in order.
    pub(super) wrong: Vec<u32>,
    pub(super) next_holds: bool,
    pub(super) twin_holds: bool,
    /// With more half-edges in doubt than these, all are.
    most_doubts: usize,
}

impl Links {
    /// Those of so many half-edges, at which nothing is wrong, where vertices keep a half-edge and nothing is open.
    pub(super) const fn right(half_edges: usize) -> Self {
        Self {
            half_edges,
            unpaired: 0,
            leaving: None,
            into: Vec::new(),
            one_into_each: true,
            wrong: Vec::new(),
            next_holds: true,
            twin_holds: true,
            most_doubts: 0,
        }
    }

    /// True if nothing is wrong, and at each vertex one border ends at most.
    pub(super) fn are_right(&self) -> bool {
        self.next_holds && self.twin_holds && self.one_into_each
    }

    /// A half-edge that leaves the vertex.
    #[inline]
    pub(super) fn leaving<V: View + ?Sized>(&self, view: &V, v: usize) -> Option<usize> {
        match &self.leaving {
            None => view.leaving(v),
            Some(noted) => noted.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize),
        }
    }

    /// A half-edge without twin that ends at the vertex.
    #[inline]
    pub(super) fn into(&self, v: usize) -> Option<usize> {
        self.into.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize)
    }

    /// Notes a half-edge that leaves each vertex, in the place of those that vertices keep. None if that is done, or there is no
    /// memory for it.
    pub(super) fn note_leaving<V: View + ?Sized>(&mut self, view: &V, extent: Extent) -> Option<()> {
        if self.leaving.is_some() {
            return None;
        }
        let mut leaving = extent.vertices.nils()?;
        for h in extent.half_edges.all().filter(|h| view.is_half_edge(*h)) {
            if let Some(v) = view.origin(h) {
                note(&mut leaving, v, h);
            }
        }
        self.leaving = Some(leaving);
        Some(())
    }

    /// Notes a half-edge at which something is wrong.
    #[cold]
    fn doubt(&mut self, h: usize, [next_holds, twin_holds]: [bool; 2]) -> Option<()> {
        self.next_holds &= next_holds;
        self.twin_holds &= twin_holds;
        if self.wrong.len() == self.most_doubts {
            return None;
        }
        self.wrong.try_reserve(1).ok()?;
        self.wrong.push(h as u32);
        Some(())
    }

    /// Notes that a half-edge without twin ends at a vertex.
    fn ends(&mut self, target: Option<usize>, h: usize, extent: Extent) -> Option<()> {
        if !extent.expect.is_open() {
            return Some(());
        }
        if self.into.is_empty() {
            self.into = extent.vertices.nils()?;
        }
        if let Some(into) = target.and_then(|v| self.into.get_mut(v)) {
            self.one_into_each &= *into == NIL;
            *into = h as u32;
        }
        Some(())
    }
}

/// Reads the links of every half-edge, in order of their numbers, so that none waits for another. None if more than so many are wrong.
pub(super) fn scan<V: View + ?Sized>(view: &V, extent: Extent, most_doubts: usize) -> Option<Links> {
    let mut links = Links { most_doubts, ..Links::right(0) };
    let mut leaving = Vec::new();
    if !extent.has(Part::Leaving) {
        leaving = extent.vertices.nils()?;
    }
    let note = |v, h| note(&mut leaving, v, h);
    // Choose the variant of the scan here, once, and not at each half-edge.
    match (extent.has(Part::Prev), extent.has(Part::Leaving)) {
        (true, true) => scan_and::<V, true>(view, extent, &mut links, |_, _| {})?,
        (false, true) => scan_and::<V, false>(view, extent, &mut links, |_, _| {})?,
        (true, false) => scan_and::<V, true>(view, extent, &mut links, note)?,
        (false, false) => scan_and::<V, false>(view, extent, &mut links, note)?,
    }
    if !extent.has(Part::Leaving) {
        if links.are_right() {
            links.leaving = Some(leaving);
        } else {
            links.note_leaving(view, extent)?;
        }
    }
    Some(links)
}

/// Notes that the half-edge leaves the vertex.
#[inline]
fn note(leaving: &mut [u32], v: usize, h: usize) {
    if let Some(noted) = leaving.get_mut(v) {
        *noted = h as u32;
    }
}

/// Scans, and tells `note` the next of each half-edge at which nothing is wrong, and its origin.
fn scan_and<V: View + ?Sized, const WITH_PREV: bool>(
    view: &V,
    extent: Extent,
    links: &mut Links,
    mut note: impl FnMut(usize, usize),
) -> Option<()> {
    let mut h = 0;
    while extent.half_edges.has(h) {
        let rest = h..extent.half_edges.count();
        let (end, live) = right_ones::<V, WITH_PREV>(view, extent.half_edges, rest, &mut note);
        h = end;
        links.half_edges += live;
        if extent.half_edges.has(h) {
            links.half_edges += 1;
            at_border_or_wrong(view, extent, h, links, &mut note)?;
            h += 1;
        }
    }
    Some(())
}

/// Scans these half-edges up to the first one that is at the border or wrong, or to their end. Returns that, and how many are live up to
/// it.
///
/// A loop of its own, as it takes most of the time: it calls nothing but the view, and everything that it compares is in registers.
#[inline(never)]
fn right_ones<V: View + ?Sized, const WITH_PREV: bool>(
    view: &V,
    half_edges: Slots,
    range: Range<usize>,
    note: &mut impl FnMut(usize, usize),
) -> (usize, usize) {
    let (mut live, end) = (0, range.end);
    for h in range {
        if view.is_half_edge(h) {
            let Some((target, next)) = inside_and_right::<V, WITH_PREV>(view, half_edges, h) else {
                return (h, live);
            };
            live += 1;
            note(target, next);
        }
    }
    (end, live)
}

/// The target and the next of a half-edge that has a twin, as nearly all have, and with which nothing is wrong.
#[inline(always)]
#[allow(clippy::inline_always, reason = "a call for each half-edge costs more than what it asks")]
fn inside_and_right<V: View + ?Sized, const WITH_PREV: bool>(
    view: &V,
    half_edges: Slots,
    h: usize,
) -> Option<(usize, usize)> {
    let t = half_edges.existing(view.twin(h))?;
    let n = half_edges.existing(view.next(h))?;
    if !(is_mutual(view, h, t) && view.is_half_edge(n)) {
        return None;
    }
    let target = view.origin(t)?;
    let holds = view.origin(n) == Some(target) && (!WITH_PREV || view.prev(n) == Some(h));
    holds.then_some((target, n))
}

/// Looks at what may be at the border, notes what is, and what is wrong. Tells `note` the next of what is at the border.
#[cold]
#[inline(never)]
fn at_border_or_wrong<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    h: usize,
    links: &mut Links,
    note: &mut dyn FnMut(usize, usize),
) -> Option<()> {
    let twin = view.twin(h);
    let next = extent.half_edges.existing(view.next(h)).filter(|n| view.is_half_edge(*n));
    let next_holds = next.is_some_and(|n| !extent.has(Part::Prev) || view.prev(n) == Some(h));
    let twin_holds = twin_holds(view, extent, h, twin, next);
    if !(next_holds && twin_holds) {
        links.doubt(h, [next_holds, twin_holds])?;
    }
    if twin.is_none() {
        links.unpaired += 1;
        let target = next.and_then(|n| extent.vertices.existing(view.origin(n)));
        links.ends(target, h, extent)?;
        if let (Some(target), Some(next)) = (target, next) {
            note(target, next);
        }
    }
    Some(())
}

/// L1 and L3.
fn twin_holds<V: View + ?Sized>(view: &V, extent: Extent, h: usize, twin: Link, next: Option<usize>) -> bool {
    let Some(t) = twin else { return extent.expect.is_open() };
    let is_pair = extent.half_edges.has(t) && is_mutual(view, h, t);
    is_pair && view.origin(t).is_some() && next.is_none_or(|n| view.origin(n) == view.origin(t))
}

/// L1.
#[inline]
fn is_mutual<V: View + ?Sized>(view: &V, h: usize, t: usize) -> bool {
    t != h && view.is_half_edge(t) && view.twin(t) == Some(h)
}
