//! The traits of a store: issue and check keys, keep links, list the inner boundary components of a face.
//!
//! This trait is public in name only: nobody outside the crate can name it, hold a store, or get at a slot.

#[cfg(feature = "near")]
use super::attributes::Attributes;
use super::keys::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use core::fmt::Debug;

/// A bare reference to a record.
pub trait Slot: Copy + Eq + Debug {}

impl<T: Copy + Eq + Debug> Slot for T {}

/// The link that a vertex keeps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexLink<H, B> {
    /// A half-edge that leaves it.
    Leaving(H),
    /// The boundary component that it is.
    Isolated(B),
}

/// The start of a boundary component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BoundaryStart<H, V> {
    /// A half-edge of its cycle.
    HalfEdge(H),
    /// The isolated vertex that it is.
    Vertex(V),
}

/// The number of records of each kind that an operator is about to add.
///
/// Code outside the crate that is generic over a store could call [`Links::with_room`] without naming it. It cannot, because
/// it has no way to make a `Need`: there is deliberately no `Default`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Need {
    /// Vertices.
    pub vertices: usize,
    /// Edges: pairs of half-edges.
    pub edges: usize,
    /// Boundary components.
    pub boundaries: usize,
    /// Faces.
    pub faces: usize,
}

impl Need {
    pub(crate) const NONE: Self = Self { vertices: 0, edges: 0, boundaries: 0, faces: 0 };
}

/// The kind of record for which there is no room.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum RecordKind {
    /// Vertices.
    Vertex,
    /// Edges: pairs of half-edges.
    Edge,
    /// Boundary components.
    Boundary,
    /// Faces.
    Face,
}

impl core::fmt::Display for RecordKind {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(match self {
            Self::Vertex => "vertices",
            Self::Edge => "edges",
            Self::Boundary => "boundary components",
            Self::Face => "faces",
        })
    }
}

/// Checks that so many more records fit into a store with room for `most`; the first kind that does not is named.
pub(super) fn room<S: Links>(store: &S, more: Need, most: Need) -> Result<(), RecordKind> {
    let checks = [
        (RecordKind::Vertex, store.vertex_count(), more.vertices, most.vertices),
        (RecordKind::Edge, store.edge_count(), more.edges, most.edges),
        (RecordKind::Boundary, store.boundary_count(), more.boundaries, most.boundaries),
        (RecordKind::Face, store.face_count(), more.faces, most.faces),
    ];
    match checks.into_iter().find(|(_, count, more, most)| count.saturating_add(*more) > *most) {
        Some((kind, ..)) => Err(kind),
        None => Ok(()),
    }
}

/// The interface between `Dcel` and the stores. Every slot handed in must be live.
#[allow(missing_docs, reason = "getters and setters of the links of each record, by their names")]
pub trait Links: Sized {
    type Vertex: Slot;
    type HalfEdge: Slot;
    type Boundary: Slot;
    type Face: Slot;

    /// True if somebody takes the log of attributes after each operator.
    #[cfg(feature = "near")]
    const RECORDS: bool = false;

    /// The attributes, if there are any, to which operators announce what they do.
    #[cfg(feature = "near")]
    fn attributes(&self) -> Option<&Attributes> {
        None
    }
    #[cfg(feature = "near")]
    fn attributes_mut(&mut self) -> Option<&mut Attributes> {
        None
    }
    /// A copy of the records in the same slots, without attributes, by stores that keep some.
    #[cfg(feature = "near")]
    fn trial(&self) -> Option<Self> {
        None
    }

    /// A store with the unbounded face and nothing else, with room for that many records where it allocates.
    fn with_room(need: Need) -> Self;
    /// The unbounded face.
    fn unbounded(&self) -> Self::Face;
    /// Checks that so many more records fit; the kind that does not is named.
    fn room_for(&self, need: Need) -> Result<(), RecordKind>;

    fn find_vertex(&self, key: VertexKey) -> Option<Self::Vertex>;
    fn find_half_edge(&self, key: HalfEdgeKey) -> Option<Self::HalfEdge>;
    fn find_boundary(&self, key: BoundaryKey) -> Option<Self::Boundary>;
    fn find_face(&self, key: FaceKey) -> Option<Self::Face>;

    fn vertex_key(&self, v: Self::Vertex) -> VertexKey;
    fn half_edge_key(&self, h: Self::HalfEdge) -> HalfEdgeKey;
    fn boundary_key(&self, b: Self::Boundary) -> BoundaryKey;
    fn face_key(&self, f: Self::Face) -> FaceKey;

    /// Live records, for counting.
    fn vertex_count(&self) -> usize;
    fn edge_count(&self) -> usize;
    fn boundary_count(&self) -> usize;
    fn face_count(&self) -> usize;

    /// Indices are below these.
    fn vertex_slots(&self) -> usize;
    fn half_edge_slots(&self) -> usize;
    fn boundary_slots(&self) -> usize;
    fn face_slots(&self) -> usize;

    /// The live record with this index.
    fn vertex_at(&self, index: usize) -> Option<Self::Vertex>;
    fn half_edge_at(&self, index: usize) -> Option<Self::HalfEdge>;
    fn boundary_at(&self, index: usize) -> Option<Self::Boundary>;
    fn face_at(&self, index: usize) -> Option<Self::Face>;

    /// The links of the half-edge with this index, for the validator. Answers for vacant slots are unspecified.
    fn origin_in(&self, index: usize) -> Option<usize> {
        Some(self.vertex_index(self.origin(self.half_edge_at(index)?)))
    }
    fn twin_in(&self, index: usize) -> Option<usize> {
        Some(self.half_edge_index(self.twin(self.half_edge_at(index)?)))
    }
    fn next_in(&self, index: usize) -> Option<usize> {
        Some(self.half_edge_index(self.next(self.half_edge_at(index)?)))
    }
    fn prev_in(&self, index: usize) -> Option<usize> {
        Some(self.half_edge_index(self.prev(self.half_edge_at(index)?)))
    }
    fn boundary_in(&self, index: usize) -> Option<usize> {
        Some(self.boundary_index(self.boundary(self.half_edge_at(index)?)))
    }

    fn vertex_index(&self, v: Self::Vertex) -> usize;
    fn half_edge_index(&self, h: Self::HalfEdge) -> usize;
    fn boundary_index(&self, b: Self::Boundary) -> usize;
    fn face_index(&self, f: Self::Face) -> usize;

    /// Adds a vertex. The caller has asked for room, here and below.
    fn add_vertex(&mut self, link: VertexLink<Self::HalfEdge, Self::Boundary>) -> Self::Vertex;
    /// Adds an isolated vertex together with the inner boundary component that it is.
    fn add_isolated(&mut self, f: Self::Face) -> (Self::Vertex, Self::Boundary);
    /// Adds an edge: two half-edges that are each other's twin, next and prev. Gives the one that leaves `from`.
    fn add_edge(&mut self, from: Self::Vertex, to: Self::Vertex, b: Self::Boundary) -> Self::HalfEdge;
    /// Adds a boundary component that no face lists yet.
    fn add_boundary(&mut self, f: Self::Face, start: BoundaryStart<Self::HalfEdge, Self::Vertex>) -> Self::Boundary;
    /// Adds a face without boundary components.
    fn add_face(&mut self) -> Self::Face;

    fn remove_vertex(&mut self, v: Self::Vertex);
    /// Removes a half-edge and its twin.
    fn remove_edge(&mut self, h: Self::HalfEdge);
    /// Removes a boundary component that no face lists.
    fn remove_boundary(&mut self, b: Self::Boundary);
    /// Removes a face without inner boundary components.
    fn remove_face(&mut self, f: Self::Face);

    fn origin(&self, h: Self::HalfEdge) -> Self::Vertex;
    fn twin(&self, h: Self::HalfEdge) -> Self::HalfEdge;
    fn next(&self, h: Self::HalfEdge) -> Self::HalfEdge;
    fn prev(&self, h: Self::HalfEdge) -> Self::HalfEdge;
    fn boundary(&self, h: Self::HalfEdge) -> Self::Boundary;
    fn vertex_link(&self, v: Self::Vertex) -> VertexLink<Self::HalfEdge, Self::Boundary>;
    fn face(&self, b: Self::Boundary) -> Self::Face;
    fn start(&self, b: Self::Boundary) -> BoundaryStart<Self::HalfEdge, Self::Vertex>;
    fn place(&self, b: Self::Boundary) -> u32;
    fn outer(&self, f: Self::Face) -> Option<Self::Boundary>;
    /// Returns the start of the outer boundary component.
    fn outer_half_edge(&self, f: Self::Face) -> Option<Self::HalfEdge> {
        match self.start(self.outer(f)?) {
            BoundaryStart::HalfEdge(h) => Some(h),
            BoundaryStart::Vertex(_) => None,
        }
    }
    fn inner_count(&self, f: Self::Face) -> usize;
    fn inner(&self, f: Self::Face, position: usize) -> Option<Self::Boundary>;

    fn set_origin(&mut self, h: Self::HalfEdge, v: Self::Vertex);
    /// Makes `n` follow `h` on its cycle: sets `next(h)` and `prev(n)`.
    fn join(&mut self, h: Self::HalfEdge, n: Self::HalfEdge);
    fn set_boundary(&mut self, h: Self::HalfEdge, b: Self::Boundary);
    fn set_vertex_link(&mut self, v: Self::Vertex, link: VertexLink<Self::HalfEdge, Self::Boundary>);
    fn set_start(&mut self, b: Self::Boundary, start: BoundaryStart<Self::HalfEdge, Self::Vertex>);
    fn set_place(&mut self, b: Self::Boundary, place: u32);

    /// Makes `b`, a cycle, the outer boundary component of `f`.
    fn list_outer(&mut self, f: Self::Face, b: Self::Boundary);
    /// Appends `b` to the inner boundary components of `f`.
    fn list_inner(&mut self, f: Self::Face, b: Self::Boundary);
    /// Takes `b` off the lists of its face. The last inner boundary component takes the place that becomes free. O(1).
    fn unlist(&mut self, b: Self::Boundary);
}

/// A place for records to live. The trait is sealed: the stores are those of this module, and only a
/// [`Dcel`](crate::dcel::Dcel) holds one.
///
/// ```compile_fail,E0277
/// fn bare<S: twinedge::store::Store>() -> S {
///     S::with_room(Default::default())
/// }
/// ```
pub trait Store: Links {}

/// A store whose records can have [attributes](crate::dcel::Attribute): the default one, alone or in a history.
#[cfg(feature = "near")]
pub trait AttributeStore: Store {
    #[doc(hidden)]
    fn kept_attributes(&mut self) -> &mut Attributes;
}
