//! One index of the edges and isolated vertices of a map, maintained while the map changes.
//!
//! Edits, location and zones use it where scanning would take long: in a face with a long boundary or many components, or at a
//! vertex of high degree. It is built in O(n log n) when first needed, so it costs nothing for a map that is not edited, or
//! edited only near hints. From then on every operator updates it in O(log n).
//!
//! ```text
//!   tree   boxes of edges and isolated vertices    what is near; what lies in a box; what a segment meets
//!   hubs   per hub, what leaves it by angle        in which corner a segment begins
//!          its edges, in a tree of their own       the same as the tree, for all but what ends at the hub
//! ```

mod hubs;
mod limits;
mod tree;

#[cfg(test)]
mod tests;

use hubs::Hub;
use limits::HUB;
pub(super) use limits::{is_hub, is_small};
use rstar::{PointDistance, SelectionFunction};
use rustc_hash::FxHashMap;
use std::sync::OnceLock;
use tree::RecordTree;
pub(super) use tree::{BoxedRecord, TreeRecord};
use twinedge::dcel::{Boundary, Dcel, HalfEdge, Vertex};
use twinedge_geometry::Point;

/// The trees of a map. Points are given by index of vertex.
#[derive(Clone)]
pub(super) struct RecordIndex {
    tree: RecordTree,
    hubs: FxHashMap<u32, Hub>,
}

/// An edge as stored in the index, used to remove it after it has changed.
#[derive(Clone, Copy)]
pub(super) struct IndexedEdge {
    boxed: BoxedRecord,
    vertices: [usize; 2],
    half_edges: [u32; 2],
}

impl IndexedEdge {
    pub(super) fn new(h: HalfEdge<'_>, points: &[Point]) -> Self {
        let h = if h.index() < h.twin().index() { h } else { h.twin() };
        Self {
            boxed: BoxedRecord::edge(h, points),
            vertices: [h.origin(), h.target()].map(Vertex::index),
            half_edges: [h, h.twin()].map(|h| h.index() as u32),
        }
    }

    pub(super) const fn vertices(&self) -> [usize; 2] {
        self.vertices
    }
}

impl RecordIndex {
    fn new(dcel: &Dcel, points: &[Point]) -> Self {
        let mut of_hubs: FxHashMap<u32, Vec<BoxedRecord>> =
            dcel.vertices().filter(|v| is_hub(*v)).map(|v| (v.index() as u32, Vec::new())).collect();
        let isolated = dcel.boundaries().filter_map(Boundary::isolated_vertex).map(|v| BoxedRecord::vertex(v, points));
        let mut others: Vec<BoxedRecord> = isolated.collect();
        for h in dcel.edges() {
            let hub = [h.origin(), h.target()].map(|v| v.index() as u32).into_iter().find(|v| of_hubs.contains_key(v));
            let list = hub.and_then(|hub| of_hubs.get_mut(&hub)).unwrap_or(&mut others);
            list.push(BoxedRecord::edge(h, points));
        }
        let hub = |(v, edges): (u32, _)| dcel.vertex_at(v as usize).map(|vertex| (v, Hub::new(vertex, points, edges)));
        Self { tree: RecordTree::new(others), hubs: of_hubs.into_iter().filter_map(hub).collect() }
    }

    pub(super) fn add_vertex(&mut self, v: Vertex<'_>, points: &[Point]) {
        self.tree.insert(BoxedRecord::vertex(v, points));
    }

    pub(super) fn remove_vertex(&mut self, vertex: usize, p: Point) {
        self.tree.remove(&BoxedRecord { record: TreeRecord::Vertex(vertex as u32), ends: [p; 2] });
    }

    pub(super) fn add_edge(&mut self, h: HalfEdge<'_>, points: &[Point]) {
        let mut into = None;
        for h in [h, h.twin()] {
            let v = h.origin();
            if let Some(hub) = self.hubs.get_mut(&(v.index() as u32)) {
                hub.add(h.index() as u32, points[h.target().index()]);
            } else if is_hub(v) {
                // Edges in the tree of another hub stay there.
                let edges = v.rotation().map(|h| BoxedRecord::edge(h, points)).filter(|edge| self.tree.remove(edge));
                let edges = edges.collect();
                self.hubs.insert(v.index() as u32, Hub::new(v, points, edges));
            } else {
                continue;
            }
            into = into.or(Some(v.index() as u32));
        }
        let hub = into.and_then(|hub| self.hubs.get_mut(&hub));
        hub.map_or(&mut self.tree, |hub| &mut hub.tree).insert(BoxedRecord::edge(h, points));
    }

    pub(super) fn remove_edge(&mut self, edge: &IndexedEdge) {
        let mut found = false;
        let [a, b] = edge.boxed.ends;
        for ((vertex, half_edge), head) in edge.vertices.into_iter().zip(edge.half_edges).zip([b, a]) {
            let Some(hub) = self.hubs.get_mut(&(vertex as u32)) else { continue };
            found = found || hub.tree.remove(&edge.boxed);
            if hub.remove(half_edge, head) < HUB / 2 {
                let gone = self.hubs.remove(&(vertex as u32));
                gone.iter().flat_map(|hub| hub.tree.iter()).for_each(|record| self.tree.insert(*record));
            }
        }
        if !found {
            self.tree.remove(&edge.boxed);
        }
    }

    /// Returns the index of the half-edge of a hub towards a point, or before that direction; `None` if the vertex is not a hub.
    pub(super) fn towards(&self, v: Vertex<'_>, p: Point) -> Option<usize> {
        self.hubs.get(&(v.index() as u32))?.towards(p)
    }

    /// Returns the index of the hub at a point, if there is one. O(hubs).
    pub(super) fn hub_at(&self, p: Point) -> Option<usize> {
        self.hubs.iter().find(|(_, hub)| hub.centre == p).map(|(v, _)| *v as usize)
    }

    fn trees(&self, but_hubs_at: [Option<Point>; 2]) -> impl Iterator<Item = &RecordTree> {
        let hubs = self.hubs.values().filter(move |hub| !but_hubs_at.contains(&Some(hub.centre)));
        core::iter::once(&self.tree).chain(hubs.map(|hub| &hub.tree))
    }

    /// Returns the records whose boxes match a selection. Hubs at certain points may be left out.
    pub(super) fn select<'a>(
        &'a self,
        selection: impl SelectionFunction<BoxedRecord> + Clone + 'a,
        but_hubs_at: [Option<Point>; 2],
    ) -> impl Iterator<Item = &'a BoxedRecord> {
        self.trees(but_hubs_at).flat_map(move |tree| tree.select(selection.clone()))
    }

    pub(super) fn in_box(&self, low: Point, high: Point) -> impl Iterator<Item = &BoxedRecord> {
        self.trees([None; 2]).flat_map(move |tree| tree.in_box(low, high))
    }

    /// Returns a record near a point, or `None` if there are no records.
    pub(super) fn near(&self, p: Point) -> Option<&BoxedRecord> {
        let distance = |record: &&BoxedRecord| record.distance_2(&p.into());
        self.trees([None; 2]).filter_map(|tree| tree.near(p)).min_by(|a, b| distance(a).total_cmp(&distance(b)))
    }
}

/// The index of a map, once needed. Clones copy it.
#[derive(Clone, Default)]
pub(super) struct KeptIndex(OnceLock<Box<RecordIndex>>);

/// Leaves out the contents, so that a map looks the same with and without an index.
impl core::fmt::Debug for KeptIndex {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str("KeptIndex")
    }
}

impl KeptIndex {
    /// Returns the index, building it in O(n log n) if necessary.
    pub(super) fn get(&self, dcel: &Dcel, points: &[Point]) -> &RecordIndex {
        self.0.get_or_init(|| Box::new(RecordIndex::new(dcel, points)))
    }

    pub(super) fn if_built(&mut self) -> Option<&mut RecordIndex> {
        self.0.get_mut().map(|index| &mut **index)
    }
}
