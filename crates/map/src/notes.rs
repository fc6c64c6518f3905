//! The log of what edits overwrite beside the links of the structure: points, features and their names, values.

use super::feature_tries::SetId;
use twinedge::dcel::extend::Saved;
use twinedge_geometry::Point;

/// The entries that the change that is being made has logged, if the log is on. A clone of the map goes on without.
#[derive(Default)]
pub(super) struct Notes(Option<Vec<MapEntry>>);

impl Notes {
    /// Notes something that is about to be overwritten, if it is to.
    pub(super) fn write(&mut self, entry: impl FnOnce() -> MapEntry) {
        if let Some(entries) = &mut self.0 {
            entries.push(entry());
        }
    }

    /// Notes from now on, and forgets earlier entries.
    pub(super) fn begin(&mut self) {
        self.0 = Some(Vec::new());
    }

    /// Notes nothing any more.
    pub(super) fn end(&mut self) {
        self.0 = None;
    }

    /// The number of entries.
    pub(super) fn len(&self) -> usize {
        self.0.as_ref().map_or(0, Vec::len)
    }

    /// Takes the entries off but for the first.
    pub(super) fn split_off(&mut self, first: usize) -> Vec<MapEntry> {
        self.0.as_mut().map(|entries| entries.split_off(first)).unwrap_or_default()
    }
}

impl Clone for Notes {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// Something of a map, other than a link, that was overwritten: its index, and what is not there.
#[derive(Clone, Debug)]
pub enum MapEntry {
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

impl MapEntry {
    /// The vertex whose point it is.
    pub(super) const fn vertex(&self) -> Option<usize> {
        if let Self::Point(v, _) = self { Some(*v as usize) } else { None }
    }
}
