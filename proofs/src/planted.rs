//! A subject with one fault, which a harness must notice.

use crate::operators::HandleKind;
use core::cell::Cell;
use twinedge::dcel::{Dcel, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge::delegate_view;
use twinedge::program::{CallOf, Corner, CornerOf, HandleOf, OpKind, Refusal, Subject};
use twinedge::validate::{Table, View};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Field {
    Origin,
    Next,
    Prev,
    Boundary,
    Leaving,
    Face,
    Inner,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// The values that the operator writes to this field of older records are lost.
    Loses(OpKind, Field),
    /// The operator reports success but does nothing, from this call on, counted from 0.
    Skips(OpKind, u32),
    /// The operator adds a record before it knows that it will refuse, and then retires it again.
    LeavesTrace(OpKind),
    /// A stale handle is taken for the handle of some live record.
    TakesStale(HandleKind),
}

/// The structure of the library, seen through a fault.
#[derive(Clone, Debug)]
pub(crate) struct Planted {
    dcel: Dcel,
    /// The table that the subject shows of itself.
    table: Table,
    fault: Fault,
    /// The number of calls of the skipped operator.
    calls: Cell<u32>,
}

impl Planted {
    pub(crate) fn new(dcel: Dcel, fault: Fault) -> Self {
        let table = Table::copy_of(&dcel).unwrap_or_default();
        Self { dcel, table, fault, calls: Cell::new(0) }
    }

    fn half_edge(&self, h: HalfEdgeKey) -> HalfEdgeKey {
        let deceived = self.fault == Fault::TakesStale(HandleKind::HalfEdge) && self.dcel.half_edge(h).is_err();
        self.dcel.half_edges().next().filter(|_| deceived).map_or(h, HalfEdge::key)
    }

    fn vertex(&self, v: VertexKey) -> VertexKey {
        let deceived = self.fault == Fault::TakesStale(HandleKind::Vertex) && self.dcel.vertex(v).is_err();
        self.dcel.vertices().next().filter(|_| deceived).map_or(v, Vertex::key)
    }

    fn face(&self, f: FaceKey) -> FaceKey {
        let deceived = self.fault == Fault::TakesStale(HandleKind::Face) && self.dcel.face(f).is_err();
        if deceived { self.dcel.unbounded_face().key() } else { f }
    }

    fn corner(&self, corner: CornerOf<Self>) -> CornerOf<Self> {
        match corner {
            Corner::At(h) => Corner::At(self.half_edge(h)),
            Corner::Isolated(v) => Corner::Isolated(self.vertex(v)),
        }
    }
}

/// Restores the earlier values of a field in all records that existed before.
fn lose(before: &Table, after: &mut Table, field: Field) {
    fn pairs<'a, T>(before: &'a [Option<T>], after: &'a mut [Option<T>]) -> impl Iterator<Item = (&'a T, &'a mut T)> {
        before.iter().zip(after).filter_map(|(before, after)| Some((before.as_ref()?, after.as_mut()?)))
    }
    for (old, new) in pairs(&before.half_edges, &mut after.half_edges) {
        match field {
            Field::Origin => new.origin = old.origin,
            Field::Next => new.next = old.next,
            Field::Prev => new.prev = old.prev,
            Field::Boundary => new.boundary = old.boundary,
            _ => {}
        }
    }
    for (old, new) in pairs(&before.vertices, &mut after.vertices).filter(|_| field == Field::Leaving) {
        new.leaving = old.leaving;
    }
    for (old, new) in pairs(&before.boundaries, &mut after.boundaries).filter(|_| field == Field::Face) {
        new.face = old.face;
    }
    for (old, new) in pairs(&before.faces, &mut after.faces).filter(|_| field == Field::Inner) {
        new.inner.clone_from(&old.inner);
    }
}

impl Subject for Planted {
    type Vertex = VertexKey;
    type HalfEdge = HalfEdgeKey;
    type Face = FaceKey;

    fn unbounded_face(&self) -> Option<FaceKey> {
        Subject::unbounded_face(&self.dcel)
    }

    fn half_edge_at(&self, index: usize) -> Option<HalfEdgeKey> {
        Subject::half_edge_at(&self.dcel, index)
    }

    fn face_of(&self, corner: CornerOf<Self>) -> Result<FaceKey, Refusal> {
        self.dcel.face_of(self.corner(corner))
    }

    fn origin_of(&self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        self.dcel.origin_of(self.half_edge(half_edge))
    }

    fn twin_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        self.dcel.twin_of(self.half_edge(half_edge))
    }

    fn next_of(&self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        self.dcel.next_of(self.half_edge(half_edge))
    }

    /// Applies an operator, unless it is skipped, and plants the fault in the resulting structure.
    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let kind = call.kind();
        let call = call.map(|v| self.vertex(v), |h| self.half_edge(h), |f| self.face(f));
        if let Fault::Skips(faulty, from) = self.fault
            && faulty == kind
        {
            let number = self.calls.replace(self.calls.get() + 1);
            if number >= from {
                return Ok(None);
            }
        }
        let before = Table::copy_of(&self.dcel).unwrap_or_default();
        let answer = self.dcel.apply(call);
        self.table = Table::copy_of(&self.dcel).unwrap_or_default();
        match self.fault {
            Fault::Loses(faulty, field) if faulty == kind => lose(&before, &mut self.table, field),
            Fault::LeavesTrace(faulty) if faulty == kind && answer.is_err() => self.table.vertices.push(None),
            _ => {}
        }
        answer
    }
}

impl View for Planted {
    delegate_view!(|this| &this.table);
}
