//! The topological operators on a map: each also updates the points and the index. Edits change a map only through these.

use super::error::EditError;
use crate::feature_sets::put;
use crate::feature_tries::SetId;
use crate::index::IndexedEdge;
use crate::notes::MapEntry;
use crate::planar_map::PlanarMap;
use twinedge::dcel::{
    Connected, Corner, FaceKey, HalfEdge, HalfEdgeKey, OperatorError, RemovedEdge, Split, SplitEdge, VertexKey,
};
use twinedge_geometry::Point;

impl PlanarMap {
    pub(super) fn add_isolated(&mut self, p: Point, face: FaceKey) -> Result<VertexKey, OperatorError> {
        let key = self.dcel.add_isolated_vertex(face)?.vertex;
        self.set_point(self.dcel.vertex(key)?.index(), p);
        let v = self.dcel.vertex(key)?;
        if let Some(index) = self.index.if_built() {
            index.add_vertex(v, &self.points);
        }
        Ok(key)
    }

    pub(super) fn remove_isolated(&mut self, vertex: VertexKey) -> Result<(), OperatorError> {
        let v = self.dcel.vertex(vertex)?.index();
        self.dcel.remove_isolated_vertex(vertex)?;
        if let Some(index) = self.index.if_built() {
            index.remove_vertex(v, self.points[v]);
        }
        Ok(())
    }

    pub(super) fn split_at(&mut self, h: HalfEdgeKey, p: Point) -> Result<SplitEdge, OperatorError> {
        let before = self.indexed(h)?;
        let made = self.dcel.split_edge(h)?;
        self.set_point(self.dcel.vertex(made.vertex)?.index(), p);
        self.measure_split_edge(h, made)?;
        if let (Some(index), Some(before)) = (self.index.if_built(), before) {
            index.remove_edge(&before);
            for part in [h, made.half_edge] {
                index.add_edge(self.dcel.half_edge(part)?, &self.points);
            }
        }
        Ok(made)
    }

    /// Draws an edge between two corners that see each other.
    pub(super) fn connect(&mut self, from: Corner, to: Corner, split: Split<'_>) -> Result<Connected, OperatorError> {
        let connected = self.dcel.connect(from, to, split)?;
        self.measure_connected(connected)?;
        if let Some(index) = self.index.if_built() {
            for corner in [from, to] {
                if let Corner::Isolated(v) = corner {
                    let v = self.dcel.vertex(v)?.index();
                    index.remove_vertex(v, self.points[v]);
                }
            }
            index.add_edge(self.dcel.half_edge(connected.half_edge)?, &self.points);
        }
        Ok(connected)
    }

    pub(super) fn disconnect(&mut self, h: HalfEdgeKey) -> Result<RemovedEdge, OperatorError> {
        let before = self.indexed(h)?;
        self.measure_beside(h)?;
        let removed = self.dcel.remove_edge(h)?;
        if let (Some(index), Some(before)) = (self.index.if_built(), before) {
            index.remove_edge(&before);
            let ends = before.vertices().into_iter().filter_map(|v| self.dcel.vertex_at(v));
            ends.filter(|v| v.isolated().is_some()).for_each(|v| index.add_vertex(v, &self.points));
        }
        Ok(removed)
    }

    /// Joins the edge of a half-edge with the edge of its next. Returns the key of `next`, which is stale afterwards.
    pub(super) fn join_at(&mut self, h: HalfEdgeKey, next: HalfEdgeKey) -> Result<HalfEdgeKey, OperatorError> {
        let before = [self.indexed(h)?, self.indexed(next)?];
        let joined = self.dcel.join_edges(h)?;
        if let Some(index) = self.index.if_built() {
            before.iter().flatten().for_each(|edge| index.remove_edge(edge));
            index.add_edge(self.dcel.half_edge(h)?, &self.points);
        }
        Ok(joined.half_edge)
    }

    /// Moves a vertex with its edges. O(degree).
    pub(super) fn put_at(&mut self, vertex: VertexKey, to: Point) -> Result<(), EditError> {
        let v = self.dcel.vertex(vertex)?;
        let from = self.points[v.index()];
        self.notes.write(|| MapEntry::Point(v.index() as u32, from));
        self.points[v.index()] = to;
        let Some(index) = self.index.if_built() else { return Ok(()) };
        if v.isolated().is_some() {
            index.remove_vertex(v.index(), from);
            index.add_vertex(v, &self.points);
        }
        let edges: Vec<HalfEdge<'_>> = v.rotation().collect();
        self.points[v.index()] = from;
        for h in &edges {
            index.remove_edge(&IndexedEdge::new(*h, &self.points));
        }
        self.points[v.index()] = to;
        for h in edges {
            index.add_edge(h, &self.points);
        }
        Ok(())
    }

    fn set_point(&mut self, vertex: usize, p: Point) {
        let from = self.points.get(vertex).copied().unwrap_or_default();
        self.notes.write(|| MapEntry::Point(vertex as u32, from));
        put(&mut self.points, vertex, p);
    }

    /// Sets the features that cover a face, by its index.
    pub(crate) fn cover_face(&mut self, face: usize, set: SetId) {
        self.notes.write(|| MapEntry::OfFace(face as u32, self.features.of_face(face)));
        self.features.put_face(face, set);
    }

    /// Sets the features along an edge, by the index of either half-edge.
    pub(crate) fn cover_edge(&mut self, half_edge: usize, set: SetId) {
        self.notes.write(|| MapEntry::Along(half_edge as u32, self.features.along(half_edge)));
        self.features.put_along(half_edge, set);
    }

    /// Returns the edge's entry in the index, if the index exists.
    fn indexed(&mut self, h: HalfEdgeKey) -> Result<Option<IndexedEdge>, OperatorError> {
        let h = self.dcel.half_edge(h)?;
        Ok(self.index.if_built().map(|_| IndexedEdge::new(h, &self.points)))
    }
}
