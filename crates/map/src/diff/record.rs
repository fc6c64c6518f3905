//! Records by their ids, and changes to records.

use std::{fmt, mem};
use twinedge::dcel::extend::Kind;
use twinedge_geometry::Point;

/// A record by its id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Record {
    /// A vertex.
    Vertex(u128),
    /// An edge, by its ends: the smaller id first.
    Edge(u128, u128),
    /// A bounded face.
    Face(u128),
    /// The unbounded face.
    Unbounded,
    /// A feature, by its number.
    Feature(usize),
}

impl Record {
    pub(super) const fn kind(self) -> Kind {
        match self {
            Self::Vertex(_) => Kind::Vertex,
            Self::Edge(..) => Kind::Edge,
            Self::Face(_) | Self::Unbounded => Kind::Face,
            Self::Feature(_) => Kind::Other,
        }
    }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vertex(v) => write!(f, "vertex {v}"),
            Self::Edge(a, b) => write!(f, "edge {a}-{b}"),
            Self::Face(id) => write!(f, "face {id}"),
            Self::Unbounded => f.write_str("the unbounded face"),
            Self::Feature(number) => write!(f, "feature {number}"),
        }
    }
}

/// A change to a record.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum Change {
    /// A vertex, an edge, a face or a feature was dropped.
    Dropped,
    /// A vertex moved.
    Moved {
        /// The old coordinates.
        from: Point,
        /// The new coordinates.
        to: Point,
    },
    /// A vertex was added at a point.
    Added(Point),
    /// An edge was drawn.
    Drawn,
    /// A face was made, with these vertices on its outer boundary, counter-clockwise.
    Made(Vec<u128>),
    /// The outer boundary of a face changed to these vertices, counter-clockwise.
    Reshaped(Vec<u128>),
    /// The features of a face or an edge changed. Features are given by number.
    Features {
        /// The old features.
        from: Vec<usize>,
        /// The new features.
        to: Vec<usize>,
    },
    /// The value of an attribute changed.
    Value {
        /// The name of the attribute.
        name: String,
        /// The old value, if any.
        from: Option<String>,
        /// The new value, if any.
        to: Option<String>,
    },
}

impl Change {
    /// Returns the position in the order of application, or `None` for a change that does not apply to this kind of record.
    pub(super) fn stage(&self, record: Record) -> Option<u8> {
        Some(match (self, record) {
            (Self::Dropped, Record::Edge(..)) => 0,
            (Self::Dropped, Record::Vertex(_)) => 1,
            (Self::Moved { .. }, Record::Vertex(_)) => 2,
            (Self::Added(_), Record::Vertex(_)) => 3,
            (Self::Drawn, Record::Edge(..)) => 4,
            (Self::Dropped | Self::Made(_) | Self::Reshaped(_), Record::Face(_)) => 5,
            (Self::Features { .. }, Record::Edge(..) | Record::Face(_) | Record::Unbounded) => 6,
            (Self::Value { .. }, _) => 7,
            // No record has the feature any more.
            (Self::Dropped, Record::Feature(_)) => 8,
            _ => return None,
        })
    }

    /// Returns the records that must exist for a change to a record.
    pub(super) fn needs(&self, record: Record) -> Vec<Record> {
        match (self, record) {
            (Self::Drawn, Record::Edge(a, b)) => vec![Record::Vertex(a), Record::Vertex(b)],
            (Self::Features { from, to }, _) => {
                to.iter().filter(|feature| !from.contains(feature)).map(|feature| Record::Feature(*feature)).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Returns true if two different changes to one record conflict.
    pub(super) fn excludes(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Dropped, _) | (_, Self::Dropped) => true,
            (Self::Value { name, .. }, Self::Value { name: other, .. }) => name == other,
            // Each part then has the lines of both sides.
            (Self::Reshaped(_), Self::Reshaped(_)) => false,
            _ => mem::discriminant(self) == mem::discriminant(other),
        }
    }
}

struct Text<'a>(&'a Option<String>);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(text) = self.0 { write!(f, "{text:?}") } else { f.write_str("none") }
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Dropped => f.write_str("dropped"),
            Self::Moved { from, to } => write!(f, "moved from ({}, {}) to ({}, {})", from.x, from.y, to.x, to.y),
            Self::Added(at) => write!(f, "added at ({}, {})", at.x, at.y),
            Self::Drawn => f.write_str("drawn"),
            Self::Made(outline) => write!(f, "made, around it {outline:?}"),
            Self::Reshaped(outline) => write!(f, "reshaped, around it {outline:?}"),
            Self::Features { from, to } => write!(f, "features: {from:?} -> {to:?}"),
            Self::Value { name, from, to } => write!(f, "{name}: {} -> {}", Text(from), Text(to)),
        }
    }
}
