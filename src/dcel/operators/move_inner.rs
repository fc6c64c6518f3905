//! Moves a hole, an island or an isolated vertex to another face.

use crate::dcel::error::{OperatorError, StaleKey};
use crate::dcel::structure::Dcel;
use crate::store::{BoundaryKey, BoundaryStart, FaceKey};

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
    /// use twinedge::dcel::{Dcel, OperatorError, Split};
    ///
    /// let mut map = Dcel::new();
    /// let outside = map.unbounded_face().key();
    /// // A triangle: a loop with two more vertices on it. Its face lies to the left of h.
    /// let v = map.add_isolated_vertex(outside)?.vertex;
    /// let h = map.connect(v, v, Split::default())?.half_edge;
    /// map.split_edge(h)?;
    /// map.split_edge(h)?;
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
        let b = self.store.find_boundary(boundary).ok_or(StaleKey::Boundary(boundary))?;
        let f = self.face_slot(face)?;
        if self.is_outer(b) {
            return Err(OperatorError::IsOuter(boundary));
        }
        let old = self.store.face(b);
        if old == f {
            return Ok(face);
        }
        let encloses_nothing = matches!(self.store.start(b), BoundaryStart::Vertex(_));
        if !encloses_nothing && f != self.store.unbounded() && self.encloses(b, f) {
            return Err(OperatorError::InsideItself(boundary, face));
        }
        self.store.unlist(b);
        self.store.list_inner(f, b);
        Ok(self.store.face_key(old))
    }
}
