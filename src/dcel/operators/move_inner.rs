//! Moving a hole, or an island, or an isolated vertex, to another face.

use crate::dcel::error::{OperatorError, StaleKey};
use crate::dcel::structure::Dcel;
use crate::store::Store;
use crate::store::links::BoundaryStart;
use crate::store::{BoundaryKey, FaceKey};

impl<S: Store> Dcel<S> {
    /// Moves an inner boundary component, and with it its component and all that lies inside, to another face.
    ///
    /// ```text
    ///   ┌─────┬─────┐      ┌─────┬─────┐
    ///   │ ┌─┐ │     │      │     │ ┌─┐ │
    ///   │ └─┘ │  f  │  ──► │     │ └─┘ │
    ///   └─────┴─────┘      └─────┴─────┘
    /// ```
    ///
    /// The move itself is O(1), and it is all for an isolated vertex or where `face` is the unbounded one. Else what moves
    /// is searched for `face`, which must not lie in it: O(size of what moves).
    ///
    /// Gives the face where it was. Inverse: moving it back there.
    ///
    /// # Errors
    /// A stale key; [`OperatorError::IsOuter`]; [`OperatorError::InsideItself`] if `face` lies inside what would be moved.
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
