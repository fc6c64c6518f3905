//! Equality of structures.

use super::elements::{Boundary, Face, HalfEdge, Vertex};
use super::structure::Dcel;
use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};

/// Two structures are equal if they have the same records under the same keys, with the same links, and lists in the same order.
/// Vacant slots do not matter. O(n).
///
/// ```
/// use twinedge::dcel::Dcel;
///
/// let mut map = Dcel::new();
/// let before = map.clone();
/// let made = map.add_isolated_vertex(map.unbounded_face().key())?;
/// assert_ne!(map, before);
/// map.remove_isolated_vertex(made.vertex)?;
/// assert_eq!(map, before);
/// # Ok::<(), twinedge::dcel::OperatorError>(())
/// ```
impl PartialEq for Dcel {
    fn eq(&self, other: &Self) -> bool {
        self.vertices().map(vertex).eq(other.vertices().map(vertex))
            && self.half_edges().map(half_edge).eq(other.half_edges().map(half_edge))
            && self.boundaries().map(boundary).eq(other.boundaries().map(boundary))
            && self.faces().map(face).eq(other.faces().map(face))
            && self.faces().zip(other.faces()).all(|(a, b)| a.inner().map(|b| b.key()).eq(b.inner().map(|b| b.key())))
    }
}

impl Eq for Dcel {}

fn vertex(v: Vertex<'_>) -> (VertexKey, Option<HalfEdgeKey>, Option<BoundaryKey>) {
    (v.key(), v.leaving().map(|h| h.key()), v.isolated().map(|b| b.key()))
}

fn half_edge(h: HalfEdge<'_>) -> ([HalfEdgeKey; 4], VertexKey, BoundaryKey) {
    let links = [h, h.twin(), h.next(), h.prev()].map(|h| h.key());
    (links, h.origin().key(), h.boundary().key())
}

fn boundary(b: Boundary<'_>) -> (BoundaryKey, FaceKey, Option<HalfEdgeKey>, Option<VertexKey>) {
    (b.key(), b.face().key(), b.start().map(|h| h.key()), b.isolated_vertex().map(|v| v.key()))
}

fn face(f: Face<'_>) -> (FaceKey, Option<BoundaryKey>) {
    (f.key(), f.outer().map(|b| b.key()))
}
