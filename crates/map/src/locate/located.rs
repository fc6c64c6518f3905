//! The result of point location, and its errors.

use crate::not_plane::NotPlane;
use thiserror::Error;
use twinedge::dcel::{FaceKey, HalfEdgeKey, StaleKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::in_range;

/// The location of a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Located {
    /// In this face, and not on its boundary.
    Face(FaceKey),
    /// Inside the edge of this half-edge.
    Edge(HalfEdgeKey),
    /// At this vertex.
    Vertex(VertexKey),
}

/// The error of point location and of zones.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum LocateError {
    /// A coordinate of the point is NaN, infinite, or beyond the range of the exact predicates; see [`in_range`].
    #[error("the point ({:?}, {:?}) is not in the range of exact arithmetic", .0.x, .0.y)]
    OutOfRange(Point),
    /// The two points that should define a direction are equal.
    #[error("there is no direction from ({}, {}) to itself", .0.x, .0.y)]
    NoDirection(Point),
    /// The map is not plane.
    #[error(transparent)]
    NotPlane(#[from] NotPlane),
    /// A key is stale.
    #[error(transparent)]
    Stale(#[from] StaleKey),
}

/// Refuses a point beyond the range of exact arithmetic.
pub(crate) fn check_range(p: Point) -> Result<(), LocateError> {
    if in_range(p) { Ok(()) } else { Err(LocateError::OutOfRange(p)) }
}
