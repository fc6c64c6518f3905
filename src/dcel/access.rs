//! Finds elements by key or index, and the errors of calls with keys.

use super::elements::{Boundary, Face, HalfEdge, Vertex};
use super::structure::Dcel;
use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, RecordKind, VertexKey};
use thiserror::Error;

mod sealed {
    pub trait Sealed {}
}

/// A key of a vertex, half-edge, boundary component or face.
pub trait ElementKey: Copy + sealed::Sealed {
    /// The element that the key names.
    type Element<'a>;

    /// Returns the element with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey`] if there is none.
    fn find(self, dcel: &Dcel) -> Result<Self::Element<'_>, StaleKey>;
}

macro_rules! element_keys {
    ($($key:ident $element:ident $find:ident;)*) => {$(
        impl sealed::Sealed for $key {}

        impl ElementKey for $key {
            type Element<'a> = $element<'a>;

            fn find(self, dcel: &Dcel) -> Result<$element<'_>, StaleKey> {
                dcel.$find(self)
            }
        }
    )*};
}

element_keys! {
    VertexKey Vertex vertex;
    HalfEdgeKey HalfEdge half_edge;
    BoundaryKey Boundary boundary;
    FaceKey Face face;
}

impl Dcel {
    /// Returns the element with this key, which must be live. O(1).
    ///
    /// [`Index`](core::ops::Index) cannot be implemented: it returns references to stored values, and elements are not
    /// stored.
    ///
    /// # Panics
    /// Panics if the key is stale. [`vertex`](Self::vertex), [`half_edge`](Self::half_edge), [`boundary`](Self::boundary) and
    /// [`face`](Self::face) return an error instead.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, Split};
    ///
    /// let mut map = Dcel::new();
    /// let v = map.add_isolated_vertex(map.unbounded_face().key())?.vertex;
    /// let h = map.connect(v, v, Split::default())?.half_edge;
    /// assert_eq!(map.at(h).origin(), map.at(v));
    /// # Ok::<(), twinedge::dcel::OperatorError>(())
    /// ```
    #[must_use]
    #[track_caller]
    pub fn at<K: ElementKey>(&self, key: K) -> K::Element<'_> {
        match key.find(self) {
            Ok(element) => element,
            Err(stale) => panic!("{stale}"),
        }
    }

    /// Returns the vertex with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Vertex`] if the key is stale.
    pub fn vertex(&self, key: VertexKey) -> Result<Vertex<'_>, StaleKey> {
        self.store.find_vertex(key).map(|slot| Vertex::new(self, slot)).ok_or(StaleKey::Vertex(key))
    }

    /// Returns the half-edge with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::HalfEdge`] if the key is stale.
    pub fn half_edge(&self, key: HalfEdgeKey) -> Result<HalfEdge<'_>, StaleKey> {
        self.store.find_half_edge(key).map(|slot| HalfEdge::new(self, slot)).ok_or(StaleKey::HalfEdge(key))
    }

    /// Returns the boundary component with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Boundary`] if the key is stale.
    pub fn boundary(&self, key: BoundaryKey) -> Result<Boundary<'_>, StaleKey> {
        self.store.find_boundary(key).map(|slot| Boundary::new(self, slot)).ok_or(StaleKey::Boundary(key))
    }

    /// Returns the face with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Face`] if the key is stale.
    pub fn face(&self, key: FaceKey) -> Result<Face<'_>, StaleKey> {
        self.store.find_face(key).map(|slot| Face::new(self, slot)).ok_or(StaleKey::Face(key))
    }

    /// Returns the unbounded face, which every map has. O(1).
    #[must_use]
    pub fn unbounded_face(&self) -> Face<'_> {
        Face::new(self, self.store.unbounded())
    }

    /// Returns all vertices, in order of their indices. O(slots).
    pub fn vertices(&self) -> impl Iterator<Item = Vertex<'_>> + '_ {
        (0..self.store.vertex_slots()).filter_map(|i| self.vertex_at(i))
    }

    /// Returns all half-edges, in order of their indices. O(slots).
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdge<'_>> + '_ {
        (0..self.store.half_edge_slots()).filter_map(|i| self.half_edge_at(i))
    }

    /// Returns one half-edge of each edge, the one with the smaller index. O(slots).
    pub fn edges(&self) -> impl Iterator<Item = HalfEdge<'_>> + '_ {
        self.half_edges().filter(|h| h.index() < h.twin().index())
    }

    /// Returns all boundary components, in order of their indices. O(slots).
    pub fn boundaries(&self) -> impl Iterator<Item = Boundary<'_>> + '_ {
        (0..self.store.boundary_slots()).filter_map(|i| self.boundary_at(i))
    }

    /// Returns all faces, in order of their indices. O(slots).
    pub fn faces(&self) -> impl Iterator<Item = Face<'_>> + '_ {
        (0..self.store.face_slots()).filter_map(|i| self.face_at(i))
    }

    /// Returns the vertex with this index, as named in reports. O(1).
    #[must_use]
    pub fn vertex_at(&self, index: usize) -> Option<Vertex<'_>> {
        self.store.vertex_at(index).map(|slot| Vertex::new(self, slot))
    }

    /// Returns the half-edge with this index, as named in reports. O(1).
    #[must_use]
    pub fn half_edge_at(&self, index: usize) -> Option<HalfEdge<'_>> {
        self.store.half_edge_at(index).map(|slot| HalfEdge::new(self, slot))
    }

    /// Returns the boundary component with this index, as named in reports. O(1).
    #[must_use]
    pub fn boundary_at(&self, index: usize) -> Option<Boundary<'_>> {
        self.store.boundary_at(index).map(|slot| Boundary::new(self, slot))
    }

    /// Returns the face with this index, as named in reports. O(1).
    #[must_use]
    pub fn face_at(&self, index: usize) -> Option<Face<'_>> {
        self.store.face_at(index).map(|slot| Face::new(self, slot))
    }
}

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
