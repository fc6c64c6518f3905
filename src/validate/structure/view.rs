//! The validator's view of a structure: one trait, whose methods take and return plain indices.

use super::parts::Parts;

/// A link as a structure stores it: `None` is nil, `Some(i)` leads to the record with index `i`, if there is one.
///
/// The validator trusts no link. An index past the end, or of a vacant record, merely violates R1. A structure with generational keys
/// answers `Some(usize::MAX)` for a stale key.
pub type Link = Option<usize>;

/// The start of a boundary component: a half-edge of its cycle, or an isolated vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Start {
    /// A half-edge of the cycle.
    HalfEdge(usize),
    /// The isolated vertex that forms the boundary component.
    Vertex(usize),
}

/// The place in the lists of its face that a boundary component claims.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum BoundaryPlace {
    /// The outer boundary component.
    Outer,
    /// This position in the list of inner boundary components.
    Inner(usize),
}

/// A half-edge structure as the validator sees it: records with dense indices, and the links between them.
///
/// Implement it for your own structure, and pass that to [`validate`](crate::validate::validate); nothing is copied. Every kind of
/// record has *slots* `0 .. n`. If slots can be vacant, the methods `is_…` tell which slots are live; answers for vacant slots are
/// unspecified. [`parts`](Self::parts) lists the stored parts; the methods for all others can keep their defaults.
///
/// | your faces store | implement | `parts` |
/// | --- | --- | --- |
/// | boundary component records (CGAL's CCBs) | `boundary…`, `outer`, `inner` | [`Parts::ALL`] |
/// | half-edges of every cycle, and of an unbounded face (the textbook's tables) | `face`, `outer_half_edge`, `inner_start` | `Parts::ALL.without(Part::BoundaryComponents)` |
/// | one half-edge (most meshes) | `face`, `outer_half_edge` | `Parts::NONE.with(Part::Faces)` |
/// | nothing: twins and rotations only | none of these | [`Parts::NONE`] |
///
/// If half-edges name their face and faces store nothing, [`adapt::FaceLabels`](crate::validate::adapt::FaceLabels) answers
/// `outer_half_edge` and `inner_start`. Without [`Part::Faces`](super::Part::Faces) the names of faces are not checked. The table of
/// [`adapt`](crate::validate::adapt) covers other structures: half-edges that store their target, borders without `next`, keys instead
/// of indices.
///
/// No answer makes the validator panic or loop, even if answers change from call to call. The validator only asks about slots below the
/// numbers of slots, and positions below `inner_count`, so `self.next[half_edge]` is a valid implementation.
///
/// References and boxes of views are views. [`delegate_view!`](crate::delegate_view) writes a view that changes a few answers of
/// another one.
///
/// ```
/// use twinedge::validate::{Collect, Expectation, Link, Parts, View, validate};
///
/// /// One edge between two vertices.
/// struct Edge;
///
/// impl View for Edge {
///     fn parts(&self) -> Parts { Parts::NONE }
///     fn vertex_slots(&self) -> usize { 2 }
///     fn half_edge_slots(&self) -> usize { 2 }
///     fn origin(&self, half_edge: usize) -> Link { Some(half_edge) }
///     fn twin(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
///     fn next(&self, half_edge: usize) -> Link { Some(1 - half_edge) }
/// }
///
/// assert!(validate(&Edge, &Expectation::plane(), Collect::All).is_valid());
/// ```
pub trait View {
    /// Lends the links of half-edges as columns, if the structure stores them that way. They must equal the answers of the other
    /// methods: the validator then reads half-edges from the columns, in about half the time, and calls the other methods for
    /// everything else.
    ///
    /// The columns are only used if origin, next, prev, and the boundary component or face are all lent, the twin of `h` is `h ^ 1`,
    /// and all half-edges from the first live one on are live. If columns and answers differ, the report is meaningless, but nothing
    /// worse happens.
    ///
    /// A view that changes another view's answers about half-edges must not lend its columns.
    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        None
    }

    /// Returns the parts that the structure stores besides `origin`, `twin` and `next`. Rules about other parts are not checked, and
    /// the report says so.
    ///
    /// On [surfaces](super::super::Expectation::surface) lists of holes and an unbounded face are ignored, stored or not.
    fn parts(&self) -> Parts;

    /// Returns the number of slots for vertices: their indices are `0 .. vertex_slots()`.
    fn vertex_slots(&self) -> usize;
    /// Returns the number of slots for half-edges.
    fn half_edge_slots(&self) -> usize;
    /// Returns the number of slots for boundary components.
    fn boundary_slots(&self) -> usize {
        0
    }
    /// Returns the number of slots for faces.
    fn face_slots(&self) -> usize {
        0
    }

    /// Returns true if the slot holds a vertex.
    fn is_vertex(&self, vertex: usize) -> bool {
        vertex < self.vertex_slots()
    }
    /// Returns true if the slot holds a half-edge.
    fn is_half_edge(&self, half_edge: usize) -> bool {
        half_edge < self.half_edge_slots()
    }
    /// Returns true if the slot holds a boundary component.
    fn is_boundary(&self, boundary: usize) -> bool {
        boundary < self.boundary_slots()
    }
    /// Returns true if the slot holds a face.
    fn is_face(&self, face: usize) -> bool {
        face < self.face_slots()
    }

    /// Returns the vertex where the half-edge starts. [`adapt::Targets`](crate::validate::adapt::Targets) answers if half-edges store
    /// their targets instead.
    fn origin(&self, half_edge: usize) -> Link;
    /// Returns the other half-edge of the same edge.
    fn twin(&self, half_edge: usize) -> Link;
    /// Returns the half-edge that follows on the same cycle.
    fn next(&self, half_edge: usize) -> Link;
    /// Returns the half-edge that precedes on the same cycle.
    fn prev(&self, half_edge: usize) -> Link {
        let _ = half_edge;
        None
    }
    /// Returns the boundary component of the half-edge.
    fn boundary(&self, half_edge: usize) -> Link {
        let _ = half_edge;
        None
    }
    /// Returns the face to the left of the half-edge, for structures without boundary component records.
    fn face(&self, half_edge: usize) -> Link {
        let _ = half_edge;
        None
    }

    /// Returns a half-edge that leaves the vertex; nil for an isolated vertex.
    fn leaving(&self, vertex: usize) -> Link {
        let _ = vertex;
        None
    }
    /// Returns the boundary component of an isolated vertex; otherwise nil.
    fn isolated(&self, vertex: usize) -> Link {
        let _ = vertex;
        None
    }

    /// Returns the face that the boundary component bounds.
    fn boundary_face(&self, boundary: usize) -> Link {
        let _ = boundary;
        None
    }
    /// Returns the start of the boundary component.
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        let _ = boundary;
        None
    }
    /// Returns the place of the boundary component in the lists of its face.
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        let _ = boundary;
        None
    }

    /// Returns the outer boundary component of the face; nil for the unbounded face.
    fn outer(&self, face: usize) -> Link {
        let _ = face;
        None
    }
    /// Returns the number of inner boundary components that the face lists.
    fn inner_count(&self, face: usize) -> usize {
        let _ = face;
        0
    }
    /// Returns the inner boundary component at this position of the face's list.
    fn inner(&self, face: usize, position: usize) -> Link {
        let _ = (face, position);
        None
    }

    /// Returns a half-edge of the face's outer cycle, nil for the unbounded face, for structures without boundary component records.
    fn outer_half_edge(&self, face: usize) -> Link {
        let _ = face;
        None
    }
    /// Returns the start of the inner boundary component at this position of the face's list, for structures without boundary
    /// component records.
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        let _ = (face, position);
        None
    }
}

/// The links of all half-edges as columns of slots, as lent by [`View::half_edge_columns`](super::View::half_edge_columns).
///
/// The twin of half-edge `h` is `h ^ 1`. Each column has an entry for each half-edge slot, including vacant ones; columns of links that are not stored are empty. `u32::MAX`
/// is nil.
#[derive(Clone, Copy, Debug)]
pub struct HalfEdgeColumns<'a> {
    /// The vertex where each half-edge starts.
    pub origin: &'a [u32],
    /// The next half-edge of each half-edge.
    pub next: &'a [u32],
    /// The previous half-edge of each half-edge.
    pub prev: &'a [u32],
    /// The boundary component that each half-edge names.
    pub boundary: &'a [u32],
    /// The face that each half-edge names.
    pub face: &'a [u32],
    /// An odd number for each live edge (the edge of half-edges `2e` and `2e + 1`), and an even one for each vacant edge; `None` if no
    /// half-edge slot is vacant.
    pub live_edges: Option<&'a [u32]>,
}
