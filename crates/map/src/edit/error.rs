//! Errors of edits.

use crate::FeatureId;
use crate::not_plane::NotPlane;
use thiserror::Error;
use twinedge::dcel::{FaceKey, HalfEdgeKey, OperatorError, RecordKind, StaleKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::noding::NodingError;

/// The error of an edit. The map is unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum EditError {
    /// A key is stale, or there is no room for more records.
    #[error(transparent)]
    Operator(#[from] OperatorError),
    /// The map is not plane ([`PlanarMap::is_plane`](crate::PlanarMap::is_plane)), so locations are undefined.
    #[error(transparent)]
    NotPlane(#[from] NotPlane),
    /// A coordinate is NaN or infinite.
    #[error("the coordinates ({x}, {y}) are not finite")]
    NotFinite {
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// A nonzero coordinate is too large or too close to zero for the predicates to be exact.
    #[error("the coordinates ({x:?}, {y:?}) are out of range: magnitudes must be zero or from 2^-400 to 2^500")]
    OutOfRange {
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// Both ends of a segment are the same point.
    #[error("both ends of the segment are ({x}, {y})")]
    NoLength {
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// A segment would cross this edge, at a point interior to both. It is the first such edge on the way, named by the half-edge
    /// whose face comes before it. There may be others.
    #[error("it would cross the edge of {0:?}")]
    Crosses(HalfEdgeKey),
    /// A ring has fewer than three points.
    #[error("a ring needs three points, this one has {points}")]
    NotARing {
        /// The number of points, without a last one that repeats the first.
        points: usize,
    },
    /// Two segments of a ring cross, at a point interior to both.
    #[error("segments {first} and {second} of the ring cross")]
    SelfCrossing {
        /// The index of the point where one segment starts.
        first: usize,
        /// The index of the point where the other segment starts.
        second: usize,
    },
    /// The vertex, or one of its edges, would sweep over another vertex.
    #[error("{0:?} is in the way")]
    VertexInTheWay(VertexKey),
    /// The vertex would run into an edge.
    #[error("the edge of {0:?} is in the way")]
    EdgeInTheWay(HalfEdgeKey),
    /// The vertex is not on the rounding grid of the edit.
    #[error("{0:?} is not on the grid")]
    NotOnGrid(VertexKey),
    /// The size of a cell is not a positive finite number.
    #[error("the size of a cell of the grid must be a positive finite number")]
    CellSize,
    /// A coordinate is more than 2^53 cells of the grid.
    #[error("({x}, {y}) is out of reach of the grid: take larger cells")]
    OutOfReach {
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// The line does not pass through the face.
    #[error("the line does not pass through {0:?}")]
    NotThrough(FaceKey),
    /// No edge separates the faces, or they are the same face.
    #[error("there is no edge between {0:?} and {1:?}")]
    NoEdgeBetween(FaceKey, FaceKey),
    /// The map has no such feature, or it was removed.
    #[error("there is no feature {}", .0.index())]
    NoSuchFeature(FeatureId),
}

impl EditError {
    /// Converts an error of noding points and segments.
    pub(super) fn of_noding(error: NodingError, segments: &[[Point; 2]], points: &[Point]) -> Self {
        match error {
            NodingError::Size => Self::CellSize,
            NodingError::NotFinite { at } | NodingError::OutOfRange { at } => {
                let Point { x, y } = at.point(segments, points).unwrap_or_default();
                Self::OutOfReach { x, y }
            }
            // Too many segments or cuts.
            _ => OperatorError::Full(RecordKind::Vertex).into(),
        }
    }
}

impl From<StaleKey> for EditError {
    fn from(key: StaleKey) -> Self {
        Self::Operator(key.into())
    }
}
