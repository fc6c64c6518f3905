//! Finds elements by key or index.

use super::elements::{Boundary, Face, HalfEdge, Vertex};
use super::error::StaleKey;
use super::structure::Dcel;
use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};

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
