//! Erasing edges and vertices.

use super::error::EditError;
use super::outcome::Edited;
use crate::planar_map::PlanarMap;
use twinedge::dcel::{HalfEdge, HalfEdgeKey, RemovedEdge, Room, VertexKey};

impl PlanarMap {
    /// Removes an edge. Its ends stay, isolated if it was their last edge.
    ///
    /// If it separates two faces, they are merged, covered by the features that covered both ([why](super#features)). The face to
    /// the left of `half_edge` is kept, unless the other face surrounds it.
    ///
    /// O(length of the shorter of the two cycles + inner boundary components of the dropped face); for a bridge O(size of the
    /// smaller part). See [`Dcel::remove_edge`](twinedge::dcel::Dcel::remove_edge).
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
    /// let removed = map.remove_edge(ring.way[0])?;
    /// assert_eq!(removed.faces_merged, ring.faces_split);
    /// assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count()), (3, 2));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// [`EditError::NotPlane`]; [`EditError::Operator`] for a stale key or a full map (a bridge leaves a boundary component).
    pub fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<Edited, EditError> {
        self.editable()?;
        let mut edited = Edited::default();
        self.erase(half_edge, &mut edited)?;
        Ok(edited)
    }

    /// Removes a vertex and all its edges. The vertices at their other ends stay.
    ///
    /// The cost of removing each of its edges.
    ///
    /// ```
    /// use twinedge_map::PlanarMap;
    ///
    /// let mut map = PlanarMap::new();
    /// let ring = map.insert_ring([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
    /// let removed = map.remove_vertex(ring.vertices[0])?;
    /// assert_eq!((removed.edges_dropped.len(), removed.faces_merged.len()), (2, 1));
    /// assert_eq!((map.dcel().vertex_count(), map.dcel().edge_count()), (2, 1));
    /// # Ok::<(), twinedge_map::edit::EditError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`remove_edge`](Self::remove_edge).
    pub fn remove_vertex(&mut self, vertex: VertexKey) -> Result<Edited, EditError> {
        self.editable()?;
        let edges: Vec<HalfEdgeKey> = self.dcel.vertex(vertex)?.rotation().map(HalfEdge::key).collect();
        self.dcel.room_for(Room { boundaries: edges.len(), ..Room::NONE })?;
        self.atomically(|map| {
            let mut edited = Edited::default();
            for h in edges {
                map.erase(h, &mut edited)?;
            }
            map.remove_isolated(vertex)?;
            edited.vertices_dropped.push(vertex);
            Ok(edited)
        })
    }

    pub(super) fn erase(&mut self, half_edge: HalfEdgeKey, edited: &mut Edited) -> Result<(), EditError> {
        let h = self.dcel.half_edge(half_edge)?;
        let sides = [h.face(), h.twin().face()].map(|f| (f.key(), self.features.of_face(f.index())));
        let removed = self.disconnect(half_edge)?;
        edited.edges_dropped.push(half_edge);
        if let RemovedEdge::Merged { kept_face, dropped_face, .. } = removed {
            edited.faces_merged.push((kept_face, dropped_face));
            let common = self.features.common(sides[0].1, sides[1].1);
            self.cover_face(self.dcel.face(kept_face)?.index(), common);
            for (face, set) in sides {
                let lost = self.features.differing(set, common);
                edited.features_dropped.extend(self.features.set(lost).map(|feature| (face, feature)));
            }
        }
        Ok(())
    }
}
