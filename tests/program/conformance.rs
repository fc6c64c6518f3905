//! Kernels in step with the reference: correct ones pass, and each kind of difference is recognised.

use crate::support::programs::{program, random};
use std::cell::Cell;
use std::rc::Rc;
use twinedge::dcel::Dcel;
use twinedge::program::conformance::{
    Conformance, ConformanceSummary, Coverage, Difference, Failure, InStep, OperatorCounts, Question,
};
use twinedge::program::*;
use twinedge::validate::{Expectation, Link, Part, Parts, Rule, View};
use twinedge::{delegate_subject, delegate_view};
use twinedge_trials::RawPointers;

/// The fault of a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fault {
    /// It begins with a vertex.
    NotEmpty,
    /// `connect` returns the twin of the expected half-edge.
    Twin,
    /// `connect` confuses the sides.
    Side,
    /// `contract_edge` reports loops as stale.
    WrongReason,
    /// `contract_edge` panics at loops.
    Panics,
    /// `flip_edge` turns the wrong way.
    Turn,
    /// `remove_edge` reports the wrong removed face.
    WrongFaceGone,
    /// A vertex keeps a wrong half-edge.
    Leaving,
    /// Only answers about faces are mixed up.
    FaceOf,
    /// There is room for only two edges.
    Small,
    /// There is room for only two edges, but the vertex is added.
    SmallAndDirty,
    /// No fault.
    None,
}

/// The model with a fault.
#[derive(Clone)]
struct Faulty {
    model: RawPointers,
    fault: Fault,
    parts: Parts,
    /// The number of questions asked.
    asked: Rc<Cell<usize>>,
    /// A question panics after this number of questions.
    panics_after: Option<usize>,
}

impl Faulty {
    fn new(fault: Fault) -> Self {
        let mut model = RawPointers::new();
        if fault == Fault::NotEmpty {
            model.apply(Call::AddIsolatedVertex { face: 0 }).unwrap();
        }
        Self { parts: model.parts(), model, fault, asked: Rc::default(), panics_after: None }
    }

    fn has(&self, fault: Fault) -> bool {
        self.fault == fault
    }

    fn count(&self) {
        assert!(self.panics_after.is_none_or(|most| self.asked.get() < most), "a question");
        self.asked.set(self.asked.get() + 1);
    }

    fn is_full(&self) -> bool {
        let live = (0..self.model.half_edge_slots()).filter(|h| self.model.is_half_edge(*h)).count();
        live >= 4 && (self.has(Fault::Small) || self.has(Fault::SmallAndDirty))
    }
}

impl View for Faulty {
    delegate_view!(|this| &this.model; except parts, leaving);

    fn parts(&self) -> Parts {
        self.parts
    }
    fn leaving(&self, vertex: usize) -> Link {
        let leaving = self.model.leaving(vertex);
        if self.has(Fault::Leaving) { leaving.map(|h| h ^ 1) } else { leaving }
    }
}

impl Subject for Faulty {
    type Vertex = usize;
    type HalfEdge = usize;
    type Face = usize;
    fn unbounded_face(&self) -> Option<usize> {
        Some(0)
    }
    fn half_edge_at(&self, index: usize) -> Option<usize> {
        Some(index)
    }
    fn vertex_at(&self, index: usize) -> Option<usize> {
        (!self.has(Fault::NotEmpty)).then_some(index)
    }
    fn face_of(&self, corner: Corner<usize, usize>) -> Result<usize, Refusal> {
        self.count();
        let face = self.model.face_of(corner)?;
        Ok(if self.has(Fault::FaceOf) && face > 0 { 1 } else { face })
    }
    fn origin_of(&self, h: usize) -> Result<usize, Refusal> {
        self.count();
        self.model.origin_of(h)
    }
    fn twin_of(&self, h: usize) -> Result<usize, Refusal> {
        self.count();
        self.model.twin_of(h)
    }
    fn next_of(&self, h: usize) -> Result<usize, Refusal> {
        self.count();
        self.model.next_of(h)
    }

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        match call {
            Call::Connect { .. } | Call::SplitEdge { .. } if self.is_full() => Err(Refusal::Full),
            Call::SplitVertex { .. } if self.is_full() => {
                if self.has(Fault::SmallAndDirty) {
                    self.model.apply(Call::AddIsolatedVertex { face: 0 })?;
                }
                Err(Refusal::Full)
            }
            Call::Connect { from, to, new_face, inner } => {
                let new_face = if self.has(Fault::Side) && new_face == Side::Left { Side::Right } else { new_face };
                let h = self.model.make_edge(Call::Connect { from, to, new_face, inner })?;
                Ok(Some(Handle::HalfEdge(if self.has(Fault::Twin) { h ^ 1 } else { h })))
            }
            Call::RemoveEdge { half_edge: h } => {
                let face = self.model.face_of(Corner::At(h))?;
                let other = self.model.face_of(Corner::At(h ^ 1))?;
                let dropped = self.model.apply(call)?;
                let wrong = if dropped == Some(Handle::Face(face)) { other } else { face };
                let right = |right| if self.has(Fault::WrongFaceGone) { Handle::Face(wrong) } else { right };
                Ok(dropped.map(right))
            }
            Call::ContractEdge { .. } => match self.model.apply(call) {
                Err(Refusal::Loop) if self.has(Fault::WrongReason) => Err(Refusal::Stale),
                Err(Refusal::Loop) if self.has(Fault::Panics) => panic!("a loop"),
                other => other,
            },
            Call::FlipEdge { half_edge, turn } => {
                let turn = if self.has(Fault::Turn) { turn.reversed() } else { turn };
                self.model.apply(Call::FlipEdge { half_edge, turn })
            }
            _ => self.model.apply(call),
        }
    }
}

fn judge(program: &Program, fault: Fault) -> Result<ConformanceSummary, Failure> {
    // Shrinking must not lead to a program that applies nothing.
    let asked = Conformance::of(&Expectation::plane()).coverage(Coverage::Nothing);
    asked.run(program, Faulty::new(fault))
}

/// The first random program on which a subject with this fault fails, shrunk, with its failure.
fn shrunk(fault: Fault) -> (Program, Failure) {
    let mut programs = (0..200).map(|seed| random(seed, 400));
    let program = programs.find(|program| judge(program, fault).is_err()).expect("the fault is found");
    let program = shrink(&program, |program| judge(program, fault).is_err());
    let failure = judge(&program, fault).unwrap_err();
    (program, failure)
}

#[test]
fn a_subject_that_is_not_empty_and_gives_no_handles_fails_before_the_first_operator() {
    let failure = judge(&Program::default(), Fault::NotEmpty).unwrap_err();
    assert_eq!(failure, Failure { before: 0, op: None, difference: Difference::NoVertexHandle { vertex: 0 } });
    assert_eq!(failure.to_string(), "at the start: vertex_at gives no handle for isolated vertex 0 of the view");
}

#[test]
fn a_wrong_handle_is_found_at_once() {
    // A loop, with its inner half-edge returned instead of its outer one: the map is valid and unchanged.
    for (fault, corner) in [(Fault::Twin, 1), (Fault::Side, 0)] {
        let (shrunk, failure) = shrunk(fault);
        assert_eq!(shrunk, program("add_isolated_vertex unbounded\nconnect i0 ~0 left"));
        assert_eq!(failure.difference, Difference::View { half_edge: 0, corner, question: Question::Face });
        let place = format!("in the view, Face of half-edge 0, corner {corner}, is another than it should be");
        assert_eq!(failure.to_string(), format!("after operator 2, `connect i0 ~0 left`: {place}"));
    }
}

#[test]
fn a_valid_map_that_is_another_one_is_found() {
    let (shrunk, failure) = shrunk(Fault::Turn);
    assert!(shrunk.0.len() <= 6, "{shrunk}");
    assert!(matches!(failure.op, Some(Op::FlipEdge { .. })));
    // Of two loops at a vertex, one has a second vertex, where the other one ends, or not, after turning.
    let flip = program(
        "add_isolated_vertex unbounded\nconnect i0 ~0 left\nconnect h0 ~0 left\nsplit_edge h0\nflip_edge h0 ccw",
    );
    let failure = judge(&flip, Fault::Turn).unwrap_err();
    assert_eq!(failure.before, 4);
    assert!(matches!(failure.difference, Difference::View { question: Question::Next, .. }), "{failure}");
}

#[test]
fn a_wrong_reason_is_found() {
    let (shrunk, failure) = shrunk(Fault::WrongReason);
    assert_eq!(shrunk, program("add_isolated_vertex unbounded\nconnect i0 ~0 left\ncontract_edge h0"));
    let (reference, subject) = (StepOutcome::Refused(Refusal::Loop), StepOutcome::Refused(Refusal::Stale));
    assert_eq!(failure.difference, Difference::StepOutcome { reference, subject });
    assert_eq!(
        failure.to_string(),
        "after operator 3, `contract_edge h0`: the outcome should be `refused: the edge is a loop` and is \
         `refused: a handle is stale`"
    );
}

/// Regression: a panic ended the run, and its program was lost.
#[test]
fn a_panic_is_caught_shrunk_and_shown_with_its_place() {
    let settings = Conformance::of(&Expectation::plane());
    let found = settings.check(|| Faulty::new(Fault::Panics)).unwrap_err();
    assert_eq!(found.program, program("add_isolated_vertex unbounded\nconnect i0 ~0 left\ncontract_edge h0"));
    let text = found.to_string();
    assert!(text.starts_with("in operator 3, `contract_edge h0`: panicked: a loop ("), "{text}");
    assert!(text.contains("conformance.rs:"), "{text}");
    // A panic in a question is the same difference; at the start, no operator is named.
    let panicking = Faulty { panics_after: Some(10), ..Faulty::new(Fault::None) };
    let failure = settings.run(&found.program, panicking).unwrap_err();
    assert!(
        matches!(&failure.difference, Difference::Panicked(message) if message.starts_with("a question (")),
        "{failure}"
    );
    let failure = settings.run(&found.program, Faulty { panics_after: Some(0), ..Faulty::new(Fault::NotEmpty) });
    assert!(failure.unwrap_err().to_string().starts_with("at the start: "));
}

/// Regression: no program, or programs without operators, passed.
#[test]
fn a_check_without_programs_or_operators_has_tried_nothing() {
    for (programs, operators) in [(0, 40), (200, 0)] {
        let settings = Conformance::of(&Expectation::plane()).programs(programs, operators);
        assert_eq!(settings.check(Dcel::new).unwrap_err().failure.difference, Difference::NothingApplied);
        assert!(settings.coverage(Coverage::Nothing).check(Dcel::new).is_ok());
    }
}

#[test]
fn a_broken_rule_is_found_and_named() {
    let (shrunk, failure) = shrunk(Fault::Leaving);
    assert!(shrunk.0.len() <= 3, "{shrunk}");
    let Difference::Invalid(report) = failure.difference else { panic!("{failure}") };
    assert_eq!(report.first().unwrap().rule(), Rule::V1);
}

#[test]
fn handles_that_disagree_with_the_view_are_found() {
    let (program, failure) = shrunk(Fault::FaceOf);
    assert!(matches!(failure.difference, Difference::Answers { question: Question::Face, .. }), "{failure}");
    assert!(program.0.len() <= 5, "{program}");
}

/// A structure whose view is that of another one, to which each operator is applied with a change, or not at all.
struct Apart {
    answers: RawPointers,
    view: RawPointers,
    change: fn(CallOf<RawPointers>) -> Option<CallOf<RawPointers>>,
}

impl View for Apart {
    delegate_view!(|this| &this.view);
}

impl Subject for Apart {
    delegate_subject!(RawPointers, |this| &this.answers);

    fn apply(&mut self, call: CallOf<Self>) -> Result<Option<HandleOf<Self>>, Refusal> {
        (self.change)(call.clone()).map(|call| self.view.apply(call)).transpose()?;
        self.answers.apply(call)
    }
}

/// Each view is a valid map, whose half-edges and vertices have the right handles.
#[test]
fn a_view_of_another_map_is_found() {
    type Change = fn(CallOf<RawPointers>) -> Option<CallOf<RawPointers>>;
    let unmoved: Change = |call| (!matches!(call, Call::MoveInner { .. })).then_some(call);
    let turned_out: Change = |call| match call {
        Call::Connect { from, to, inner, .. } => Some(Call::Connect { from, to, new_face: Side::Right, inner }),
        call => Some(call),
    };
    let emptied: Change = |call| (!matches!(call, Call::AddIsolatedVertex { .. })).then_some(call);
    let on_face = Difference::View { half_edge: 0, corner: 0, question: Question::Face };
    for (text, change, difference) in [
        ("add_isolated_vertex unbounded", emptied, Difference::Missing { corner: 0 }),
        // The two faces of a loop look alike: only one of them is unbounded.
        ("add_isolated_vertex unbounded\nconnect i0 ~0 left", turned_out, on_face),
        (
            "add_isolated_vertex unbounded\nconnect i0 ~0 left\nadd_isolated_vertex unbounded\nmove_inner i0 h0",
            unmoved,
            Difference::Isolated { vertex: 1 },
        ),
    ] {
        let apart = Apart { answers: RawPointers::new(), view: RawPointers::new(), change };
        let program = program(text);
        let failure = conformance::run(&program, apart, &Expectation::plane()).unwrap_err();
        assert_eq!((failure.before, failure.difference), (program.0.len() - 1, difference), "{text}");
    }
}

#[test]
fn a_face_reported_gone_that_is_not_is_found_when_it_is_asked_for() {
    let (shrunk, failure) = shrunk(Fault::WrongFaceGone);
    assert!(shrunk.0.len() <= 5, "{shrunk}");
    let stale = StepOutcome::Refused(Refusal::Stale);
    assert!(matches!(failure.difference, Difference::StepOutcome { reference, .. } if reference == stale), "{failure}");
}

#[test]
fn want_of_room_is_no_fault_unless_it_leaves_a_trace() {
    let crowded =
        program("add_isolated_vertex unbounded\nsplit_vertex i0 ~0\nsplit_edge h0\nsplit_vertex h0 ~0\nsplit_edge h3");
    let total = judge(&crowded, Fault::Small).unwrap().total();
    assert_eq!(total, OperatorCounts { applied: 3, no_room: 2, ..OperatorCounts::default() });
    let failure = judge(&crowded, Fault::SmallAndDirty).unwrap_err();
    assert_eq!((failure.before, failure.difference), (3, Difference::Isolated { vertex: 3 }));
}

/// Regression: comparing asked O(n²) questions, each O(n) in the model.
#[test]
fn a_step_asks_every_corner_a_few_questions() {
    let subject = Faulty::new(Fault::None);
    let asked = subject.asked.clone();
    let mut pair = InStep::new(subject, &Expectation::plane()).unwrap();
    let mut step = |line: &str| {
        let before = asked.get();
        pair.step(program(line).0[0]).unwrap();
        asked.get() - before
    };
    step("add_isolated_vertex unbounded");
    step("split_vertex i0 ~0");
    for _ in 0..100 {
        step("split_edge h0");
    }
    // Four questions for each of the 202 corners, and a few by the operator itself.
    let questions = step("remove_edge !h0");
    assert_eq!(questions, 4 * 202);
}

#[test]
fn a_structure_without_what_tells_maps_apart_is_refused_by_name() {
    let (plane, all) = (Expectation::plane(), RawPointers::new().parts());
    let run = |program: &Program, parts: Parts, expectation: &Expectation| {
        conformance::run(program, Faulty { parts, ..Faulty::new(Fault::None) }, expectation)
    };
    for (parts, expectation, part) in [
        (all.without(Part::Faces), plane, Part::Faces),
        (all.without(Part::Holes), plane, Part::Holes),
        (all.without(Part::UnboundedFace), plane, Part::UnboundedFace),
        (all, Expectation::surface(), Part::Holes),
    ] {
        let failure = run(&Program::default(), parts, &expectation).unwrap_err();
        assert_eq!(failure, Failure { before: 0, op: None, difference: Difference::Lacks(part) });
    }
    let failure = Failure { before: 0, op: None, difference: Difference::Lacks(Part::Faces) };
    assert_eq!(
        failure.to_string(),
        "at the start: the structure is empty, and stores no faces; begin with one that is not"
    );
    let least = all.without(Part::Prev).without(Part::Leaving);
    assert!(run(&random(1, 300), least, &plane).is_ok());
}

#[test]
fn a_run_can_be_stopped_and_looked_at_between_operators() {
    let program = program("add_isolated_vertex unbounded\nremove_edge h0\nconnect i0 ~0 left\ncontract_edge h0");
    let mut pair = InStep::new(Faulty::new(Fault::WrongReason), &Expectation::plane()).unwrap();
    let outcomes = [0, 1, 2].map(|i| pair.step(program.0[i]).unwrap());
    assert_eq!(outcomes, [StepOutcome::Applied, StepOutcome::Skipped, StepOutcome::Applied]);
    assert_eq!(pair.summary().total(), OperatorCounts { applied: 2, skipped: 1, ..OperatorCounts::default() });
    let failure = pair.step(program.0[3]).unwrap_err();
    assert_eq!((failure.before, failure.op), (3, Some(program.0[3])));
}
