//! Point location by an index.
//!
//! [`PlanarMap::locate`](crate::PlanarMap::locate) builds an index once, in O(n log n), and maintains it through edits. A query
//! takes O(log n) on most maps, O(n) at worst. It is exact: a point is at a vertex, inside an edge or in a face, without any
//! tolerance.
//!
//! ```text
//!    ●────────────●
//!    │      f     │      p: in face f
//!    │  p      q  r      q: in face f, however near to the edge
//!    │            │      r: inside the edge
//!    ●────────────●
//! ```
//!
//! ```
//! use twinedge_geometry::Point;
//! use twinedge_map::{Builder, Located, Shape};
//!
//! let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
//! let lake = [[1.0, 1.0], [2.0, 1.0], [1.0, 2.0]];
//! let mut builder = Builder::new();
//! let land = builder.shape(&Shape::polygon(square).hole(lake))?;
//! let map = builder.build()?;
//!
//! let Located::Face(face) = map.locate(Point::new(3.0, 3.0))? else { panic!("it is inside") };
//! assert!(map.features_of(face)?.eq([land]));
//! let Located::Face(lake) = map.locate(Point::new(1.25, 1.25))? else { panic!("it is inside") };
//! assert_eq!(map.features_of(lake)?.count(), 0);
//! assert!(matches!(map.locate(Point::new(1.5, 1.5))?, Located::Edge(_)));
//! assert!(matches!(map.locate(Point::new(4.0, 4.0))?, Located::Vertex(_)));
//! assert_eq!(map.locate(Point::new(5.0, 4.0))?, Located::Face(map.dcel().unbounded_face().key()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod in_face;
mod kept;

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
