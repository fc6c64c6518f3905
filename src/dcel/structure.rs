//! The structure itself: a store, and how many records there are.

use crate::store::links::Need;
use crate::store::{SlotStore, Store};

/// A doubly connected edge list of a planar subdivision.
///
/// A key of another `Dcel` is stale here, like one whose record is gone: the keys of different structures differ in their
/// generations. (A clone shares its original's keys; what either makes later may get a key that the other uses too.)
#[derive(Clone, Debug)]
pub struct Dcel<S: Store = SlotStore> {
    pub(super) store: S,
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
}
