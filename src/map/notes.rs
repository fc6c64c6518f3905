//! Notes of the records that edits write, for a map that is audited.

use crate::validate::near::WriteSet;

/// The records that edits have written, if they are to note that. A clone of the map goes on without.
#[derive(Default)]
pub(super) struct Notes(pub(super) Option<Box<WriteSet>>);

impl Clone for Notes {
    fn clone(&self) -> Self {
        Self::default()
    }
}
