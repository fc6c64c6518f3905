//! The structure itself: a store, and how many records there are.

use crate::store::{Room, Store};
use core::fmt;

/// A doubly connected edge list of a planar subdivision.
///
/// # Keys
///
/// A key names one record of one structure. Once the record is removed, the key is [stale](crate::dcel::StaleKey): every
/// method refuses it, also after the slot has been used again.
///
/// A key of another `Dcel` is stale too, because each structure adds a number of its own to its generations. This has
/// limits:
///
/// - A clone accepts its original's keys, and so does a structure that was saved and loaded. What either makes later may get
///   a key that the other uses too.
/// - Keys of unrelated structures can coincide after very many of both: the first key of another structure that was accepted
///   in a test came after 5,473 structures and 41,233 uses of one slot.
/// - A [`SecondaryMap`](crate::dcel::SecondaryMap) does not know to which structure its keys belong. It compares slots and
///   generations only, so look up in it with keys of the structure that it was filled for.
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
    /// The empty map: one unbounded face and nothing in it. O(1).
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

    /// The empty map, with capacity for this many vertices and edges, and for the faces of a connected map of these.
    ///
    /// Capacity is best effort: if there is not enough memory for it, the columns grow as they are filled. It has no
    /// influence on what the structure can hold, only on how often memory is allocated.
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

    /// The empty map, which never has more records than that: an operator that would need more is refused with
    /// [`OperatorError::Full`](super::OperatorError::Full). Clones have the same limits. At least the unbounded face fits.
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

    #[allow(dead_code, reason = "for the layers above, which a smaller selection of features leaves out")]
    pub(crate) const fn store(&self) -> &Store {
        &self.store
    }

    #[allow(dead_code, reason = "for the layers above, which a smaller selection of features leaves out")]
    pub(crate) const fn store_mut(&mut self) -> &mut Store {
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

    /// The number of slots for vertices, vacant ones included: every [index](super::Vertex::index) of a vertex is below it. O(1).
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

    /// The number of slots for half-edges, vacant ones included. O(1).
    #[must_use]
    pub fn half_edge_slots(&self) -> usize {
        self.store.half_edge_slots()
    }

    /// The number of slots for boundary components, vacant ones included. O(1).
    #[must_use]
    pub fn boundary_slots(&self) -> usize {
        self.store.boundary_slots()
    }

    /// The number of slots for faces, vacant ones included. O(1).
    #[must_use]
    pub fn face_slots(&self) -> usize {
        self.store.face_slots()
    }
}
