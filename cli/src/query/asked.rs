//! The map that a question is about.

use twinedge::map::PlanarMap;

/// A map and the name of its input.
pub(super) struct Asked {
    pub(super) input: String,
    pub(super) map: PlanarMap,
}
