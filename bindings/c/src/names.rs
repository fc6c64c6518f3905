//! The numbers by which callers name links, records, expectations and counts.

use crate::failure::{Failure, Status};
use std::ffi::c_int;

/// A kind of record.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Record {
    /// Vertices.
    Vertex,
    /// Half-edges.
    HalfEdge,
    /// Boundary components: CGAL's CCBs.
    Boundary,
    /// Faces.
    Face,
}

/// A link: what a column holds.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// Per half-edge: the vertex where it starts. This or `TARGET` is needed.
    Origin,
    /// Per half-edge: the vertex where it ends. Reports then speak of origins that follow: that of a half-edge is the target of its twin.
    Target,
    /// Per half-edge: the other half-edge of its edge. Without this column, the twin of half-edge `h` is `h ^ 1`, and the text of a report
    /// says so. A structure of pointers needs it.
    Twin,
    /// Per half-edge: the one that follows on its cycle. Needed.
    Next,
    /// Per half-edge: the one that precedes.
    Prev,
    /// Per half-edge: the face to its left, in structures without records of boundary components. Each face has one cycle then, the
    /// outside too. A map in the plane with several components, or with faces that have holes, needs `BOUNDARY` instead. Where the
    /// outside has no record, its half-edges have the face nil: expect `OPEN`, also with `PLANE`.
    Face,
    /// Per half-edge: its boundary component. Needs the links of boundary components, `OUTER`, `INNER_FIRST` and `INNER`.
    Boundary,
    /// Per vertex: a half-edge that leaves it.
    Leaving,
    /// Per vertex: the boundary component that it is, if it is isolated.
    Isolated,
    /// Per face: a half-edge of it, in structures without records of boundary components. Every face needs one, the outside of a plane
    /// too, if it has a record: nil is for no face. Needs `FACE`.
    FaceHalfEdge,
    /// Per face: its outer boundary component; nil for the unbounded face.
    Outer,
    /// Per face, and one more: where its list begins in `INNER`. It ends where that of the next face begins.
    InnerFirst,
    /// The inner boundary components of all faces, one list after the other.
    Inner,
    /// Per boundary component: the face that it bounds.
    BoundaryFace,
    /// Per boundary component: a half-edge of it; nil if it is an isolated vertex.
    BoundaryHalfEdge,
    /// Per boundary component: the isolated vertex that it is. Read where it has no half-edge.
    BoundaryVertex,
}

/// A claim about a structure, beyond the rules that every structure keeps.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expect {
    /// Not 0: it lies in the plane: every component has genus 0 (T3). With `BOUNDARY`, faces and components nest (F1, T1, T2): then the
    /// one unbounded face has `OUTER` nil. With `FACE`, no face is unbounded: each keeps a half-edge. Otherwise it is a surface of any genus.
    Plane,
    /// Not 0: borders are legal, where a half-edge lacks its twin or its face.
    Open,
    /// Not 0: there are no loops and no parallel edges (M2).
    Simple,
    /// Not 0: there is no border (M4).
    Closed,
    /// Not 0: a half-edge leaves every vertex (M1).
    Used,
    /// Not 0: a border vertex keeps a border half-edge (M8).
    BorderKept,
    /// Every bounded face has so many sides (M3).
    Sides,
    /// There are so many components with an edge (M5). `twinedge_count` counts isolated vertices as components, too.
    Components,
    /// There are so many border loops (M6).
    Borders,
    /// There are so many handles (M7).
    Genus,
    /// No expectation: at most so many violations are listed. All are counted. 1000 if this is not set.
    List,
}

/// A number that a report counts.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// Vertices.
    Vertices,
    /// Half-edges.
    HalfEdges,
    /// Edges: pairs of twins, and half-edges without twin.
    Edges,
    /// Faces.
    Faces,
    /// Boundary components that faces list as outer.
    OuterBoundaries,
    /// Boundary components that faces list as inner, isolated vertices included.
    InnerBoundaries,
    /// Vertices that no half-edge leaves.
    IsolatedVertices,
    /// Connected components. An isolated vertex is one.
    Components,
    /// Cycles of `next` that are no border loops.
    Cycles,
    /// Border loops.
    Borders,
    /// The sum of the genera of the components.
    Genus,
    /// Violations, listed or not.
    Violations,
}

fn find<T: Copy>(all: &[T], what: &str, number: c_int) -> Result<T, Failure> {
    let found = usize::try_from(number).ok().and_then(|i| all.get(i).copied());
    found.ok_or_else(|| Failure::new(Status::Unknown, format!("there is no {what} with the number {number}")))
}

impl Record {
    /// The number of kinds.
    pub(crate) const KINDS: usize = 4;
    const ALL: [Self; Self::KINDS] = [Self::Vertex, Self::HalfEdge, Self::Boundary, Self::Face];

    pub(crate) fn of(number: c_int) -> Result<Self, Failure> {
        find(&Self::ALL, "kind of record", number)
    }

    /// Returns the plural name.
    pub(crate) const fn names(self) -> &'static str {
        match self {
            Self::Vertex => "vertices",
            Self::HalfEdge => "half-edges",
            Self::Boundary => "boundary components",
            Self::Face => "faces",
        }
    }

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Vertex => "vertex",
            Self::HalfEdge => "half-edge",
            Self::Boundary => "boundary component",
            Self::Face => "face",
        }
    }
}

impl Link {
    /// The number of links.
    pub(crate) const KINDS: usize = 16;
    /// All links, each at the position of its number.
    pub(crate) const ALL: [Self; Self::KINDS] = [
        Self::Origin,
        Self::Target,
        Self::Twin,
        Self::Next,
        Self::Prev,
        Self::Face,
        Self::Boundary,
        Self::Leaving,
        Self::Isolated,
        Self::FaceHalfEdge,
        Self::Outer,
        Self::InnerFirst,
        Self::Inner,
        Self::BoundaryFace,
        Self::BoundaryHalfEdge,
        Self::BoundaryVertex,
    ];

    pub(crate) fn of(number: c_int) -> Result<Self, Failure> {
        find(&Self::ALL, "link", number)
    }

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Origin => "origin",
            Self::Target => "target",
            Self::Twin => "twin",
            Self::Next => "next",
            Self::Prev => "prev",
            Self::Face => "face",
            Self::Boundary => "boundary",
            Self::Leaving => "leaving",
            Self::Isolated => "isolated",
            Self::FaceHalfEdge => "face_half_edge",
            Self::Outer => "outer",
            Self::InnerFirst => "inner_first",
            Self::Inner => "inner",
            Self::BoundaryFace => "boundary_face",
            Self::BoundaryHalfEdge => "boundary_half_edge",
            Self::BoundaryVertex => "boundary_vertex",
        }
    }

    /// Returns the name of the constant in the header.
    pub(crate) fn constant(self) -> String {
        format!("TWINEDGE_LINK_{}", self.name().to_ascii_uppercase())
    }

    /// Returns the kinds of records that have the link, and to which it leads; `None` for the lists.
    pub(crate) const fn ends(self) -> Option<(Record, Record)> {
        Some(match self {
            Self::Origin | Self::Target => (Record::HalfEdge, Record::Vertex),
            Self::Twin | Self::Next | Self::Prev => (Record::HalfEdge, Record::HalfEdge),
            Self::Face => (Record::HalfEdge, Record::Face),
            Self::Boundary => (Record::HalfEdge, Record::Boundary),
            Self::Leaving => (Record::Vertex, Record::HalfEdge),
            Self::Isolated => (Record::Vertex, Record::Boundary),
            Self::FaceHalfEdge => (Record::Face, Record::HalfEdge),
            Self::Outer => (Record::Face, Record::Boundary),
            Self::BoundaryFace => (Record::Boundary, Record::Face),
            Self::BoundaryHalfEdge => (Record::Boundary, Record::HalfEdge),
            Self::BoundaryVertex => (Record::Boundary, Record::Vertex),
            Self::InnerFirst | Self::Inner => return None,
        })
    }
}

impl Expect {
    const ALL: [Self; 11] = [
        Self::Plane,
        Self::Open,
        Self::Simple,
        Self::Closed,
        Self::Used,
        Self::BorderKept,
        Self::Sides,
        Self::Components,
        Self::Borders,
        Self::Genus,
        Self::List,
    ];

    pub(crate) fn of(number: c_int) -> Result<Self, Failure> {
        find(&Self::ALL, "expectation", number)
    }
}

impl Count {
    const ALL: [Self; 12] = [
        Self::Vertices,
        Self::HalfEdges,
        Self::Edges,
        Self::Faces,
        Self::OuterBoundaries,
        Self::InnerBoundaries,
        Self::IsolatedVertices,
        Self::Components,
        Self::Cycles,
        Self::Borders,
        Self::Genus,
        Self::Violations,
    ];

    pub(crate) fn of(number: c_int) -> Result<Self, Failure> {
        find(&Self::ALL, "count", number)
    }
}
