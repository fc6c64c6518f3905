//! The columns of a certificate.

use alloc::vec::Vec;
use core::fmt;

/// The number that marks a vacant slot, in the first column of its kind of record.
pub const VACANT: u32 = u32::MAX - 1;
/// A link that leads nowhere, for a structure whose own number for it does not fit into 32 bits.
pub(super) const DEAD: u32 = u32::MAX - 2;
/// The greatest number of slots that can be numbered.
pub(super) const MOST_SLOTS: usize = DEAD as usize;

macro_rules! columns {
    ($($(#[$doc:meta])* $column:ident $name:literal,)*) => {
        /// A column of a certificate: a number for each record of one kind. `proofs/coq/CERTIFICATE.md` describes each.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
        #[non_exhaustive]
        pub enum Column {
            $($(#[$doc])* $column,)*
        }

        impl Column {
            /// All columns.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$column),*];

            /// Returns the name of the column: its file name without `.u32`.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { $(Self::$column => $name,)* }
            }
        }
    };
}

columns! {
    /// The vertex that the half-edge leaves.
    HalfEdgeOrigin "half_edge_origin",
    /// The other half-edge of the edge.
    HalfEdgeTwin "half_edge_twin",
    /// The next half-edge on the cycle.
    HalfEdgeNext "half_edge_next",
    /// The previous half-edge on the cycle.
    HalfEdgePrev "half_edge_prev",
    /// The boundary component of the half-edge.
    HalfEdgeBoundary "half_edge_boundary",
    /// The rank of the half-edge: always a label.
    HalfEdgeRank "half_edge_rank",
    /// A half-edge that leaves the vertex, or nil if it is isolated.
    VertexLeaving "vertex_leaving",
    /// The boundary component of the vertex, if it is isolated, or nil.
    VertexIsolated "vertex_isolated",
    /// The face of the boundary component.
    BoundaryFace "boundary_face",
    /// A half-edge of the boundary component, or nil.
    BoundaryStart "boundary_start",
    /// The isolated vertex of the boundary component, or nil.
    BoundaryVertex "boundary_vertex",
    /// The position among the inner boundary components of the face, or nil if it is the outer one.
    BoundaryPlace "boundary_place",
    /// The outer boundary component of the face, or nil for the unbounded face.
    FaceOuter "face_outer",
    /// The end of the list of the face in the next column; it begins at the end of the previous face's list.
    FaceEnd "face_end",
    /// The inner boundary components of the faces, face after face.
    FaceInner "face_inner",
    /// Drawing: the other dart of the edge.
    DartTwin "dart_twin",
    /// Drawing: the point at which the dart starts.
    DartPoint "dart_point",
    /// Drawing: the half-edge on the dart, or nil if its edge is added.
    DartHalfEdge "dart_half_edge",
    /// Drawing: the half-edge on the first dart with one, counter-clockwise from this dart, inclusive.
    DartAhead "dart_ahead",
    /// Drawing: the face that contains the triangle of the dart.
    DartFace "dart_face",
    /// Drawing: the rank of the dart.
    DartRank "dart_rank",
    /// Drawing: the dart under the half-edge.
    HalfEdgeDart "half_edge_dart",
    /// Drawing: a dart that starts at the vertex.
    VertexDart "vertex_dart",
    /// Drawing: the dart of the face to which its ranks lead.
    FaceDart "face_dart",
    /// On surfaces: the position of the half-edge in its rotation.
    HalfEdgeTurn "half_edge_turn",
    /// On surfaces: the position of the half-edge on its cycle.
    HalfEdgeStep "half_edge_step",
    /// On surfaces: the half-edge that is the root of the component. The last entry also applies to all later half-edges.
    HalfEdgeComponent "half_edge_component",
    /// On surfaces: the half-edge of a hole that leaves the vertex, or nil.
    VertexBorder "vertex_border",
}

impl Column {
    /// Returns the columns of a certificate of a plane subdivision.
    #[must_use]
    pub fn of_subdivision() -> &'static [Self] {
        &Self::ALL[..Self::DartTwin as usize]
    }

    /// Returns the columns of a certificate of surfaces.
    #[must_use]
    pub fn of_surface() -> &'static [Self] {
        &[
            Self::HalfEdgeOrigin,
            Self::HalfEdgeTwin,
            Self::HalfEdgeNext,
            Self::HalfEdgePrev,
            Self::HalfEdgeBoundary,
            Self::HalfEdgeRank,
            Self::VertexLeaving,
            Self::BoundaryFace,
            Self::BoundaryStart,
            Self::FaceOuter,
            Self::HalfEdgeTurn,
            Self::HalfEdgeStep,
            Self::HalfEdgeComponent,
            Self::VertexBorder,
        ]
    }

    /// Returns the columns of a [`Drawing`](super::Drawing).
    #[must_use]
    pub fn of_drawing() -> &'static [Self] {
        &Self::ALL[Self::DartTwin as usize..Self::HalfEdgeTurn as usize]
    }
}

/// The additions of a certificate: the rank of each half-edge, and a column for each link that the structure does not store.
///
/// The numbers may be arbitrary: [`check`](super::check()) decides. Unneeded columns are empty. In a column `u32::MAX` is nil.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Labels {
    columns: [Vec<u32>; Column::ALL.len()],
}

impl Labels {
    /// Returns the column; empty if the structure stores it.
    #[must_use]
    pub fn column(&self, column: Column) -> &[u32] {
        &self.columns[column as usize]
    }

    /// Returns the column for changes of any kind.
    pub fn column_mut(&mut self, column: Column) -> &mut Vec<u32> {
        &mut self.columns[column as usize]
    }
}

/// The reason why a structure has no labels, or no certificate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum LabelsError {
    /// The structure stores faces without lists of inner boundary components or without an unbounded face: its nesting is
    /// undetermined.
    NoContainment,
    /// This half-edge names another face than its boundary component does. A certificate would not cover the name.
    FaceOfHalfEdge(usize),
    /// This face names half-edges or vertices that are not on its boundary components. A certificate would not cover them.
    StartsOfFace(usize),
    /// The structure has more records than 32 bits can number.
    TooLarge,
    /// There is no memory for the labels.
    OutOfMemory,
}

impl fmt::Display for LabelsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoContainment => {
                f.write_str("the structure has faces, but no lists of inner boundary components or no unbounded face")
            }
            Self::FaceOfHalfEdge(h) => write!(f, "half-edge {h} names another face than its boundary component"),
            Self::StartsOfFace(face) => {
                write!(f, "face {face} names half-edges or vertices that are not on its boundary components")
            }
            Self::TooLarge => f.write_str("the structure has more records than 32 bits can number"),
            Self::OutOfMemory => f.write_str("there is no memory for the labels"),
        }
    }
}

impl core::error::Error for LabelsError {}
