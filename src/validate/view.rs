//! What the validator asks of a structure: one trait of small questions, answered with plain indices.

/// A link as a structure stores it: `None` is nil, `Some(i)` leads to the record with index `i`, if there is one.
///
/// The validator trusts no link. An index past the end, or of a record that is not live, is a violation of R1 and
/// nothing worse, so a structure with generational keys answers `Some(usize::MAX)` where it keeps a stale one.
pub type Link = Option<usize>;

/// Where a boundary component starts: on a half-edge of its cycle, or at the isolated vertex that it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Start {
    /// A half-edge of the cycle.
    HalfEdge(usize),
    /// The isolated vertex that is the whole boundary component.
    Vertex(usize),
}

/// Where a boundary component says that its face lists it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum BoundaryPlace {
    /// It is the outer boundary component.
    Outer,
    /// It stands at this position of the list of inner ones.
    Inner(usize),
}

/// A half-edge structure as the validator sees it: records with dense indices, and the links between them.
///
/// Implement it for a structure of your own, without copying anything, and hand that to [`validate`](super::validate).
/// Every kind of record has *slots* `0 .. n`; where a slot may be vacant, say which are live. What a structure does not
/// have is left at its default and named in the [`Expectation`](super::Expectation).
///
/// | your faces keep | implement | and leave out |
/// | --- | --- | --- |
/// | boundary component records (CGAL's CCBs) | `boundary…`, `outer`, `inner` | `face`, `outer_half_edge`, `inner_start` |
/// | half-edges (the textbook's tables, most meshes) | `face`, `outer_half_edge`, `inner_start` | `boundary…`, `outer`, `inner` |
/// | nothing: twins and rotations only | neither | all of these |
///
/// Where half-edges name their face and faces keep nothing at all, make them keep something first: one pass over the
/// half-edges finds one for each face, to answer `outer_half_edge`. Leaving out [`Part::Faces`](super::Part::Faces) instead
/// would leave the names unchecked.
///
/// No answer can make the validator panic or loop, not even answers that change from call to call. And it asks only
/// about slots that there are, and about positions below `inner_count`, so an answer may well be
/// `self.next[half_edge]`.
pub trait View {
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

    /// Whether there is a vertex in this slot.
    fn is_vertex(&self, vertex: usize) -> bool {
        vertex < self.vertex_slots()
    }
    /// Whether there is a half-edge in this slot.
    fn is_half_edge(&self, half_edge: usize) -> bool {
        half_edge < self.half_edge_slots()
    }
    /// Whether there is a boundary component in this slot.
    fn is_boundary(&self, boundary: usize) -> bool {
        boundary < self.boundary_slots()
    }
    /// Whether there is a face in this slot.
    fn is_face(&self, face: usize) -> bool {
        face < self.face_slots()
    }

    /// The vertex where the half-edge starts.
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
    /// Where the boundary component starts.
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
    /// How many inner boundary components the face lists.
    fn inner_count(&self, face: usize) -> usize {
        let _ = face;
        0
    }
    /// The inner boundary component at this position of the face's list.
    fn inner(&self, face: usize, position: usize) -> Link {
        let _ = (face, position);
        None
    }

    /// A half-edge of the face's outer cycle, for structures without boundary component records.
    fn outer_half_edge(&self, face: usize) -> Link {
        let _ = face;
        None
    }
    /// Where the inner boundary component at this position of the face's list starts, for structures without boundary
    /// component records.
    fn inner_start(&self, face: usize, position: usize) -> Option<Start> {
        let _ = (face, position);
        None
    }
}
