//! Laws of the operators of any subject.
//!
//! Each body starts from the empty map, and returns whether the case was relevant: an operator that refuses keeps the
//! rules too, but says little.

use crate::grow::{Arguments, Bound, choose_op, choose_side, choose_turn, grow};
use twinedge::program::choose::Choose;
use twinedge::program::{
    Call, CallOf, Corner, CornerOf, Handle, OpKind, Refusal, Runner, Side, StepOutcome, Subject, Turn,
};
use twinedge::validate::{Collect, Expectation, Table, View, validate};
use twinedge_trials::canonical;

fn grown<K: Subject>(empty: K, bound: Bound, source: &mut impl Choose) -> Runner<K> {
    let mut runner = Runner::new(empty);
    grow(&mut runner, bound, source);
    runner
}

fn keeps_all_rules<V: View>(view: &V) -> bool {
    validate(view, &Expectation::plane(), Collect::First).is_valid()
}

/// Checks that an operator, with any live arguments, leaves a map that keeps every rule.
///
/// # Panics
/// If a rule is broken.
pub fn keeps_rules<K: Subject>(operator: OpKind, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
    let mut runner = grown(empty, bound, source);
    let Some(op) = choose_op(operator, Arguments::Live, bound.islands, &runner, source) else { return false };
    let outcome = runner.step(op);
    assert!(keeps_all_rules(runner.subject()), "a rule is broken after {op:?}");
    outcome == StepOutcome::Applied
}

/// Checks that an operator that refuses, for its arguments or for lack of room, leaves every field of the structure
/// unchanged.
///
/// One operator that retires handles runs before it, so that there are stale handles to choose.
///
/// # Panics
/// If a field has changed.
pub fn refuses_without_a_trace<K: Subject>(operator: OpKind, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
    let mut runner = grown(empty, bound, source);
    retire(bound, &mut runner, source);
    let before = Table::copy_of(runner.subject());
    let Some(op) = choose_op(operator, Arguments::Any, bound.islands, &runner, source) else { return false };
    let StepOutcome::Refused(_) = runner.step(op) else { return false };
    assert!(Table::copy_of(runner.subject()) == before, "a trace is left by {op:?}");
    true
}

/// Removes a record, or nothing.
fn retire<K: Subject>(bound: Bound, runner: &mut Runner<K>, source: &mut impl Choose) -> bool {
    let operator = match source.choose(5) {
        0 => return false,
        1 => OpKind::RemoveIsolatedVertex,
        2 => OpKind::RemoveEdge,
        3 => OpKind::JoinEdges,
        _ => OpKind::ContractEdge,
    };
    let op = choose_op(operator, Arguments::Live, bound.islands, runner, source);
    op.is_some_and(|op| runner.step(op) == StepOutcome::Applied)
}

/// The kind of a handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "named after what is named")]
pub enum HandleKind {
    Vertex,
    HalfEdge,
    Face,
}

/// Checks that every operator and every query refuses a stale handle as stale, even after its slot was used again.
///
/// # Panics
/// If a stale handle is taken for a live one, or refused for another reason.
pub fn refuses_stale<K: Subject>(kind: HandleKind, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
    let mut runner = grown(empty, bound, source);
    if !retire(bound, &mut runner, source) {
        return false;
    }
    grow(&mut runner, Bound { edges: 1, islands: 0 }, source);
    let stale_half_edges = runner.retired_half_edges().to_vec();
    let stale_vertices = runner.retired_vertices().to_vec();
    let stale_faces = runner.retired_faces().to_vec();
    let corner = runner.corners().next();
    let mut subject = runner.into_subject();
    match kind {
        HandleKind::HalfEdge => {
            for h in &stale_half_edges {
                refuses_stale_half_edge(&mut subject, *h, corner);
            }
            !stale_half_edges.is_empty()
        }
        HandleKind::Vertex => {
            for v in &stale_vertices {
                refuses_stale_vertex(&mut subject, *v, corner);
            }
            !stale_vertices.is_empty()
        }
        HandleKind::Face => {
            for f in &stale_faces {
                refuses_stale_face(&mut subject, *f, corner);
            }
            !stale_faces.is_empty()
        }
    }
}

/// Asserts that the answer is a refusal of a stale handle.
fn stale<T>(what: &str, answer: Result<T, Refusal>) {
    let refusal = answer.err();
    assert!(refusal == Some(Refusal::Stale), "a stale handle is not refused as such by {what}: {refusal:?}");
}

/// Asserts that the operator refuses a stale handle.
fn refuses<K: Subject>(subject: &mut K, call: CallOf<K>) {
    let name = call.kind().name();
    stale(name, subject.apply(call));
}

fn refuses_stale_half_edge<K: Subject>(subject: &mut K, half_edge: K::HalfEdge, live: Option<CornerOf<K>>) {
    stale("origin_of", subject.origin_of(half_edge));
    stale("twin_of", subject.twin_of(half_edge));
    stale("next_of", subject.next_of(half_edge));
    refuses(subject, Call::RemoveEdge { half_edge });
    refuses(subject, Call::SplitEdge { half_edge });
    refuses(subject, Call::JoinEdges { half_edge });
    refuses(subject, Call::ContractEdge { half_edge });
    for turn in [Turn::CounterClockwise, Turn::Clockwise] {
        refuses(subject, Call::FlipEdge { half_edge, turn });
    }
    refuses_stale_corner(subject, Corner::At(half_edge), live);
}

fn refuses_stale_vertex<K: Subject>(subject: &mut K, vertex: K::Vertex, live: Option<CornerOf<K>>) {
    refuses(subject, Call::RemoveIsolatedVertex { vertex });
    refuses_stale_corner(subject, Corner::Isolated(vertex), live);
}

fn refuses_stale_corner<K: Subject>(subject: &mut K, corner: CornerOf<K>, live: Option<CornerOf<K>>) {
    stale("face_of", subject.face_of(corner));
    if let Some(face) = subject.unbounded_face() {
        refuses(subject, Call::MoveInner { inner: corner, face });
    }
    refuses(subject, Call::connect(corner, corner));
    refuses(subject, Call::SplitVertex { from: corner, to: corner });
    if let Some(live) = live {
        refuses(subject, Call::connect(live, corner));
        refuses(subject, Call::Connect { from: live, to: live, new_face: Side::Left, inner: vec![corner] });
        refuses(subject, Call::SplitVertex { from: live, to: corner });
    }
}

fn refuses_stale_face<K: Subject>(subject: &mut K, face: K::Face, live: Option<CornerOf<K>>) {
    refuses(subject, Call::AddIsolatedVertex { face });
    if let Some(inner) = live {
        refuses(subject, Call::MoveInner { inner, face });
    }
}

/// Checks that an operator followed by its inverse yields an isomorphic map.
///
/// # Panics
/// If the map differs, or if the inverse is refused.
pub fn is_undone<K: Subject>(operator: OpKind, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
    let runner = grown(empty, bound, source);
    let map = Map {
        half_edges: runner.half_edges().to_vec(),
        isolated: runner.isolated().to_vec(),
        corners: runner.corners().collect(),
        subject: runner.into_subject(),
    };
    let before = canonical::code(&map.subject);
    let Some((subject, inverse)) = map.there_and_back(operator, bound, source) else { return false };
    assert!(inverse, "{operator:?} is not undone: the inverse is refused");
    assert!(
        before.is_some() && canonical::code(&subject) == before,
        "{operator:?} is not undone: another map comes back"
    );
    true
}

struct Map<K: Subject> {
    subject: K,
    half_edges: Vec<K::HalfEdge>,
    isolated: Vec<K::Vertex>,
    corners: Vec<CornerOf<K>>,
}

impl<K: Subject> Map<K> {
    /// Returns the subject after an operator and its inverse, and whether the inverse was done; `None` if the
    /// operator was refused.
    fn there_and_back(mut self, operator: OpKind, bound: Bound, source: &mut impl Choose) -> Option<(K, bool)> {
        let inverse = match operator {
            OpKind::AddIsolatedVertex => {
                let face = self.choose_face(source)?;
                let Handle::Vertex(vertex) = self.subject.apply(Call::AddIsolatedVertex { face }).ok()?? else {
                    return None;
                };
                self.subject.apply(Call::RemoveIsolatedVertex { vertex }).is_ok()
            }
            OpKind::RemoveIsolatedVertex => {
                let vertex = choose_of(&self.isolated, source)?;
                let face = self.subject.face_of(Corner::Isolated(vertex)).ok()?;
                self.subject.apply(Call::RemoveIsolatedVertex { vertex }).ok()?;
                self.subject.apply(Call::AddIsolatedVertex { face }).is_ok()
            }
            OpKind::Connect => {
                let from = choose_of(&self.corners, source)?;
                let to = choose_of(&self.corners, source)?;
                let inner: Vec<_> =
                    (0..source.choose(bound.islands + 1)).filter_map(|_| choose_of(&self.corners, source)).collect();
                let call = Call::Connect { from, to, new_face: choose_side(source), inner };
                let half_edge = self.subject.make_edge(call).ok()?;
                self.subject.apply(Call::RemoveEdge { half_edge }).is_ok()
            }
            OpKind::RemoveEdge => {
                let n = choose_of(&self.half_edges, source)?;
                self.remove_and_connect(n)?
            }
            OpKind::SplitEdge => {
                let half_edge = choose_of(&self.half_edges, source)?;
                self.subject.apply(Call::SplitEdge { half_edge }).ok()?;
                self.subject.apply(Call::JoinEdges { half_edge }).is_ok()
            }
            OpKind::JoinEdges => {
                let half_edge = choose_of(&self.half_edges, source)?;
                self.subject.apply(Call::JoinEdges { half_edge }).ok()?;
                self.subject.apply(Call::SplitEdge { half_edge }).is_ok()
            }
            OpKind::SplitVertex => {
                let from = choose_of(&self.corners, source)?;
                let to = choose_of(&self.corners, source)?;
                let half_edge = self.subject.make_edge(Call::SplitVertex { from, to }).ok()?;
                self.subject.apply(Call::ContractEdge { half_edge }).is_ok()
            }
            OpKind::ContractEdge => {
                let n = choose_of(&self.half_edges, source)?;
                self.contract_and_split(n)?
            }
            OpKind::FlipEdge => {
                let (half_edge, turn) = (choose_of(&self.half_edges, source)?, choose_turn(source));
                self.subject.apply(Call::FlipEdge { half_edge, turn }).ok()?;
                self.subject.apply(Call::FlipEdge { half_edge, turn: turn.reversed() }).is_ok()
            }
            OpKind::MoveInner => {
                let inner = choose_of(&self.corners, source)?;
                let old = self.subject.face_of(inner).ok()?;
                let face = self.choose_face(source)?;
                self.subject.apply(Call::MoveInner { inner, face }).ok()?;
                self.subject.apply(Call::MoveInner { inner, face: old }).is_ok()
            }
            OpKind::MeshFlipEdge | OpKind::MeshSplitEdge | OpKind::MeshSplitFace | OpKind::MeshCollapseEdge => {
                return None;
            }
        };
        Some((self.subject, inverse))
    }

    fn choose_face(&self, source: &mut impl Choose) -> Option<K::Face> {
        let mut faces: Vec<_> = self.subject.unbounded_face().into_iter().collect();
        for corner in &self.corners {
            faces.extend(self.subject.face_of(*corner).ok().filter(|face| !faces.contains(face)));
        }
        choose_of(&faces, source)
    }

    /// Returns the corner in which a half-edge leaves, as it is named once its edge is removed.
    fn corner_without(&self, n: K::HalfEdge) -> Option<CornerOf<K>> {
        let t = self.subject.twin_of(n).ok()?;
        let other = self.subject.next_of(t).ok()?;
        if other != n && other != t {
            return Some(Corner::At(other));
        }
        // At a loop with nothing on one side, the corner is on the other side; at a leaf there is no other half-edge.
        let across = self.subject.next_of(n).ok()?;
        let is_loop = self.subject.origin_of(n).ok()? == self.subject.origin_of(t).ok()?;
        if is_loop && across != n && across != t {
            return Some(Corner::At(across));
        }
        Some(Corner::Isolated(self.subject.origin_of(n).ok()?))
    }

    fn cycle(&self, start: K::HalfEdge) -> Vec<K::HalfEdge> {
        let mut cycle = vec![start];
        while let Some(Ok(next)) = cycle.last().map(|h| self.subject.next_of(*h))
            && next != start
            && cycle.len() <= self.half_edges.len()
        {
            cycle.push(next);
        }
        cycle
    }

    fn remove_and_connect(&mut self, n: K::HalfEdge) -> Option<bool> {
        let t = self.subject.twin_of(n).ok()?;
        let (from, to) = (self.corner_without(n)?, self.corner_without(t)?);
        // The isolated vertices and half-edges in the face to either side of the edge, on other boundary components.
        let sides = [n, t].map(|side| {
            let cycle = self.cycle(side);
            let face = self.subject.face_of(Corner::At(side)).ok();
            let lies_in = |corner: &&CornerOf<K>| {
                let on_cycle = matches!(corner, Corner::At(h) if cycle.contains(h));
                !on_cycle && self.subject.face_of(**corner).ok() == face
            };
            (face, self.corners.iter().filter(lies_in).copied().collect::<Vec<_>>())
        });
        // A loop drawn from a corner to itself has everything else to its left. If this one has it to its right, draw
        // its twin.
        let is_alone = self.subject.next_of(n).ok()? == n;
        let dropped = match self.subject.apply(Call::RemoveEdge { half_edge: n }).ok()? {
            Some(Handle::Face(face)) => Some(face),
            _ => None,
        };
        let [(left, in_left), (_, in_right)] = sides;
        let (new_face, inner) = match dropped {
            None => (Side::Left, Vec::new()),
            Some(_) if dropped == left => (if is_alone { Side::Right } else { Side::Left }, in_left),
            Some(_) => (if is_alone { Side::Left } else { Side::Right }, in_right),
        };
        Some(self.subject.apply(Call::Connect { from, to, new_face, inner }).is_ok())
    }

    fn contract_and_split(&mut self, n: K::HalfEdge) -> Option<bool> {
        let t = self.subject.twin_of(n).ok()?;
        let ends = [self.subject.origin_of(n).ok()?, self.subject.origin_of(t).ok()?];
        let (after_t, after_n) = (self.subject.next_of(t).ok()?, self.subject.next_of(n).ok()?);
        let dropped = self.subject.apply(Call::ContractEdge { half_edge: n }).ok()?;
        let kept = if dropped == Some(Handle::Vertex(ends[0])) { ends[1] } else { ends[0] };
        // The half-edges of the target lie between these two corners; a leaf has none, so they are one.
        let (from, to) = match (after_t == n, after_n == t) {
            (false, false) => (Corner::At(after_t), Corner::At(after_n)),
            (false, true) => (Corner::At(after_t), Corner::At(after_t)),
            (true, false) => (Corner::At(after_n), Corner::At(after_n)),
            (true, true) => (Corner::Isolated(kept), Corner::Isolated(kept)),
        };
        Some(self.subject.apply(Call::SplitVertex { from, to }).is_ok())
    }
}

fn choose_of<T: Copy>(list: &[T], source: &mut impl Choose) -> Option<T> {
    list.get(source.choose(list.len())).copied()
}
