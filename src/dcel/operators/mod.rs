//! The operators. Each checks everything first and changes nothing until no check is left to fail.

mod connect;
mod corner;
mod flip;
mod isolated;
mod move_inner;
mod remove;
mod split_edge;
mod split_vertex;
mod walk;

pub use connect::{Connected, Connection, Side, Split};
pub use corner::Corner;
pub use flip::Turn;
pub use isolated::{AddedVertex, RemovedVertex};
pub use remove::RemovedEdge;
pub use split_edge::{JoinedEdges, SplitEdge};
pub use split_vertex::{ContractedEdge, SplitVertex};

use super::{Dcel, FaceKey, HalfEdgeKey, OperatorError, StaleKey, VertexKey};
use crate::store::Store;
use crate::store::links::Need;
use crate::store::place::OUTER;

impl<S: Store> Dcel<S> {
    fn vertex_slot(&self, key: VertexKey) -> Result<S::Vertex, OperatorError> {
        self.store.find_vertex(key).ok_or(OperatorError::Stale(StaleKey::Vertex(key)))
    }

    fn half_edge_slot(&self, key: HalfEdgeKey) -> Result<S::HalfEdge, OperatorError> {
        self.store.find_half_edge(key).ok_or(OperatorError::Stale(StaleKey::HalfEdge(key)))
    }

    fn face_slot(&self, key: FaceKey) -> Result<S::Face, OperatorError> {
        self.store.find_face(key).ok_or(OperatorError::Stale(StaleKey::Face(key)))
    }

    pub(crate) fn room_for(&self, need: Need) -> Result<(), OperatorError> {
        self.store.room_for(need).map_err(OperatorError::Full)
    }

    /// Whether `b` is the outer boundary component of its face.
    fn is_outer(&self, b: S::Boundary) -> bool {
        self.store.place(b) == OUTER
    }

    /// Lists `b` in `f` as the outer or as an inner boundary component.
    fn list(&mut self, f: S::Face, b: S::Boundary, outer: bool) {
        if outer {
            self.store.list_outer(f, b);
        } else {
            self.store.list_inner(f, b);
        }
    }
}
