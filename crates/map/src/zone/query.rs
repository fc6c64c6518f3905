//! The arguments of a question about a line, and the parts of the answer.

use twinedge::dcel::{FaceKey, HalfEdgeKey, VertexKey};
use twinedge_geometry::Point;

/// A straight way through the plane, with a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QueryLine {
    /// From the first point to the second, both included.
    Segment(Point, Point),
    /// From the first point, included, through the second and on for ever.
    Ray(Point, Point),
    /// Through both points, in the direction from the first to the second, without beginning or end.
    Line(Point, Point),
}

/// Something that a line meets.
///
/// A face or the course along an edge is always followed by an edge or a vertex, and an edge or a vertex by a face or the
/// course along an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ZoneElement {
    /// It goes through this face.
    Face(FaceKey),
    /// It crosses the edge of this half-edge, or begins or ends inside it, not along it. The half-edge comes from the
    /// left of the line: its face is ahead, that of its twin behind.
    Edge(HalfEdgeKey),
    /// It goes along the edge of this half-edge, or a part of it. The half-edge has the direction of the line.
    Along(HalfEdgeKey),
    /// It meets this vertex.
    Vertex(VertexKey),
}
