//! How sentences name records: by their indices, or as the owner of the structure names them.

use super::record::Record;
use super::view::Link;
use core::fmt;

/// Writes the name of a record, without its kind.
pub(super) type WriteName<'a> = &'a dyn Fn(Record, &mut fmt::Formatter<'_>) -> fmt::Result;

/// How sentences name records.
#[derive(Clone, Copy)]
pub(super) struct Names<'a>(pub(super) Option<WriteName<'a>>);

/// The name of one record, with or without its kind. A link may be nil.
pub(super) struct Name<'a> {
    names: Names<'a>,
    record: Option<Record>,
    with_kind: bool,
}

impl<'a> Names<'a> {
    /// The index of each record is its name.
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

    /// A link to a record of this kind.
    pub(super) fn link(self, kind: fn(usize) -> Record, link: Link) -> Name<'a> {
        Name { names: self, record: link.map(kind), with_kind: false }
    }

    /// A record, with its kind.
    pub(super) const fn record(self, record: Record) -> Name<'a> {
        Name { names: self, record: Some(record), with_kind: true }
    }
}

impl fmt::Display for Name<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(record) = self.record else { return f.write_str("nil") };
        if self.with_kind {
            write!(f, "{} ", record.kind())?;
        }
        match self.names.0 {
            Some(write_name) => write_name(record, f),
            None => write!(f, "{}", record.index()),
        }
    }
}
