//! The doubly connected edge list: accessors, circulators and operators, written once for every store.
//!
//! ```
//! use twinedge::dcel::{Dcel, Side, Split};
//!
//! let mut map = Dcel::new();
//! let outside = map.unbounded_face().key();
//! // A triangle: three vertices, joined one to the next; the third edge splits the face.
//! let a = map.add_isolated_vertex(outside)?.vertex;
//! let b = map.add_isolated_vertex(outside)?.vertex;
//! let c = map.add_isolated_vertex(outside)?.vertex;
//! let ab = map.connect(a, b, Split::default())?.half_edge;
//! let ba = map.half_edge(ab)?.twin().key();
//! let bc = map.connect(ba, c, Split::default())?.half_edge;
//! let cb = map.half_edge(bc)?.twin().key();
//! let ca = map.connect(cb, ab, Split { new_face: Side::Left, inner: &[] })?;
//!
//! let inside = map.half_edge(ab)?.face();
//! assert_eq!(Some(inside.key()), ca.new_face());
//! assert_eq!(inside.outer().unwrap().half_edges().count(), 3);
//! assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (3, 3, 2));
//! assert!(map.validate().is_valid());
//! # Ok::<(), twinedge::dcel::OperatorError>(())
//! ```
//!
//! # Reading
//!
//! A key is checked once, where it enters ([`Dcel::half_edge`] and its kin); what comes out is a reference ([`HalfEdge`])
//! that borrows the structure, so nothing can be removed meanwhile, and every further step is a bare array access.
//!
//! # Changing
//!
//! The operators are Euler operators: each keeps every rule from R1 to T4, is atomic (an error leaves everything as it was)
//! and says what it made, kept and dropped, so that data kept beside the structure can follow.
//!
//! | operator | inverse |
//! | --- | --- |
//! | [`add_isolated_vertex`](Dcel::add_isolated_vertex) | [`remove_isolated_vertex`](Dcel::remove_isolated_vertex) |
//! | [`connect`](Dcel::connect) | [`remove_edge`](Dcel::remove_edge) |
//! | [`split_edge`](Dcel::split_edge) | [`join_edges`](Dcel::join_edges) |
//! | [`split_vertex`](Dcel::split_vertex) | [`contract_edge`](Dcel::contract_edge) |
//! | [`flip_edge`](Dcel::flip_edge) | [`flip_edge`](Dcel::flip_edge), turned the other way |
//! | [`move_inner`](Dcel::move_inner) | [`move_inner`](Dcel::move_inner), back |
//!
//! # Data of your own
//!
//! The records hold topology and nothing else. Keep coordinates, names and weights in `slotmap::SecondaryMap`s by key.

mod assemble;
mod circulators;
mod elements;
mod error;
mod import;
mod operators;
mod view;

pub use circulators::{Cycle, Rotation};
pub use elements::{Boundary, Face, HalfEdge, Vertex};
pub use error::{OperatorError, StaleKey};
pub use import::{ImportError, Keys, Outside};

#[allow(unused_imports, reason = "for the layers above, which a smaller selection of features leaves out")]
pub(crate) use assemble::Assembly;
pub use operators::{
    AddedVertex, Connected, Connection, ContractedEdge, Corner, JoinedEdges, RemovedEdge, RemovedVertex, Side, Split,
    SplitEdge, SplitVertex, Turn,
};

pub use crate::store::links::RecordKind;
pub use crate::store::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};

use crate::store::links::Need;
use crate::store::{SlotStore, Store};
use crate::validate::{Collect, Expectation, Report, validate};

/// A doubly connected edge list of a planar subdivision.
///
/// A key of another `Dcel` is stale here, like one whose record is gone: the keys of different structures differ in their
/// generations. (A clone shares its original's keys; what either makes later may get a key that the other uses too.)
#[derive(Clone, Debug)]
pub struct Dcel<S: Store = SlotStore> {
    store: S,
}

impl Dcel {
    /// The empty map: one unbounded face, nothing in it. O(1).
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The empty map, with room for this many vertices and edges, and the faces of a connected map of these.
    ///
    /// Room is a wish: where there is not that much memory, the columns grow as they are filled. It makes no difference
    /// to what the structure holds, only to how often memory is asked for.
    #[must_use]
    pub fn with_capacity(vertices: usize, edges: usize) -> Self {
        let faces = edges.saturating_add(1).saturating_sub(vertices);
        Self::with_room(Need { vertices, edges, boundaries: faces.saturating_add(1), faces })
    }
}

impl<S: Store> Default for Dcel<S> {
    fn default() -> Self {
        Self::with_room(Need::NONE)
    }
}

impl<S: Store> Dcel<S> {
    pub(crate) fn with_room(need: Need) -> Self {
        Self { store: S::with_room(need) }
    }

    #[allow(dead_code, reason = "for the layers above, which a smaller selection of features leaves out")]
    pub(crate) const fn store_mut(&mut self) -> &mut S {
        &mut self.store
    }

    /// The number of vertices. O(1).
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.store.vertex_count()
    }

    /// The number of edges, half that of half-edges. O(1).
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.store.edge_count()
    }

    /// The number of half-edges. O(1).
    #[must_use]
    pub fn half_edge_count(&self) -> usize {
        2 * self.store.edge_count()
    }

    /// The number of boundary components. O(1).
    #[must_use]
    pub fn boundary_count(&self) -> usize {
        self.store.boundary_count()
    }

    /// The number of faces, the unbounded one included. O(1).
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.store.face_count()
    }

    /// The vertex with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Vertex`] if there is none (any more).
    pub fn vertex(&self, key: VertexKey) -> Result<Vertex<'_, S>, StaleKey> {
        self.store.find_vertex(key).map(|slot| Vertex::new(self, slot)).ok_or(StaleKey::Vertex(key))
    }

    /// The half-edge with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::HalfEdge`] if there is none (any more).
    pub fn half_edge(&self, key: HalfEdgeKey) -> Result<HalfEdge<'_, S>, StaleKey> {
        self.store.find_half_edge(key).map(|slot| HalfEdge::new(self, slot)).ok_or(StaleKey::HalfEdge(key))
    }

    /// The boundary component with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Boundary`] if there is none (any more).
    pub fn boundary(&self, key: BoundaryKey) -> Result<Boundary<'_, S>, StaleKey> {
        self.store.find_boundary(key).map(|slot| Boundary::new(self, slot)).ok_or(StaleKey::Boundary(key))
    }

    /// The face with this key. O(1).
    ///
    /// # Errors
    /// [`StaleKey::Face`] if there is none (any more).
    pub fn face(&self, key: FaceKey) -> Result<Face<'_, S>, StaleKey> {
        self.store.find_face(key).map(|slot| Face::new(self, slot)).ok_or(StaleKey::Face(key))
    }

    /// The unbounded face, which every map has. O(1).
    #[must_use]
    pub fn unbounded_face(&self) -> Face<'_, S> {
        Face::new(self, self.store.unbounded())
    }

    /// All vertices, in order of their indices. O(slots).
    pub fn vertices(&self) -> impl Iterator<Item = Vertex<'_, S>> + '_ {
        (0..self.store.vertex_slots()).filter_map(|i| self.vertex_at(i))
    }

    /// All half-edges, in order of their indices. O(slots).
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdge<'_, S>> + '_ {
        (0..self.store.half_edge_slots()).filter_map(|i| self.half_edge_at(i))
    }

    /// One half-edge of each edge: of the two, the one with the smaller index. O(slots).
    pub fn edges(&self) -> impl Iterator<Item = HalfEdge<'_, S>> + '_ {
        self.half_edges().filter(|h| h.index() < h.twin().index())
    }

    /// All boundary components, in order of their indices. O(slots).
    pub fn boundaries(&self) -> impl Iterator<Item = Boundary<'_, S>> + '_ {
        (0..self.store.boundary_slots()).filter_map(|i| self.boundary_at(i))
    }

    /// All faces, in order of their indices. O(slots).
    pub fn faces(&self) -> impl Iterator<Item = Face<'_, S>> + '_ {
        (0..self.store.face_slots()).filter_map(|i| self.face_at(i))
    }

    /// The vertex with this index, which is how reports name it. O(1).
    #[must_use]
    pub fn vertex_at(&self, index: usize) -> Option<Vertex<'_, S>> {
        self.store.vertex_at(index).map(|slot| Vertex::new(self, slot))
    }

    /// The half-edge with this index, which is how reports name it. O(1).
    #[must_use]
    pub fn half_edge_at(&self, index: usize) -> Option<HalfEdge<'_, S>> {
        self.store.half_edge_at(index).map(|slot| HalfEdge::new(self, slot))
    }

    /// The boundary component with this index, which is how reports name it. O(1).
    #[must_use]
    pub fn boundary_at(&self, index: usize) -> Option<Boundary<'_, S>> {
        self.store.boundary_at(index).map(|slot| Boundary::new(self, slot))
    }

    /// The face with this index, which is how reports name it. O(1).
    #[must_use]
    pub fn face_at(&self, index: usize) -> Option<Face<'_, S>> {
        self.store.face_at(index).map(|slot| Face::new(self, slot))
    }

    /// Checks every rule from R1 to T4. O(n).
    ///
    /// No sequence of operators breaks one; this is for those who would rather see than believe.
    #[must_use]
    pub fn validate(&self) -> Report {
        validate(self, &Expectation::plane(), Collect::All)
    }
}
