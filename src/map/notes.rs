//! The records that edits write, noted for a map that is audited.

use crate::validate::near::Touched;

/// The records that edits have written, if they are to note that. A clone of the map goes on without.
#[derive(Default)]
pub(super) struct Notes(pub(super) Option<Box<Touched>>);

impl Clone for Notes {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// Leaves out what is in it, so that a map looks the same with and without.
impl core::fmt::Debug for Notes {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("Notes")
    }
}
