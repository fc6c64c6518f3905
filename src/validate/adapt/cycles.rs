//! The cycles of a structure, with the face and the component of each, and the inverse of a link between half-edges.

use crate::numbers::{NIL, Sets};
use crate::validate::structure::{Link, View};
use crate::validate::subject::column;
use alloc::vec::Vec;

pub(super) struct Cycles {
    /// By cycle: its first half-edge, which represents it.
    pub(super) start: Vec<u32>,
    /// By cycle: the face of its first half-edge, or nil.
    pub(super) face: Vec<u32>,
    /// By cycle: its component. There are no more components than cycles.
    pub(super) component: Vec<u32>,
    /// By cycle: whether one of its half-edges has no twin.
    pub(super) unpaired: Vec<bool>,
    by_face: Groups,
}

impl Cycles {
    /// Finds all cycles; `None` if memory runs out. O(n α(n)).
    pub(super) fn of<V: View>(view: &V) -> Option<Self> {
        let mut of = nils(view.half_edge_slots())?;
        let faces = fits(view.face_slots())?;
        let (mut start, mut face): (Vec<u32>, Vec<u32>) = (Vec::new(), Vec::new());
        for first in live(view, of.len()) {
            if of[first] != NIL {
                continue;
            }
            start.try_reserve(1).ok()?;
            face.try_reserve(1).ok()?;
            let number = start.len() as u32;
            start.push(first as u32);
            face.push(view.face(first).filter(|f| *f < faces).map_or(NIL, |f| f as u32));
            let mut at = Some(first);
            while let Some(entry) = at.and_then(|h| of.get_mut(h)).filter(|entry| **entry == NIL) {
                *entry = number;
                at = at.and_then(|h| view.next(h)).filter(|h| *h < of.len() && view.is_half_edge(*h));
            }
        }
        let mut unpaired = filled(start.len(), false)?;
        let mut sets = Sets::try_new(start.len())?;
        for (h, cycle) in of.iter().enumerate().filter(|(_, cycle)| **cycle != NIL) {
            match view.twin(h) {
                None => unpaired[*cycle as usize] = true,
                Some(t) => {
                    if let Some(other) = entry(&of, t) {
                        sets.join(*cycle, other as u32);
                    }
                }
            }
        }
        let component = sets.numbered()?;
        let by_face = Groups::of(&face, faces)?;
        Some(Self { start, face, component, unpaired, by_face })
    }

    pub(super) fn faces(&self) -> usize {
        self.by_face.begin.len() - 1
    }

    pub(super) fn of_face(&self, face: usize) -> &[u32] {
        self.by_face.group(face)
    }
}

pub(super) struct Groups {
    members: Vec<u32>,
    begin: Vec<u32>,
}

impl Groups {
    /// Groups the numbers by label, which is nil or less than `groups`. Numbers labelled nil are in no group.
    pub(super) fn of(labels: &[u32], groups: usize) -> Option<Self> {
        let mut begin = filled(groups + 1, 0_u32)?;
        for label in labels.iter().filter(|label| **label != NIL) {
            begin[*label as usize + 1] += 1;
        }
        for group in 0..groups {
            begin[group + 1] += begin[group];
        }
        let mut members = nils(begin[groups] as usize)?;
        let mut free = begin.clone();
        for (number, label) in labels.iter().enumerate().filter(|(_, label)| **label != NIL) {
            let place = &mut free[*label as usize];
            members[*place as usize] = number as u32;
            *place += 1;
        }
        Some(Self { members, begin })
    }

    pub(super) fn group(&self, label: usize) -> &[u32] {
        &self.members[self.begin[label] as usize..self.begin[label + 1] as usize]
    }
}

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
