//! The stores differ in how they keep records and in nothing else: the same operators on each give the same structure, step
//! by step, with records named by the order in which they were made. Keys that name nothing are refused by all of them, and
//! what does not fit into fixed arrays is refused without a trace.

use quickcheck::{Gen, QuickCheck};
use std::collections::{HashMap, HashSet};
use std::hash::Hash;
use std::mem::{Discriminant, discriminant};
use twinedge::dcel::{
    BoundaryKey, Connection, Corner, Dcel, FaceKey, HalfEdgeKey, OperatorError, RecordKind, RemovedEdge, Side, Split,
    StaleKey, Turn, VertexKey,
};
use twinedge::store::{FixedStore, PointerStore, SlotStore, Store};
use twinedge::validate::{BoundaryRow, FaceRow, HalfEdgeRow, Start, Table, VertexRow};

/// Room for every program of up to 100 steps.
type Roomy = FixedStore<127, 127, 128, 128>;
/// Room for next to nothing.
type Tiny = FixedStore<3, 4, 4, 3>;

/// The keys of one kind by number: the order in which their records were made.
struct Names<K>(Vec<K>);

impl<K: Copy + Eq + Hash> Names<K> {
    fn add(&mut self, key: K) -> usize {
        self.0.push(key);
        self.0.len() - 1
    }

    fn of(&self, key: K) -> usize {
        self.0.iter().rposition(|k| *k == key).expect("a key that was made")
    }

    /// Per index in the view, the rank among the records that are live.
    fn ranks(&self, index: impl Fn(K) -> Option<usize>) -> HashMap<usize, usize> {
        self.0.iter().filter_map(|key| index(*key)).enumerate().map(|(rank, index)| (index, rank)).collect()
    }
}

/// A place to attach an edge, by number.
#[derive(Clone, Copy, Debug)]
enum Spot {
    At(usize),
    Isolated(usize),
}

/// One operator, its arguments by number.
#[derive(Clone, Debug)]
enum Step {
    AddIsolatedVertex(usize),
    RemoveIsolatedVertex(usize),
    Connect(Spot, Spot, Side, Vec<usize>),
    RemoveEdge(usize),
    SplitEdge(usize),
    JoinEdges(usize),
    SplitVertex(Spot, Spot),
    ContractEdge(usize),
    FlipEdge(usize, Turn),
    MoveInner(usize, usize),
    Clone,
}

/// What an operator said, by number, or which error it was.
type Answer = Result<Vec<usize>, (Discriminant<OperatorError>, Option<Discriminant<StaleKey>>, Option<RecordKind>)>;

/// A structure and the names of all that was ever made in it.
struct Run<S: Store> {
    dcel: Dcel<S>,
    vertices: Names<VertexKey>,
    half_edges: Names<HalfEdgeKey>,
    boundaries: Names<BoundaryKey>,
    faces: Names<FaceKey>,
}

impl<S: Store + Clone> Run<S> {
    fn new() -> Self {
        let dcel = Dcel::default();
        let faces = Names(vec![dcel.unbounded_face().key()]);
        Self { dcel, vertices: Names(vec![]), half_edges: Names(vec![]), boundaries: Names(vec![]), faces }
    }

    fn corner(&self, spot: Spot) -> Corner {
        match spot {
            Spot::At(h) => Corner::At(self.half_edges.0[h]),
            Spot::Isolated(v) => Corner::Isolated(self.vertices.0[v]),
        }
    }

    fn add_edge(&mut self, h: HalfEdgeKey) -> usize {
        let twin = self.dcel.half_edge(h).unwrap().twin().key();
        let number = self.half_edges.add(h);
        self.half_edges.add(twin);
        number
    }

    fn apply(&mut self, step: &Step) -> Answer {
        self.try_to(step).map_err(|error| {
            let stale = if let OperatorError::Stale(key) = &error { Some(discriminant(key)) } else { None };
            let kind = if let OperatorError::Full(kind) = error { Some(kind) } else { None };
            (discriminant(&error), stale, kind)
        })
    }

    fn try_to(&mut self, step: &Step) -> Result<Vec<usize>, OperatorError> {
        Ok(match step {
            Step::AddIsolatedVertex(f) => {
                let added = self.dcel.add_isolated_vertex(self.faces.0[*f])?;
                vec![self.vertices.add(added.vertex), self.boundaries.add(added.boundary)]
            }
            Step::RemoveIsolatedVertex(v) => {
                let removed = self.dcel.remove_isolated_vertex(self.vertices.0[*v])?;
                vec![self.boundaries.of(removed.boundary), self.faces.of(removed.face)]
            }
            Step::Connect(from, to, new_face, inner) => {
                let (from, to) = (self.corner(*from), self.corner(*to));
                let inner: Vec<_> = inner.iter().map(|b| self.boundaries.0[*b]).collect();
                let connected = self.dcel.connect(from, to, Split { new_face: *new_face, inner: &inner })?;
                let h = self.add_edge(connected.half_edge);
                match connected.connection {
                    Connection::Bridge { kept, dropped } => {
                        vec![h, self.boundaries.of(kept), self.boundaries.of(dropped)]
                    }
                    Connection::Split { kept, made, face } => {
                        vec![h, self.boundaries.of(kept), self.boundaries.add(made), self.faces.add(face)]
                    }
                    other => panic!("{other:?}"),
                }
            }
            Step::RemoveEdge(h) => match self.dcel.remove_edge(self.half_edges.0[*h])? {
                RemovedEdge::Merged { kept_face, dropped_face, kept, dropped } => vec![
                    self.faces.of(kept_face),
                    self.faces.of(dropped_face),
                    self.boundaries.of(kept),
                    self.boundaries.of(dropped),
                ],
                RemovedEdge::Parted { kept, made } => vec![self.boundaries.of(kept), self.boundaries.add(made)],
                other => panic!("{other:?}"),
            },
            Step::SplitEdge(h) => {
                let split = self.dcel.split_edge(self.half_edges.0[*h])?;
                vec![self.vertices.add(split.vertex), self.add_edge(split.half_edge)]
            }
            Step::JoinEdges(h) => {
                let joined = self.dcel.join_edges(self.half_edges.0[*h])?;
                vec![self.vertices.of(joined.vertex), self.half_edges.of(joined.half_edge)]
            }
            Step::SplitVertex(from, to) => {
                let split = self.dcel.split_vertex(self.corner(*from), self.corner(*to))?;
                vec![self.vertices.add(split.vertex), self.add_edge(split.half_edge)]
            }
            Step::ContractEdge(h) => {
                let contracted = self.dcel.contract_edge(self.half_edges.0[*h])?;
                vec![self.vertices.of(contracted.kept), self.vertices.of(contracted.dropped)]
            }
            Step::FlipEdge(h, turn) => {
                self.dcel.flip_edge(self.half_edges.0[*h], *turn)?;
                vec![]
            }
            Step::MoveInner(b, f) => {
                vec![self.faces.of(self.dcel.move_inner(self.boundaries.0[*b], self.faces.0[*f])?)]
            }
            Step::Clone => {
                self.dcel = self.dcel.clone();
                vec![]
            }
        })
    }

    /// Everything that the structure says, the live records numbered in the order in which they were made.
    fn table(&self) -> Table {
        let said = Table::copy_of(&self.dcel).expect("a small map fits");
        let v = self.vertices.ranks(|key| self.dcel.vertex(key).ok().map(twinedge::dcel::Vertex::index));
        let h = self.half_edges.ranks(|key| self.dcel.half_edge(key).ok().map(twinedge::dcel::HalfEdge::index));
        let b = self.boundaries.ranks(|key| self.dcel.boundary(key).ok().map(twinedge::dcel::Boundary::index));
        let f = self.faces.ranks(|key| self.dcel.face(key).ok().map(twinedge::dcel::Face::index));
        let vertices = ordered(&said.vertices, &v, |row| VertexRow {
            leaving: row.leaving.map(|i| h[&i]),
            isolated: row.isolated.map(|i| b[&i]),
        });
        let half_edges = ordered(&said.half_edges, &h, |row| HalfEdgeRow {
            origin: row.origin.map(|i| v[&i]),
            twin: row.twin.map(|i| h[&i]),
            next: row.next.map(|i| h[&i]),
            prev: row.prev.map(|i| h[&i]),
            boundary: row.boundary.map(|i| b[&i]),
            face: row.face,
        });
        let boundaries = ordered(&said.boundaries, &b, |row| BoundaryRow {
            face: row.face.map(|i| f[&i]),
            start: row.start.map(|start| match start {
                Start::HalfEdge(i) => Start::HalfEdge(h[&i]),
                Start::Vertex(i) => Start::Vertex(v[&i]),
            }),
            place: row.place,
        });
        let faces = ordered(&said.faces, &f, |row| FaceRow {
            outer: row.outer.map(|i| b[&i]),
            inner: row.inner.iter().map(|link| link.map(|i| b[&i])).collect(),
            ..row.clone()
        });
        Table { vertices, half_edges, boundaries, faces }
    }
}

/// The live rows, which must be those with a rank, in order of rank.
fn ordered<R>(rows: &[Option<R>], ranks: &HashMap<usize, usize>, renumbered: impl Fn(&R) -> R) -> Vec<Option<R>> {
    let mut result: Vec<Option<R>> = ranks.iter().map(|_| None).collect();
    for (index, row) in rows.iter().enumerate() {
        if let Some(row) = row {
            result[ranks[&index]] = Some(renumbered(row));
        }
    }
    result
}

/// Picks one of the live, mostly, or of all there ever were.
fn pick<K: Copy>(keys: &[K], live: impl Fn(K) -> bool, random: u16) -> Option<usize> {
    let any_at_all = random.is_multiple_of(16);
    let candidates: Vec<usize> = (0..keys.len()).filter(|i| any_at_all || live(keys[*i])).collect();
    candidates.get(random as usize / 16 % candidates.len().max(1)).copied()
}

impl<S: Store + Clone> Run<S> {
    fn a_vertex(&self, random: u16) -> Option<usize> {
        pick(&self.vertices.0, |key| self.dcel.vertex(key).is_ok(), random)
    }

    fn a_half_edge(&self, random: u16) -> Option<usize> {
        pick(&self.half_edges.0, |key| self.dcel.half_edge(key).is_ok(), random)
    }

    fn a_boundary(&self, random: u16) -> Option<usize> {
        pick(&self.boundaries.0, |key| self.dcel.boundary(key).is_ok(), random)
    }

    fn a_face(&self, random: u16) -> Option<usize> {
        pick(&self.faces.0, |key| self.dcel.face(key).is_ok(), random)
    }

    fn a_spot(&self, random: u16) -> Option<Spot> {
        let isolated = || {
            let is = |key| self.dcel.vertex(key).is_ok_and(|v| v.isolated().is_some());
            pick(&self.vertices.0, is, random / 4).map(Spot::Isolated)
        };
        let at = || self.a_half_edge(random / 4).map(Spot::At);
        if random.is_multiple_of(4) { isolated().or_else(at) } else { at().or_else(isolated) }
    }

    /// A corner that goes with another: of the same face or vertex, mostly.
    fn a_partner(&self, spot: Spot, same_vertex: bool, random: u16) -> Option<Spot> {
        let Some(Ok(h)) = (if let Spot::At(h) = spot { Some(self.dcel.half_edge(self.half_edges.0[h])) } else { None })
        else {
            return if same_vertex { Some(spot) } else { self.a_spot(random) };
        };
        if random.is_multiple_of(8) {
            return self.a_spot(random / 8);
        }
        let others: Vec<_> =
            if same_vertex { h.origin().rotation().collect() } else { h.face().half_edges().collect() };
        Some(Spot::At(self.half_edges.of(others[random as usize / 8 % others.len()].key())))
    }

    /// The step that these numbers stand for, if the structure has what it takes.
    fn step(&self, [operator, a, b, c]: [u16; 4]) -> Option<Step> {
        let side = if c % 2 == 0 { Side::Left } else { Side::Right };
        Some(match operator % 16 {
            0 | 1 => Step::AddIsolatedVertex(self.a_face(a)?),
            2 => Step::RemoveIsolatedVertex(self.a_vertex(a)?),
            3..=6 => {
                let from = self.a_spot(a)?;
                let to = self.a_partner(from, false, b)?;
                let face = match self.corner(from) {
                    Corner::At(h) => self.dcel.half_edge(h).ok()?.face(),
                    Corner::Isolated(v) => self.dcel.vertex(v).ok()?.isolated()?.face(),
                };
                let others = face.inner().enumerate().filter(|(i, _)| c >> (1 + i % 8) & 1 == 1);
                let mut inner: Vec<_> = others.map(|(_, b)| self.boundaries.of(b.key())).collect();
                if c % 128 == 0 {
                    inner.extend(self.a_boundary(c / 128));
                }
                Step::Connect(from, to, side, inner)
            }
            7 | 8 => Step::RemoveEdge(self.a_half_edge(a)?),
            9 => Step::SplitEdge(self.a_half_edge(a)?),
            10 => Step::JoinEdges(self.a_half_edge(a)?),
            11 => {
                let from = self.a_spot(a)?;
                Step::SplitVertex(from, self.a_partner(from, true, b)?)
            }
            12 => Step::ContractEdge(self.a_half_edge(a)?),
            13 => {
                let turn = if c % 2 == 0 { Turn::CounterClockwise } else { Turn::Clockwise };
                Step::FlipEdge(self.a_half_edge(a)?, turn)
            }
            14 => Step::MoveInner(self.a_boundary(a)?, self.a_face(b)?),
            _ => Step::Clone,
        })
    }
}

/// Runs a property of programs, always the same ones.
fn for_programs(property: fn(Vec<[u16; 4]>) -> bool) {
    QuickCheck::new().rng(Gen::from_size_and_seed(100, 7)).tests(1000).quickcheck(property);
}

#[test]
fn the_same_steps_give_the_same_structure_in_every_store() {
    fn in_step(program: Vec<[u16; 4]>) -> bool {
        let (mut slots, mut pointers, mut fixed) =
            (Run::<SlotStore>::new(), Run::<PointerStore>::new(), Run::<Roomy>::new());
        for numbers in program {
            let Some(step) = slots.step(numbers) else { continue };
            let answer = slots.apply(&step);
            assert_eq!(answer, pointers.apply(&step), "{step:?}");
            assert_eq!(answer, fixed.apply(&step), "{step:?}");
            let table = slots.table();
            assert_eq!(table, pointers.table(), "{step:?}");
            assert_eq!(table, fixed.table(), "{step:?}");
            let reports = [slots.dcel.validate(), pointers.dcel.validate(), fixed.dcel.validate()];
            assert!(reports.iter().all(twinedge::validate::Report::is_valid), "{step:?}: {reports:?}");
        }
        true
    }
    for_programs(in_step);
}

#[test]
fn what_does_not_fit_is_refused_without_a_trace_and_what_fits_is_not() {
    fn like_the_default(program: Vec<[u16; 4]>) -> bool {
        let (mut slots, mut fixed) = (Run::<SlotStore>::new(), Run::<Tiny>::new());
        for numbers in program {
            let Some(step) = slots.step(numbers) else { continue };
            let before = Table::copy_of(&fixed.dcel);
            let answer = fixed.apply(&step);
            if let Err((_, _, Some(kind))) = answer {
                assert_eq!(before, Table::copy_of(&fixed.dcel), "{step:?}");
                let (count, most) = match kind {
                    RecordKind::Vertex => (fixed.dcel.vertex_count(), 3),
                    RecordKind::Edge => (fixed.dcel.edge_count(), 4),
                    RecordKind::Boundary => (fixed.dcel.boundary_count(), 4),
                    RecordKind::Face => (fixed.dcel.face_count(), 3),
                    other => panic!("{other:?}"),
                };
                assert_eq!(count, most, "{step:?}");
                continue;
            }
            assert_eq!(answer, slots.apply(&step), "{step:?}");
            assert_eq!(fixed.table(), slots.table(), "{step:?}");
            assert!(fixed.dcel.validate().is_valid(), "{step:?}");
        }
        true
    }
    for_programs(like_the_default);
}

/// Puts two vertices, joined by an edge, in the unbounded face. Takes one boundary component only.
fn an_edge<S: Store>(dcel: &mut Dcel<S>) -> HalfEdgeKey {
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    dcel.split_vertex(v, v).unwrap().half_edge
}

fn refused<S: Store, T: std::fmt::Debug + PartialEq>(
    dcel: &mut Dcel<S>,
    kind: RecordKind,
    operator: impl FnOnce(&mut Dcel<S>) -> Result<T, OperatorError>,
) {
    let before = Table::copy_of(dcel);
    assert_eq!(operator(dcel), Err(OperatorError::Full(kind)));
    assert_eq!(Table::copy_of(dcel), before);
    assert!(dcel.validate().is_valid());
}

#[test]
fn full_of_vertices() {
    let mut dcel: Dcel<FixedStore<2, 9, 9, 9>> = Dcel::default();
    let h = an_edge(&mut dcel);
    let outside = dcel.unbounded_face().key();
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.add_isolated_vertex(outside));
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.split_edge(h));
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.split_vertex(h, h));
    let kept = dcel.contract_edge(h).unwrap().kept;
    assert!(dcel.split_vertex(kept, kept).is_ok());
}

#[test]
fn full_of_edges() {
    let mut dcel: Dcel<FixedStore<9, 1, 9, 9>> = Dcel::default();
    let h = an_edge(&mut dcel);
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.connect(h, v, Split::default()));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.connect(h, h, Split::default()));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.split_edge(h));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.split_vertex(v, v));
    dcel.remove_edge(h).unwrap();
    assert!(dcel.split_vertex(v, v).is_ok());
}

#[test]
fn full_of_boundary_components() {
    let mut dcel: Dcel<FixedStore<9, 9, 1, 9>> = Dcel::default();
    let h = an_edge(&mut dcel);
    let outside = dcel.unbounded_face().key();
    refused(&mut dcel, RecordKind::Boundary, |dcel| dcel.add_isolated_vertex(outside));
    refused(&mut dcel, RecordKind::Boundary, |dcel| dcel.connect(h, h, Split::default()));
    refused(&mut dcel, RecordKind::Boundary, |dcel| dcel.remove_edge(h));
    let kept = dcel.contract_edge(h).unwrap().kept;
    dcel.remove_isolated_vertex(kept).unwrap();
    assert!(dcel.add_isolated_vertex(outside).is_ok());
}

#[test]
fn full_of_faces() {
    let mut dcel: Dcel<FixedStore<9, 9, 9, 1>> = Dcel::default();
    let h = an_edge(&mut dcel);
    refused(&mut dcel, RecordKind::Face, |dcel| dcel.connect(h, h, Split::default()));
    let mut dcel: Dcel<FixedStore<9, 9, 9, 2>> = Dcel::default();
    let h = an_edge(&mut dcel);
    let n = dcel.connect(h, h, Split::default()).unwrap().half_edge;
    refused(&mut dcel, RecordKind::Face, |dcel| dcel.connect(h, h, Split::default()));
    dcel.remove_edge(n).unwrap();
    assert!(dcel.connect(h, h, Split::default()).is_ok());
}

#[test]
fn the_largest_fixed_store_holds_what_it_says() {
    let mut dcel: Dcel<FixedStore<255, 127, 255, 255>> = Dcel::default();
    let outside = dcel.unbounded_face().key();
    let vertices: Vec<_> = (0..255).map(|_| dcel.add_isolated_vertex(outside).unwrap().vertex).collect();
    refused(&mut dcel, RecordKind::Vertex, |dcel| dcel.add_isolated_vertex(outside));
    let first = dcel.connect(vertices[0], vertices[1], Split::default()).unwrap().half_edge;
    for v in &vertices[2..128] {
        dcel.connect(first, *v, Split::default()).unwrap();
    }
    assert_eq!((dcel.vertex_count(), dcel.edge_count(), dcel.boundary_count()), (255, 127, 128));
    refused(&mut dcel, RecordKind::Edge, |dcel| dcel.connect(first, vertices[200], Split::default()));
    assert_eq!(dcel.vertex(vertices[0]).unwrap().degree(), 127);

    let mut dcel: Dcel<FixedStore<255, 127, 255, 128>> = Dcel::default();
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    let first = dcel.connect(v, v, Split::default()).unwrap().half_edge;
    for _ in 1..127 {
        dcel.connect(first, first, Split { new_face: Side::Right, inner: &[] }).unwrap();
    }
    assert_eq!((dcel.edge_count(), dcel.face_count(), dcel.boundary_count()), (127, 128, 128));
    assert!(dcel.validate().is_valid());
}

/// All keys that a structure has now.
fn all_keys<S: Store>(dcel: &Dcel<S>) -> (Vec<VertexKey>, Vec<HalfEdgeKey>, Vec<BoundaryKey>, Vec<FaceKey>) {
    (
        dcel.vertices().map(twinedge::dcel::Vertex::key).collect(),
        dcel.half_edges().map(twinedge::dcel::HalfEdge::key).collect(),
        dcel.boundaries().map(twinedge::dcel::Boundary::key).collect(),
        dcel.faces().map(twinedge::dcel::Face::key).collect(),
    )
}

/// Two structures made alike share no key, and each refuses those of the other by name.
fn foreign_keys_are_refused<S: Store>() {
    let make = || {
        let mut dcel = Dcel::<S>::default();
        let h = an_edge(&mut dcel);
        dcel.connect(h, h, Split::default()).unwrap();
        dcel
    };
    let (mut one, other) = (make(), make());
    let before = Table::copy_of(&one);
    let (vertices, half_edges, boundaries, faces) = all_keys(&other);
    for v in vertices {
        assert_eq!(one.vertex(v).unwrap_err(), StaleKey::Vertex(v));
        assert_eq!(one.remove_isolated_vertex(v), Err(StaleKey::Vertex(v).into()));
    }
    for h in half_edges {
        assert_eq!(one.half_edge(h).unwrap_err(), StaleKey::HalfEdge(h));
        assert_eq!(one.remove_edge(h), Err(StaleKey::HalfEdge(h).into()));
        assert_eq!(one.connect(h, h, Split::default()), Err(StaleKey::HalfEdge(h).into()));
    }
    for b in boundaries {
        assert_eq!(one.boundary(b).unwrap_err(), StaleKey::Boundary(b));
        assert_eq!(one.move_inner(b, one.unbounded_face().key()), Err(StaleKey::Boundary(b).into()));
    }
    for f in faces {
        assert_eq!(one.face(f).unwrap_err(), StaleKey::Face(f));
        assert_eq!(one.add_isolated_vertex(f), Err(StaleKey::Face(f).into()));
    }
    assert_eq!(Table::copy_of(&one), before);
}

#[test]
fn foreign_keys_are_refused_by_every_store() {
    foreign_keys_are_refused::<SlotStore>();
    foreign_keys_are_refused::<PointerStore>();
    foreign_keys_are_refused::<Roomy>();
}

/// A slot is used again, with a key that was never there before, while all keys of the past stay refused.
fn used_slots_get_new_keys<S: Store>() {
    let mut dcel = Dcel::<S>::default();
    let outside = dcel.unbounded_face().key();
    let kept = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let (mut vertices, mut half_edges, mut boundaries, mut faces) =
        (HashSet::new(), HashSet::new(), HashSet::new(), HashSet::new());
    let mut slots = HashSet::new();
    for _ in 0..50 {
        let h = dcel.connect(kept, kept, Split::default()).unwrap();
        let (a, t) = (dcel.half_edge(h.half_edge).unwrap(), dcel.half_edge(h.half_edge).unwrap().twin());
        let face = dcel.face(h.new_face().unwrap()).unwrap();
        slots.insert((a.index().min(t.index()), face.index()));
        assert!(half_edges.insert(a.key()) && half_edges.insert(t.key()) && faces.insert(face.key()));
        let Ok(RemovedEdge::Merged { dropped, .. }) = dcel.remove_edge(h.half_edge) else { panic!() };
        assert!(boundaries.insert(dropped));
        let added = dcel.add_isolated_vertex(outside).unwrap();
        assert!(vertices.insert(added.vertex) && boundaries.insert(added.boundary));
        dcel.remove_isolated_vertex(added.vertex).unwrap();
        assert!(vertices.iter().all(|v| dcel.vertex(*v).is_err()));
        assert!(half_edges.iter().all(|h| dcel.half_edge(*h).is_err()));
        assert!(boundaries.iter().all(|b| dcel.boundary(*b).is_err()));
        assert!(faces.iter().all(|f| dcel.face(*f).is_err()));
    }
    assert_eq!(slots.len(), 1, "the memory is used again");
    assert!(dcel.vertex(kept).is_ok() && dcel.face(outside).is_ok());
}

#[test]
fn used_slots_get_new_keys_in_every_store() {
    used_slots_get_new_keys::<SlotStore>();
    used_slots_get_new_keys::<PointerStore>();
    used_slots_get_new_keys::<FixedStore<2, 1, 2, 2>>();
}

/// Keys made of arbitrary bits name a record only if they are its key.
fn only_keys_that_were_issued_are_accepted<S: Store>() {
    let mut dcel = Dcel::<S>::default();
    let h = an_edge(&mut dcel);
    dcel.connect(h, h, Split::default()).unwrap();
    let (vertices, half_edges, boundaries, faces) = all_keys(&dcel);
    let generation = slotmap::Key::data(&h).as_ffi() >> 32;
    let slots = (0..300).chain([u64::from(u32::MAX) - 1, u64::from(u32::MAX)]);
    let generations =
        [generation, 1, generation.wrapping_add(2) & 0xFFFF_FFFF, generation ^ 0x8000_0000, 0, 0xFFFF_FFFF];
    for bits in slots.flat_map(|slot| generations.map(|generation| generation << 32 | slot)) {
        let data = slotmap::KeyData::from_ffi(bits);
        assert_eq!(dcel.vertex(data.into()).is_ok(), vertices.contains(&data.into()), "{data:?}");
        assert_eq!(dcel.half_edge(data.into()).is_ok(), half_edges.contains(&data.into()), "{data:?}");
        assert_eq!(dcel.boundary(data.into()).is_ok(), boundaries.contains(&data.into()), "{data:?}");
        assert_eq!(dcel.face(data.into()).is_ok(), faces.contains(&data.into()), "{data:?}");
    }
}

#[test]
fn only_keys_that_were_issued_are_accepted_by_every_store() {
    only_keys_that_were_issued_are_accepted::<SlotStore>();
    only_keys_that_were_issued_are_accepted::<PointerStore>();
    only_keys_that_were_issued_are_accepted::<Roomy>();
}

/// Data kept beside the structure is found by key, and comes back in full when iterated.
fn secondary_maps_take_the_keys<S: Store>() {
    let mut dcel = Dcel::<S>::default();
    an_edge(&mut dcel);
    let (vertices, half_edges, boundaries, faces) = all_keys(&dcel);
    let of_vertices: slotmap::SecondaryMap<VertexKey, ()> = vertices.iter().map(|v| (*v, ())).collect();
    let of_half_edges: slotmap::SecondaryMap<HalfEdgeKey, ()> = half_edges.iter().map(|h| (*h, ())).collect();
    let of_boundaries: slotmap::SecondaryMap<BoundaryKey, ()> = boundaries.iter().map(|b| (*b, ())).collect();
    let of_faces: slotmap::SecondaryMap<FaceKey, ()> = faces.iter().map(|f| (*f, ())).collect();
    assert_eq!(of_vertices.keys().collect::<Vec<_>>(), vertices);
    assert_eq!(of_half_edges.keys().collect::<Vec<_>>(), half_edges);
    assert_eq!(of_boundaries.keys().collect::<Vec<_>>(), boundaries);
    assert_eq!(of_faces.keys().collect::<Vec<_>>(), faces);
}

#[test]
fn secondary_maps_take_the_keys_of_every_store() {
    secondary_maps_take_the_keys::<SlotStore>();
    secondary_maps_take_the_keys::<PointerStore>();
    secondary_maps_take_the_keys::<Roomy>();
}

/// What is done to a copy does not show in the original, nor the other way round.
fn copies_are_apart<S: Store + Clone>() {
    let mut dcel = Dcel::<S>::default();
    let h = an_edge(&mut dcel);
    dcel.connect(h, h, Split::default()).unwrap();
    let gone = dcel.split_edge(h).unwrap().half_edge;
    dcel.join_edges(h).unwrap();
    let before = Table::copy_of(&dcel);
    let mut copy = dcel.clone();
    assert_eq!(Table::copy_of(&copy), before);
    assert_eq!(all_keys(&copy), all_keys(&dcel));
    assert!(copy.half_edge(gone).is_err());
    copy.split_edge(h).unwrap();
    copy.contract_edge(h).unwrap();
    assert_eq!(Table::copy_of(&dcel), before);
    let after = Table::copy_of(&copy);
    drop(dcel);
    assert_eq!(Table::copy_of(&copy), after);
    assert!(copy.validate().is_valid());
}

#[test]
fn copies_are_apart_in_every_store() {
    copies_are_apart::<SlotStore>();
    copies_are_apart::<PointerStore>();
    copies_are_apart::<Roomy>();
}
