//! A point for an edit, with a hint about its location.

use twinedge::dcel::{HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;

/// A point for an edit, with a location hint. Points, pairs of coordinates, vertices, and points with a half-edge convert to it.
///
/// For several points, only the first one is searched, using its hint; walks lead from there to the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// Anywhere. Found like [`PlanarMap::locate`](crate::PlanarMap::locate), with an index that the map then keeps.
    Point(Point),
    /// A point in the face of a half-edge or on its boundary, found in O(1) if that boundary is short. If the point lies
    /// elsewhere or the boundary is long, it is found as without the hint.
    Near(Point, HalfEdgeKey),
    /// The coordinates of this vertex. O(1).
    Vertex(VertexKey),
}

impl From<Point> for At {
    fn from(p: Point) -> Self {
        Self::Point(p)
    }
}

impl From<[f64; 2]> for At {
    fn from(p: [f64; 2]) -> Self {
        Self::Point(p.into())
    }
}

impl From<VertexKey> for At {
    fn from(v: VertexKey) -> Self {
        Self::Vertex(v)
    }
}

impl<P: Into<Point>> From<(P, HalfEdgeKey)> for At {
    fn from((p, hint): (P, HalfEdgeKey)) -> Self {
        Self::Near(p.into(), hint)
    }
}
