//! The lists of the faces, as a column.

use super::columns::Columns;
use crate::Embedding;
use crate::numbers::NIL;
use twinedge::validate::{Part, Parts, Record, Start};

pub(crate) struct Listed {
    pub(crate) face: usize,
    /// The record that a report names.
    pub(crate) boundary: Record,
    pub(crate) start: Start,
    pub(crate) is_outer: bool,
}

pub(crate) struct Lists {
    pub(crate) all: Vec<Listed>,
    /// The face without an outer boundary component.
    pub(crate) unbounded: Option<usize>,
}

impl Lists {
    /// Reads the lists of the faces, up to the maximum length that F2 permits. O(n).
    pub(crate) fn of<E: Embedding + ?Sized>(embedding: &E, parts: Parts, columns: &Columns) -> Self {
        let (vertices, half_edges) = (columns.points.len(), columns.origin.len());
        let by_record = parts.has(Part::BoundaryComponents);
        let boundaries = embedding.boundary_slots();
        let most = if by_record { boundaries } else { vertices + half_edges };
        let live = |start: &Start| match *start {
            Start::HalfEdge(h) => columns.origin.get(h).is_some_and(|origin| *origin != NIL),
            Start::Vertex(v) => columns.is_vertex.get(v) == Some(&true),
        };
        let named = |b: usize| (b < boundaries).then(|| (embedding.boundary_start(b), Record::Boundary(b)));
        let itself = |start: Start| match start {
            Start::HalfEdge(h) => (Some(start), Record::HalfEdge(h)),
            Start::Vertex(v) => (Some(start), Record::Vertex(v)),
        };
        let mut lists = Self { all: Vec::new(), unbounded: None };
        for face in (0..embedding.face_slots()).filter(|f| embedding.is_face(*f)) {
            let outer = if by_record {
                embedding.outer(face).and_then(named)
            } else {
                embedding.outer_half_edge(face).map(|h| itself(Start::HalfEdge(h)))
            };
            if outer.is_none() && lists.unbounded.is_none() {
                lists.unbounded = Some(face);
            }
            let count = if parts.has(Part::Holes) { embedding.inner_count(face) } else { 0 };
            let inner = (0..count.min(most.saturating_sub(lists.all.len()))).filter_map(|i| {
                if by_record {
                    embedding.inner(face, i).and_then(named)
                } else {
                    embedding.inner_start(face, i).map(itself)
                }
            });
            let all = outer.into_iter().map(|found| (found, true)).chain(inner.map(|found| (found, false)));
            lists.all.extend(all.filter_map(|((start, boundary), is_outer)| {
                Some(Listed { face, boundary, start: start.filter(live)?, is_outer })
            }));
        }
        lists
    }
}
