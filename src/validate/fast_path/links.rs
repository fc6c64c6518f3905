//! The scan over the half-edges: L1 and L3, and R1 of `twin` and `next`.

use super::extent::{Extent, existing, nils};
use crate::validate::expectation::Part;
use crate::validate::view::View;
use alloc::vec::Vec;

/// What the scan finds.
pub(super) struct Links {
    pub(super) half_edges: usize,
    /// Per vertex a half-edge that leaves it, or nil, where vertices keep none.
    pub(super) leaving: Option<Vec<u32>>,
}

impl Links {
    /// A half-edge that leaves the vertex.
    #[inline]
    pub(super) fn leaving<V: View + ?Sized>(&self, view: &V, v: usize) -> Option<usize> {
        match &self.leaving {
            None => view.leaving(v),
            Some(noted) => noted.get(v).copied().filter(|h| *h != u32::MAX).map(|h| h as usize),
        }
    }
}

/// Reads the links of every half-edge, in order of their numbers, so that none waits for another.
#[inline(never)]
pub(super) fn scan<V: View + ?Sized>(view: &V, extent: Extent) -> Option<Links> {
    if extent.has(Part::Leaving) {
        let half_edges = scan_and(view, extent, |_, _| Some(()))?;
        return Some(Links { half_edges, leaving: None });
    }
    let mut leaving = nils(extent.vertices)?;
    let half_edges = scan_and(view, extent, |h, origin| leaving.get_mut(origin).map(|noted| *noted = h as u32))?;
    Some(Links { half_edges, leaving: Some(leaving) })
}

/// Scans, and tells `note` each half-edge with its origin.
#[inline]
fn scan_and<V: View + ?Sized>(
    view: &V,
    extent: Extent,
    mut note: impl FnMut(usize, usize) -> Option<()>,
) -> Option<usize> {
    let mut live = 0;
    for h in 0..extent.half_edges {
        if !view.is_half_edge(h) {
            continue;
        }
        live += 1;
        let t = existing(view.twin(h), extent.half_edges)?;
        let n = existing(view.next(h), extent.half_edges)?;
        let mutual = t != h && view.twin(t) == Some(h) && view.is_half_edge(t) && view.is_half_edge(n);
        if !mutual || view.origin(n)? != view.origin(t)? {
            return None;
        }
        note(h, view.origin(h)?)?;
    }
    Some(live)
}
