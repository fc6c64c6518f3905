//! The map that a question is about.

use twinedge::map::PlanarMap;

/// A map and the name of its input.
pub(crate) struct Asked {
    pub(crate) input: String,
    pub(crate) map: PlanarMap,
}
