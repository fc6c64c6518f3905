//! Notes of what edits write, for a map that is audited or has a history.

use super::feature_tries::SetId;
use crate::geometry::Point;
use crate::store::Journal;
use crate::store::attributes::Saved;
use crate::validate::near::WriteSet;

/// The notes that edits take. A clone of the map goes on without.
#[derive(Default)]
pub(super) struct Notes {
    /// The records that were written.
    pub(super) written: Option<Box<WriteSet>>,
    /// Values that were overwritten. A map has one or the other, or neither.
    pub(super) journal: Option<Box<MapJournal>>,
}

impl Notes {
    /// Notes something that is about to be overwritten, if it is to.
    pub(super) fn write(&mut self, entry: impl FnOnce() -> MapEntry) {
        if let Some(journal) = &mut self.journal {
            journal.entries.push(entry());
        }
    }

    /// Notes that a vertex is about to lie elsewhere.
    pub(super) fn write_point(&mut self, vertex: usize, from: Point) {
        if let Some(written) = &mut self.written {
            written.vertices.push(vertex);
        }
        self.write(|| MapEntry::Point(vertex as u32, from));
    }
}

impl Clone for Notes {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// Values that the change that is being made has overwritten.
#[derive(Clone, Debug, Default)]
pub(super) struct MapJournal {
    pub(super) links: Journal,
    pub(super) entries: Vec<MapEntry>,
}

/// Something of a map, other than a link, that was overwritten: its index, and what is not there.
#[derive(Clone, Debug)]
pub(crate) enum MapEntry {
    /// The point of a vertex.
    Point(u32, Point),
    /// The set of features of a face.
    OfFace(u32, SetId),
    /// The set of features along an edge, by either half-edge.
    Along(u32, SetId),
    /// The last feature, with the name that it has when it is there again.
    Feature(Option<Box<str>>),
    /// The name of a feature that is removed.
    Name(u32, Option<Box<str>>),
    /// The value of an attribute.
    Value(Saved),
}
