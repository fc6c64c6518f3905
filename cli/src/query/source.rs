//! The map in question.

use crate::output::plain;
use twinedge_map::PlanarMap;
use twinedge_report::Noted;

/// A map, the name of its input, and the notes on its features.
pub(crate) struct Source {
    pub(crate) input: String,
    pub(crate) map: PlanarMap,
    pub(crate) noted: Noted,
}

impl Source {
    /// Describes how to select a feature by its number, with its id, if it has one.
    pub(super) fn hint(&self, number: usize) -> String {
        match self.noted.ids.get(number).and_then(Option::as_deref) {
            Some(id) => format!("'#{number}' (id {})", plain(id)),
            None => format!("'#{number}'"),
        }
    }
}
