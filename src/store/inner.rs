//! The lists of the inner boundary components of faces.

use super::columns::{BoundarySlot, OTHER, put};
use crate::slots::NIL;
use alloc::vec::Vec;

/// The entry of an empty list.
const NONE: BoundarySlot = BoundarySlot(NIL);

/// The list of each face, by slot. Most lists are empty and most others have one entry; only longer ones are on the
/// heap.
#[derive(Clone, Debug, Default)]
pub(super) struct InnerLists {
    /// Per face: no entry, its only entry, or (high bit) the number of its list.
    faces: Vec<BoundarySlot>,
    lists: Vec<Vec<BoundarySlot>>,
    /// The unused lists, which are empty.
    free: Vec<u32>,
}

impl InnerLists {
    pub(super) const fn new(faces: Vec<BoundarySlot>) -> Self {
        Self { faces, lists: Vec::new(), free: Vec::new() }
    }

    pub(super) const fn unused() -> BoundarySlot {
        NONE
    }

    /// Adds faces with empty lists up to this number of slots.
    pub(super) fn resize(&mut self, faces: usize) {
        self.faces.resize(faces, NONE);
    }

    pub(super) fn add(&mut self, face: u32) {
        put(&mut self.faces, face, NONE);
    }

    #[inline]
    pub(super) fn of(&self, face: u32) -> &[BoundarySlot] {
        let entry = &self.faces[face as usize];
        if *entry == NONE {
            &[]
        } else if entry.0 & OTHER == 0 {
            core::slice::from_ref(entry)
        } else {
            &self.lists[(entry.0 ^ OTHER) as usize]
        }
    }

    /// Appends an entry to the list of a face. O(1), amortised.
    pub(super) fn push(&mut self, face: u32, b: BoundarySlot) {
        let entry = &mut self.faces[face as usize];
        if *entry == NONE {
            *entry = b;
        } else if entry.0 & OTHER == 0 {
            let list = self.free.pop().unwrap_or_else(|| {
                self.lists.push(Vec::new());
                self.lists.len() as u32 - 1
            });
            self.lists[list as usize].extend([*entry, b]);
            *entry = BoundarySlot(list | OTHER);
        } else {
            self.lists[(entry.0 ^ OTHER) as usize].push(b);
        }
    }

    /// Removes an entry from the list of a face, and returns the entry that takes its place, previously the last. O(1).
    pub(super) fn swap_remove(&mut self, face: u32, place: u32) -> Option<BoundarySlot> {
        let entry = &mut self.faces[face as usize];
        if entry.0 & OTHER == 0 {
            *entry = NONE;
            return None;
        }
        let number = entry.0 ^ OTHER;
        let list = self.lists.get_mut(number as usize)?;
        list.swap_remove(place as usize);
        if list.is_empty() {
            *list = Vec::new();
            self.free.push(number);
            *entry = NONE;
            return None;
        }
        list.get(place as usize).copied()
    }
    pub(super) fn pop(&mut self, face: u32) {
        let last = self.of(face).len().saturating_sub(1);
        self.swap_remove(face, last as u32);
    }

    /// Undoes a [`swap_remove`](Self::swap_remove). O(1), amortised.
    pub(super) fn put_back(&mut self, face: u32, place: u32, b: BoundarySlot) {
        self.push(face, b);
        let entry = self.faces[face as usize];
        let list = if entry.0 & OTHER == 0 { None } else { self.lists.get_mut((entry.0 ^ OTHER) as usize) };
        if let Some(list) = list {
            let last = list.len() - 1;
            list.swap(place as usize, last);
        }
    }
}
