//! Values that follow operators: none is lost or doubled, and each stays where it was.

use crate::history::Recording;
use crate::support::programs::check;
use crate::support::tokens::{Handles, Mint, Mints, Tokens};
use quickcheck::{Arbitrary, Gen};
use std::collections::{BTreeMap, BTreeSet};
use twinedge::dcel::{
    Attribute, Dcel, Edges, FaceKey, HalfEdgeKey, History, OperatorError, Outside, Policy, Quantity, Split, VertexKey,
    Vertices,
};
use twinedge::program::{Program, Refusal, Runner, StepOutcome};
use twinedge::validate::Expectation;

/// The vertex of each corner's token, and the face of each half-edge's token.
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

/// Checks the tokens that an operator made and dropped, of vertices, half-edges, edges, corners and faces.
fn only_what_is_new_has_new_tokens(before: &Dcel, after: &Dcel, name: &str, difference: [[usize; 2]; 5]) {
    let [vertices, half_edges, edges, corners, faces] = difference;
    let isolated = |dcel: &Dcel| dcel.vertices().filter(|v| v.isolated().is_some()).count();
    let (was, is) = (isolated(before), isolated(after));
    let made = |names: &[&str], count: usize| if names.contains(&name) { count } else { 0 };
    assert_eq!(vertices[0], made(&["add_isolated_vertex", "split_edge"], 1));
    assert!(vertices[1] == 0 || ["remove_isolated_vertex", "join_edges"].contains(&name), "{name}");
    assert_eq!(
        (edges[0], half_edges[0]),
        (made(&["connect", "split_vertex"], 1), made(&["connect", "split_vertex"], 2))
    );
    let removes = ["remove_edge", "contract_edge"].contains(&name);
    assert!((edges[1] == 0 && half_edges[1] == 0) || removes, "{name}");
    assert_eq!(faces, [0, 0]);
    let new = after.edges().find(|h| before.half_edge(h.key()).is_err()).filter(|_| was == is);
    let is_leaf = new.is_some_and(|h| h.origin().degree() == 1 || h.target().degree() == 1);
    match name {
        "split_edge" => assert_eq!(corners[0], 2),
        "split_vertex" if was == is => assert_eq!(corners[0], usize::from(is_leaf)),
        "connect" | "split_vertex" => assert_eq!(corners[0] > 0, was > is),
        _ => assert_eq!(corners[0], 0, "{name}"),
    }
    assert!(corners[1] == 0 || name == "join_edges" || (removes && is > was), "{name}");
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
            let counts = mints.each_ref().map(Mint::counts);
            let outcome = runner.step(*op);
            let dcel = runner.subject();
            handles.check(dcel, &mints);
            let now = mints.each_ref().map(Mint::counts);
            let difference = [0, 1, 2, 3, 4].map(|kind| [0, 1].map(|i| now[kind][i] - counts[kind][i]));
            if outcome == StepOutcome::Applied {
                only_what_is_new_has_new_tokens(&before, dcel, name, difference);
            } else {
                assert_eq!(now, counts);
            }
            let ((was_at, was_beside), (is_at, is_beside)) = (places(handles, &before), places(handles, dcel));
            for (token, v) in &is_at {
                let stays = was_at.get(token).is_none_or(|was| was == v);
                // A vertex was split in two, or two were merged.
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
            let outcome = runner.step(*op);
            let (was, is) = (handles.values(&before), handles.values(runner.subject()));
            if outcome == StepOutcome::Refused(Refusal::Policy) {
                assert!(*runner.subject() == before);
                assert_eq!(is, was);
                refused += 1;
            }
            // A refused operator loses no value.
            for (mint, (was, is)) in mints.iter().zip(was.iter().zip(&is)) {
                let is: BTreeSet<u64> = is.values().flatten().copied().collect();
                assert!(was.values().flatten().all(|token| is.contains(token) || mint.has_dropped(*token)));
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
        let has_edges = |v: VertexKey| dcel.vertex(v).is_ok_and(|v| v.isolated().is_none());
        assert!(was_at.iter().all(|(token, v)| is_at.contains_key(token) == has_edges(*v)));
        // The surviving face has the tokens of all faces merged into it.
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

#[test]
fn values_are_undone_and_redone_with_the_structure() {
    fn law(program: Program, refuses: bool) {
        let mints = Mints::default();
        let mut history = History::new(Dcel::new());
        let add = |dcel: &mut Dcel| Ok::<_, OperatorError>(Handles::new(dcel, &mints, if refuses { 7 } else { 0 }));
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
        // A clone continues independently.
        while copy.redo() {}
        assert_eq!(states[last], handles.values(copy.get()));
    }
    check(60, 40, law as fn(Program, bool));
}

/// A triangle made by splitting a loop, and the key of the original edge.
fn triangle() -> (Dcel, HalfEdgeKey) {
    let mut dcel = Dcel::new();
    let v = dcel.add_isolated_vertex(dcel.unbounded_face().key()).unwrap().vertex;
    let h = dcel.connect(v, v, Split::default()).unwrap().half_edge;
    dcel.split_edge(h).unwrap();
    dcel.split_edge(h).unwrap();
    (dcel, h)
}

/// A change that sets values, applies an operator and sets values again loses no overwritten value.
#[test]
fn all_values_that_a_change_overwrote_come_back() {
    let (dcel, h) = triangle();
    let [inside, outside] = [dcel.half_edge(h).unwrap().face().key(), dcel.unbounded_face().key()];
    let mut history = History::new(dcel);
    let add = |dcel: &mut Dcel| Ok::<_, OperatorError>(dcel.add_attribute(Policy::of_faces()));
    let owner = history.change("attribute", add).unwrap();
    let values = |history: &History| [inside, outside].map(|f| history.get().value(owner, f).copied());
    history.change("value", |dcel| dcel.set_value(owner, inside, 1)).unwrap();
    let several = |dcel: &mut Dcel| {
        dcel.set_value(owner, inside, 2)?;
        dcel.split_edge(h)?;
        assert_eq!(dcel.value(owner, inside), Some(&2));
        dcel.set_value(owner, outside, 3)
    };
    history.change("values", several).unwrap();
    assert_eq!(values(&history), [Some(2), Some(3)]);
    assert!(history.undo());
    assert_eq!(values(&history), [Some(1), None]);
    assert!(history.redo());
    assert_eq!(values(&history), [Some(2), Some(3)]);
    // The last change can be undone even after earlier changes are forgotten.
    history.change("value", |dcel| dcel.set_value(owner, inside, 4)).unwrap();
    history.forget(1);
    assert!(history.undo() && !history.undo());
    assert_eq!(values(&history), [Some(2), Some(3)]);
}

/// Policies merge the values of merged faces even if each write is logged.
#[test]
fn retaining_in_a_change_merges_the_values_of_faces() {
    let (mut dcel, h) = triangle();
    let third = dcel.half_edge(h).unwrap().prev().key();
    let chord = dcel.connect(h, third, Split::default()).unwrap().half_edge;
    let sides = [dcel.half_edge(chord).unwrap(), dcel.half_edge(chord).unwrap().twin()].map(|h| h.face().key());
    let count = dcel.add_attribute(Policy::of_faces().merge_sum());
    for side in sides {
        assert_eq!(dcel.set_value(count, side, 1), Ok(None));
    }
    let mut history = History::new(dcel);
    let without = |dcel: &mut Dcel| dcel.retain(|_| true, |h| h.key() != chord && h.twin().key() != chord);
    let merged = history.change("retain", without).unwrap().faces[0];
    assert_eq!(history.get().value(count, merged.kept), Some(&2));
    assert!(history.undo());
    assert_eq!(sides.map(|side| history.get().value(count, side)), [Some(&1); 2]);
}

#[test]
fn each_ready_made_policy_does_what_it_says() {
    let (mut dcel, h) = triangle();
    let inside = dcel.half_edge(h).unwrap().face().key();
    let copied = dcel.add_attribute(Policy::of_faces().split_copy().merge_sum());
    let shared = dcel.add_attribute(Policy::of_faces().split_share().merge_larger());
    let kept = dcel.add_attribute(Policy::of_faces());
    let (made, height) = (
        dcel.add_attribute(Policy::of_edges().make_with(Default::default)),
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
    assert_eq!(dcel.remove_value(height, middle), Ok(Some(1.5)));
    assert_eq!(dcel.value(height, middle), None);
}

#[test]
fn stale_keys_and_attributes_of_other_structures_are_errors() {
    let (mut dcel, _) = triangle();
    let (mut other, _) = triangle();
    let outside = dcel.unbounded_face().key();
    let gone = dcel.add_isolated_vertex(outside).unwrap().vertex;
    dcel.remove_isolated_vertex(gone).unwrap();
    let foreign = other.add_attribute(Policy::<twinedge::dcel::Faces, i32>::of_faces());
    assert_eq!(dcel.set_value(foreign, outside, 1), Err(OperatorError::NoSuchAttribute));
    let height = dcel.add_attribute(Policy::<Vertices, f64>::of_vertices());
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

#[test]
fn ids_find_their_records_through_operators_undoing_and_compacting() {
    fn right(dcel: &Dcel, id: Attribute<Edges, u64>, given: &mut BTreeMap<u64, HalfEdgeKey>) {
        let ids = dcel.values(id).unwrap();
        assert_eq!(ids.len(), dcel.edge_count());
        for (key, number) in ids {
            assert_eq!(dcel.find(id, number), Some(key));
            // Two edges never get the same number.
            assert_eq!(*given.entry(*number).or_insert(key), key);
        }
        assert!(given.iter().all(|(number, key)| dcel.find(id, number).is_some() == dcel.half_edge(*key).is_ok()));
    }
    fn law(program: Program) {
        let mut history = History::new(Dcel::new());
        let add = |dcel: &mut Dcel| Ok::<_, OperatorError>(dcel.add_attribute(Policy::of_edges().ids(7)));
        let id = history.change("number edges", add).unwrap();
        let mut given = BTreeMap::new();
        let mut runner = Runner::new(Recording(history));
        for (i, op) in program.0.iter().enumerate() {
            runner.step(*op);
            right(runner.subject().dcel(), id, &mut given);
            if i % 5 == 4 {
                let mut history = runner.into_subject().0;
                history.undo();
                right(history.get(), id, &mut given);
                if i % 2 == 0 {
                    history.redo();
                }
                // The runner starts again with the existing edges.
                runner = Runner::new(Recording(history));
            }
        }
        let mut dcel = runner.into_subject().0.into_inner();
        let before = dcel.clone();
        let renamed = dcel.compact();
        for (key, number) in before.values(id).unwrap() {
            assert_eq!(dcel.find(id, number), Some(renamed.half_edges[key]));
        }
    }
    check(60, 40, law as fn(Program));
}

#[test]
fn faces_get_ids_although_the_unbounded_one_has_none() {
    let mut dcel = Dcel::new();
    let id = dcel.add_attribute(Policy::of_faces().ids(5));
    let outside = dcel.unbounded_face().key();
    let v = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let loop_at = |dcel: &mut Dcel| dcel.connect(v, v, Split::default());
    let drawn = loop_at(&mut dcel).unwrap();
    assert_eq!((dcel.value(id, outside), dcel.value(id, drawn.new_face().unwrap())), (None, Some(&5)));
    dcel.remove_edge(drawn.half_edge).unwrap();
    let drawn = loop_at(&mut dcel).unwrap();
    assert_eq!(dcel.value(id, drawn.new_face().unwrap()), Some(&6));
    assert_eq!((dcel.next_id(id), dcel.values(id).unwrap().len()), (Some(7), 1));
}

/// Vertices numbered 1 and 2.
fn two_numbered() -> (Dcel, Attribute<Vertices, u64>, [VertexKey; 2]) {
    let mut dcel = Dcel::new();
    let id = dcel.add_attribute(Policy::of_vertices().ids(1));
    let outside = dcel.unbounded_face().key();
    let keys = [(); 2].map(|()| dcel.add_isolated_vertex(outside).unwrap().vertex);
    (dcel, id, keys)
}

#[test]
fn a_number_that_was_set_by_hand_is_not_given_again() {
    let (mut dcel, id, [a, _]) = two_numbered();
    dcel.set_value(id, a, 7_u64).unwrap();
    assert_eq!(dcel.next_id(id), Some(8));
    let outside = dcel.unbounded_face().key();
    let next = dcel.add_isolated_vertex(outside).unwrap().vertex;
    assert_eq!(dcel.value(id, next), Some(&8));
    dcel.set_value(id, a, u64::MAX).unwrap();
    assert_eq!(dcel.next_id(id), Some(u64::MAX));
}

/// The last number is never assigned, so the next one never wraps around.
#[test]
fn once_all_numbers_are_given_no_record_is_made() {
    let mut by_hand = Dcel::new();
    let id = by_hand.add_attribute(Policy::of_vertices().ids(1));
    let outside = by_hand.unbounded_face().key();
    let v = by_hand.add_isolated_vertex(outside).unwrap().vertex;
    by_hand.set_value(id, v, u64::MAX).unwrap();
    let mut counted = Dcel::new();
    let of_counted = counted.add_attribute(Policy::of_vertices().ids(u64::MAX - 1));
    let last = counted.add_isolated_vertex(counted.unbounded_face().key()).unwrap().vertex;
    assert_eq!(counted.value(of_counted, last), Some(&(u64::MAX - 1)));
    for (mut dcel, id) in [(by_hand, id), (counted, of_counted)] {
        for _ in 0..2 {
            let refused = dcel.add_isolated_vertex(dcel.unbounded_face().key());
            assert!(matches!(refused, Err(OperatorError::Refused(_))), "{refused:?}");
        }
        assert_eq!((dcel.vertex_count(), dcel.values(id).unwrap().len()), (1, 1));
    }
}

/// The unbounded face has no number.
#[test]
fn records_that_are_there_are_numbered() {
    let mut dcel = Dcel::new();
    let outside = dcel.unbounded_face().key();
    let v = dcel.add_isolated_vertex(outside).unwrap().vertex;
    let ring = dcel.connect(v, v, Split::default()).unwrap();
    let inside = ring.new_face().unwrap();
    let of_faces = dcel.add_attribute(Policy::of_faces().ids(1));
    let of_edges = dcel.add_attribute(Policy::of_edges().ids(1));
    let of_half_edges = dcel.add_attribute(Policy::of_half_edges().ids(1));
    assert_eq!((dcel.value(of_faces, inside), dcel.value(of_faces, outside)), (Some(&1), None));
    assert_eq!((dcel.find(of_faces, &1), dcel.next_id(of_faces)), (Some(inside), Some(2)));
    let twin = dcel.half_edge(ring.half_edge).unwrap().twin().key();
    assert_eq!([ring.half_edge, twin].map(|h| dcel.value(of_edges, h).copied()), [Some(1); 2]);
    let mut sides = [ring.half_edge, twin].map(|h| *dcel.value(of_half_edges, h).unwrap());
    sides.sort_unstable();
    assert_eq!(sides, [1, 2]);
    // Other saved numbers stay, and the remaining records get the next ones.
    let mut saved = twinedge::dcel::SecondaryMap::new();
    saved.insert(v, 30_u64);
    let w = dcel.split_edge(ring.half_edge).unwrap().vertex;
    let of_vertices = dcel.add_attribute_with(Policy::of_vertices().ids(20), saved);
    assert_eq!([v, w].map(|v| dcel.value(of_vertices, v).copied()), [Some(30), Some(31)]);
}

#[test]
fn a_record_is_found_again_once_no_other_has_its_number() {
    let (mut dcel, id, [a, b]) = two_numbered();
    dcel.set_value(id, a, 2_u64).unwrap();
    assert_eq!((dcel.find(id, &1), dcel.find(id, &2)), (None, Some(a)));
    dcel.set_value(id, a, 1_u64).unwrap();
    assert_eq!((dcel.find(id, &1), dcel.find(id, &2)), (Some(a), Some(b)));
    // Exchange the numbers.
    dcel.set_value(id, a, 2_u64).unwrap();
    dcel.set_value(id, b, 1_u64).unwrap();
    assert_eq!((dcel.find(id, &1), dcel.find(id, &2)), (Some(b), Some(a)));
    dcel.remove_value(id, a).unwrap();
    assert_eq!((dcel.find(id, &1), dcel.find(id, &2)), (Some(b), None));
}

#[test]
fn a_number_that_a_record_has_is_not_taken_over_for_another() {
    let (dcel, id, [a, b]) = two_numbered();
    let (mut new, keys) = Dcel::from_view(&dcel, &Expectation::plane(), Outside::Given).unwrap();
    let [a, b] = [a, b].map(|v| keys.vertex(dcel.vertex(v).unwrap().index()).unwrap());
    new.add_attributes_of(&dcel);
    new.set_value(id, b, 1_u64).unwrap();
    new.carry_values(&dcel, &keys);
    assert_eq!([a, b].map(|v| new.value(id, v)), [Some(&3), Some(&1)]);
    assert_eq!((new.find(id, &1), new.find(id, &3)), (Some(b), Some(a)));
}
