//! The log of what is overwritten, by which it is taken back and done again.
//!
//! An [`Entry`] has a number that was overwritten. To take it back, the two are exchanged, so that the entry then has the
//! number by which it is done again. Entries are taken back in the opposite order in which they were made.
//!
//! # Keys that live again
//!
//! An entry of a key that was issued or retired has the generation of its slot before. So when a removed record comes back, its
//! key names it again, and the stack of vacant slots is what it was. A slotmap cannot do this: its generations only grow.
//!
//! ```text
//!   generation of a slot    2 ── issue ──► 3 ── retire ──► 4
//!                           2 ◄── undo ─── 3 ◄─── undo ─── 4 ◄── and the key of generation 3 is live, then stale again
//!                           2 ── issue, for another record ──► 5: 3 was issued, so it never names anything else
//! ```
//!
//! What is issued after something was taken back must not have a key that was issued before, or a key that somebody still
//! holds would name another record. So the log keeps, for each slot of a key that was issued in a change that can no longer be
//! done again, the generation from which the next ones are issued. That is the only thing in it that is never taken back.
//!
//! # What is not logged
//!
//! The links that a record has when it is added. Once that is taken back nobody reads them, and until it is done again nobody
//! writes there: they are still there then. The links of a record that is removed are logged, since the slot may be used again. So is what
//! is in vacant slots, if a change is made while others can be done again: it may fail, and they still can.

use super::issuer::{Issuer, structure_offset};
use alloc::boxed::Box;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::ops::Range;

/// A kind of slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Vertex,
    Edge,
    Boundary,
    Face,
}

pub(super) const KINDS: [Kind; 4] = [Kind::Vertex, Kind::Edge, Kind::Boundary, Kind::Face];

/// A column, or what happened to a slot or a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Written {
    // A link, by its column. The number is that which is not there.
    Origin,
    Next,
    Prev,
    Boundary,
    VertexLink,
    BoundaryFace,
    Start,
    Place,
    Outer,
    /// A slot that was never used before. The number is the generation in which it is issued.
    New(Kind),
    /// A slot that was issued again. The number is the generation that it does not have.
    Issued(Kind),
    /// A slot that was retired, likewise.
    Retired(Kind),
    /// A list that became longer, by the face. The number is the boundary component.
    Listed,
    /// A list that became shorter, likewise. The place is still, or again, that of the boundary component.
    Unlisted,
}

/// Something that was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Entry {
    pub(super) written: Written,
    pub(super) slot: u32,
    pub(super) number: u32,
}

/// A direction in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// To take back.
    Back,
    /// To do again.
    Forth,
}

/// Entries that were written, and the keys that must not be issued again.
#[derive(Debug, Default)]
pub(crate) struct Log {
    pub(crate) entries: Vec<Entry>,
    /// By kind of slot its number of slots.
    pub(super) ends: [usize; 4],
    /// By kind, for slots of keys that cannot be issued again: the even generation from which the next ones are.
    floors: [BTreeMap<u32, u32>; 4],
    /// True if there are changes that can be done again.
    pub(super) saves_vacant: bool,
    /// Tells it from all other logs.
    token: Option<u32>,
    /// The number of changes and of cuts so far.
    serial: u64,
    /// The serial number of the present change.
    change: u64,
    /// The places to which it was cut back, each with its serial number; only those that no later cut goes further back than.
    cuts: Vec<(u64, usize)>,
}

impl Log {
    /// A copy, which is another log.
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

    /// Returns a number that no other log has.
    pub(crate) const fn token(&self) -> Option<u32> {
        self.token
    }

    /// Starts anew as another log, of a store with so many slots of each kind. The keys stay those that must not be issued again.
    pub(super) fn begin(&mut self, ends: [usize; 4]) {
        self.entries.clear();
        self.saves_vacant = false;
        self.token = Some(structure_offset());
        self.ends = ends;
    }

    /// Begins a change, in which no place of an earlier one leads back.
    pub(crate) fn begin_change(&mut self) {
        self.serial += 1;
        self.change = self.serial;
        self.cuts.clear();
    }

    /// Notes that the log was cut back to so many entries.
    pub(crate) fn cut_back(&mut self, entries: usize) {
        self.serial += 1;
        while self.cuts.last().is_some_and(|(_, cut)| *cut >= entries) {
            self.cuts.pop();
        }
        self.cuts.push((self.serial, entries));
    }

    /// Returns the serial number of the last change or cut.
    pub(crate) const fn serial(&self) -> u64 {
        self.serial
    }

    /// True if a serial number is of the present change, and the log has had so many entries, the same ones, ever since.
    pub(crate) fn has_kept(&self, entries: usize, serial: u64) -> bool {
        let first = self.cuts.iter().find(|(cut, _)| *cut > serial);
        serial >= self.change && entries <= self.entries.len() && first.is_none_or(|(_, cut)| *cut >= entries)
    }

    /// Saves what is in the slots that are issued from now on, or not.
    pub(crate) const fn set_saves_vacant(&mut self, saves: bool) {
        self.saves_vacant = saves;
    }

    /// Keeps the keys that some entries, which were taken back, issue, from being issued for anything else.
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

    /// The half-edges, one of each edge, and the vertices of which entries of a part say that they came or went, that the edge has another
    /// end, or that the vertex may be isolated or not; each perhaps several times.
    pub(crate) fn redrawn(&self, part: Range<usize>) -> (Vec<usize>, Vec<usize>) {
        let (mut edges, mut vertices) = (Vec::new(), Vec::new());
        for Entry { written, slot, .. } in &self.entries[part] {
            match written {
                Written::Origin => edges.push((slot & !1) as usize),
                Written::VertexLink => vertices.push(*slot as usize),
                Written::New(kind) | Written::Issued(kind) | Written::Retired(kind) => match kind {
                    Kind::Edge => edges.push(2 * *slot as usize),
                    Kind::Vertex => vertices.push(*slot as usize),
                    Kind::Boundary | Kind::Face => {}
                },
                _ => {}
            }
        }
        (edges, vertices)
    }

    /// Notes numbers that are about to be overwritten. Out of line: an operator without a log passes it over.
    #[cold]
    pub(super) fn note(&mut self, entries: &[(Written, u32, u32)]) {
        self.entries.extend(entries.iter().map(|(written, slot, number)| Entry {
            written: *written,
            slot: *slot,
            number: *number,
        }));
    }

    /// Logs that a slot was issued. Its generation grows if the key must not be issued again.
    pub(super) fn issued(&mut self, issuer: &mut Issuer, kind: Kind, slot: u32) {
        let before = issuer.generation(slot).wrapping_sub(1);
        let floors = &self.floors[kind as usize];
        if let Some(floor) = floors.get(&slot).filter(|floor| is_later(**floor, before)) {
            issuer.set_generation(slot, *floor | 1);
        }
        let end = &mut self.ends[kind as usize];
        if slot as usize == *end {
            *end += 1;
            self.entries.push(Entry { written: Written::New(kind), slot, number: issuer.generation(slot) });
        } else {
            self.entries.push(Entry { written: Written::Issued(kind), slot, number: before });
        }
    }
}

/// Returns true if a generation comes after another one.
const fn is_later(generation: u32, other: u32) -> bool {
    let ahead = generation.wrapping_sub(other);
    ahead != 0 && ahead < 1 << 31
}

/// The log of a store, if one is kept. A clone of the store keeps none.
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
