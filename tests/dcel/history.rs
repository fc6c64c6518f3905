//! Undo and redo: the structure, its keys, its bytes.

use crate::support::programs::check;
use std::panic::{AssertUnwindSafe, catch_unwind};
use twinedge::dcel::{Corner, Dcel, History, OperatorError, Split, VertexKey};
use twinedge::program::{CallOf, HandleOf, Program, Refusal, Runner, StepOutcome, Subject};
use twinedge::validate::{Table, View};
use twinedge::{delegate_subject, delegate_view};

/// A history in which every operator is a change.
#[derive(Clone, Debug)]
pub(crate) struct Recording(pub(crate) History);

impl Recording {
    pub(crate) const fn dcel(&self) -> &Dcel {
        self.0.get()
    }
}

impl View for Recording {
    delegate_view!(|this| this.dcel());
}

impl Subject for Recording {
    delegate_subject!(Dcel, |this| this.dcel());

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        self.0.change("operator", |dcel| dcel.apply(call))
    }
}

fn bytes(dcel: &Dcel) -> String {
    serde_json::to_string(dcel).unwrap()
}

#[test]
fn a_program_undone_in_any_part_and_redone_gives_the_bytes_of_the_program() {
    fn law(program: Program, parts: Vec<usize>) {
        let empty = Dcel::new();
        // A clone issues the same keys as the original.
        let mut plain = Runner::new(empty.clone());
        let mut recording = Runner::new(Recording(History::new(empty)));
        let mut states = vec![bytes(plain.subject())];
        for op in &program.0 {
            let outcome = plain.step(*op);
            assert_eq!(recording.step(*op), outcome);
            if outcome == StepOutcome::Applied && !recording.subject().0.written().is_empty() {
                states.push(bytes(plain.subject()));
            }
        }
        let mut history = recording.into_subject().0;
        let mut done = states.len() - 1;
        for part in parts {
            let part = part % states.len();
            for _ in 0..part {
                done -= usize::from(history.undo());
                assert_eq!(bytes(history.get()), states[done]);
            }
            while history.redo() {
                done += 1;
                assert_eq!(bytes(history.get()), states[done]);
            }
        }
        assert_eq!(done, states.len() - 1);
        assert_eq!(bytes(history.get()), bytes(plain.subject()));
    }
    check(60, 60, law as fn(Program, Vec<usize>));
}

fn loop_at(dcel: &mut Dcel, v: VertexKey) -> Result<twinedge::dcel::Connected, OperatorError> {
    let corner = dcel.vertex(v)?.leaving().map_or(Corner::Isolated(v), |h| Corner::At(h.key()));
    dcel.connect(corner, corner, Split::default())
}

/// A vertex, and a loop at it, each a change.
fn with_loop() -> (History, VertexKey, twinedge::dcel::Connected) {
    let mut history = History::new(Dcel::new());
    let outside = history.get().unbounded_face().key();
    let v = history.change("vertex", |dcel| dcel.add_isolated_vertex(outside)).unwrap().vertex;
    let made = history.change("loop", |dcel| loop_at(dcel, v)).unwrap();
    (history, v, made)
}

#[test]
fn a_key_that_lives_again_names_the_same_record() {
    let (mut history, v, made) = with_loop();
    let (before, rows) = (history.get().clone(), Table::copy_of(history.get()));
    let h = made.half_edge;
    history
        .change("erase", |dcel| {
            dcel.remove_edge(h)?;
            dcel.remove_isolated_vertex(v)?;
            // The slots are reused.
            let v = dcel.add_isolated_vertex(dcel.unbounded_face().key())?.vertex;
            loop_at(dcel, v)
        })
        .unwrap();
    assert!(history.get().half_edge(h).is_err() && history.get().vertex(v).is_err());
    assert!(history.undo());
    assert_eq!((history.get(), &Table::copy_of(history.get())), (&before, &rows));
    assert_eq!(history.get().half_edge(h).unwrap().origin().key(), v);
    assert!(history.undo() && history.get().half_edge(h).is_err());
    assert!(history.undo() && history.get().vertex(v).is_err());
    assert!(!history.undo());
}

/// A user who still holds the key of a permanently undone change must not reach another record.
#[test]
fn a_key_of_a_change_that_was_dropped_is_never_issued_again() {
    let (mut history, v, made) = with_loop();
    let mut gone = vec![made];
    for _ in 0..20 {
        assert!(history.undo());
        let again = history.change("another loop", |dcel| loop_at(dcel, v)).unwrap();
        assert!(!history.redo(), "what was undone is dropped");
        for old in &gone {
            assert!(
                history.get().half_edge(old.half_edge).is_err() && history.get().face(old.new_face().unwrap()).is_err()
            );
        }
        gone.push(again);
    }
    // Even if the slot is retired and issued in turn, below the earlier generation.
    let h = gone.pop().unwrap().half_edge;
    history.change("erase", |dcel| dcel.remove_edge(h)).unwrap();
    let last = history.change("loop", |dcel| loop_at(dcel, v)).unwrap();
    assert!(gone.iter().all(|old| old.half_edge != last.half_edge) && last.half_edge != h);
}

#[test]
fn an_error_takes_back_all_of_a_change_and_leaves_what_can_be_redone() {
    let (mut history, v, made) = with_loop();
    assert!(history.undo());
    let before = bytes(history.get());
    let refused = history.change("fails", |dcel| {
        loop_at(dcel, v)?;
        dcel.remove_isolated_vertex(v)
    });
    assert_eq!(refused, Err(OperatorError::NotIsolated(v)));
    assert_eq!(bytes(history.get()), before);
    assert!(history.written().is_empty());
    assert_eq!((history.undo_name(), history.redo_name()), (Some("vertex"), Some("loop")));
    assert!(history.redo());
    assert_eq!(history.get().half_edge(made.half_edge).unwrap().face().key(), made.new_face().unwrap());
    assert!(history.get().validate().is_valid());
}

#[test]
fn a_refused_operator_that_searched_is_not_recorded_and_leaves_what_can_be_redone() {
    let (mut history, _, made) = with_loop();
    let h = history.get().half_edge(made.half_edge).unwrap();
    let (left, right) = (h.boundary(), h.twin().boundary());
    let around = if left.is_outer() { right.key() } else { left.key() };
    let face = made.new_face().unwrap();
    let outside = history.get().unbounded_face().key();
    history.change("another", |dcel| dcel.add_isolated_vertex(outside)).unwrap();
    assert!(history.undo());
    // `move_inner` searches the faces inside the component before it refuses.
    let refused = history.change("refused", |dcel| Ok::<_, OperatorError>(dcel.move_inner(around, face)));
    assert_eq!(refused, Ok(Err(OperatorError::InsideItself(around, face))));
    assert_eq!((history.undo_name(), history.redo_name()), (Some("loop"), Some("another")));
}

#[test]
fn a_panic_takes_back_all_of_a_change() {
    let (mut history, v, _) = with_loop();
    let before = bytes(history.get());
    let panicked = catch_unwind(AssertUnwindSafe(|| {
        history.change("panics", |dcel| {
            loop_at(dcel, v)?;
            assert_eq!(dcel.edge_count(), 1, "in the middle");
            Ok::<(), OperatorError>(())
        })
    }));
    assert!(panicked.is_err());
    assert_eq!(bytes(history.get()), before);
    assert_eq!(history.undo_name(), Some("loop"));
}

#[test]
fn a_change_that_writes_nothing_is_no_step() {
    let (mut history, _, _) = with_loop();
    assert!(history.undo());
    history.change("looks", |dcel| Ok::<_, OperatorError>(dcel.vertex_count())).unwrap();
    assert_eq!((history.undo_name(), history.redo_name()), (Some("vertex"), Some("loop")));
}

#[test]
fn a_mark_leads_back_to_its_state_and_nowhere_else() {
    let (mut history, v, _) = with_loop();
    let marked = (history.mark(), bytes(history.get()));
    let more = |history: &mut History| history.change("loop", |dcel| loop_at(dcel, v)).unwrap();
    more(&mut history);
    more(&mut history);
    let ahead = history.mark();
    assert!(!history.clone().undo_to(ahead), "a clone has marks of its own");
    assert!(history.undo_to(marked.0));
    assert_eq!(bytes(history.get()), marked.1);
    assert!(history.undo_to(marked.0), "it is there already");
    assert!(!history.undo_to(ahead), "that lies ahead");
    // Makes the number of changes equal to the number at the other mark.
    more(&mut history);
    more(&mut history);
    assert!(!history.undo_to(ahead), "that state was dropped");
    assert!(history.undo_to(marked.0));
    assert!(history.undo());
    assert!(!history.undo_to(marked.0), "that lies ahead");
}

#[test]
fn what_is_forgotten_cannot_be_undone_and_its_keys_stay_stale() {
    let (mut history, v, _) = with_loop();
    let start = history.mark();
    let undone = history.change("loop", |dcel| loop_at(dcel, v)).unwrap();
    let kept = history.mark();
    history.undo();
    history.forget(1);
    assert_eq!((history.undo_name(), history.redo_name()), (Some("loop"), None));
    assert!(!history.undo_to(kept) && history.undo_to(start));
    let made = history.change("loop", |dcel| loop_at(dcel, v)).unwrap();
    assert_ne!(made.half_edge, undone.half_edge);
    assert!(history.undo() && history.undo() && !history.undo());
    assert_eq!((history.get().vertex_count(), history.get().edge_count()), (1, 0));
}

/// A structure swapped in by the closure has no history before it.
#[test]
fn another_structure_begins_another_history() {
    let ((mut one, v, made), (mut other, ..)) = (with_loop(), with_loop());
    one.undo();
    let mark = one.mark();
    let swap = |a: &mut Dcel, b: &mut Dcel| {
        std::mem::swap(a, b);
        Ok::<_, OperatorError>(())
    };
    one.change("swap", |a| other.change("swap", |b| swap(a, b))).unwrap();
    assert!(!one.undo() && !one.redo() && !one.undo_to(mark) && !other.undo() && !other.redo());
    assert_eq!((one.get().edge_count(), other.get().edge_count()), (1, 0));
    // The change that could be redone is dropped, and its key is not issued again.
    let again = other.change("loop", |dcel| loop_at(dcel, v)).unwrap();
    assert_ne!(again.half_edge, made.half_edge);
    assert!(other.undo() && !other.undo());
    other.change("new", |dcel| swap(dcel, &mut Dcel::default())).unwrap();
    assert!(!other.undo());
    let outside = other.get().unbounded_face().key();
    other.change("vertex", |dcel| dcel.add_isolated_vertex(outside)).unwrap();
    assert!(other.undo() && other.redo() && other.get().vertex_count() == 1);
}

#[test]
fn a_place_of_the_log_leads_back_within_its_change_alone() {
    let mut history = History::new(Dcel::new());
    let outside = history.get().unbounded_face().key();
    let mut places = Vec::new();
    let first = history.change("one", |dcel| {
        places.extend(dcel.log_place());
        dcel.add_isolated_vertex(outside)?;
        places.extend(dcel.log_place());
        dcel.add_isolated_vertex(outside)
    });
    first.unwrap();
    let within = history.change("two", |dcel| {
        // A place in an earlier change.
        for place in places {
            dcel.roll_back(place).apply(dcel);
        }
        assert_eq!(dcel.vertex_count(), 2);
        let outer = dcel.log_place().unwrap();
        dcel.add_isolated_vertex(outside)?;
        let inner = dcel.log_place().unwrap();
        dcel.add_isolated_vertex(outside)?;
        dcel.roll_back(inner).apply(dcel);
        assert_eq!(dcel.vertex_count(), 3);
        dcel.roll_back(outer).apply(dcel);
        assert_eq!(dcel.vertex_count(), 2);
        // The log was cut back to before the place, and continues with other entries.
        dcel.add_isolated_vertex(outside)?;
        dcel.add_isolated_vertex(outside)?;
        dcel.roll_back(inner).apply(dcel);
        assert_eq!(dcel.vertex_count(), 4);
        Ok::<_, OperatorError>(())
    });
    within.unwrap();
    assert!(history.undo() && history.get().vertex_count() == 2 && history.get().validate().is_valid());
    assert!(history.undo() && history.get().vertex_count() == 0);
}
