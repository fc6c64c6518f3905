//! Structures that lie: the validator returns, and refuses them. No answer may make it panic, ask about what is not
//! there, or go on for ever.

use crate::support::delegate::delegate_view;
use crate::support::moody::Moody;
use crate::support::nested::{nested, nested_textbook};
use crate::support::opinions::{agree, broken};
use crate::support::tables::{map, mesh};
use std::cell::Cell;
use twinedge::validate::enumerate::for_each_corruption;
use twinedge::validate::{
    BoundaryPlace, Collect, Expectation, Link, Part, Rule, Start, Table, Unchecked, View, Violation, validate,
};

/// All the expectations that make a difference to which code runs.
fn expectations() -> Vec<Expectation> {
    let mut all = vec![];
    for base in [Expectation::plane(), Expectation::surface()] {
        for parts in [&[][..], &[Part::BoundaryComponents], &[Part::Faces], &[Part::Holes], &[Part::UnboundedFace]] {
            let without = |expectation: Expectation, part: &Part| expectation.without(*part);
            let expectation = parts.iter().fold(base, without);
            let without_prev = expectation.without(Part::Prev);
            all.extend([expectation, expectation.open(), without_prev, without_prev.open()]);
        }
    }
    all
}

/// A structure that claims this many slots of each kind and answers every question with this link.
struct Claims {
    slots: [usize; 4],
    answer: Link,
    listed: usize,
}

impl View for Claims {
    fn vertex_slots(&self) -> usize {
        self.slots[0]
    }
    fn half_edge_slots(&self) -> usize {
        self.slots[1]
    }
    fn boundary_slots(&self) -> usize {
        self.slots[2]
    }
    fn face_slots(&self) -> usize {
        self.slots[3]
    }
    fn origin(&self, _: usize) -> Link {
        self.answer
    }
    fn twin(&self, _: usize) -> Link {
        self.answer
    }
    fn next(&self, _: usize) -> Link {
        self.answer
    }
    fn prev(&self, _: usize) -> Link {
        self.answer
    }
    fn boundary(&self, _: usize) -> Link {
        self.answer
    }
    fn face(&self, _: usize) -> Link {
        self.answer
    }
    fn leaving(&self, _: usize) -> Link {
        self.answer
    }
    fn isolated(&self, _: usize) -> Link {
        self.answer
    }
    fn boundary_face(&self, _: usize) -> Link {
        self.answer
    }
    fn boundary_start(&self, _: usize) -> Option<Start> {
        self.answer.map(Start::HalfEdge)
    }
    fn boundary_place(&self, _: usize) -> Option<BoundaryPlace> {
        self.answer.map(BoundaryPlace::Inner)
    }
    fn outer(&self, _: usize) -> Link {
        self.answer
    }
    fn inner_count(&self, _: usize) -> usize {
        self.listed
    }
    fn inner(&self, _: usize, _: usize) -> Link {
        self.answer
    }
    fn outer_half_edge(&self, _: usize) -> Link {
        self.answer
    }
    fn inner_start(&self, _: usize, position: usize) -> Option<Start> {
        self.answer.map(if position.is_multiple_of(2) { Start::HalfEdge } else { Start::Vertex })
    }
}

#[test]
fn a_claim_of_too_many_records_is_refused_unread() {
    for kind in 0..4 {
        for claimed in [usize::MAX, u32::MAX as usize] {
            let mut slots = [1; 4];
            slots[kind] = claimed;
            let view = Claims { slots, answer: None, listed: 0 };
            let report = validate(&view, &Expectation::plane(), Collect::All);
            assert!(!report.is_valid());
            assert_eq!((report.violation_count(), report.certificate()), (0, None));
            assert!(report.outcomes().all(|(_, outcome)| outcome.unchecked == Some(Unchecked::TooLarge)));
        }
        let mut slots = [1; 4];
        slots[kind] = usize::MAX;
        assert_eq!(Table::copy_of(&Claims { slots, answer: None, listed: 0 }), None);
    }
    assert_eq!(Table::copy_of(&Claims { slots: [1; 4], answer: None, listed: usize::MAX }), None);
}

#[test]
fn every_link_leads_to_one_record() {
    for expectation in expectations() {
        for answer in [None, Some(0), Some(1), Some(999), Some(1000), Some(usize::MAX)] {
            for listed in [0, 3, usize::MAX] {
                let view = Claims { slots: [1000; 4], answer, listed };
                let report = validate(&view, &expectation, Collect::AtMost(0));
                assert!(!report.is_valid());
                assert!(report.violation_count() > 0);
            }
        }
    }
}

/// A loop in a loop beside a vertex, in either form: every question has an answer in it.
fn loops() -> Table {
    let (outside, between) = ([Start::HalfEdge(1), Start::Vertex(2)], [Start::HalfEdge(3)]);
    let half_edges = [(0, 0), (0, 1), (1, 2), (1, 3)];
    let faces: [(Option<usize>, &[Start]); 3] = [(None, &outside), (Some(0), &between), (Some(2), &[])];
    let (mut table, textbook) =
        (map(3, &half_edges, &faces), crate::support::tables::textbook_map(3, &half_edges, &faces));
    for (row, other) in table.half_edges.iter_mut().flatten().zip(textbook.half_edges.iter().flatten()) {
        row.face = other.face;
    }
    for (row, other) in table.faces.iter_mut().flatten().zip(textbook.faces.iter().flatten()) {
        (row.outer_half_edge, row.inner_starts) = (other.outer_half_edge, other.inner_starts.clone());
    }
    table
}

/// Whatever changes while it is being looked at, and from whichever question on: only a few questions more are asked,
/// and none about what is not there.
#[test]
fn answers_may_change_from_call_to_call() {
    let table = loops();
    for expectation in expectations() {
        let questions = |patience, seed| {
            let view = Moody::new(&table, patience, seed);
            validate(&view, &expectation, Collect::All);
            view.questions.get()
        };
        let honest = questions(u64::MAX, 0);
        for patience in 0..=honest {
            for seed in 0..8 {
                assert!(questions(patience, seed) < 3 * honest + 300, "{expectation:?}");
            }
        }
    }
}

/// `next` is a permutation when R1 and L2 look at it, and another when T3 counts its cycles: the only way to a surface
/// that does not exist, because where L and V2 hold, the numbers of a component are those of a surface.
#[test]
fn a_surface_that_does_not_exist() {
    struct Fickle(Cell<usize>, usize);
    impl View for Fickle {
        fn vertex_slots(&self) -> usize {
            1
        }
        fn half_edge_slots(&self) -> usize {
            2
        }
        fn origin(&self, _: usize) -> Link {
            Some(0)
        }
        fn twin(&self, half_edge: usize) -> Link {
            Some(half_edge ^ 1)
        }
        fn next(&self, half_edge: usize) -> Link {
            self.0.set(self.0.get() + 1);
            Some(if self.0.get() <= self.1 { half_edge } else { half_edge ^ 1 })
        }
    }
    let expectation = Expectation::surface().without(Part::Faces).without(Part::Prev).without(Part::Leaving);
    let reports = (0..20).map(|n| validate(&Fickle(Cell::new(0), n), &expectation, Collect::All));
    let odd: Vec<_> = reports.filter(|report| broken(report) == [Rule::T3]).collect();
    let violation = Violation::NoSuchSurface { vertex: 0, vertices: 1, edges: 1, cycles: 1 };
    assert!(!odd.is_empty());
    assert!(odd.iter().all(|report| report.violations() == [violation]));
}

/// A torus of six triangles for each unit of length.
fn torus(length: usize) -> Table {
    let vertex = |i: usize, j: usize| 3 * (i % length) + j % 3;
    let triangles: Vec<[usize; 3]> = (0..3 * length)
        .map(|k| (k / 3, k % 3))
        .flat_map(|(i, j)| {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    mesh(3 * length, &triangles)
}

/// Twice and four times the records cost twice and four times the questions, whether the structure is right or not.
#[test]
fn the_work_is_linear() {
    let expectation = Expectation::surface();
    assert_eq!(validate(&torus(10), &expectation, Collect::All).certificate().unwrap().genus, 1);
    let questions = |length, spoil: &dyn Fn(&mut Table)| {
        let mut table = torus(length);
        spoil(&mut table);
        let view = Moody::new(&table, u64::MAX, 0);
        validate(&view, &expectation, Collect::All);
        view.questions.get()
    };
    let spoils: [&dyn Fn(&mut Table); 6] = [
        &|_| (),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.next = Some(0)),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.origin = Some(0)),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.boundary = Some(0)),
        &|table| table.boundaries.iter_mut().flatten().for_each(|row| row.start = Some(Start::HalfEdge(0))),
        &|table| table.faces.iter_mut().flatten().for_each(|row| row.outer = Some(0)),
    ];
    for spoil in spoils {
        let [one, two, four] = [10, 20, 40].map(|length| questions(length, spoil));
        // What is asked but once, before something amiss is found, drops out of the differences.
        assert!((four - two).abs_diff(2 * (two - one)) < 10, "{one} {two} {four}");
    }
}

#[test]
fn an_honest_table_is_judged_as_always() {
    for expectation in [Expectation::plane(), Expectation::plane().without(Part::BoundaryComponents)] {
        assert_eq!(agree(&loops(), expectation), None);
    }
}

/// Whatever link leads one past the end, or anywhere else: nobody asks what is there.
#[test]
fn no_question_about_a_slot_that_is_not_there() {
    let plane = Expectation::plane();
    for (mut table, base) in [(nested(), plane), (nested_textbook(), plane.without(Part::BoundaryComponents))] {
        for expectation in [base, base.open(), base.without(Part::Prev), base.without(Part::Places)] {
            let mut changes = 0;
            for_each_corruption(&mut table, &expectation, |changed, _, _| {
                changes += 1;
                // It panics where it is asked about something else.
                let report = validate(&Moody::new(changed, u64::MAX, 0), &expectation, Collect::All);
                assert_eq!(report, validate(changed, &expectation, Collect::All));
            });
            assert!(changes > 500, "{changes}");
        }
    }
}

/// What was in the last slots of each kind is still to be read there, but nothing lives in them any more.
struct Haunted {
    live: Table,
    rows: Table,
}

impl Haunted {
    /// The last slots must be vacant, of boundary components the last two. What is left in them is what the first ones hold,
    /// but of the faces the second.
    fn by(live: &Table) -> Self {
        let live = live.clone();
        let mut rows = live.clone();
        *rows.vertices.last_mut().unwrap() = rows.vertices[0];
        *rows.half_edges.last_mut().unwrap() = rows.half_edges[0];
        let n = rows.boundaries.len();
        // A cycle and an isolated vertex, where there are boundary components.
        (rows.boundaries[n - 1], rows.boundaries[n - 2]) = (rows.boundaries[0], rows.boundaries[3 % n]);
        rows.faces.pop();
        rows.faces.push(rows.faces[1].clone());
        Self { live, rows }
    }
}

impl View for Haunted {
    delegate_view!(live, rows);
}

#[test]
fn what_is_left_in_vacant_slots_means_nothing() {
    let plane = Expectation::plane();
    for (mut table, base) in [(nested(), plane), (nested_textbook(), plane.without(Part::BoundaryComponents))] {
        table.vertices.push(None);
        table.half_edges.push(None);
        table.boundaries.extend([None, None]);
        table.faces.push(None);
        for expectation in [base, base.open(), base.without(Part::Prev), base.without(Part::Places)] {
            let judged = |table: &Table| validate(table, &expectation, Collect::All);
            assert!(judged(&table).is_valid());
            assert_eq!(validate(&Haunted::by(&table), &expectation, Collect::All), judged(&table));
            for_each_corruption(&mut table.clone(), &expectation, |changed, _, _| {
                assert_eq!(validate(&Haunted::by(changed), &expectation, Collect::All), judged(changed));
            });
        }
    }
}
