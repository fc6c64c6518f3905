//! The half-edges by index: their number, and the starts of the walks around the vertices.

use crate::slots::NIL;
use crate::validate::structure::{Part, View};
use crate::validate::subject::{Extent, Subject};
use alloc::vec::Vec;

pub(super) struct Starts {
    pub(super) half_edges: usize,
    pub(super) unpaired: usize,
    /// By vertex: a half-edge that leaves it, or nil; only if vertices store none.
    leaving: Option<Vec<u32>>,
    /// By vertex: the half-edge without twin that ends there, or nil; empty if all half-edges have twins.
    pub(super) into: Vec<u32>,
}

/// Counts the half-edges, and records the starts that the structure does not store. `None` if two half-edges without twin end at one
/// vertex: two fans share it.
pub(super) fn find<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Starts> {
    let mut starts = Starts { half_edges: 0, unpaired: 0, leaving: None, into: Vec::new() };
    if !extent.has(Part::Leaving) {
        let mut leaving = extent.vertices.nils()?;
        for h in (Subject { view, extent }).half_edges() {
            if let Some(noted) = view.origin(h as usize).and_then(|v| leaving.get_mut(v)) {
                *noted = h;
            }
        }
        starts.leaving = Some(leaving);
    }
    if !extent.expect.is_open() {
        starts.half_edges = match view.half_edge_columns().and_then(|columns| columns.live_edges) {
            Some(live) => 2 * live.iter().map(|edge| (edge & 1) as usize).sum::<usize>(),
            None => extent.half_edges.all().map(|h| usize::from(view.is_half_edge(h))).sum(),
        };
        return Some(starts);
    }
    for h in (Subject { view, extent }).half_edges() {
        starts.half_edges += 1;
        if view.twin(h as usize).is_none() {
            starts.unpaired += 1;
            starts.note_end(view, extent, h)?;
        }
    }
    Some(starts)
}

impl Starts {
    /// Returns the first live half-edge, if all half-edges from there on are live.
    pub(super) fn first_live<V: View + ?Sized>(&self, view: &V, extent: Extent) -> Option<u32> {
        let first = extent.half_edges.count.checked_sub(self.half_edges as u32)?;
        (0..first).all(|h| !view.is_half_edge(h as usize)).then_some(first)
    }

    #[inline]
    pub(super) fn leaving<V: View + ?Sized>(&self, view: &V, v: usize) -> Option<usize> {
        match &self.leaving {
            None => view.leaving(v),
            Some(noted) => noted.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize),
        }
    }

    #[inline]
    pub(super) fn into(&self, v: usize) -> Option<usize> {
        self.into.get(v).copied().filter(|h| *h != NIL).map(|h| h as usize)
    }

    fn note_end<V: View + ?Sized>(&mut self, view: &V, extent: Extent, h: u32) -> Option<()> {
        if self.into.is_empty() {
            self.into = extent.vertices.nils()?;
        }
        let next = extent.half_edges.existing(view.next(h as usize)).filter(|n| view.is_half_edge(*n))?;
        let into = self.into.get_mut(view.origin(next)?)?;
        (core::mem::replace(into, h) == NIL).then_some(())
    }
}
