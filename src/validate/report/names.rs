//! Records and their fields, and their names in sentences: indices, or the owner's names.

use crate::validate::structure::{BoundaryPlace, Link};
use core::fmt;

/// Writes the name of a record, without its kind.
pub(super) type WriteName<'a> = &'a dyn Fn(Record, &mut fmt::Formatter<'_>) -> fmt::Result;

#[derive(Clone, Copy)]
pub(super) struct Names<'a>(pub(super) Option<WriteName<'a>>);

/// The name of one record, preceded by words. A link may be nil.
pub(super) struct Name<'a> {
    names: Names<'a>,
    record: Option<Record>,
    before: Before,
}

#[derive(Clone, Copy)]
enum Before {
    Nothing,
    /// The kind of the record.
    Kind,
    /// The kind of the record; for a half-edge, its cycle.
    CycleOf,
    /// The record is, or lies on, this boundary component.
    Component(&'static str),
}

pub(super) struct Ends<'a>(pub(super) [Name<'a>; 2]);

pub(super) struct PlaceText(pub(super) Option<BoundaryPlace>);

impl<'a> Names<'a> {
    /// Indices as names.
    pub(super) const INDICES: Self = Self(None);

    pub(super) fn vertex(self, index: usize) -> Name<'a> {
        self.link(Record::Vertex, Some(index))
    }

    pub(super) fn half_edge(self, index: usize) -> Name<'a> {
        self.link(Record::HalfEdge, Some(index))
    }

    pub(super) fn boundary(self, index: usize) -> Name<'a> {
        self.link(Record::Boundary, Some(index))
    }

    pub(super) fn face(self, index: usize) -> Name<'a> {
        self.link(Record::Face, Some(index))
    }

    pub(super) fn link(self, kind: fn(usize) -> Record, link: Link) -> Name<'a> {
        Name { names: self, record: link.map(kind), before: Before::Nothing }
    }

    pub(super) const fn record(self, record: Record) -> Name<'a> {
        Name { names: self, record: Some(record), before: Before::Kind }
    }

    pub(super) const fn cycle_of(self, record: Record) -> Name<'a> {
        Name { names: self, record: Some(record), before: Before::CycleOf }
    }

    /// A boundary component, by its own record, or by the half-edge or vertex that its face lists.
    pub(super) const fn component(self, which: &'static str, record: Record) -> Name<'a> {
        Name { names: self, record: Some(record), before: Before::Component(which) }
    }
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(record) = self.record else { return f.write_str("nil") };
        match (self.before, record) {
            (Before::Nothing, _) => {}
            (Before::CycleOf, Record::HalfEdge(_)) => write!(f, "the cycle of {} ", record.kind())?,
            (Before::Component(which), Record::Boundary(_)) => write!(f, "the {which} {} ", record.kind())?,
            (Before::Component(which), _) => write!(f, "the {which} boundary component at {} ", record.kind())?,
            (Before::Kind | Before::CycleOf, _) => write!(f, "{} ", record.kind())?,
        }
        match self.names.0 {
            Some(write_name) => write_name(record, f),
            None => write!(f, "{}", record.index()),
        }
    }
}

impl fmt::Display for Ends<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [one, other] = &self.0;
        write!(f, "{one} and {other}")
    }
}

impl fmt::Display for PlaceText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(BoundaryPlace::Outer) => f.write_str("the outer one"),
            Some(BoundaryPlace::Inner(i)) => write!(f, "inner position {i}"),
            None => f.write_str("no place"),
        }
    }
}

/// A number with its noun: `1 map`, `2 maps`.
pub(super) struct Number(pub(super) u64, pub(super) &'static str, pub(super) &'static str);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(number, one, many) = *self;
        write!(f, "{number} {}", if number == 1 { one } else { many })
    }
}

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
