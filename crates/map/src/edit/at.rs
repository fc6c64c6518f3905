//! A point for an edit, with what is known of where it lies.

use twinedge::dcel::{HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;

/// A point for an edit, with what is known of where it lies. Points, pairs of coordinates, vertices, and pairs of a point
/// and a half-edge convert.
///
/// Of several points only the first is searched for, and its hint used: from there on the way leads to the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// Anywhere. It is found as by [`PlanarMap::locate`](crate::PlanarMap::locate): by an index that the map keeps once it is needed.
    Point(Point),
    /// A point in the face of a half-edge or on its boundary, O(1) if that boundary is short; or elsewhere after all, or in a
    /// face with a long one, and found as without the hint.
    Near(Point, HalfEdgeKey),
    /// The place of this vertex. O(1).
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
