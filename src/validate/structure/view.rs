//! The structure as the validator sees it: one trait, whose methods take and return plain indices.

use super::columns::HalfEdgeColumns;
use super::parts::Parts;

/// A link as a structure stores it: `None` is nil, `Some(i)` leads to the record with index `i`, if there is one.
///
/// The validator trusts no link. An index past the end, or of a record that is not live, is a violation of R1 and
/// nothing worse. A structure with generational keys answers `Some(usize::MAX)` for a stale key.
pub type Link = Option<usize>;

/// The start of a boundary component: a half-edge of its cycle, or the isolated vertex that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Start {
    /// A half-edge of the cycle.
    HalfEdge(usize),
    /// The isolated vertex that is the whole boundary component.
    Vertex(usize),
}

/// The place at which a boundary component says that its face lists it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum BoundaryPlace {
    /// It is the outer boundary component.
    Outer,
    /// It is at this position of the list of inner ones.
    Inner(usize),
}

/// A half-edge structure as the validator sees it: records with dense indices, and the links between them.
///
/// Implement it for a structure of your own and pass that to [`validate`](crate::validate::validate); nothing is copied. Every kind
/// of record has *slots* `0 .. n`. Where a slot may be vacant, the methods `is_…` say which slots are live; answers for vacant
/// slots are unspecified. [`parts`](Self::parts) says which parts the structure stores; the methods for all others may keep their default.
///
/// | your faces keep | implement | `parts` |
/// | --- | --- | --- |
/// | boundary component records (CGAL's CCBs) | `boundary…`, `outer`, `inner` | [`Parts::ALL`] |
/// | half-edges of every cycle, and of an unbounded face (the textbook's tables) | `face`, `outer_half_edge`, `inner_start` | `Parts::ALL.without(Part::BoundaryComponents)` |
/// | one half-edge (most meshes) | `face`, `outer_half_edge` | `Parts::NONE.with(Part::Faces)` |
/// | nothing: twins and rotations only | none of these | [`Parts::NONE`] |
///
/// Where half-edges name their face and faces keep nothing, [`adapt::FaceLabels`](crate::validate::adapt::FaceLabels) answers
/// `outer_half_edge` and `inner_start`. Without [`Part::Faces`](super::Part::Faces) the names of the faces would not be
/// checked. The table of [`adapt`](crate::validate::adapt) says what to do with other structures: half-edges that keep their target,
/// borders without `next`, keys instead of indices.
///
/// No answer makes the validator panic or loop, not even answers that change from call to call. It asks only about slots
/// below the numbers of slots, and about positions below `inner_count`, so `self.next[half_edge]` is a fine answer.
///
/// References and boxes of views are views. [`delegate_view!`](crate::delegate_view) writes a view that differs from another
/// one in a few answers.
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
    /// Lends the links of half-edges as columns, if the structure keeps them so. The validator then reads half-edges from the columns, in
    /// about half the time, and asks the other methods about everything else.
    ///
    /// The columns must hold the links that the other methods answer. If they hold others, the report says nothing about either, and
    /// nothing worse happens. The validator reads them only if the twin of `h` is `h ^ 1`, if `origin`, `next`, `prev` and the boundary component
    /// or the face are all lent, and if all half-edges from the first live one on are live.
    ///
    /// A view that differs from another one in an answer about half-edges must not lend the other one's columns.
    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        None
    }

    /// The parts that the structure stores beside `origin`, `twin` and `next`. Rules about others are not checked, and the report
    /// says so.
    ///
    /// On [surfaces](super::super::Expectation::surface) lists of holes and an unbounded face are not looked at, stored or not.
    fn parts(&self) -> Parts;

    /// The number of slots for vertices: their indices are `0 .. vertex_slots()`.
    fn vertex_slots(&self) -> usize;
    /// The number of slots for half-edges.
    fn half_edge_slots(&self) -> usize;
    /// The number of slots for boundary components.
    fn boundary_slots(&self) -> usize {
        0
    }
    /// The number of slots for faces.
    fn face_slots(&self) -> usize {
        0
    }

    /// True if the slot holds a vertex.
    fn is_vertex(&self, vertex: usize) -> bool {
        vertex < self.vertex_slots()
    }
    /// True if the slot holds a half-edge.
    fn is_half_edge(&self, half_edge: usize) -> bool {
        half_edge < self.half_edge_slots()
    }
    /// True if the slot holds a boundary component.
    fn is_boundary(&self, boundary: usize) -> bool {
        boundary < self.boundary_slots()
    }
    /// True if the slot holds a face.
    fn is_face(&self, face: usize) -> bool {
        face < self.face_slots()
    }

    /// The vertex where the half-edge starts. Where half-edges keep the vertex in which they end,
    /// [`adapt::Targets`](crate::validate::adapt::Targets) answers.
    fn origin(&self, half_edge: usize) -> Link;
    /// The other half-edge of the same edge.
    fn twin(&self, half_edge: usize) -> Link;
    /// The half-edge that follows on the same cycle.
    fn next(&self, half_edge: usize) -> Link;
    /// The half-edge that precedes on the same cycle.
    fn prev(&self, half_edge: usize) -> Link {
        let _ = half_edge;
        None
    }
    /// The boundary component that the half-edge is part of.
    fn boundary(&self, half_edge: usize) -> Link {
        let _ = half_edge;
        None
    }
    /// The face to the left of the half-edge, for structures without boundary component records.
    fn face(&self, half_edge: usize) -> Link {
        let _ = half_edge;
        None
    }

    /// A half-edge that leaves the vertex; nil if it is isolated.
    fn leaving(&self, vertex: usize) -> Link {
        let _ = vertex;
        None
    }
    /// The boundary component that the vertex is, if it is isolated; nil if not.
    fn isolated(&self, vertex: usize) -> Link {
        let _ = vertex;
        None
    }

    /// The face that the boundary component bounds.
    fn boundary_face(&self, boundary: usize) -> Link {
        let _ = boundary;
        None
    }
    /// Returns the start of the boundary component.
    fn boundary_start(&self, boundary: usize) -> Option<Start> {
        let _ = boundary;
        None
    }
    /// The place that the boundary component takes in its face's list.
    fn boundary_place(&self, boundary: usize) -> Option<BoundaryPlace> {
        let _ = boundary;
        None
    }

    /// The outer boundary component of the face; nil for the unbounded face.
    fn outer(&self, face: usize) -> Link {
        let _ = face;
        None
    }
    /// Returns the number of inner boundary components that the face lists.
    fn inner_count(&self, face: usize) -> usize {
        let _ = face;
        0
    }
    /// The inner boundary component at this position of the face's list.
    fn inner(&self, face: usize, position: usize) -> Link {
        let _ = (face, position);
        None
    }

    /// A half-edge of the face's outer cycle, nil for the unbounded face, for structures without boundary component records.
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
