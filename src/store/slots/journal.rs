//! A journal of what is written, by which it is taken back and done again.
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
//! holds would name another record. So the journal keeps, for each slot of a key that was issued in a change that can no longer be
//! done again, the generation from which the next ones are issued. That is the only thing in it that is never taken back.
//!
//! # What is not logged
//!
//! The links that a record has when it is added. Once that is taken back nobody reads them, and until it is done again nobody
//! writes there: they are still there then. The links of a record that is removed are logged, since the slot may be used again. So is what
//! is in vacant slots, if a change is made while others can be done again: it may fail, and they still can.

use super::columns::{BoundarySlot, FaceSlot, HalfEdgeSlot, VACANT, VertexSlot};
use super::store::SlotStore;
use crate::store::issuer::{Issuer, structure_offset};
use crate::store::links::Links;
use crate::store::place::{MOST, OUTER};
use crate::store::watch::Watch;
use crate::validate::near::WriteSet;
use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::ops::Range;

/// A kind of slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Vertex,
    Edge,
    Boundary,
    Face,
}

const KINDS: [Kind; 4] = [Kind::Vertex, Kind::Edge, Kind::Boundary, Kind::Face];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Written {
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
    written: Written,
    slot: u32,
    number: u32,
}

/// A direction in time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    /// To take back.
    Back,
    /// To do again.
    Forth,
}

/// Entries that were written, and the keys that must not be issued again.
#[derive(Debug, Default)]
pub struct Journal {
    pub(crate) entries: Vec<Entry>,
    /// By kind of slot its number of slots.
    ends: [usize; 4],
    /// By kind, for slots of keys that cannot be issued again: the even generation from which the next ones are.
    floors: [BTreeMap<u32, u32>; 4],
    /// True if there are changes that can be done again.
    saves_vacant: bool,
    /// Tells it from all other journals.
    token: Option<u32>,
}

/// A clone is another journal.
impl Clone for Journal {
    fn clone(&self) -> Self {
        let Self { entries, ends, floors, saves_vacant, .. } = self;
        let (entries, floors) = (entries.clone(), floors.clone());
        Self { entries, ends: *ends, floors, saves_vacant: *saves_vacant, token: Some(structure_offset()) }
    }
}

impl Journal {
    /// Returns a number that no other journal has.
    pub(crate) const fn token(&self) -> Option<u32> {
        self.token
    }

    /// Starts anew with the store as it is, as another journal. The keys stay those that must not be issued again.
    pub(crate) fn begin(&mut self, store: &SlotStore) {
        self.entries.clear();
        self.saves_vacant = false;
        self.token = Some(structure_offset());
        self.follow(store);
    }

    /// Notes how many slots there are.
    fn follow(&mut self, store: &SlotStore) {
        self.ends = KINDS.map(|kind| store.issuer(kind).end());
    }

    /// Saves what is in the slots that are issued from now on, or not.
    pub(crate) const fn save_vacant(&mut self, saves: bool) {
        self.saves_vacant = saves;
    }

    /// Takes back what was written last, from the end, or writes again what was taken back last. O(entries).
    pub(crate) fn replay(&mut self, store: &mut SlotStore, part: Range<usize>, way: Way) {
        let entries = &mut self.entries[part];
        match way {
            Way::Back => entries.iter_mut().rev().for_each(|entry| store.undo(entry)),
            Way::Forth => entries.iter_mut().for_each(|entry| store.redo(entry)),
        }
        self.follow(store);
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

    /// The half-edges, one of each edge, and the vertices whose drawing some entries may have changed, each perhaps several times: edges
    /// that came, went or have another end, and vertices that came, went or may be isolated or not.
    #[cfg(feature = "map")]
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

    /// The records that some entries wrote, or took back. O(entries).
    pub(crate) fn written(&self, store: &SlotStore, part: Range<usize>) -> WriteSet {
        let mut written = WriteSet::default();
        for entry in &self.entries[part] {
            let slot = entry.slot as usize;
            match entry.written {
                Written::Origin | Written::Next | Written::Prev | Written::Boundary => {
                    written.half_edges.push(slot);
                }
                Written::VertexLink => written.vertices.push(slot),
                Written::BoundaryFace | Written::Start => written.boundaries.push(slot),
                Written::Place => {
                    written.boundaries.push(slot);
                    // Each entry of a list that is another one now is one of a boundary component with another place.
                    if store.boundaries.is_live(entry.slot) && store.place[slot] < MOST {
                        written.listed.push((store.boundary_face[slot].0 as usize, store.place[slot] as usize));
                    }
                }
                Written::Outer => written.faces.push(slot),
                Written::New(kind) | Written::Issued(kind) | Written::Retired(kind) => match kind {
                    Kind::Vertex => written.vertices.push(slot),
                    Kind::Edge => written.half_edges.extend([2 * slot, 2 * slot + 1]),
                    Kind::Boundary => written.boundaries.push(slot),
                    Kind::Face => written.faces.push(slot),
                },
                Written::Listed | Written::Unlisted => {
                    written.faces.push(slot);
                    let b = entry.number as usize;
                    written.boundaries.push(b);
                    if entry.written == Written::Listed
                        && store.boundaries.is_live(entry.number)
                        && store.place[b] < MOST
                    {
                        written.listed.push((store.boundary_face[b].0 as usize, store.place[b] as usize));
                    }
                }
            }
        }
        written
    }

    #[inline]
    fn log(&mut self, written: Written, slot: u32, number: u32) {
        self.entries.push(Entry { written, slot, number });
    }

    /// Logs several at once, which takes less time.
    #[inline]
    fn log_all<const N: usize>(&mut self, entries: [(Written, u32, u32); N]) {
        self.entries.extend(entries.map(|(written, slot, number)| Entry { written, slot, number }));
    }

    /// Logs what is in the slot that is issued next, if it has ever been used.
    fn save(&mut self, columns: &[Written], slot: u32, store: &mut SlotStore) {
        for column in columns {
            if let Some(number) = store.link_mut(*column, slot) {
                self.log(*column, slot, *number);
            }
        }
    }

    fn issued(&mut self, issuer: &mut Issuer, kind: Kind, slot: u32) {
        let before = issuer.generation(slot).wrapping_sub(1);
        let floors = &self.floors[kind as usize];
        if let Some(floor) = floors.get(&slot).filter(|floor| is_later(**floor, before)) {
            issuer.set_generation(slot, *floor | 1);
        }
        let end = &mut self.ends[kind as usize];
        if slot as usize == *end {
            *end += 1;
            self.log(Written::New(kind), slot, issuer.generation(slot));
        } else {
            self.log(Written::Issued(kind), slot, before);
        }
    }

    fn retired(&mut self, issuer: &Issuer, kind: Kind, slot: u32) {
        self.log(Written::Retired(kind), slot, issuer.generation(slot));
    }
}

/// Returns true if a generation comes after another one.
const fn is_later(generation: u32, other: u32) -> bool {
    let ahead = generation.wrapping_sub(other);
    ahead != 0 && ahead < 1 << 31
}

impl Watch<SlotStore> for Journal {
    const RECORDS: bool = true;

    fn add_vertex(&mut self, store: &mut SlotStore) {
        if self.saves_vacant {
            self.save(&[Written::VertexLink], store.vertices.next(), store);
        }
    }

    fn add_isolated(&mut self, store: &mut SlotStore) {
        self.add_vertex(store);
        self.add_boundary(store);
    }

    fn add_edge(&mut self, store: &mut SlotStore) {
        if self.saves_vacant {
            for h in [0, 1].map(|side| 2 * store.edges.next() + side) {
                self.save(&[Written::Origin, Written::Next, Written::Prev, Written::Boundary], h, store);
            }
        }
    }

    fn add_boundary(&mut self, store: &mut SlotStore) {
        if self.saves_vacant {
            self.save(&[Written::BoundaryFace, Written::Start, Written::Place], store.boundaries.next(), store);
        }
    }

    fn added_vertex(&mut self, store: &mut SlotStore, v: VertexSlot) {
        self.issued(&mut store.vertices, Kind::Vertex, v.0);
    }

    fn added_isolated(&mut self, store: &mut SlotStore, v: VertexSlot, b: BoundarySlot) {
        self.issued(&mut store.vertices, Kind::Vertex, v.0);
        self.issued(&mut store.boundaries, Kind::Boundary, b.0);
        self.log(Written::Listed, store.face(b).0, b.0);
    }

    fn added_edge(&mut self, store: &mut SlotStore, h: HalfEdgeSlot) {
        self.issued(&mut store.edges, Kind::Edge, h.0 >> 1);
    }

    fn added_boundary(&mut self, store: &mut SlotStore, b: BoundarySlot) {
        self.issued(&mut store.boundaries, Kind::Boundary, b.0);
    }

    fn added_face(&mut self, store: &mut SlotStore, f: FaceSlot) {
        self.issued(&mut store.faces, Kind::Face, f.0);
        self.log(Written::Outer, f.0, VACANT);
    }

    fn remove_vertex(&mut self, store: &SlotStore, v: VertexSlot) {
        self.set_vertex_link(store, v);
        self.retired(&store.vertices, Kind::Vertex, v.0);
    }

    fn remove_edge(&mut self, store: &SlotStore, h: HalfEdgeSlot) {
        for h in [h, store.twin(h)] {
            self.log_all([
                (Written::Origin, h.0, store.origin(h).0),
                (Written::Next, h.0, store.next(h).0),
                (Written::Prev, h.0, store.prev(h).0),
                (Written::Boundary, h.0, store.boundary(h).0),
            ]);
        }
        self.retired(&store.edges, Kind::Edge, h.0 >> 1);
    }

    fn remove_boundary(&mut self, store: &SlotStore, b: BoundarySlot) {
        self.log_all([
            (Written::Start, b.0, store.start[b.0 as usize]),
            (Written::BoundaryFace, b.0, store.face(b).0),
            (Written::Place, b.0, store.place(b)),
        ]);
        self.retired(&store.boundaries, Kind::Boundary, b.0);
    }

    fn remove_face(&mut self, store: &SlotStore, f: FaceSlot) {
        self.log(Written::Outer, f.0, store.outer[f.0 as usize]);
        self.retired(&store.faces, Kind::Face, f.0);
    }

    fn set_origin(&mut self, store: &SlotStore, h: HalfEdgeSlot) {
        self.log(Written::Origin, h.0, store.origin(h).0);
    }

    fn join(&mut self, store: &SlotStore, h: HalfEdgeSlot, n: HalfEdgeSlot) {
        self.log_all([(Written::Next, h.0, store.next(h).0), (Written::Prev, n.0, store.prev(n).0)]);
    }

    fn set_boundary(&mut self, store: &SlotStore, h: HalfEdgeSlot) {
        self.log(Written::Boundary, h.0, store.boundary(h).0);
    }

    fn set_vertex_link(&mut self, store: &SlotStore, v: VertexSlot) {
        self.log(Written::VertexLink, v.0, store.vertex_link[v.0 as usize]);
    }

    fn set_start(&mut self, store: &SlotStore, b: BoundarySlot) {
        self.log(Written::Start, b.0, store.start[b.0 as usize]);
        if store.place(b) == OUTER {
            let f = store.face(b).0;
            self.log(Written::Outer, f, store.outer[f as usize]);
        }
    }

    fn set_place(&mut self, store: &SlotStore, b: BoundarySlot) {
        self.log(Written::Place, b.0, store.place(b));
    }

    fn list_outer(&mut self, store: &SlotStore, f: FaceSlot, b: BoundarySlot) {
        self.log_all([
            (Written::Outer, f.0, store.outer[f.0 as usize]),
            (Written::BoundaryFace, b.0, store.face(b).0),
            (Written::Place, b.0, store.place(b)),
        ]);
    }

    fn list_inner(&mut self, store: &SlotStore, f: FaceSlot, b: BoundarySlot) {
        self.log_all([
            (Written::BoundaryFace, b.0, store.face(b).0),
            (Written::Place, b.0, store.place(b)),
            (Written::Listed, f.0, b.0),
        ]);
    }

    fn unlist(&mut self, store: &SlotStore, b: BoundarySlot) {
        let f = store.face(b);
        if store.place(b) == OUTER {
            self.log(Written::Outer, f.0, store.outer[f.0 as usize]);
        } else {
            self.log(Written::Unlisted, f.0, b.0);
            // The last of the list moves to its place.
            if let Some(last) = store.inner.of(f.0).last() {
                self.set_place(store, *last);
            }
        }
        self.set_place(store, b);
    }
}

impl SlotStore {
    const fn issuer(&self, kind: Kind) -> &Issuer {
        match kind {
            Kind::Vertex => &self.vertices,
            Kind::Edge => &self.edges,
            Kind::Boundary => &self.boundaries,
            Kind::Face => &self.faces,
        }
    }

    const fn issuer_mut(&mut self, kind: Kind) -> &mut Issuer {
        match kind {
            Kind::Vertex => &mut self.vertices,
            Kind::Edge => &mut self.edges,
            Kind::Boundary => &mut self.boundaries,
            Kind::Face => &mut self.faces,
        }
    }

    /// The link that an entry is about, in a slot that was used once.
    #[inline]
    fn link_mut(&mut self, written: Written, slot: u32) -> Option<&mut u32> {
        let i = slot as usize;
        match written {
            Written::Origin => self.origin.get_mut(i).map(|v| &mut v.0),
            Written::Next => self.next.get_mut(i).map(|h| &mut h.0),
            Written::Prev => self.prev.get_mut(i).map(|h| &mut h.0),
            Written::Boundary => self.boundary.get_mut(i).map(|b| &mut b.0),
            Written::VertexLink => self.vertex_link.get_mut(i),
            Written::BoundaryFace => self.boundary_face.get_mut(i).map(|f| &mut f.0),
            Written::Start => self.start.get_mut(i),
            Written::Place => self.place.get_mut(i),
            Written::Outer => self.outer.get_mut(i),
            _ => None,
        }
    }

    fn undo(&mut self, Entry { written, slot, number }: &mut Entry) {
        if let Some(link) = self.link_mut(*written, *slot) {
            return core::mem::swap(link, number);
        }
        match written {
            Written::New(kind) => self.issuer_mut(*kind).forget_last(),
            Written::Issued(kind) | Written::Retired(kind) => self.issuer_mut(*kind).exchange(*slot, number),
            Written::Listed => self.inner.pop(*slot),
            Written::Unlisted => self.inner.put_back(*slot, self.place[*number as usize], BoundarySlot(*number)),
            _ => {}
        }
    }

    fn redo(&mut self, Entry { written, slot, number }: &mut Entry) {
        if let Some(link) = self.link_mut(*written, *slot) {
            return core::mem::swap(link, number);
        }
        match written {
            Written::New(kind) => self.issuer_mut(*kind).issue_last(*number),
            Written::Issued(kind) | Written::Retired(kind) => self.issuer_mut(*kind).exchange(*slot, number),
            Written::Listed => self.inner.push(*slot, BoundarySlot(*number)),
            Written::Unlisted => {
                self.inner.swap_remove(*slot, self.place[*number as usize]);
            }
            _ => {}
        }
    }
}
