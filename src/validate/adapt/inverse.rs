//! The inverse of a link between half-edges.

use crate::validate::columns::{NIL, column};
use crate::validate::structure::{Link, View};
use alloc::vec::Vec;

/// By half-edge: the first half-edge whose link leads to it, or [`NIL`]. `None` if there are too many half-edges for
/// 32-bit numbers, or if memory runs out.
pub(super) fn inverse<V: View + ?Sized>(view: &V, link: impl Fn(&V, usize) -> Link) -> Option<Vec<u32>> {
    let mut inverse = nils(view.half_edge_slots())?;
    for h in live(view, inverse.len()) {
        if let Some(entry) = link(view, h).and_then(|to| inverse.get_mut(to)).filter(|entry| **entry == NIL) {
            *entry = h as u32;
        }
    }
    Some(inverse)
}

/// A column of `n` nils; `None` if memory runs out or 32-bit numbers do not suffice.
pub(super) fn nils(n: usize) -> Option<Vec<u32>> {
    filled(n, NIL)
}

/// A column of `n` copies of `value`; `None` if memory runs out or 32-bit numbers do not suffice.
pub(super) fn filled<T: Clone>(n: usize, value: T) -> Option<Vec<T>> {
    column(fits(n)? as u32, value).ok()
}

/// Returns `n` if 32-bit numbers can distinguish `n` records and nil.
pub(super) fn fits(n: usize) -> Option<usize> {
    (n < NIL as usize).then_some(n)
}

pub(super) fn live<V: View + ?Sized>(view: &V, slots: usize) -> impl Iterator<Item = usize> + '_ {
    (0..slots).filter(|h| view.is_half_edge(*h))
}

pub(super) fn entry(column: &[u32], i: usize) -> Link {
    column.get(i).filter(|entry| **entry != NIL).map(|entry| *entry as usize)
}
