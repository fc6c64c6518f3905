//! The structure of this crate as a subject, over every store.

use super::subject::{Refusal, Subject};
use crate::dcel::{
    Boundary, BoundaryKey, Corner, Dcel, FaceKey, HalfEdgeKey, OperatorError, RemovedEdge, Side, Split, Turn, VertexKey,
};
use crate::store::Store;
use alloc::vec::Vec;

/// The boundary component on which a corner lies.
pub(super) fn boundary_of<S: Store>(dcel: &Dcel<S>, corner: Corner) -> Result<Boundary<'_, S>, OperatorError> {
    match corner {
        Corner::At(h) => Ok(dcel.half_edge(h)?.boundary()),
        Corner::Isolated(v) => dcel.vertex(v)?.isolated().ok_or(OperatorError::NotIsolated(v)),
    }
}

impl<S: Store> Subject for Dcel<S> {
    type Vertex = VertexKey;
    type HalfEdge = HalfEdgeKey;
    type Face = FaceKey;
    type Error = OperatorError;

    fn refusal(error: &OperatorError) -> Refusal {
        match error {
            OperatorError::Stale(_) => Refusal::Stale,
            OperatorError::Full(_) => Refusal::Full,
            OperatorError::NotIsolated(_) => Refusal::NotIsolated,
            OperatorError::FacesDiffer(..) => Refusal::FacesDiffer,
            OperatorError::VerticesDiffer(..) => Refusal::VerticesDiffer,
            OperatorError::NotInner(_) => Refusal::NotInner,
            OperatorError::IsOuter(_) => Refusal::IsOuter,
            OperatorError::DegreeNotTwo(_) => Refusal::DegreeNotTwo,
            OperatorError::Loop(_) => Refusal::Loop,
            OperatorError::NotSeparating(_) => Refusal::NotSeparating,
            OperatorError::InsideItself(..) => Refusal::InsideItself,
        }
    }

    fn unbounded_face(&self) -> FaceKey {
        self.unbounded_face().key()
    }

    fn face_of(&self, corner: Corner) -> Result<FaceKey, OperatorError> {
        Ok(boundary_of(self, corner)?.face().key())
    }

    fn origin_of(&self, half_edge: HalfEdgeKey) -> Result<VertexKey, OperatorError> {
        Ok(self.half_edge(half_edge)?.origin().key())
    }

    fn twin_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, OperatorError> {
        Ok(self.half_edge(half_edge)?.twin().key())
    }

    fn next_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, OperatorError> {
        Ok(self.half_edge(half_edge)?.next().key())
    }

    fn add_isolated_vertex(&mut self, face: FaceKey) -> Result<VertexKey, OperatorError> {
        Ok(self.add_isolated_vertex(face)?.vertex)
    }

    fn remove_isolated_vertex(&mut self, vertex: VertexKey) -> Result<(), OperatorError> {
        self.remove_isolated_vertex(vertex).map(drop)
    }

    fn connect(
        &mut self,
        from: Corner,
        to: Corner,
        new_face: Side,
        inner: &[Corner],
    ) -> Result<HalfEdgeKey, OperatorError> {
        boundary_of(self, from)?;
        boundary_of(self, to)?;
        let inner: Vec<BoundaryKey> =
            inner.iter().map(|corner| Ok(boundary_of(self, *corner)?.key())).collect::<Result<_, OperatorError>>()?;
        Ok(self.connect(from, to, Split { new_face, inner: &inner })?.half_edge)
    }

    fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<Option<FaceKey>, OperatorError> {
        match self.remove_edge(half_edge)? {
            RemovedEdge::Merged { dropped_face, .. } => Ok(Some(dropped_face)),
            RemovedEdge::Parted { .. } => Ok(None),
        }
    }

    fn split_edge(&mut self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, OperatorError> {
        Ok(self.split_edge(half_edge)?.half_edge)
    }

    fn join_edges(&mut self, half_edge: HalfEdgeKey) -> Result<(), OperatorError> {
        self.join_edges(half_edge).map(drop)
    }

    fn split_vertex(&mut self, from: Corner, to: Corner) -> Result<HalfEdgeKey, OperatorError> {
        Ok(self.split_vertex(from, to)?.half_edge)
    }

    fn contract_edge(&mut self, half_edge: HalfEdgeKey) -> Result<VertexKey, OperatorError> {
        Ok(self.contract_edge(half_edge)?.dropped)
    }

    fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), OperatorError> {
        self.flip_edge(half_edge, turn)
    }

    fn move_inner(&mut self, inner: Corner, face: FaceKey) -> Result<(), OperatorError> {
        let boundary = boundary_of(self, inner)?.key();
        self.move_inner(boundary, face).map(drop)
    }
}
