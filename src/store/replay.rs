//! Writes the log of a store, and replays it for undo and redo.

use super::columns::RecordKind;
use super::columns::{BoundaryRow, BoundarySlot, FaceSlot, MOST};
use super::issuer::Issuer;
use super::keys::{FaceKey, HalfEdgeKey, VertexKey, key};
use super::log::{Entry, KINDS, Way, Written};
use super::slots::Store;
use crate::validate::near::WriteSet;
use alloc::boxed::Box;
use core::ops::Range;

impl Store {
    /// Starts a new log. Keys that must not be issued again stay blocked.
    pub(crate) fn begin_log(&mut self) {
        let ends = self.ends();
        self.log.0.get_or_insert_default().begin(ends);
    }

    pub(crate) fn end_log(&mut self) {
        self.log.0 = None;
    }

    /// Continues with a copy of the log of `other`, the original of this clone.
    pub(crate) fn copy_log(&mut self, other: &Self) {
        self.log.0 = other.log.get().map(|log| Box::new(log.copied()));
    }

    /// Undoes a part of the log, from its end, or redoes it. O(entries).
    pub(crate) fn replay(&mut self, part: Range<usize>, way: Way) {
        let Some(mut log) = self.log.0.take() else { return };
        let entries = &mut log.entries[part];
        match way {
            Way::Back => entries.iter_mut().rev().for_each(|entry| self.undo(entry)),
            Way::Forth => entries.iter_mut().for_each(|entry| self.redo(entry)),
        }
        log.ends = self.ends();
        self.log.0 = Some(log);
    }

    /// Adds the records written by a part of the log, in either direction. O(entries).
    pub(crate) fn add_written(&self, part: Range<usize>, written: &mut WriteSet) {
        for entry in self.log.get().map_or(&[][..], |log| &log.entries[part]) {
            let slot = entry.slot as usize;
            match entry.written {
                Written::Origin | Written::Next | Written::Prev | Written::Boundary => {
                    written.half_edges.push(slot);
                }
                Written::VertexLink => written.vertices.push(slot),
                Written::BoundaryFace | Written::Start => written.boundaries.push(slot),
                Written::Place => {
                    written.boundaries.push(slot);
                    // A list entry changes only if a boundary component changes its place.
                    written.listed.extend(self.listed(entry.slot));
                }
                Written::Outer => {
                    written.faces.push(slot);
                    // The face is now another region. One component that lies in it is enough to check, without a full validation.
                    written.boundaries.extend(self.inner_list(FaceSlot(entry.slot)).last().map(|b| b.index()));
                }
                Written::New(kind) | Written::Issued(kind) | Written::Retired(kind) => match kind {
                    RecordKind::Vertex => written.vertices.push(slot),
                    RecordKind::Edge => written.half_edges.extend([2 * slot, 2 * slot + 1]),
                    RecordKind::Boundary => written.boundaries.push(slot),
                    RecordKind::Face => written.faces.push(slot),
                },
                Written::Listed | Written::Unlisted => {
                    written.faces.push(slot);
                    written.boundaries.push(entry.number as usize);
                    if entry.written == Written::Listed {
                        written.listed.extend(self.listed(entry.number));
                    }
                }
            }
        }
    }

    /// The face and the place of a boundary component that may be in a list.
    fn listed(&self, b: u32) -> Option<(usize, usize)> {
        let BoundaryRow { face, place, .. } = *self.boundary_rows.get(b as usize)?;
        let is_listed = self.boundaries.is_live(b) && (place as usize) < MOST;
        is_listed.then_some((face.index(), place as usize))
    }

    #[inline]
    pub(super) fn note(&mut self, written: Written, slot: u32, number: u32) {
        if let Some(log) = &mut self.log.0 {
            log.note(&[(written, slot, number)]);
        }
    }

    /// Logs several numbers at once, which is faster.
    #[inline]
    pub(super) fn note_all<const N: usize>(&mut self, entries: [(Written, u32, u32); N]) {
        if let Some(log) = &mut self.log.0 {
            log.note(&entries);
        }
    }

    /// Logs an issued slot. Its generation grows if the key must not be issued again.
    #[inline]
    pub(super) fn note_issued(&mut self, kind: RecordKind, slot: u32) {
        if self.is_logged() {
            self.log_issued(kind, slot);
        }
    }

    #[cold]
    fn log_issued(&mut self, kind: RecordKind, slot: u32) {
        if let Some(mut log) = self.log.0.take() {
            log.issued(self.issuer_mut(kind), kind, slot);
            self.log.0 = Some(log);
        }
    }

    /// The key that the next vertex will have.
    pub(crate) fn next_vertex(&self) -> VertexKey {
        key(self.vertices.next(), self.next_generation(RecordKind::Vertex))
    }

    /// The keys of the two half-edges that the next edge will have.
    pub(crate) fn next_edge(&self) -> [HalfEdgeKey; 2] {
        let h = self.edges.next() << 1;
        [h, h | 1].map(|h| key(h, self.next_generation(RecordKind::Edge)))
    }

    /// The key that the next face will have.
    pub(crate) fn next_face(&self) -> FaceKey {
        key(self.faces.next(), self.next_generation(RecordKind::Face))
    }

    fn next_generation(&self, kind: RecordKind) -> u32 {
        let (slot, generation) = (self.issuer(kind).next(), self.issuer(kind).next_generation());
        self.log.get().map_or(generation, |log| log.allowed(kind, slot, generation))
    }

    #[inline]
    pub(super) fn note_retired(&mut self, kind: RecordKind, slot: u32) {
        if self.is_logged() {
            let generation = self.issuer(kind).generation(slot);
            self.note(Written::Retired(kind), slot, generation);
        }
    }

    /// Logs the contents of the next slot to be issued, if it was ever used and there are changes to redo.
    #[inline]
    pub(super) fn save_vacant(&mut self, kind: RecordKind) {
        if self.is_logged() {
            self.log_vacant(kind);
        }
    }

    #[cold]
    fn log_vacant(&mut self, kind: RecordKind) {
        if let Some(mut log) = self.log.0.take_if(|log| log.saves_vacant) {
            let edge = 2 * self.edges.next();
            let (columns, slots): (&[Written], _) = match kind {
                RecordKind::Vertex => (&[Written::VertexLink], self.vertices.next()..self.vertices.next() + 1),
                RecordKind::Edge => {
                    (&[Written::Origin, Written::Next, Written::Prev, Written::Boundary], edge..edge + 2)
                }
                RecordKind::Boundary => (
                    &[Written::BoundaryFace, Written::Start, Written::Place],
                    self.boundaries.next()..self.boundaries.next() + 1,
                ),
                RecordKind::Face => (&[], 0..0),
            };
            for slot in slots {
                for column in columns {
                    if let Some(number) = self.link_mut(*column, slot) {
                        log.entries.push(Entry { written: *column, slot, number: *number });
                    }
                }
            }
            self.log.0 = Some(log);
        }
    }

    fn ends(&self) -> [usize; 4] {
        KINDS.map(|kind| self.issuer(kind).end())
    }

    const fn issuer(&self, kind: RecordKind) -> &Issuer {
        match kind {
            RecordKind::Vertex => &self.vertices,
            RecordKind::Edge => &self.edges,
            RecordKind::Boundary => &self.boundaries,
            RecordKind::Face => &self.faces,
        }
    }

    const fn issuer_mut(&mut self, kind: RecordKind) -> &mut Issuer {
        match kind {
            RecordKind::Vertex => &mut self.vertices,
            RecordKind::Edge => &mut self.edges,
            RecordKind::Boundary => &mut self.boundaries,
            RecordKind::Face => &mut self.faces,
        }
    }

    /// The link named by an entry, in a slot used before.
    #[inline]
    fn link_mut(&mut self, written: Written, slot: u32) -> Option<&mut u32> {
        let i = slot as usize;
        match written {
            Written::Origin => self.origin.get_mut(i),
            Written::Next => self.next.get_mut(i),
            Written::Prev => self.prev.get_mut(i),
            Written::Boundary => self.boundary.get_mut(i),
            Written::VertexLink => self.vertex_link.get_mut(i),
            Written::BoundaryFace => self.boundary_rows.get_mut(i).map(|row| &mut row.face.0),
            Written::Start => self.boundary_rows.get_mut(i).map(|row| &mut row.start),
            Written::Place => self.boundary_rows.get_mut(i).map(|row| &mut row.place),
            Written::Outer => self.face_rows.get_mut(i).map(|row| &mut row.outer),
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
            Written::Listed => self.inner.pop(&mut self.face_rows[*slot as usize].inner),
            Written::Unlisted => {
                let place = self.boundary_rows[*number as usize].place;
                self.inner.put_back(&mut self.face_rows[*slot as usize].inner, place, BoundarySlot(*number));
            }
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
            Written::Listed => self.inner.push(&mut self.face_rows[*slot as usize].inner, BoundarySlot(*number)),
            Written::Unlisted => {
                let place = self.boundary_rows[*number as usize].place;
                self.inner.swap_remove(&mut self.face_rows[*slot as usize].inner, place);
            }
            _ => {}
        }
    }
}
