//! The structure: a store, and the numbers of its records.

use crate::store::{Room, Store};
use core::fmt;

/// A doubly connected edge list of a planar subdivision.
///
/// # Keys
///
/// A key names one record of one structure. Once the record is removed, the key is [stale](crate::dcel::StaleKey): every method
/// refuses it, even after the slot has been reused.
///
/// A key of another `Dcel` is also stale, because each structure adds its own number to its generations. This has limits:
///
/// - A clone, or a structure that was saved and loaded, accepts the original's keys. Records that either makes later may share a
///   key.
/// - Keys of unrelated structures can coincide after very many of both: in a test, the first accepted key of another structure
///   came after 5,473 structures and 41,233 uses of one slot.
/// - A [`SecondaryMap`](crate::dcel::SecondaryMap) compares only slots and generations, so look up only keys of the structure for
///   which it was filled.
#[derive(Clone)]
pub struct Dcel {
    pub(super) store: Store,
}

/// Prints the numbers of records.
impl fmt::Debug for Dcel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Dcel")
            .field("vertices", &self.vertex_count())
            .field("edges", &self.edge_count())
            .field("boundaries", &self.boundary_count())
            .field("faces", &self.face_count())
            .finish()
    }
}

impl Dcel {
    /// Creates the empty map: one unbounded face and nothing else. O(1).
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let map = Dcel::new();
    /// assert!(map.unbounded_face().is_unbounded());
    /// assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (0, 0, 1));
    /// ```
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates the empty map, with capacity for this number of vertices and edges, and for the faces of a connected map of these.
    ///
    /// Capacity is best effort: if memory is short, columns grow as they are filled. It does not limit the structure, and only
    /// affects how often memory is allocated.
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let map = Dcel::with_capacity(1000, 2000);
    /// assert_eq!((map.vertex_count(), map.edge_count(), map.face_count()), (0, 0, 1));
    /// ```
    #[must_use]
    pub fn with_capacity(vertices: usize, edges: usize) -> Self {
        let faces = edges.saturating_add(1).saturating_sub(vertices);
        Self::with_room(Room { vertices, edges, boundaries: faces.saturating_add(1), faces })
    }

    /// Creates an empty map that never has more records than these: an operator that would exceed them is refused with
    /// [`OperatorError::Full`](super::OperatorError::Full). Clones have the same limits. The unbounded face always fits.
    ///
    /// ```
    /// use twinedge::dcel::{Dcel, OperatorError, RecordKind, Room};
    ///
    /// let mut map = Dcel::with_limits(Room { vertices: 1, edges: 2, boundaries: 3, faces: 3 });
    /// let outside = map.unbounded_face().key();
    /// map.add_isolated_vertex(outside)?;
    /// assert_eq!(map.add_isolated_vertex(outside), Err(OperatorError::Full(RecordKind::Vertex)));
    /// # Ok::<(), OperatorError>(())
    /// ```
    #[must_use]
    pub fn with_limits(most: Room) -> Self {
        let mut dcel = Self::default();
        dcel.store.limit(most);
        dcel
    }
}

impl Default for Dcel {
    fn default() -> Self {
        Self::with_room(Room::NONE)
    }
}

impl Dcel {
    pub(crate) fn with_room(need: Room) -> Self {
        Self { store: Store::with_room(need) }
    }

    /// Returns the number of vertices. O(1).
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.store.vertex_count()
    }

    /// Returns the number of edges. O(1).
    #[must_use]
    pub fn edge_count(&self) -> usize {
        self.store.edge_count()
    }

    /// Returns the number of half-edges, twice the number of edges. O(1).
    #[must_use]
    pub fn half_edge_count(&self) -> usize {
        2 * self.store.edge_count()
    }

    /// Returns the number of boundary components. O(1).
    #[must_use]
    pub fn boundary_count(&self) -> usize {
        self.store.boundary_count()
    }

    /// Returns the number of faces, including the unbounded face. O(1).
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.store.face_count()
    }

    /// Returns the number of slots for vertices, including vacant ones, an upper bound for every [index](super::Vertex::index).
    /// O(1).
    ///
    /// ```
    /// use twinedge::dcel::Dcel;
    ///
    /// let mut map = Dcel::new();
    /// let vertex = map.add_isolated_vertex(map.unbounded_face().key())?.vertex;
    /// let mut names = vec![""; map.vertex_slots()];
    /// names[map.vertex(vertex)?.index()] = "Rome";
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn vertex_slots(&self) -> usize {
        self.store.vertex_slots()
    }

    /// Returns the number of slots for half-edges, including vacant ones. O(1).
    #[must_use]
    pub fn half_edge_slots(&self) -> usize {
        self.store.half_edge_slots()
    }

    /// Returns the number of slots for boundary components, including vacant ones. O(1).
    #[must_use]
    pub fn boundary_slots(&self) -> usize {
        self.store.boundary_slots()
    }

    /// Returns the number of slots for faces, including vacant ones. O(1).
    #[must_use]
    pub fn face_slots(&self) -> usize {
        self.store.face_slots()
    }
}
