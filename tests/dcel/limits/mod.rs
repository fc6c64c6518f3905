//! A structure with limits only differs from an unlimited one by refusing records that do not fit, without a trace: the same operators
//! make the same structure, step by step, with records named by their order of creation. Invalid keys are refused.

mod full;
mod keys;

use crate::support::erased::validate_plane;
use quickcheck::{Gen, QuickCheck};
use std::collections::HashMap;
use std::hash::Hash;
use std::mem::{Discriminant, discriminant};
use twinedge::dcel::{
    BoundaryKey, Connection, Corner, Dcel, FaceKey, HalfEdgeKey, OperatorError, RecordKind, RemovedEdge, Room, Side,
    Split, StaleKey, Turn, VertexKey,
};
use twinedge::validate::{BoundaryRow, FaceRow, HalfEdgeRow, Start, Table, VertexRow};

/// An empty structure limited to these numbers of vertices, edges, boundary components and faces.
pub(crate) fn limited([vertices, edges, boundaries, faces]: [usize; 4]) -> Dcel {
    Dcel::with_limits(Room { vertices, edges, boundaries, faces })
}

/// The keys of one kind, numbered by the order of creation.
struct Names<K>(Vec<K>);

impl<K: Copy + Eq + Hash> Names<K> {
    fn add(&mut self, key: K) -> usize {
        self.0.push(key);
        self.0.len() - 1
    }

    fn of(&self, key: K) -> usize {
        self.0.iter().rposition(|k| *k == key).expect("a key that was made")
    }

    /// By index in the view: the rank among the live records.
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

/// One operator, with arguments by number.
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

/// The answer of an operator, by number, or the kind of its error.
type Answer = Result<Vec<usize>, (Discriminant<OperatorError>, Option<Discriminant<StaleKey>>, Option<RecordKind>)>;

/// A structure, and the names of all records ever made in it.
struct Run {
    dcel: Dcel,
    vertices: Names<VertexKey>,
    half_edges: Names<HalfEdgeKey>,
    boundaries: Names<BoundaryKey>,
    faces: Names<FaceKey>,
}

impl Run {
    fn of(dcel: Dcel) -> Self {
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

    /// The answers of the structure, with live records numbered in the order of creation.
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
        Table { vertices, half_edges, boundaries, faces, ..said }
    }
}

/// The live rows, which must be the rows with a rank, in order of rank.
fn ordered<R>(rows: &[Option<R>], ranks: &HashMap<usize, usize>, renumbered: impl Fn(&R) -> R) -> Vec<Option<R>> {
    let mut result: Vec<Option<R>> = ranks.iter().map(|_| None).collect();
    for (index, row) in rows.iter().enumerate() {
        if let Some(row) = row {
            result[ranks[&index]] = Some(renumbered(row));
        }
    }
    result
}

/// Picks a live key, mostly, or any key ever issued.
fn pick<K: Copy>(keys: &[K], live: impl Fn(K) -> bool, random: u16) -> Option<usize> {
    let any_at_all = random.is_multiple_of(16);
    let candidates: Vec<usize> = (0..keys.len()).filter(|i| any_at_all || live(keys[*i])).collect();
    candidates.get(random as usize / 16 % candidates.len().max(1)).copied()
}

impl Run {
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

    /// A corner to combine with another: of the same face or vertex, mostly.
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

    /// The step that these numbers encode, if its elements exist.
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

/// Puts an edge with two vertices in the unbounded face. Takes only one boundary component.
fn an_edge(dcel: &mut Dcel) -> HalfEdgeKey {
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    dcel.split_vertex(v, v).unwrap().half_edge
}

/// Runs a property of programs, always the same ones.
fn for_programs(property: fn(Vec<[u16; 4]>) -> bool) {
    QuickCheck::new().rng(Gen::from_size_and_seed(100, 7)).tests(1000).quickcheck(property);
}

#[test]
fn what_does_not_fit_is_refused_without_a_trace_and_what_fits_is_not() {
    fn like_one_without_limits(program: Vec<[u16; 4]>) -> bool {
        let (mut free, mut limited) = (Run::of(Dcel::new()), Run::of(limited([3, 4, 4, 3])));
        for numbers in program {
            let Some(step) = free.step(numbers) else { continue };
            let before = Table::copy_of(&limited.dcel);
            let answer = limited.apply(&step);
            if let Err((_, _, Some(kind))) = answer {
                assert_eq!(before, Table::copy_of(&limited.dcel), "{step:?}");
                let (count, most) = match kind {
                    RecordKind::Vertex => (limited.dcel.vertex_count(), 3),
                    RecordKind::Edge => (limited.dcel.edge_count(), 4),
                    RecordKind::Boundary => (limited.dcel.boundary_count(), 4),
                    RecordKind::Face => (limited.dcel.face_count(), 3),
                    other => panic!("{other:?}"),
                };
                assert_eq!(count, most, "{step:?}");
                continue;
            }
            assert_eq!(answer, free.apply(&step), "{step:?}");
            assert_eq!(limited.table(), free.table(), "{step:?}");
            assert!(validate_plane(&limited.dcel).is_valid(), "{step:?}");
        }
        true
    }
    for_programs(like_one_without_limits);
}
