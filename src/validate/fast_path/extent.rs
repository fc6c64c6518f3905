//! What the scan and the walks share: how much there is, and what is asked for.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::{Expectation, Part};
use crate::validate::view::{Link, View};
use alloc::vec::Vec;
use core::ops::Range;

/// How many slots there are, and what the structure has.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    pub(super) vertices: Slots,
    pub(super) half_edges: Slots,
    pub(super) boundaries: Slots,
    pub(super) faces: Slots,
    pub(super) expect: Expectation,
}

impl Extent {
    pub(super) const fn has(&self, part: Part) -> bool {
        self.expect.has(part)
    }

    /// The boundary component, or without records for these the face, that the half-edge names.
    #[inline]
    pub(super) fn name<V: View + ?Sized>(&self, view: &V, h: usize) -> Link {
        if self.has(Part::BoundaryComponents) { view.boundary(h) } else { view.face(h) }
    }
}

/// How many slots there are of one kind.
///
/// In 32 bits: where a structure keeps its links in 32 bits too, with all of them set for nil, one comparison tells that a link is not
/// nil and that its slot exists.
#[derive(Clone, Copy)]
pub(super) struct Slots(pub(super) u32);

impl Slots {
    #[inline]
    pub(super) const fn count(self) -> usize {
        self.0 as usize
    }

    #[inline]
    pub(super) const fn all(self) -> Range<usize> {
        0..self.count()
    }

    #[inline]
    pub(super) const fn has(self, slot: usize) -> bool {
        slot < self.count()
    }

    /// A link, if the slot that it leads to exists.
    #[inline]
    pub(super) fn existing(self, link: Link) -> Link {
        link.filter(|slot| self.has(*slot))
    }

    /// A column with a nil for each slot, if there is memory for it.
    pub(super) fn nils(self) -> Option<Vec<u32>> {
        column(self.0, NIL).ok()
    }
}
