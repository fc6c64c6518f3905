//! Drawing an edge between two corners that are known to see each other.

use super::error::EditError;
use crate::feature_tries::SetId;
use crate::planar_map::PlanarMap;
use twinedge::dcel::{Corner, HalfEdgeKey, Room, Split};

impl PlanarMap {
    /// Checks that the map can be edited and has room for this number of edges between existing vertices. O(1).
    ///
    /// # Errors
    /// The map is not plane or is full.
    pub fn room_for_edges(&self, edges: usize) -> Result<(), EditError> {
        self.editable()?;
        Ok(self.dcel.room_for(Room { edges, boundaries: edges, faces: edges, vertices: 0 })?)
    }

    /// Draws the straight edge between two corners of a face that are known to see each other: the edge meets nothing else, and
    /// if both corners are on one boundary component, it is the only one of the face. None of this is checked, so a diagonal
    /// needs no search. [`insert_segment`](Self::insert_segment) draws any segment.
    ///
    /// O(length of the shorter of the two cycles).
    ///
    /// # Errors
    /// The errors of [`Dcel::connect`](twinedge::dcel::Dcel::connect).
    pub fn connect_corners(&mut self, from: Corner, to: Corner) -> Result<HalfEdgeKey, EditError> {
        let connected = self.connect(from, to, Split::default())?;
        let h = self.dcel.half_edge(connected.half_edge)?;
        let (index, kept) = (h.index(), h.twin().face().index());
        // The slot may have belonged to another edge or face.
        self.cover_edge(index, SetId::default());
        if let Some(made) = connected.new_face() {
            let made = self.dcel.face(made)?.index();
            self.cover_face(made, self.features.of_face(kept));
        }
        Ok(connected.half_edge)
    }
}
