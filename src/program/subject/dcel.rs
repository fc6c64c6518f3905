//! The structure of this crate as a subject.

use super::{Refusal, Subject};
use crate::dcel::{
    Boundary, BoundaryKey, Corner, Dcel, FaceKey, HalfEdgeKey, OperatorError, RemovedEdge, Side, Split, Turn, VertexKey,
};
use alloc::vec::Vec;

/// The boundary component on which a corner lies.
fn boundary_of(dcel: &Dcel, corner: Corner) -> Result<Boundary<'_>, OperatorError> {
    match corner {
        Corner::At(h) => Ok(dcel.half_edge(h)?.boundary()),
        Corner::Isolated(v) => dcel.vertex(v)?.isolated().ok_or(OperatorError::NotIsolated(v)),
    }
}

impl From<OperatorError> for Refusal {
    /// The category of the error.
    fn from(error: OperatorError) -> Self {
        match error {
            OperatorError::Stale(_) | OperatorError::NoSuchAttribute => Self::Stale,
            OperatorError::Full(_) => Self::Full,
            OperatorError::NotIsolated(_) => Self::NotIsolated,
            OperatorError::FacesDiffer(..) => Self::FacesDiffer,
            OperatorError::VerticesDiffer(..) => Self::VerticesDiffer,
            OperatorError::NotInner(_) => Self::NotInner,
            OperatorError::IsOuter(_) => Self::IsOuter,
            OperatorError::DegreeNotTwo(_) => Self::DegreeNotTwo,
            OperatorError::Loop(_) => Self::Loop,
            OperatorError::NotSeparating(_) => Self::NotSeparating,
            OperatorError::InsideItself(..) => Self::InsideItself,
            OperatorError::Refused(_) => Self::Policy,
        }
    }
}

impl Subject for Dcel {
    type Vertex = VertexKey;
    type HalfEdge = HalfEdgeKey;
    type Face = FaceKey;

    fn unbounded_face(&self) -> Option<FaceKey> {
        Some(self.unbounded_face().key())
    }

    fn half_edge_at(&self, index: usize) -> Option<HalfEdgeKey> {
        Some(self.half_edge_at(index)?.key())
    }

    fn vertex_at(&self, index: usize) -> Option<VertexKey> {
        Some(self.vertex_at(index)?.key())
    }

    fn face_of(&self, corner: Corner) -> Result<FaceKey, Refusal> {
        Ok(boundary_of(self, corner)?.face().key())
    }

    fn origin_of(&self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        Ok(self.half_edge(half_edge).map_err(OperatorError::from)?.origin().key())
    }

    fn twin_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        Ok(self.half_edge(half_edge).map_err(OperatorError::from)?.twin().key())
    }

    fn next_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        Ok(self.half_edge(half_edge).map_err(OperatorError::from)?.next().key())
    }

    fn add_isolated_vertex(&mut self, face: FaceKey) -> Result<VertexKey, Refusal> {
        Ok(self.add_isolated_vertex(face)?.vertex)
    }

    fn remove_isolated_vertex(&mut self, vertex: VertexKey) -> Result<(), Refusal> {
        self.remove_isolated_vertex(vertex)?;
        Ok(())
    }

    fn connect(&mut self, from: Corner, to: Corner, new_face: Side, inner: &[Corner]) -> Result<HalfEdgeKey, Refusal> {
        boundary_of(self, from)?;
        boundary_of(self, to)?;
        let inner: Vec<BoundaryKey> =
            inner.iter().map(|corner| Ok(boundary_of(self, *corner)?.key())).collect::<Result<_, OperatorError>>()?;
        Ok(self.connect(from, to, Split { new_face, inner: &inner })?.half_edge)
    }

    fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<Option<FaceKey>, Refusal> {
        match self.remove_edge(half_edge)? {
            RemovedEdge::Merged { dropped_face, .. } => Ok(Some(dropped_face)),
            RemovedEdge::Parted { .. } => Ok(None),
        }
    }

    fn split_edge(&mut self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        Ok(self.split_edge(half_edge)?.half_edge)
    }

    fn join_edges(&mut self, half_edge: HalfEdgeKey) -> Result<(), Refusal> {
        self.join_edges(half_edge)?;
        Ok(())
    }

    fn split_vertex(&mut self, from: Corner, to: Corner) -> Result<HalfEdgeKey, Refusal> {
        Ok(self.split_vertex(from, to)?.half_edge)
    }

    fn contract_edge(&mut self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        Ok(self.contract_edge(half_edge)?.dropped)
    }

    fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), Refusal> {
        Ok(self.flip_edge(half_edge, turn)?)
    }

    fn move_inner(&mut self, inner: Corner, face: FaceKey) -> Result<(), Refusal> {
        let boundary = boundary_of(self, inner)?.key();
        self.move_inner(boundary, face)?;
        Ok(())
    }

    crate::mesh_operators_by_steps!();
}
