//! What the scan and the walks share: how much there is, and what is asked for.

use crate::validate::columns::{NIL, column};
use crate::validate::expectation::{Expectation, Part};
use crate::validate::view::{Link, View};
use alloc::vec::Vec;

/// How many slots there are, and what the structure has.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    pub(super) vertices: usize,
    pub(super) half_edges: usize,
    pub(super) boundaries: usize,
    pub(super) faces: usize,
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

/// A link, if the slot that it leads to exists.
#[inline]
pub(super) fn existing(link: Option<usize>, slots: usize) -> Option<usize> {
    link.filter(|i| *i < slots)
}

/// A column of `n` nils, if there is memory for it.
pub(super) fn nils(n: usize) -> Option<Vec<u32>> {
    column(n as u32, NIL).ok()
}
