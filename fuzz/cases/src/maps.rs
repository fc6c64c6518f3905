//! Targets that run programs of operators.

use std::collections::BTreeSet;
use std::fmt::Debug;
use twinedge::dcel::{
    BoundaryKey, Corner, Dcel, FaceKey, HalfEdgeKey, OperatorError, Room, Side, Split, Turn, VertexKey,
};
use twinedge::program::conformance::{Conformance, Coverage};
use twinedge::program::{Program, Runner, Subject};
use twinedge::validate::{Expectation, Table};
use twinedge_trials::RawPointers;

/// Longer programs are cut off: the second model of `in_step` takes O(n²) per operator.
const LONGEST: usize = 300;

fn program(bytes: &[u8]) -> Program {
    let mut program = Program::from_bytes(bytes);
    program.0.truncate(LONGEST);
    program
}

/// Runs operators, with the validator after each.
///
/// # Panics
/// If a rule is broken.
pub fn programs(bytes: &[u8]) {
    let program = program(bytes);
    let mut runner = Runner::new(Dcel::new());
    for (i, op) in program.0.iter().enumerate() {
        runner.step(*op);
        let report = runner.subject().validate();
        assert!(report.is_valid(), "after operator {} of\n{program}\n{report}", i + 1);
    }
}

/// Runs the structure, with limits and without, and the second model, in step with the first.
///
/// # Panics
/// If they differ.
pub fn in_step(bytes: &[u8]) {
    let program = program(bytes);
    conforms(&program, Dcel::new(), Expectation::plane());
    conforms(&program, RawPointers::new(), Expectation::plane());
    let most = Room { vertices: 4, edges: 5, boundaries: 4, faces: 3 };
    conforms(&program, Dcel::with_limits(most), Expectation::plane());
}

fn conforms<K: Subject + Debug>(program: &Program, subject: K, expectation: Expectation) {
    // Many programs of a fuzzer apply no operator.
    let asked = Conformance::of(&expectation).coverage(Coverage::Nothing);
    if let Err(failure) = asked.run(program, subject) {
        panic!("{}: {failure}\n{program}", std::any::type_name::<K>());
    }
}

/// All keys that a structure has issued.
#[derive(Default)]
struct Keys {
    vertices: BTreeSet<VertexKey>,
    half_edges: BTreeSet<HalfEdgeKey>,
    boundaries: BTreeSet<BoundaryKey>,
    faces: BTreeSet<FaceKey>,
}

impl Keys {
    fn of(dcel: &Dcel) -> Self {
        Self {
            vertices: dcel.vertices().map(|v| v.key()).collect(),
            half_edges: dcel.half_edges().map(|h| h.key()).collect(),
            boundaries: dcel.boundaries().map(|b| b.key()).collect(),
            faces: dcel.faces().map(|f| f.key()).collect(),
        }
    }

    /// Returns the keys that are not in `others`.
    fn without(&self, others: &Self) -> Self {
        Self {
            vertices: &self.vertices - &others.vertices,
            half_edges: &self.half_edges - &others.half_edges,
            boundaries: &self.boundaries - &others.boundaries,
            faces: &self.faces - &others.faces,
        }
    }

    fn take_up(&mut self, others: Self) {
        self.vertices.extend(others.vertices);
        self.half_edges.extend(others.half_edges);
        self.boundaries.extend(others.boundaries);
        self.faces.extend(others.faces);
    }
}

/// Passes keys of removed records, and keys of another structure, to every accessor after each operator, and to every
/// operator at the end.
///
/// # Panics
/// If a key is taken for a live one, or something is changed.
pub fn stale_keys(bytes: &[u8]) {
    let program = program(bytes);
    let mut stranger = Runner::new(Dcel::new());
    stranger.run(&program);
    let mut stale = Keys::of(stranger.subject());

    let mut runner = Runner::new(Dcel::new());
    let mut before = Keys::of(runner.subject());
    for op in &program.0 {
        runner.step(*op);
        let now = Keys::of(runner.subject());
        stale.take_up(before.without(&now));
        assert_refused_by_accessors(runner.subject(), &stale);
        before = now;
    }
    assert_refused_by_operators(&mut runner.into_subject(), &stale);
}

fn assert_refused_by_accessors(dcel: &Dcel, stale: &Keys) {
    for v in &stale.vertices {
        assert!(dcel.vertex(*v).is_err(), "{v:?} names another vertex");
    }
    for h in &stale.half_edges {
        assert!(dcel.half_edge(*h).is_err(), "{h:?} names another half-edge");
    }
    for b in &stale.boundaries {
        assert!(dcel.boundary(*b).is_err(), "{b:?} names another boundary component");
    }
    for f in &stale.faces {
        assert!(dcel.face(*f).is_err(), "{f:?} names another face");
    }
}

fn stale<T>(what: &str, answer: Result<T, OperatorError>) {
    let refusal = answer.err();
    assert!(matches!(refusal, Some(OperatorError::Stale(_))), "{what} takes a stale key: {refusal:?}");
}

fn assert_refused_by_operators(dcel: &mut Dcel, keys: &Keys) {
    let before = Table::copy_of(dcel);
    let outside = dcel.unbounded_face().key();
    let live = dcel.half_edges().next().map(|h| h.key());
    let inner = dcel.unbounded_face().inner().next().map(|b| b.key());
    for h in keys.half_edges.iter().copied() {
        stale("remove_edge", dcel.remove_edge(h));
        stale("split_edge", dcel.split_edge(h));
        stale("join_edges", dcel.join_edges(h));
        stale("contract_edge", dcel.contract_edge(h));
        stale("flip_edge", dcel.flip_edge(h, Turn::CounterClockwise));
        stale("flip_edge", dcel.flip_edge(h, Turn::Clockwise));
        assert_corner_refused(dcel, h.into(), live);
    }
    for v in keys.vertices.iter().copied() {
        stale("remove_isolated_vertex", dcel.remove_isolated_vertex(v));
        assert_corner_refused(dcel, v.into(), live);
    }
    for b in keys.boundaries.iter().copied() {
        stale("move_inner", dcel.move_inner(b, outside));
        if let Some(live) = live {
            stale("connect", dcel.connect(live, live, Split { new_face: Side::Left, inner: &[b] }));
        }
    }
    for f in keys.faces.iter().copied() {
        stale("add_isolated_vertex", dcel.add_isolated_vertex(f));
        if let Some(inner) = inner {
            stale("move_inner", dcel.move_inner(inner, f));
        }
    }
    assert_eq!(Table::copy_of(dcel), before, "a refusal leaves a trace");
}

fn assert_corner_refused(dcel: &mut Dcel, corner: Corner, live: Option<HalfEdgeKey>) {
    stale("connect", dcel.connect(corner, corner, Split::default()));
    stale("split_vertex", dcel.split_vertex(corner, corner));
    if let Some(live) = live {
        stale("connect", dcel.connect(live, corner, Split::default()));
        stale("connect", dcel.connect(corner, live, Split::default()));
        stale("split_vertex", dcel.split_vertex(live, corner));
        stale("split_vertex", dcel.split_vertex(corner, live));
    }
}
