//! Errors of calls.

use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, RecordKind, VertexKey};
use thiserror::Error;

/// A key that names no record of this structure, because the record was removed or belongs to another structure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum StaleKey {
    /// A stale vertex key.
    #[error("{0:?} names no vertex of this structure (any more)")]
    Vertex(VertexKey),
    /// A stale half-edge key.
    #[error("{0:?} names no half-edge of this structure (any more)")]
    HalfEdge(HalfEdgeKey),
    /// A stale boundary component key.
    #[error("{0:?} names no boundary component of this structure (any more)")]
    Boundary(BoundaryKey),
    /// A stale face key.
    #[error("{0:?} names no face of this structure (any more)")]
    Face(FaceKey),
}

/// The error of an operator, which leaves the structure unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Error)]
#[non_exhaustive]
pub enum OperatorError {
    /// A key is stale.
    #[error(transparent)]
    Stale(#[from] StaleKey),
    /// There is no room for more records of this kind.
    #[error("there is no room for more {0}")]
    Full(RecordKind),
    /// The vertex has half-edges, and the operator needs an isolated one.
    #[error("{0:?} is not isolated")]
    NotIsolated(VertexKey),
    /// The two corners lie in different faces, so an edge between them would cross something.
    #[error("the corners lie in different faces, {0:?} and {1:?}")]
    FacesDiffer(FaceKey, FaceKey),
    /// The two corners are at different vertices.
    #[error("the corners are at different vertices, {0:?} and {1:?}")]
    VerticesDiffer(VertexKey, VertexKey),
    /// The boundary component cannot move to the new face: it is not an inner one of the split face, or it is the one
    /// being split.
    #[error("{0:?} is not another inner boundary component of the face that is split")]
    NotInner(BoundaryKey),
    /// The boundary component is an outer one, which cannot be moved.
    #[error("{0:?} is the outer boundary component of its face")]
    IsOuter(BoundaryKey),
    /// The degree of the half-edge's target is not 2, so its edges cannot be joined.
    #[error("the target of {0:?} does not have degree 2")]
    DegreeNotTwo(HalfEdgeKey),
    /// The half-edge starts and ends at the same vertex.
    #[error("{0:?} is a loop")]
    Loop(HalfEdgeKey),
    /// Both sides of the edge lie on one boundary component, so it separates nothing and cannot be turned.
    #[error("{0:?} has the same boundary component on both sides")]
    NotSeparating(HalfEdgeKey),
    /// The policy of an attribute refused, with this reason.
    #[error("an attribute does not allow it: {0}")]
    Refused(&'static str),
    /// The structure has no such attribute.
    #[error("the attribute is one of another structure")]
    NoSuchAttribute,
    /// The face lies inside the component to be moved into it.
    #[error("{1:?} lies inside the component of {0:?}")]
    InsideItself(BoundaryKey, FaceKey),
}
