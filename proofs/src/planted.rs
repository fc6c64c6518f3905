//! A subject with one fault: what a harness must notice.

use crate::grow::Operator;
use crate::operators::Handle;
use core::cell::Cell;
use twinedge::dcel::{Dcel, FaceKey, HalfEdge, HalfEdgeKey, Vertex, VertexKey};
use twinedge::delegate_view;
use twinedge::program::{Corner, CornerOf, Refusal, Side, Subject, Turn};
use twinedge::validate::{Table, View};

/// A field of a record.
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

/// A fault of the subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// The values that the operator writes to this field of older records are lost.
    Loses(Operator, Field),
    /// The operator says that it is done, and nothing is, from this call on, counted from 0.
    Skips(Operator, u32),
    /// The operator issues a record before it knows that it will refuse, and then retires it again.
    LeavesTrace(Operator),
    /// A stale handle is taken for that of some live record.
    TakesStale(Handle),
}

/// The structure of the library, seen through a fault.
#[derive(Clone, Debug)]
pub(crate) struct Planted {
    dcel: Dcel,
    /// The table that it shows of itself.
    table: Table,
    fault: Fault,
    /// The number of calls of the operator that is to be skipped.
    calls: Cell<u32>,
}

impl Planted {
    pub(crate) fn new(dcel: Dcel, fault: Fault) -> Self {
        let table = Table::copy_of(&dcel).unwrap_or_default();
        Self { dcel, table, fault, calls: Cell::new(0) }
    }

    /// Runs an operator, unless it is skipped, and plants the fault in what the structure then says.
    fn run<T>(
        &mut self,
        operator: Operator,
        skipped: T,
        run: impl FnOnce(&mut Dcel) -> Result<T, Refusal>,
    ) -> Result<T, Refusal> {
        if let Fault::Skips(faulty, from) = self.fault
            && faulty == operator
        {
            let call = self.calls.replace(self.calls.get() + 1);
            if call >= from {
                return Ok(skipped);
            }
        }
        let before = Table::copy_of(&self.dcel).unwrap_or_default();
        let answer = run(&mut self.dcel);
        self.table = Table::copy_of(&self.dcel).unwrap_or_default();
        match self.fault {
            Fault::Loses(faulty, field) if faulty == operator => lose(&before, &mut self.table, field),
            Fault::LeavesTrace(faulty) if faulty == operator && answer.is_err() => self.table.vertices.push(None),
            _ => {}
        }
        answer
    }

    fn half_edge(&self, h: HalfEdgeKey) -> HalfEdgeKey {
        let deceived = self.fault == Fault::TakesStale(Handle::HalfEdge) && self.dcel.half_edge(h).is_err();
        self.dcel.half_edges().next().filter(|_| deceived).map_or(h, HalfEdge::key)
    }

    fn vertex(&self, v: VertexKey) -> VertexKey {
        let deceived = self.fault == Fault::TakesStale(Handle::Vertex) && self.dcel.vertex(v).is_err();
        self.dcel.vertices().next().filter(|_| deceived).map_or(v, Vertex::key)
    }

    fn face(&self, f: FaceKey) -> FaceKey {
        let deceived = self.fault == Fault::TakesStale(Handle::Face) && self.dcel.face(f).is_err();
        if deceived { self.dcel.unbounded_face().key() } else { f }
    }

    fn corner(&self, corner: CornerOf<Self>) -> CornerOf<Self> {
        match corner {
            Corner::At(h) => Corner::At(self.half_edge(h)),
            Corner::Isolated(v) => Corner::Isolated(self.vertex(v)),
        }
    }
}

/// Puts back what a field said before, in all records that were there.
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

    fn add_isolated_vertex(&mut self, face: FaceKey) -> Result<VertexKey, Refusal> {
        let face = self.face(face);
        let skipped = VertexKey::default();
        self.run(Operator::AddIsolatedVertex, skipped, |dcel| Subject::add_isolated_vertex(dcel, face))
    }

    fn remove_isolated_vertex(&mut self, vertex: VertexKey) -> Result<(), Refusal> {
        let vertex = self.vertex(vertex);
        self.run(Operator::RemoveIsolatedVertex, (), |dcel| Subject::remove_isolated_vertex(dcel, vertex))
    }

    fn connect(
        &mut self,
        from: CornerOf<Self>,
        to: CornerOf<Self>,
        new_face: Side,
        inner: &[CornerOf<Self>],
    ) -> Result<HalfEdgeKey, Refusal> {
        let (from, to) = (self.corner(from), self.corner(to));
        let inner: Vec<_> = inner.iter().map(|corner| self.corner(*corner)).collect();
        let skipped = HalfEdgeKey::default();
        self.run(Operator::Connect, skipped, |dcel| Subject::connect(dcel, from, to, new_face, &inner))
    }

    fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<Option<FaceKey>, Refusal> {
        let half_edge = self.half_edge(half_edge);
        self.run(Operator::RemoveEdge, None, |dcel| Subject::remove_edge(dcel, half_edge))
    }

    fn split_edge(&mut self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        let half_edge = self.half_edge(half_edge);
        self.run(Operator::SplitEdge, half_edge, |dcel| Subject::split_edge(dcel, half_edge))
    }

    fn join_edges(&mut self, half_edge: HalfEdgeKey) -> Result<(), Refusal> {
        let half_edge = self.half_edge(half_edge);
        self.run(Operator::JoinEdges, (), |dcel| Subject::join_edges(dcel, half_edge))
    }

    fn split_vertex(&mut self, from: CornerOf<Self>, to: CornerOf<Self>) -> Result<HalfEdgeKey, Refusal> {
        let (from, to) = (self.corner(from), self.corner(to));
        self.run(Operator::SplitVertex, HalfEdgeKey::default(), |dcel| Subject::split_vertex(dcel, from, to))
    }

    fn contract_edge(&mut self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        let half_edge = self.half_edge(half_edge);
        self.run(Operator::ContractEdge, VertexKey::default(), |dcel| Subject::contract_edge(dcel, half_edge))
    }

    fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), Refusal> {
        let half_edge = self.half_edge(half_edge);
        self.run(Operator::FlipEdge, (), |dcel| Subject::flip_edge(dcel, half_edge, turn))
    }

    fn move_inner(&mut self, inner: CornerOf<Self>, face: FaceKey) -> Result<(), Refusal> {
        let (inner, face) = (self.corner(inner), self.face(face));
        self.run(Operator::MoveInner, (), |dcel| Subject::move_inner(dcel, inner, face))
    }
}

impl View for Planted {
    delegate_view!(|this| &this.table);
}
