//! Records and their fields, as named in reports.

use core::fmt;

/// A record, by its kind and its index in the [`View`](crate::validate::View).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Record {
    /// A vertex.
    Vertex(usize),
    /// A half-edge.
    HalfEdge(usize),
    /// A boundary component.
    Boundary(usize),
    /// A face.
    Face(usize),
}

impl Record {
    /// Returns the index of the record.
    #[must_use]
    pub const fn index(&self) -> usize {
        match self {
            Self::Vertex(i) | Self::HalfEdge(i) | Self::Boundary(i) | Self::Face(i) => *i,
        }
    }

    /// The kind of record, as used in sentences.
    pub(super) const fn kind(self) -> &'static str {
        match self {
            Self::Vertex(_) => "vertex",
            Self::HalfEdge(_) => "half-edge",
            Self::Boundary(_) => "boundary component",
            Self::Face(_) => "face",
        }
    }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.kind(), self.index())
    }
}

/// A field of a record that holds a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Field {
    /// `origin` of a half-edge.
    Origin,
    /// `twin` of a half-edge.
    Twin,
    /// `next` of a half-edge.
    Next,
    /// `prev` of a half-edge.
    Prev,
    /// `boundary` of a half-edge.
    Boundary,
    /// `face` of a half-edge or of a boundary component.
    Face,
    /// `leaving` of a vertex.
    Leaving,
    /// `isolated` of a vertex.
    Isolated,
    /// `start` of a boundary component.
    Start,
    /// `outer` of a face.
    Outer,
    /// The entry at this position of the inner list of a face.
    Inner(usize),
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Origin => "origin",
            Self::Twin => "twin",
            Self::Next => "next",
            Self::Prev => "prev",
            Self::Boundary => "boundary component",
            Self::Face => "face",
            Self::Leaving => "leaving half-edge",
            Self::Isolated => "isolated link",
            Self::Start => "start",
            Self::Outer => "outer boundary component",
            Self::Inner(i) => return write!(f, "inner boundary component at position {i}"),
        })
    }
}
