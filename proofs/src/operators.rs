//! Laws of the operators of any subject.
//!
//! Each body starts from the empty map, and tells whether the case was one that it speaks about: an operator that
//! refuses keeps the rules too, but says little.

use crate::grow::{Arguments, Bound, Operator, choose_op, choose_side, choose_turn, grow};
use twinedge::program::choose::Choose;
use twinedge::program::{Corner, CornerOf, Refusal, Runner, Side, StepOutcome, Subject, Turn, canonical};
use twinedge::validate::{Collect, Expectation, Table, View, validate};

fn grown<K: Subject>(empty: K, bound: Bound, source: &mut impl Choose) -> Runner<K> {
    let mut runner = Runner::new(empty);
    grow(&mut runner, bound, source);
    runner
}

fn keeps_all_rules<V: View>(view: &V) -> bool {
    validate(view, &Expectation::plane(), Collect::First).is_valid()
}

/// An operator, with any live arguments, leaves a map that keeps every rule.
///
/// # Panics
/// If a rule is broken.
pub fn keeps_rules<K: Subject>(operator: Operator, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
    let mut runner = grown(empty, bound, source);
    let Some(op) = choose_op(operator, Arguments::Live, bound.islands, &runner, source) else { return false };
    let outcome = runner.step(op);
    assert!(keeps_all_rules(runner.subject()), "a rule is broken after {op:?}");
    outcome == StepOutcome::Applied
}

/// An operator that refuses, be it for its arguments or for want of room, leaves the structure as it was, in every
/// field.
///
/// Before it, one operator is run that retires handles, so that there are stale ones to choose.
///
/// # Panics
/// If a field has changed.
pub fn refuses_without_a_trace<K: Subject>(
    operator: Operator,
    bound: Bound,
    empty: K,
    source: &mut impl Choose,
) -> bool {
    let mut runner = grown(empty, bound, source);
    retire(bound, &mut runner, source);
    let before = Table::copy_of(runner.subject());
    let Some(op) = choose_op(operator, Arguments::Any, bound.islands, &runner, source) else { return false };
    let StepOutcome::Refused(_) = runner.step(op) else { return false };
    assert!(Table::copy_of(runner.subject()) == before, "a trace is left by {op:?}");
    true
}

/// Removes something, or nothing.
fn retire<K: Subject>(bound: Bound, runner: &mut Runner<K>, source: &mut impl Choose) -> bool {
    let operator = match source.choose(5) {
        0 => return false,
        1 => Operator::RemoveIsolatedVertex,
        2 => Operator::RemoveEdge,
        3 => Operator::JoinEdges,
        _ => Operator::ContractEdge,
    };
    let op = choose_op(operator, Arguments::Live, bound.islands, runner, source);
    op.is_some_and(|op| runner.step(op) == StepOutcome::Applied)
}

/// The kind of a handle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "named after what is named")]
pub enum Handle {
    Vertex,
    HalfEdge,
    Face,
}

/// Every operator and every question refuses a stale handle as stale, also after its slot was used again.
///
/// # Panics
/// If it is taken for a live one, or refused for another reason.
pub fn refuses_stale<K: Subject>(kind: Handle, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
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
        Handle::HalfEdge => {
            for h in &stale_half_edges {
                refuses_stale_half_edge(&mut subject, *h, corner);
            }
            !stale_half_edges.is_empty()
        }
        Handle::Vertex => {
            for v in &stale_vertices {
                refuses_stale_vertex(&mut subject, *v, corner);
            }
            !stale_vertices.is_empty()
        }
        Handle::Face => {
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

fn refuses_stale_half_edge<K: Subject>(subject: &mut K, h: K::HalfEdge, live: Option<CornerOf<K>>) {
    let corner = Corner::At(h);
    stale("origin_of", subject.origin_of(h));
    stale("twin_of", subject.twin_of(h));
    stale("next_of", subject.next_of(h));
    stale("remove_edge", subject.remove_edge(h));
    stale("split_edge", subject.split_edge(h));
    stale("join_edges", subject.join_edges(h));
    stale("contract_edge", subject.contract_edge(h));
    for turn in [Turn::CounterClockwise, Turn::Clockwise] {
        stale("flip_edge", subject.flip_edge(h, turn));
    }
    refuses_stale_corner(subject, corner, live);
}

fn refuses_stale_vertex<K: Subject>(subject: &mut K, v: K::Vertex, live: Option<CornerOf<K>>) {
    stale("remove_isolated_vertex", subject.remove_isolated_vertex(v));
    refuses_stale_corner(subject, Corner::Isolated(v), live);
}

fn refuses_stale_corner<K: Subject>(subject: &mut K, corner: CornerOf<K>, live: Option<CornerOf<K>>) {
    stale("face_of", subject.face_of(corner));
    if let Some(outside) = subject.unbounded_face() {
        stale("move_inner", subject.move_inner(corner, outside));
    }
    stale("connect", subject.connect(corner, corner, Side::Left, &[]));
    stale("split_vertex", subject.split_vertex(corner, corner));
    if let Some(live) = live {
        stale("connect", subject.connect(live, corner, Side::Left, &[]));
        stale("connect", subject.connect(live, live, Side::Left, &[corner]));
        stale("split_vertex", subject.split_vertex(live, corner));
    }
}

fn refuses_stale_face<K: Subject>(subject: &mut K, f: K::Face, live: Option<CornerOf<K>>) {
    stale("add_isolated_vertex", subject.add_isolated_vertex(f));
    if let Some(live) = live {
        stale("move_inner", subject.move_inner(live, f));
    }
}

/// An operator, then its inverse, gives an isomorphic map.
///
/// # Panics
/// If it does not, or if the inverse is refused.
pub fn is_undone<K: Subject>(operator: Operator, bound: Bound, empty: K, source: &mut impl Choose) -> bool {
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
    /// The subject after an operator and its inverse, and whether the latter was done; nothing if the former was
    /// refused.
    fn there_and_back(mut self, operator: Operator, bound: Bound, source: &mut impl Choose) -> Option<(K, bool)> {
        let inverse = match operator {
            Operator::AddIsolatedVertex => {
                let face = self.choose_face(source)?;
                let v = self.subject.add_isolated_vertex(face).ok()?;
                self.subject.remove_isolated_vertex(v).is_ok()
            }
            Operator::RemoveIsolatedVertex => {
                let v = choose_of(&self.isolated, source)?;
                let face = self.subject.face_of(Corner::Isolated(v)).ok()?;
                self.subject.remove_isolated_vertex(v).ok()?;
                self.subject.add_isolated_vertex(face).is_ok()
            }
            Operator::Connect => {
                let from = choose_of(&self.corners, source)?;
                let to = choose_of(&self.corners, source)?;
                let inner: Vec<_> =
                    (0..source.choose(bound.islands + 1)).filter_map(|_| choose_of(&self.corners, source)).collect();
                let n = self.subject.connect(from, to, choose_side(source), &inner).ok()?;
                self.subject.remove_edge(n).is_ok()
            }
            Operator::RemoveEdge => {
                let n = choose_of(&self.half_edges, source)?;
                self.remove_and_connect(n)?
            }
            Operator::SplitEdge => {
                let h = choose_of(&self.half_edges, source)?;
                self.subject.split_edge(h).ok()?;
                self.subject.join_edges(h).is_ok()
            }
            Operator::JoinEdges => {
                let h = choose_of(&self.half_edges, source)?;
                self.subject.join_edges(h).ok()?;
                self.subject.split_edge(h).is_ok()
            }
            Operator::SplitVertex => {
                let from = choose_of(&self.corners, source)?;
                let to = choose_of(&self.corners, source)?;
                let n = self.subject.split_vertex(from, to).ok()?;
                self.subject.contract_edge(n).is_ok()
            }
            Operator::ContractEdge => {
                let n = choose_of(&self.half_edges, source)?;
                self.contract_and_split(n)?
            }
            Operator::FlipEdge => {
                let (h, turn) = (choose_of(&self.half_edges, source)?, choose_turn(source));
                self.subject.flip_edge(h, turn).ok()?;
                self.subject.flip_edge(h, turn.reversed()).is_ok()
            }
            Operator::MoveInner => {
                let inner = choose_of(&self.corners, source)?;
                let old = self.subject.face_of(inner).ok()?;
                let face = self.choose_face(source)?;
                self.subject.move_inner(inner, face).ok()?;
                self.subject.move_inner(inner, old).is_ok()
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

    /// The corner in which a half-edge leaves, as it is named once its edge is gone.
    fn corner_without(&self, n: K::HalfEdge) -> Option<CornerOf<K>> {
        let t = self.subject.twin_of(n).ok()?;
        let other = self.subject.next_of(t).ok()?;
        if other != n && other != t {
            return Some(Corner::At(other));
        }
        // At a loop with nothing on one side, the corner is that on the other side; at a leaf there is no other
        // half-edge.
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
        // A loop drawn from a corner to itself has all else to its left. If this one has it to its right, its twin is
        // drawn.
        let is_alone = self.subject.next_of(n).ok()? == n;
        let dropped = self.subject.remove_edge(n).ok()?;
        let [(left, in_left), (_, in_right)] = sides;
        let (side, inner) = match dropped {
            None => (Side::Left, Vec::new()),
            Some(_) if dropped == left => (if is_alone { Side::Right } else { Side::Left }, in_left),
            Some(_) => (if is_alone { Side::Left } else { Side::Right }, in_right),
        };
        Some(self.subject.connect(from, to, side, &inner).is_ok())
    }

    fn contract_and_split(&mut self, n: K::HalfEdge) -> Option<bool> {
        let t = self.subject.twin_of(n).ok()?;
        let ends = [self.subject.origin_of(n).ok()?, self.subject.origin_of(t).ok()?];
        let (after_t, after_n) = (self.subject.next_of(t).ok()?, self.subject.next_of(n).ok()?);
        let dropped = self.subject.contract_edge(n).ok()?;
        let kept = if dropped == ends[0] { ends[1] } else { ends[0] };
        // The half-edges of the target are met between these two corners; a leaf has none, so they are one.
        let (from, to) = match (after_t == n, after_n == t) {
            (false, false) => (Corner::At(after_t), Corner::At(after_n)),
            (false, true) => (Corner::At(after_t), Corner::At(after_t)),
            (true, false) => (Corner::At(after_n), Corner::At(after_n)),
            (true, true) => (Corner::Isolated(kept), Corner::Isolated(kept)),
        };
        Some(self.subject.split_vertex(from, to).is_ok())
    }
}

fn choose_of<T: Copy>(list: &[T], source: &mut impl Choose) -> Option<T> {
    list.get(source.choose(list.len())).copied()
}
