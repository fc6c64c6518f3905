//! The log of all data that edits overwrite apart from links: points, features and their names, values.

use super::feature_tries::SetId;
use twinedge::dcel::extend::Saved;
use twinedge_geometry::Point;

/// The log entries of the current change, if the log is on. A clone of the map has no log.
#[derive(Default)]
pub(super) struct Notes(Option<Vec<MapEntry>>);

impl Notes {
    /// Logs a value that is about to be overwritten, if the log is on.
    pub(super) fn write(&mut self, entry: impl FnOnce() -> MapEntry) {
        if let Some(entries) = &mut self.0 {
            entries.push(entry());
        }
    }

    pub(super) fn begin(&mut self) {
        self.0 = Some(Vec::new());
    }

    pub(super) fn end(&mut self) {
        self.0 = None;
    }

    pub(super) fn len(&self) -> usize {
        self.0.as_ref().map_or(0, Vec::len)
    }

    /// Removes and returns all entries but the first ones.
    pub(super) fn split_off(&mut self, first: usize) -> Vec<MapEntry> {
        self.0.as_mut().map(|entries| entries.split_off(first)).unwrap_or_default()
    }
}

impl Clone for Notes {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// An overwritten value of a map, other than a link: its index and the value to exchange.
#[derive(Clone, Debug)]
pub enum MapEntry {
    /// The point of a vertex.
    Point(u32, Point),
    /// The set of features of a face.
    OfFace(u32, SetId),
    /// The set of features along an edge, by either half-edge.
    Along(u32, SetId),
    /// The last feature, with its name once it has been removed.
    Feature(Option<Box<str>>),
    /// The name of a feature that is removed.
    Name(u32, Option<Box<str>>),
    /// The value of an attribute.
    Value(Saved),
}

impl MapEntry {
    pub(super) const fn vertex(&self) -> Option<usize> {
        if let Self::Point(v, _) = self { Some(*v as usize) } else { None }
    }
}
