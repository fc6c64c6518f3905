//! A `Dcel` as a subject whose reports are checked.

use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{Boundary, Connection, Corner, Dcel, OperatorError, RemovedEdge, Side, Split, StaleKey, Turn};
use twinedge::dcel::{BoundaryKey, FaceKey, HalfEdgeKey, VertexKey};
use twinedge::program::{Call, CallOf, Handle, HandleOf, Refusal, Subject, mesh};
use twinedge::validate::View;
use twinedge::{delegate_subject, delegate_view};

/// A [`Dcel`] as a subject that checks the reports of its operators: the records that they made, kept and dropped.
///
/// [`Subject`] needs only the operations of programs, and so do the models that a subject runs in step with: none of them has
/// keys of boundary components. This one compares the keys before and after each operator with the report, including which of two
/// records is kept. It also keeps the keys of all dropped boundary components, and tests that they are stale after each operator.
///
/// In addition to the operator, each step costs O(n log n) for n records and dropped boundary components.
///
/// # Panics
/// The operators panic at a wrong report, or if the key of a dropped boundary component is accepted.
///
/// ```
/// use twinedge::dcel::Dcel;
/// use twinedge::program::{Program, conformance};
/// use twinedge::validate::Expectation;
/// use twinedge_trials::ReportAudit;
/// let program = Program::from_bytes(b"some bytes that came from a fuzzer");
/// conformance::run(&program, ReportAudit::new(Dcel::new()), &Expectation::plane())?;
/// # Ok::<(), conformance::Failure>(())
/// ```
#[derive(Clone, Debug)]
pub struct ReportAudit {
    dcel: Dcel,
    dropped: Vec<BoundaryKey>,
}

fn boundary_of(dcel: &Dcel, corner: Corner) -> Result<Boundary<'_>, OperatorError> {
    match corner {
        Corner::At(h) => Ok(dcel.half_edge(h)?.boundary()),
        Corner::Isolated(v) => dcel.vertex(v)?.isolated().ok_or(OperatorError::NotIsolated(v)),
    }
}

/// All keys, and for each boundary component its face and its number of half-edges.
struct Records {
    vertices: BTreeSet<VertexKey>,
    half_edges: BTreeSet<HalfEdgeKey>,
    boundaries: BTreeMap<BoundaryKey, (FaceKey, usize)>,
    faces: BTreeSet<FaceKey>,
}

impl Records {
    fn of(dcel: &Dcel) -> Self {
        let mut boundaries: BTreeMap<_, _> = dcel.boundaries().map(|b| (b.key(), (b.face().key(), 0))).collect();
        for h in dcel.half_edges() {
            if let Some((_, length)) = boundaries.get_mut(&h.boundary().key()) {
                *length += 1;
            }
        }
        Self {
            vertices: dcel.vertices().map(|v| v.key()).collect(),
            half_edges: dcel.half_edges().map(|h| h.key()).collect(),
            boundaries,
            faces: dcel.faces().map(|f| f.key()).collect(),
        }
    }

    fn length(&self, b: BoundaryKey) -> usize {
        self.boundaries.get(&b).map_or(0, |(_, length)| *length)
    }
}

/// The records that exist after an operator and not before, or vice versa.
#[derive(Debug, Default, PartialEq, Eq)]
struct Changes {
    vertices: Vec<VertexKey>,
    half_edges: Vec<HalfEdgeKey>,
    boundaries: Vec<BoundaryKey>,
    faces: Vec<FaceKey>,
}

impl Changes {
    fn between(one: &Records, other: &Records) -> Self {
        let has_not = |b: &&BoundaryKey| !other.boundaries.contains_key(*b);
        Self {
            vertices: one.vertices.difference(&other.vertices).copied().collect(),
            half_edges: one.half_edges.difference(&other.half_edges).copied().collect(),
            boundaries: one.boundaries.keys().filter(has_not).copied().collect(),
            faces: one.faces.difference(&other.faces).copied().collect(),
        }
    }
}

struct Change {
    before: Records,
    after: Records,
    made: Changes,
    gone: Changes,
}

impl Change {
    /// Compares the numbers of made and dropped records: vertices, half-edges, boundary components, faces.
    fn counts(&self, operator: &str, made: [usize; 4], gone: [usize; 4]) {
        let count = |c: &Changes| [c.vertices.len(), c.half_edges.len(), c.boundaries.len(), c.faces.len()];
        let found = [count(&self.made), count(&self.gone)];
        assert!(found == [made, gone], "{operator} made and dropped {found:?} records, not {:?}", [made, gone]);
    }
}

#[track_caller]
fn reports<T: Copy + PartialEq + std::fmt::Debug>(operator: &str, what: &str, reported: T, found: T) {
    assert!(reported == found, "{operator} reports {what} {reported:?}, not {found:?}");
}

impl Default for ReportAudit {
    fn default() -> Self {
        Self::new(Dcel::default())
    }
}

impl ReportAudit {
    /// Wraps a map; its reports are checked from here on.
    #[must_use]
    pub const fn new(dcel: Dcel) -> Self {
        Self { dcel, dropped: Vec::new() }
    }

    /// Returns the map.
    #[must_use]
    pub const fn dcel(&self) -> &Dcel {
        &self.dcel
    }

    /// Runs an operator, and returns its changes if it was applied. A refused one must change nothing.
    fn run<T>(
        &mut self,
        operator: impl FnOnce(&mut Dcel) -> Result<T, OperatorError>,
    ) -> Result<(T, Change), OperatorError> {
        let before = Records::of(&self.dcel);
        let result = operator(&mut self.dcel);
        let after = Records::of(&self.dcel);
        let (made, gone) = (Changes::between(&after, &before), Changes::between(&before, &after));
        if let Err(error) = &result {
            assert!(made == gone, "records change although it is refused: {error}");
        }
        self.dropped.extend(&gone.boundaries);
        for key in &self.dropped {
            let found = self.dcel.boundary(*key).err();
            assert!(found == Some(StaleKey::Boundary(*key)), "a dropped boundary component is found: {key:?}");
        }
        if let Some(key) = self.dropped.last() {
            let unbounded = self.dcel.unbounded_face().key();
            let refused = self.dcel.move_inner(*key, unbounded).err();
            let stale = OperatorError::Stale(StaleKey::Boundary(*key));
            assert!(refused == Some(stale), "a dropped boundary component can be moved: {key:?}");
        }
        Ok((result?, Change { before, after, made, gone }))
    }

    /// Returns the boundary component to the left of a half-edge, and true if it is an outer one.
    fn left_of(&self, h: HalfEdgeKey) -> Option<(BoundaryKey, bool)> {
        let b = self.dcel.half_edge(h).ok()?.boundary();
        Some((b.key(), b.is_outer()))
    }
}

impl View for ReportAudit {
    delegate_view!(|this| &this.dcel);
}

impl Subject for ReportAudit {
    delegate_subject!(Dcel, |this| &this.dcel);

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        let nothing = |()| None;
        match call {
            Call::AddIsolatedVertex { face } => self.add_isolated_vertex(face).map(Handle::Vertex).map(Some),
            Call::RemoveIsolatedVertex { vertex } => self.remove_isolated_vertex(vertex).map(nothing),
            Call::Connect { from, to, new_face, inner } => {
                self.connect(from, to, new_face, &inner).map(Handle::HalfEdge).map(Some)
            }
            Call::RemoveEdge { half_edge } => Ok(self.remove_edge(half_edge)?.map(Handle::Face)),
            Call::SplitEdge { half_edge } => self.split_edge(half_edge).map(Handle::HalfEdge).map(Some),
            Call::JoinEdges { half_edge } => self.join_edges(half_edge).map(nothing),
            Call::SplitVertex { from, to } => self.split_vertex(from, to).map(Handle::HalfEdge).map(Some),
            Call::ContractEdge { half_edge } => self.contract_edge(half_edge).map(Handle::Vertex).map(Some),
            Call::FlipEdge { half_edge, turn } => self.flip_edge(half_edge, turn).map(nothing),
            Call::MoveInner { inner, face } => self.move_inner(inner, face).map(nothing),
            Call::MeshFlipEdge { half_edge } => mesh::flip_edge(self, half_edge).map(nothing),
            Call::MeshSplitEdge { half_edge } => mesh::split_edge(self, half_edge).map(nothing),
            Call::MeshSplitFace { half_edge } => mesh::split_face(self, half_edge).map(nothing),
            Call::MeshCollapseEdge { half_edge } => mesh::collapse_edge(self, half_edge).map(nothing),
        }
    }
}

/// The operators, with checks of their reports.
impl ReportAudit {
    fn add_isolated_vertex(&mut self, face: FaceKey) -> Result<VertexKey, Refusal> {
        let (added, changed) = self.run(|dcel| dcel.add_isolated_vertex(face))?;
        changed.counts("add_isolated_vertex", [1, 0, 1, 0], [0; 4]);
        reports("add_isolated_vertex", "the vertex", added.vertex, changed.made.vertices[0]);
        reports("add_isolated_vertex", "the boundary component", added.boundary, changed.made.boundaries[0]);
        Ok(added.vertex)
    }

    fn remove_isolated_vertex(&mut self, vertex: VertexKey) -> Result<(), Refusal> {
        let (removed, changed) = self.run(|dcel| dcel.remove_isolated_vertex(vertex))?;
        changed.counts("remove_isolated_vertex", [0; 4], [1, 0, 1, 0]);
        let gone = changed.gone.boundaries[0];
        reports("remove_isolated_vertex", "the boundary component", removed.boundary, gone);
        reports("remove_isolated_vertex", "the face", removed.face, changed.before.boundaries[&gone].0);
        Ok(())
    }

    fn connect(&mut self, from: Corner, to: Corner, new_face: Side, inner: &[Corner]) -> Result<HalfEdgeKey, Refusal> {
        let [first, second] = [boundary_of(&self.dcel, from)?.key(), boundary_of(&self.dcel, to)?.key()];
        let inner: Vec<BoundaryKey> = inner
            .iter()
            .map(|corner| Ok(boundary_of(&self.dcel, *corner)?.key()))
            .collect::<Result<_, OperatorError>>()?;
        let (connected, changed) = self.run(|dcel| dcel.connect(from, to, Split { new_face, inner: &inner }))?;
        let h = connected.half_edge;
        reports("connect", "a half-edge that is new", changed.made.half_edges.contains(&h), true);
        let left = self.left_of(h).map(|(b, _)| b);
        let right = self.twin_of(h).ok().and_then(|twin| self.left_of(twin)).map(|(b, _)| b);
        match connected.connection {
            Connection::Bridge { kept, dropped } => {
                changed.counts("connect", [0, 2, 0, 0], [0, 0, 1, 0]);
                let second_is_kept = changed.before.length(second) >= changed.before.length(first);
                let longer = if second_is_kept { second } else { first };
                reports("connect", "as kept", kept, longer);
                reports("connect", "as dropped", dropped, changed.gone.boundaries[0]);
                reports("connect", "as kept", [Some(kept); 2], [left, right]);
            }
            Connection::Split { kept, made, face } => {
                changed.counts("connect", [0, 2, 1, 1], [0; 4]);
                reports("connect", "as kept", kept, first);
                reports("connect", "as made", made, changed.made.boundaries[0]);
                reports("connect", "the new face", face, changed.made.faces[0]);
                let new_side = if new_face == Side::Left { left } else { right };
                let bounds = |b: BoundaryKey| changed.after.boundaries.get(&b).map(|(f, _)| *f);
                reports("connect", "the new face", Some(face), new_side.and_then(bounds));
                let length = |b: Option<BoundaryKey>| b.map_or(0, |b| changed.after.length(b));
                let longer = if length(left) >= length(right) { left } else { right };
                reports("connect", "as kept", Some(kept), longer);
            }
            connection => panic!("connect reports what nothing checks: {connection:?}"),
        }
        Ok(h)
    }

    fn remove_edge(&mut self, half_edge: HalfEdgeKey) -> Result<Option<FaceKey>, Refusal> {
        let left = self.left_of(half_edge);
        let right = self.twin_of(half_edge).ok().and_then(|twin| self.left_of(twin));
        let (removed, changed) = self.run(|dcel| dcel.remove_edge(half_edge))?;
        match (removed, left.zip(right)) {
            (
                RemovedEdge::Merged { kept_face, dropped_face, kept, dropped },
                Some(((left, outer), (right, beyond))),
            ) => {
                changed.counts("remove_edge", [0; 4], [0, 2, 1, 1]);
                reports("remove_edge", "as dropped", dropped, changed.gone.boundaries[0]);
                reports("remove_edge", "as kept", kept, if dropped == left { right } else { left });
                reports("remove_edge", "the dropped face", dropped_face, changed.gone.faces[0]);
                let surrounding = if outer && !beyond { right } else { left };
                reports("remove_edge", "the kept face", kept_face, changed.before.boundaries[&surrounding].0);
                Ok(Some(dropped_face))
            }
            (RemovedEdge::Parted { kept, made }, Some(((left, _), _))) => {
                changed.counts("remove_edge", [0, 0, 1, 0], [0, 2, 0, 0]);
                reports("remove_edge", "as kept", kept, left);
                reports("remove_edge", "as made", made, changed.made.boundaries[0]);
                let is_longer = changed.after.length(kept) >= changed.after.length(made);
                reports("remove_edge", "the longer part as kept", true, is_longer);
                Ok(None)
            }
            (removed, None) => panic!("remove_edge takes a stale key: {removed:?}"),
            (removed, Some(_)) => panic!("remove_edge reports what nothing checks: {removed:?}"),
        }
    }

    fn split_edge(&mut self, half_edge: HalfEdgeKey) -> Result<HalfEdgeKey, Refusal> {
        let (split, changed) = self.run(|dcel| dcel.split_edge(half_edge))?;
        changed.counts("split_edge", [1, 2, 0, 0], [0; 4]);
        reports("split_edge", "the vertex", split.vertex, changed.made.vertices[0]);
        reports("split_edge", "the half-edge", Some(split.half_edge), self.next_of(half_edge).ok());
        reports("split_edge", "a half-edge that is new", changed.made.half_edges.contains(&split.half_edge), true);
        Ok(split.half_edge)
    }

    fn join_edges(&mut self, half_edge: HalfEdgeKey) -> Result<(), Refusal> {
        let following = self.next_of(half_edge).ok();
        let (joined, changed) = self.run(|dcel| dcel.join_edges(half_edge))?;
        changed.counts("join_edges", [0; 4], [1, 2, 0, 0]);
        reports("join_edges", "the vertex", joined.vertex, changed.gone.vertices[0]);
        reports("join_edges", "the half-edge", Some(joined.half_edge), following);
        Ok(())
    }

    fn split_vertex(&mut self, from: Corner, to: Corner) -> Result<HalfEdgeKey, Refusal> {
        let (split, changed) = self.run(|dcel| dcel.split_vertex(from, to))?;
        changed.counts("split_vertex", [1, 2, 0, 0], [0; 4]);
        reports("split_vertex", "the vertex", split.vertex, changed.made.vertices[0]);
        reports("split_vertex", "a half-edge that is new", changed.made.half_edges.contains(&split.half_edge), true);
        let h = self.dcel.half_edge(split.half_edge).map_err(OperatorError::from)?;
        let [origin, target] = [h.origin(), h.target()];
        let new = if target.degree() <= origin.degree() { target } else { origin };
        reports("split_vertex", "the smaller one as new", split.vertex, new.key());
        Ok(split.half_edge)
    }

    fn contract_edge(&mut self, half_edge: HalfEdgeKey) -> Result<VertexKey, Refusal> {
        let ends = self.dcel.half_edge(half_edge).ok().map(|h| [h.origin(), h.target()].map(|v| (v.key(), v.degree())));
        let (contracted, changed) = self.run(|dcel| dcel.contract_edge(half_edge))?;
        changed.counts("contract_edge", [0; 4], [1, 2, 0, 0]);
        reports("contract_edge", "as dropped", contracted.dropped, changed.gone.vertices[0]);
        let larger = ends.map(|[origin, target]| if origin.1 >= target.1 { origin.0 } else { target.0 });
        reports("contract_edge", "as kept", Some(contracted.kept), larger);
        Ok(contracted.dropped)
    }

    fn flip_edge(&mut self, half_edge: HalfEdgeKey, turn: Turn) -> Result<(), Refusal> {
        let ((), changed) = self.run(|dcel| dcel.flip_edge(half_edge, turn))?;
        changed.counts("flip_edge", [0; 4], [0; 4]);
        Ok(())
    }

    fn move_inner(&mut self, inner: Corner, face: FaceKey) -> Result<(), Refusal> {
        let boundary = boundary_of(&self.dcel, inner)?.key();
        let (was_in, changed) = self.run(|dcel| dcel.move_inner(boundary, face))?;
        changed.counts("move_inner", [0; 4], [0; 4]);
        reports("move_inner", "the face in which it was", was_in, changed.before.boundaries[&boundary].0);
        reports("move_inner", "success", face, changed.after.boundaries[&boundary].0);
        Ok(())
    }
}
