//! The log of overwritten numbers, for undo and redo.
//!
//! An [`Entry`] contains an overwritten number. Undo exchanges it with the current number, so the entry then contains the number for
//! redo. Entries are undone in reverse order.
//!
//! # Revived keys
//!
//! The entry of an issued or retired key contains the previous generation of its slot. When a removed record returns, its key is valid
//! again, and the stack of vacant slots is as before. A slotmap cannot do this: its generations only grow.
//!
//! ```text
//!   generation of a slot    2 ── issue ──► 3 ── retire ──► 4
//!                           2 ◄── undo ─── 3 ◄─── undo ─── 4 ◄── and the key of generation 3 is live, then stale again
//!                           2 ── issue, for another record ──► 5: 3 was issued, so it never names anything else
//! ```
//!
//! After undo, a newly issued key must differ from all keys issued before, or a key that a user still holds would name another record.
//! So for each slot whose key was issued in a change that can no longer be redone, the log keeps the generation from which to issue new
//! keys. No other part of the log is permanent.
//!
//! # Not logged
//!
//! The initial links of a new record are not logged: after undo nobody reads them, and until redo nobody overwrites them. The links of
//! removed records are logged, since the slot may be reused. The contents of vacant slots are logged if a change starts while others
//! can be redone: the change may fail, and the others must remain.

use super::columns::RecordKind;
use super::issuer::{Issuer, structure_offset};
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::ops::Range;

pub(super) const KINDS: [RecordKind; 4] =
    [RecordKind::Vertex, RecordKind::Edge, RecordKind::Boundary, RecordKind::Face];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Written {
    // A link, by column. The number is the other value of the link.
    Origin,
    Next,
    Prev,
    Boundary,
    VertexLink,
    BoundaryFace,
    Start,
    Place,
    Outer,
    /// A slot issued for the first time. The number is the generation that it gets.
    New(RecordKind),
    /// A slot issued again. The number is the other generation.
    Issued(RecordKind),
    /// A retired slot. The number is the other generation.
    Retired(RecordKind),
    /// An entry appended to the list of a face. The number is the boundary component.
    Listed,
    /// An entry removed from the list of a face. The boundary component keeps, or regains, its place.
    Unlisted,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(super) written: Written,
    pub(super) slot: u32,
    pub(super) number: u32,
}

/// A direction in the history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Undo.
    Back,
    /// Redo.
    Forth,
}

/// The entries, and the keys that must not be issued again.
#[derive(Debug, Default)]
pub(crate) struct Log {
    pub(crate) entries: Vec<Entry>,
    pub(super) ends: [usize; 4],
    /// By kind, for slots with keys that must not be issued again: the even generation from which to issue.
    floors: [BTreeMap<u32, u32>; 4],
    /// True if there are changes to redo.
    pub(super) saves_vacant: bool,
    /// Distinguishes the log from all others.
    token: Option<u32>,
    serial: u64,
    change: u64,
    /// The positions to which the log was cut back, each with its serial number, except positions followed by a deeper cut.
    cuts: Vec<(u64, usize)>,
}

impl Log {
    pub(super) fn copied(&self) -> Self {
        let Self { entries, ends, floors, saves_vacant, .. } = self;
        let (entries, floors) = (entries.clone(), floors.clone());
        Self {
            entries,
            ends: *ends,
            floors,
            saves_vacant: *saves_vacant,
            token: Some(structure_offset()),
            ..Self::default()
        }
    }

    pub(crate) const fn token(&self) -> Option<u32> {
        self.token
    }

    /// Clears the log and sets a new token, for a store with `ends` slots of each kind. Keys that must not be issued again stay
    /// blocked.
    pub(super) fn begin(&mut self, ends: [usize; 4]) {
        self.entries.clear();
        self.saves_vacant = false;
        self.token = Some(structure_offset());
        self.ends = ends;
    }

    /// Begins a change: positions in earlier changes become invalid.
    pub(crate) fn begin_change(&mut self) {
        self.serial += 1;
        self.change = self.serial;
        self.cuts.clear();
    }

    pub(crate) fn cut_back(&mut self, entries: usize) {
        self.serial += 1;
        while self.cuts.last().is_some_and(|(_, cut)| *cut >= entries) {
            self.cuts.pop();
        }
        self.cuts.push((self.serial, entries));
    }

    pub(crate) const fn serial(&self) -> u64 {
        self.serial
    }

    /// Tells whether the first `entries` entries are unchanged since the serial number, which must be of the current change.
    pub(crate) fn has_kept(&self, entries: usize, serial: u64) -> bool {
        let first = self.cuts.iter().find(|(cut, _)| *cut > serial);
        serial >= self.change && entries <= self.entries.len() && first.is_none_or(|(_, cut)| *cut >= entries)
    }

    /// Sets whether the contents of newly issued slots are saved.
    pub(crate) const fn set_saves_vacant(&mut self, saves: bool) {
        self.saves_vacant = saves;
    }

    /// Blocks the keys issued by undone entries from being issued for other records.
    pub(crate) fn keep_from(&mut self, undone: &[Entry]) {
        for entry in undone {
            if let Written::New(kind) | Written::Issued(kind) = entry.written {
                let after = entry.number.wrapping_add(1);
                let floor = self.floors[kind as usize].entry(entry.slot).or_insert(after);
                if is_later(after, *floor) {
                    *floor = after;
                }
            }
        }
    }

    /// Returns one half-edge of each edge, and the vertices, for which entries of a part log an addition, a removal, a different end,
    /// or a change in being isolated; possibly with repetitions.
    pub(crate) fn redrawn(&self, part: Range<usize>) -> (Vec<usize>, Vec<usize>) {
        let (mut edges, mut vertices) = (Vec::new(), Vec::new());
        for Entry { written, slot, .. } in &self.entries[part] {
            match written {
                Written::Origin => edges.push((slot & !1) as usize),
                Written::VertexLink => vertices.push(*slot as usize),
                Written::New(kind) | Written::Issued(kind) | Written::Retired(kind) => match kind {
                    RecordKind::Edge => edges.push(2 * *slot as usize),
                    RecordKind::Vertex => vertices.push(*slot as usize),
                    RecordKind::Boundary | RecordKind::Face => {}
                },
                _ => {}
            }
        }
        (edges, vertices)
    }

    /// Logs numbers about to be overwritten. Not inlined, to keep operators without a log fast.
    #[cold]
    pub(super) fn note(&mut self, entries: &[(Written, u32, u32)]) {
        self.entries.extend(entries.iter().map(|(written, slot, number)| Entry {
            written: *written,
            slot: *slot,
            number: *number,
        }));
    }

    /// Returns the generation with which a slot is issued next: `generation`, or a later one if its keys must not be issued again.
    pub(super) fn allowed(&self, kind: RecordKind, slot: u32, generation: u32) -> u32 {
        let floor = self.floors[kind as usize].get(&slot).map(|floor| floor | 1);
        floor.filter(|floor| is_later(*floor, generation)).unwrap_or(generation)
    }

    /// Logs an issued slot. Its generation grows if the key must not be issued again.
    pub(super) fn issued(&mut self, issuer: &mut Issuer, kind: RecordKind, slot: u32) {
        let generation = issuer.generation(slot);
        issuer.set_generation(slot, self.allowed(kind, slot, generation));
        let end = &mut self.ends[kind as usize];
        if slot as usize == *end {
            *end += 1;
            self.entries.push(Entry { written: Written::New(kind), slot, number: issuer.generation(slot) });
        } else {
            self.entries.push(Entry { written: Written::Issued(kind), slot, number: generation.wrapping_sub(1) });
        }
    }
}

/// Returns true if one generation comes after another.
const fn is_later(generation: u32, other: u32) -> bool {
    let ahead = generation.wrapping_sub(other);
    ahead != 0 && ahead < 1 << 31
}

/// The log of a store, if there is one. A clone of the store has none.
#[derive(Debug, Default)]
pub(crate) struct KeptLog(pub(super) Option<Box<Log>>);

impl Clone for KeptLog {
    fn clone(&self) -> Self {
        Self(None)
    }
}

impl KeptLog {
    #[inline]
    pub(crate) const fn get(&self) -> Option<&Log> {
        match &self.0 {
            Some(log) => Some(log),
            None => None,
        }
    }

    pub(crate) fn get_mut(&mut self) -> Option<&mut Log> {
        self.0.as_deref_mut()
    }
}
