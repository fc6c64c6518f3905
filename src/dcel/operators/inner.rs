//! Adds and removes isolated vertices, and moves inner boundary components between faces.

use crate::dcel::access::{OperatorError, StaleKey};
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryKey, BoundaryStart, FaceKey, Room, VertexKey, VertexLink};

/// The records made by [`Dcel::add_isolated_vertex`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AddedVertex {
    /// The vertex.
    pub vertex: VertexKey,
    /// Its boundary component.
    pub boundary: BoundaryKey,
}

/// The record dropped by [`Dcel::remove_isolated_vertex`], and the face of the vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct RemovedVertex {
    /// The boundary component of the vertex.
    pub boundary: BoundaryKey,
    /// The face that contained it.
    pub face: FaceKey,
}

impl Dcel {
    /// Adds an isolated vertex in a face, as a new inner boundary component. O(1).
    ///
    #[doc = include_str!("../pictures/add_isolated_vertex.svg")]
    ///
    /// Inverse: [`Dcel::remove_isolated_vertex`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::Full`].
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// let added = map.add_isolated_vertex(outside)?;
    /// assert_eq!(map.vertex(added.vertex)?.isolated().map(|b| b.key()), Some(added.boundary));
    /// assert_eq!(map.unbounded_face().inner_count(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "MVFS")]
    pub fn add_isolated_vertex(&mut self, face: FaceKey) -> Result<AddedVertex, OperatorError> {
        let f = self.face_slot(face)?;
        self.room_for(Room { vertices: 1, boundaries: 1, ..Room::NONE })?;
        self.follow(Self::steps_to_add_vertex)?;
        let (v, b) = self.store.add_isolated(f);
        Ok(AddedVertex { vertex: self.store.vertex_key(v), boundary: self.store.boundary_key(b) })
    }

    /// Removes an isolated vertex. O(1).
    ///
    #[doc = include_str!("../pictures/remove_isolated_vertex.svg")]
    ///
    /// Inverse: [`Dcel::add_isolated_vertex`].
    ///
    /// # Errors
    /// A stale key; [`OperatorError::NotIsolated`] if half-edges leave the vertex.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// let added = map.add_isolated_vertex(outside)?;
    /// let removed = map.remove_isolated_vertex(added.vertex)?;
    /// assert_eq!((removed.boundary, removed.face), (added.boundary, outside));
    /// assert!(map.vertex(added.vertex).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "KVFS")]
    pub fn remove_isolated_vertex(&mut self, vertex: VertexKey) -> Result<RemovedVertex, OperatorError> {
        let v = self.vertex_slot(vertex)?;
        let VertexLink::Isolated(b) = self.store.vertex_link(v) else { return Err(OperatorError::NotIsolated(vertex)) };
        let removed =
            RemovedVertex { boundary: self.store.boundary_key(b), face: self.store.face_key(self.store.face(b)) };
        self.follow(move |dcel| dcel.steps_to_remove_vertex(v))?;
        self.store.unlist(b);
        self.store.remove_boundary(b);
        self.store.remove_vertex(v);
        Ok(removed)
    }
}

impl Dcel {
    /// Moves an inner boundary component to another face, with its component and everything inside.
    ///
    #[doc = include_str!("../pictures/move_inner.svg")]
    ///
    /// O(1) for an isolated vertex, and if `face` is the unbounded face. Otherwise O(size of the moved part), to check that
    /// `face` does not lie inside it.
    ///
    /// Returns the previous face. Inverse: moving the component back.
    ///
    /// # Errors
    /// A stale key; [`OperatorError::IsOuter`]; [`OperatorError::InsideItself`] if `face` lies inside the moved part.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, OperatorError};
    ///
    /// let (mut map, keys) = Dcel::from_faces(3, [[0, 1, 2]])?;
    /// let h = keys.half_edge(0).unwrap();
    /// let outside = map.unbounded_face().key();
    /// let island = map.add_isolated_vertex(outside)?.boundary;
    /// let triangle = map.half_edge(h)?.face().key();
    /// assert_eq!(map.move_inner(island, triangle)?, outside);
    /// assert_eq!(map.boundary(island)?.face().key(), triangle);
    /// // The triangle's own outside cannot go into the triangle.
    /// let around = map.half_edge(h)?.twin().boundary().key();
    /// assert_eq!(map.move_inner(around, triangle), Err(OperatorError::InsideItself(around, triangle)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "RINGMV")]
    pub fn move_inner(&mut self, boundary: BoundaryKey, face: FaceKey) -> Result<FaceKey, OperatorError> {
        let moved = self.store.find_boundary(boundary).ok_or(StaleKey::Boundary(boundary))?;
        let f = self.face_slot(face)?;
        if self.is_outer(moved) {
            return Err(OperatorError::IsOuter(boundary));
        }
        let old = self.store.face(moved);
        if old == f {
            return Ok(face);
        }
        let encloses_nothing = matches!(self.store.start(moved), BoundaryStart::Vertex(_));
        if !encloses_nothing && f != self.store.unbounded() && self.encloses(moved, f) {
            return Err(OperatorError::InsideItself(boundary, face));
        }
        self.store.unlist(moved);
        self.store.list_inner(f, moved);
        Ok(self.store.face_key(old))
    }
}
