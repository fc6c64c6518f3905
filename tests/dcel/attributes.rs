//! Values that follow operators: none is lost or doubled, and each stays where it was.

use crate::support::tokens::{Handles, Mints, Tokens};
use quickcheck::{Arbitrary, Gen, QuickCheck, Testable};
use std::collections::BTreeMap;
use twinedge::dcel::{
    Dcel, FaceKey, HalfEdgeKey, History, OperatorError, Policy, Quantity, Recorded, Split, VertexKey,
};
use twinedge::program::{Program, Refusal, Runner, StepOutcome, Subject};
use twinedge::validate::View;
use twinedge::{delegate_subject, delegate_view};

fn check(tests: u64, size: usize, law: impl Testable) {
    QuickCheck::new().rng(Gen::from_size_and_seed(size, 2026)).tests(tests).quickcheck(law);
}

/// By token of a corner its vertex, and by token of a half-edge its face.
fn places(handles: Handles, dcel: &Dcel) -> (BTreeMap<u64, VertexKey>, BTreeMap<u64, FaceKey>) {
    let (mut vertices, mut faces) = (BTreeMap::new(), BTreeMap::new());
    for h in dcel.half_edges() {
        let tokens = |of: Option<&Tokens>| of.cloned().unwrap_or_default();
        vertices
            .extend(tokens(dcel.value(handles.corners, h.key())).into_iter().map(|token| (token, h.origin().key())));
        faces.extend(tokens(dcel.value(handles.half_edges, h.key())).into_iter().map(|token| (token, h.face().key())));
    }
    (vertices, faces)
}

#[test]
fn no_token_is_lost_or_doubled_by_any_operator_and_each_stays_where_it_was() {
    fn law(program: Program) {
        let mints = Mints::default();
        let mut dcel = Dcel::new();
        let handles = Handles::new(&mut dcel, &mints, 0);
        let mut runner = Runner::new(dcel);
        for op in &program.0 {
            let before = runner.subject().clone();
            let name = op.name();
            runner.step(*op);
            let dcel = runner.subject();
            handles.check(dcel, &mints);
            let ((was_at, was_beside), (is_at, is_beside)) = (places(handles, &before), places(handles, dcel));
            for (token, v) in &is_at {
                let stays = was_at.get(token).is_none_or(|was| was == v);
                // A vertex is split in two, or two are one now.
                assert!(stays || before.vertex(*v).is_err() || dcel.vertex(was_at[token]).is_err(), "{name}: {token}");
            }
            for (token, f) in &is_beside {
                let stays = was_beside.get(token).is_none_or(|was| was == f);
                let moves = name == "move_inner" || name == "connect" || name == "flip_edge";
                assert!(stays || moves || dcel.face(was_beside[token]).is_err(), "{name}: {token}");
            }
        }
    }
    check(150, 60, law as fn(Program));
}

#[test]
fn a_refusal_changes_nothing() {
    fn law(program: Program) -> usize {
        let mints = Mints::default();
        let mut dcel = Dcel::new();
        let handles = Handles::new(&mut dcel, &mints, 7);
        let mut runner = Runner::new(dcel);
        let mut refused = 0;
        for op in &program.0 {
            let before = runner.subject().clone();
            if runner.step(*op) == StepOutcome::Refused(Refusal::Policy) {
                assert!(*runner.subject() == before);
                assert_eq!(handles.values(runner.subject()), handles.values(&before));
                refused += 1;
            }
        }
        refused
    }
    let mut gen_programs = Gen::from_size_and_seed(60, 2026);
    let refused: usize = (0..60).map(|_| law(Program::arbitrary(&mut gen_programs))).sum();
    assert!(refused > 100, "{refused}");
}

#[test]
fn retaining_and_compacting_carry_all_tokens() {
    fn law(program: Program, stays: Vec<bool>) {
        let mints = Mints::default();
        let mut dcel = Dcel::new();
        let handles = Handles::new(&mut dcel, &mints, 0);
        let mut runner = Runner::new(dcel);
        runner.run(&program);
        let mut dcel = runner.into_subject();
        let before = dcel.clone();
        let stays = |i: usize| stays.is_empty() || stays[i % stays.len()];
        dcel.retain(|v| stays(v.index()), |h| stays(h.index() + 1)).unwrap();
        handles.check(&dcel, &mints);
        let (was_at, is_at) = (places(handles, &before).0, places(handles, &dcel).0);
        assert!(is_at.iter().all(|(token, v)| was_at[token] == *v));
        // The rest of a face has the tokens of all that became part of it.
        for f in dcel.faces() {
            let of_old = |f: FaceKey| before.value(handles.faces, f).unwrap().iter();
            let tokens = dcel.value(handles.faces, f.key()).unwrap();
            assert!(of_old(f.key()).all(|token| tokens.contains(token)));
        }
        let retained = dcel.clone();
        let renamed = dcel.compact();
        handles.check(&dcel, &mints);
        for (old, new) in &renamed.half_edges {
            assert_eq!(retained.value(handles.half_edges, old), dcel.value(handles.half_edges, *new));
            assert_eq!(retained.value(handles.edges, old), dcel.value(handles.edges, *new));
            assert_eq!(retained.value(handles.corners, old), dcel.value(handles.corners, *new));
        }
        assert!(renamed.faces.iter().all(|(f, g)| retained.value(handles.faces, f) == dcel.value(handles.faces, *g)));
        assert!(
            renamed
                .vertices
                .iter()
                .all(|(v, w)| retained.value(handles.vertices, v) == dcel.value(handles.vertices, *w))
        );
    }
    check(100, 60, law as fn(Program, Vec<bool>));
}

#[test]
fn retaining_is_refused_before_anything_changes() {
    let (mut dcel, keys) = Dcel::from_faces(4, [[0, 1, 2], [0, 2, 3]]).unwrap();
    let owner = dcel.add_attribute(Policy::of_faces().merge_equal());
    dcel.set_value(owner, keys.face(0).unwrap(), "Ada").unwrap();
    let before = dcel.clone();
    let open = |dcel: &mut Dcel| dcel.retain(|_| true, |h| h.face().is_unbounded() || h.twin().face().is_unbounded());
    assert!(matches!(open(&mut dcel), Err(OperatorError::Refused(_))));
    assert!(dcel == before && dcel.value(owner, keys.face(0).unwrap()) == Some(&"Ada"));
    dcel.set_value(owner, keys.face(1).unwrap(), "Ada").unwrap();
    assert_eq!(open(&mut dcel).unwrap().faces.len(), 1);
    assert_eq!(dcel.values(owner).unwrap().values().collect::<Vec<_>>(), [&"Ada"]);
}

/// A history whose operators are changes.
#[derive(Clone, Debug)]
struct Recording(History);

impl Recording {
    const fn dcel(&self) -> &Dcel {
        self.0.get()
    }

    fn run<T>(&mut self, operator: impl FnOnce(&mut Dcel<Recorded>) -> Result<T, Refusal>) -> Result<T, Refusal> {
        self.0.change("operator", operator)
    }
}

impl View for Recording {
    delegate_view!(|this| this.dcel());
}

impl Subject for Recording {
    delegate_subject!(Dcel, Self::dcel);
    delegate_subject!(operators Self::run);
}

#[test]
fn values_are_undone_and_redone_with_the_structure() {
    fn law(program: Program, refuses: bool) {
        let mints = Mints::default();
        let mut history = History::new(Dcel::new());
        let add =
            |dcel: &mut Dcel<Recorded>| Ok::<_, OperatorError>(Handles::new(dcel, &mints, if refuses { 7 } else { 0 }));
        let handles = history.change("add attributes", add).unwrap();
        let mut states = vec![handles.values(history.get())];
        let mut runner = Runner::new(Recording(history));
        for op in &program.0 {
            let before = runner.subject().0.mark();
            let outcome = runner.step(*op);
            assert!(outcome == StepOutcome::Applied || runner.subject().0.mark() == before);
            if runner.subject().0.mark() != before {
                states.push(handles.values(runner.subject().dcel()));
            }
        }
        let mut history = runner.into_subject().0;
        let last = states.len() - 1;
        for (i, state) in states.iter().enumerate().rev() {
            assert_eq!(*state, handles.values(history.get()));
            assert!(history.undo());
            assert!(i > 0 || history.get().values(handles.faces).unwrap().is_empty());
        }
        let mut copy = history.clone();
        for state in &states {
            assert!(history.redo());
            assert_eq!(*state, handles.values(history.get()));
        }
        assert!(!history.redo());
        // A clone goes on by itself.
        while copy.redo() {}
        assert_eq!(states[last], handles.values(copy.get()));
    }
    check(60, 40, law as fn(Program, bool));
}

/// A triangle of a loop that was split, and the key of its edge from which it was made.
fn triangle() -> (Dcel, HalfEdgeKey) {
    let mut dcel = Dcel::new();
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    let h = dcel.connect(v, v, Split::default()).unwrap().half_edge;
    dcel.split_edge(h).unwrap();
    dcel.split_edge(h).unwrap();
    (dcel, h)
}

#[test]
fn each_ready_made_policy_does_what_it_says() {
    let (mut dcel, h) = triangle();
    let inside = dcel.half_edge(h).unwrap().face().key();
    let copied = dcel.add_attribute(Policy::of_faces().split_copy().merge_sum());
    let shared = dcel.add_attribute(Policy::of_faces().split_share().merge_larger());
    let kept = dcel.add_attribute(Policy::of_faces());
    let (made, height) = (
        dcel.add_attribute(Policy::of_edges().make_default()),
        dcel.add_attribute(Policy::of_vertices().interpolate().make_with(|| -1.0)),
    );
    for (of, value) in [(copied, 3), (shared, 3), (kept, 3)] {
        assert_eq!(dcel.set_value(of, inside, value), Ok(None));
    }
    let third = dcel.half_edge(h).unwrap().prev().key();
    let split = dcel.connect(h, third, Split::default()).unwrap();
    let new = split.new_face().unwrap();
    assert_eq!([copied, shared, kept].map(|of| dcel.value(of, new)), [Some(&3), Some(&0), None]);
    assert_eq!(dcel.value(made, split.half_edge), Some(&0_u32));
    assert_eq!(dcel.values(made).unwrap().len(), 1);
    dcel.remove_edge(dcel.half_edge(split.half_edge).unwrap().twin().key()).unwrap();
    let left = if dcel.face(inside).is_ok() { inside } else { new };
    assert_eq!(dcel.value(copied, left), Some(&6));
    assert!(dcel.values(made).unwrap().is_empty());

    let [a, b] = [dcel.half_edge(h).unwrap().origin().key(), dcel.half_edge(h).unwrap().target().key()];
    assert_eq!(dcel.set_value(height, a, 1.0), Ok(None));
    let first = dcel.split_edge(h).unwrap().vertex;
    assert_eq!(dcel.value(height, first), Some(&-1.0));
    dcel.join_edges(h).unwrap();
    assert_eq!(dcel.set_value(height, b, 2.0), Ok(None));
    let middle = dcel.split_edge(h).unwrap().vertex;
    assert_eq!(dcel.value(height, middle), Some(&1.5));
    assert_eq!(dcel.set_value(height, middle, None), Ok(Some(1.5)));
    assert_eq!(dcel.value(height, middle), None);
}

#[test]
fn stale_keys_and_attributes_of_other_structures_are_errors() {
    let (mut dcel, _) = triangle();
    let (mut other, _) = triangle();
    let outside = dcel.unbounded_face().key();
    let gone = dcel.add_isolated_vertex(outside).unwrap().vertex;
    dcel.remove_isolated_vertex(gone).unwrap();
    let foreign = other.add_attribute(Policy::of_faces());
    assert_eq!(dcel.set_value(foreign, outside, 1), Err(OperatorError::NoSuchAttribute));
    let height = dcel.add_attribute(Policy::of_vertices());
    assert_eq!(dcel.set_value(foreign, outside, 1), Err(OperatorError::NoSuchAttribute));
    assert!(matches!(dcel.set_value(height, gone, 1.0), Err(OperatorError::Stale(_))));
    assert_eq!((dcel.value(foreign, outside), dcel.value(height, gone)), (None, None));
    assert!(dcel.values(foreign).is_none());
}

#[test]
fn a_quantity_is_shared_without_a_rest() {
    fn law(all: i64, part: u16) -> bool {
        let part = f64::from(part) / f64::from(u16::MAX);
        let small = all as i32;
        let [kept, given] = small.share(part);
        let exact = kept.sum(&given) == small && (f64::from(given) - f64::from(small) * part).abs() <= 0.5;
        let [kept, given] = all.share(part);
        let at_ends = [all.share(0.0), all.share(1.0)] == [[all, 0], [0, all]];
        exact && kept.sum(&given) == all && at_ends && i64::between(&2, &6, 0.25) == 3
    }
    check(300, 100, law as fn(i64, u16) -> bool);
}
