//! The small maps of the census, as tables.

use twinedge::validate::Table;
use twinedge_trials::census::{Census, Scope};

/// Every map with at most this many edges and vertices.
pub(crate) fn small_maps(edges: usize, vertices: usize) -> impl Iterator<Item = Table> {
    Census::new(Scope::Subdivisions { edges, vertices }).map(|map| Table::copy_of(map.runner.subject()).unwrap())
}
