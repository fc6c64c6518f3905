//! The boxes around the edges and isolated vertices of a map, in an R-tree.

use super::planar_map::PlanarMap;
use crate::dcel::Vertex;
use crate::geometry::Point;
use crate::validate::Embedding;
use rstar::{AABB, RTree, RTreeObject, SelectionFunction};

/// Edges and isolated vertices by the boxes around them.
pub(super) struct RecordTree {
    tree: RTree<BoxedRecord>,
}

/// An edge, by the index of one of its half-edges, or an isolated vertex, by its own.
#[derive(Clone, Copy)]
pub(super) enum TreeRecord {
    Edge(u32),
    Vertex(u32),
}

/// With its ends, so that the map need be asked only about what is met.
pub(super) struct BoxedRecord {
    pub(super) record: TreeRecord,
    pub(super) ends: [Point; 2],
}

impl RTreeObject for BoxedRecord {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        let [a, b] = self.ends.map(<[f64; 2]>::from);
        AABB::from_corners(a, b)
    }
}

impl RecordTree {
    /// O(n log n).
    pub(super) fn new(map: &PlanarMap) -> Self {
        let place = |v: Vertex<'_>| map.point(v.index());
        let edges = map.dcel().edges().map(|h| BoxedRecord {
            record: TreeRecord::Edge(h.index() as u32),
            ends: [place(h.origin()), place(h.target())],
        });
        let isolated = map
            .dcel()
            .boundaries()
            .filter_map(|b| b.isolated_vertex())
            .map(|v| BoxedRecord { record: TreeRecord::Vertex(v.index() as u32), ends: [place(v); 2] });
        Self { tree: RTree::bulk_load(edges.chain(isolated).collect()) }
    }

    /// The records whose boxes a selection takes.
    pub(super) fn select(&self, selection: impl SelectionFunction<BoxedRecord>) -> impl Iterator<Item = &BoxedRecord> {
        self.tree.locate_with_selection_function(selection)
    }
}
