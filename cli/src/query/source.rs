//! The map that a question is about.

use crate::output::plain;
use twinedge_map::PlanarMap;
use twinedge_report::Noted;

/// A map, the name of its input, and what was noted of its features.
pub(crate) struct Source {
    pub(crate) input: String,
    pub(crate) map: PlanarMap,
    pub(crate) noted: Noted,
}

impl Source {
    /// The words by which a feature can be asked for by its number, with its id, if it has one.
    pub(super) fn hint(&self, number: usize) -> String {
        match self.noted.ids.get(number).and_then(Option::as_deref) {
            Some(id) => format!("'#{number}' (id {})", plain(id)),
            None => format!("'#{number}'"),
        }
    }
}
