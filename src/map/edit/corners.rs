//! Drawing an edge between two corners that are known to see each other.

use super::error::EditError;
use crate::dcel::{Corner, HalfEdgeKey, Split};
use crate::map::feature_tries::SetId;
use crate::map::planar_map::PlanarMap;
use crate::store::Room;

impl PlanarMap {
    /// Checks that there is room for so many edges between existing vertices.
    pub(crate) fn room_for_edges(&self, edges: usize) -> Result<(), EditError> {
        self.editable()?;
        Ok(self.dcel.room_for(Room { edges, boundaries: edges, faces: edges, vertices: 0 })?)
    }

    /// Draws the straight edge between two corners of a face. The caller knows that it meets nothing else, and that the face
    /// has no other boundary component if both corners are on the same one.
    ///
    /// O(length of the shorter of the two cycles).
    pub(crate) fn connect_corners(&mut self, from: Corner, to: Corner) -> Result<HalfEdgeKey, EditError> {
        let connected = self.connect(from, to, Split::default())?;
        let h = self.dcel.half_edge(connected.half_edge)?;
        let (index, kept) = (h.index(), h.twin().face().index());
        // A slot may have been that of another edge or face.
        self.cover_edge(index, SetId::default());
        if let Some(made) = connected.new_face() {
            let made = self.dcel.face(made)?.index();
            self.cover_face(made, self.features.of_face(kept));
        }
        Ok(connected.half_edge)
    }
}
