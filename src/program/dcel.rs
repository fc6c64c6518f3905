//! [`Subject`] for `Dcel`, plain and audited.

use super::mesh;
use super::operators::{Call, Handle};
use super::subject::{CallOf, HandleOf, Refusal, Subject};
use crate::dcel::{
    Audited, Boundary, BoundaryKey, Corner, Dcel, FaceKey, HalfEdgeKey, OperatorError, RemovedEdge, Split, VertexKey,
};
use crate::validate::{HalfEdgeColumns, View};
use alloc::vec::Vec;

fn boundary_of(dcel: &Dcel, corner: Corner) -> Result<Boundary<'_>, OperatorError> {
    match corner {
        Corner::At(h) => Ok(dcel.half_edge(h)?.boundary()),
        Corner::Isolated(v) => dcel.vertex(v)?.isolated().ok_or(OperatorError::NotIsolated(v)),
    }
}

impl From<OperatorError> for Refusal {
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

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        Ok(match call {
            Call::AddIsolatedVertex { face } => Some(Handle::Vertex(self.add_isolated_vertex(face)?.vertex)),
            Call::RemoveIsolatedVertex { vertex } => {
                self.remove_isolated_vertex(vertex)?;
                None
            }
            Call::Connect { from, to, new_face, inner } => {
                boundary_of(self, from)?;
                boundary_of(self, to)?;
                let boundary = |corner: Corner| Ok(boundary_of(self, corner)?.key());
                let inner: Vec<BoundaryKey> = inner.into_iter().map(boundary).collect::<Result<_, OperatorError>>()?;
                Some(Handle::HalfEdge(self.connect(from, to, Split { new_face, inner: &inner })?.half_edge))
            }
            Call::RemoveEdge { half_edge } => match self.remove_edge(half_edge)? {
                RemovedEdge::Merged { dropped_face, .. } => Some(Handle::Face(dropped_face)),
                RemovedEdge::Parted { .. } => None,
            },
            Call::SplitEdge { half_edge } => Some(Handle::HalfEdge(self.split_edge(half_edge)?.half_edge)),
            Call::JoinEdges { half_edge } => {
                self.join_edges(half_edge)?;
                None
            }
            Call::SplitVertex { from, to } => Some(Handle::HalfEdge(self.split_vertex(from, to)?.half_edge)),
            Call::ContractEdge { half_edge } => Some(Handle::Vertex(self.contract_edge(half_edge)?.dropped)),
            Call::FlipEdge { half_edge, turn } => {
                self.flip_edge(half_edge, turn)?;
                None
            }
            Call::MoveInner { inner, face } => {
                let boundary = boundary_of(self, inner)?.key();
                self.move_inner(boundary, face)?;
                None
            }
            Call::MeshFlipEdge { half_edge } => {
                mesh::flip_edge(self, half_edge)?;
                None
            }
            Call::MeshSplitEdge { half_edge } => {
                mesh::split_edge(self, half_edge)?;
                None
            }
            Call::MeshSplitFace { half_edge } => {
                mesh::split_face(self, half_edge)?;
                None
            }
            Call::MeshCollapseEdge { half_edge } => {
                mesh::collapse_edge(self, half_edge)?;
                None
            }
        })
    }
}

impl View for Audited {
    crate::delegate_view!(|this| this.get());

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        self.get().half_edge_columns()
    }
}

/// # Panics
/// Operators panic with the report if they break a rule. [`Audited::change`] returns the report as an error instead.
impl Subject for Audited {
    crate::delegate_subject!(Dcel, |this| this.get());

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        match self.change(|dcel| dcel.apply(call)) {
            Ok(given) => given,
            Err(report) => panic!("{report}"),
        }
    }
}
