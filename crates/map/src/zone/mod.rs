//! The zone of a line: the faces, edges and vertices along it, in order.
//!
//! ```text
//!        ____________
//!       |      b     |           from a to d, the segment meets
//!   a---|------o-----|---c===d   face, edge, face, vertex, face, edge, face, vertex, along an edge, vertex
//!       |____________|
//! ```
//!
//! [`PlanarMap::zone`](crate::PlanarMap::zone) finds the edges in the R-tree of an index, and sorts the k edges on the line in
//! O(k log k). It is exact, even through vertices and along edges: no intersection is ever computed, and there is no tolerance.

mod follow;
mod indexed;
pub(crate) mod line;
pub(crate) mod selection;

use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;

/// A straight path through the plane, with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QueryLine {
    /// From the first point to the second, both included.
    Segment(Point, Point),
    /// From the first point, included, through the second, without end.
    Ray(Point, Point),
    /// Through both points, in the direction from the first to the second, without beginning or end.
    Line(Point, Point),
}

/// An element that a line meets.
///
/// Faces and stretches along an edge alternate with edges and vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ZoneElement {
    /// The line passes through this face.
    Face(FaceKey),
    /// The line crosses the edge of this half-edge, or begins or ends inside it without running along it. The half-edge comes
    /// from the left of the line: its face is ahead, the face of its twin behind.
    Edge(HalfEdgeKey),
    /// The line runs along the edge of this half-edge, or along part of it. The half-edge has the direction of the line.
    Along(HalfEdgeKey),
    /// The line meets this vertex.
    Vertex(VertexKey),
}
