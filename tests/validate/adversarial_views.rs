//! Views that answer anything: the validator returns, and refuses them. No answer makes it panic, ask about a slot that is
//! not there, or go on for ever.

use crate::support::erased::validate;
use crate::support::inconsistent::Inconsistent;
use crate::support::nested::{nested, nested_textbook};
use crate::support::opinions::{agree, broken};
use crate::support::tables::{map, mesh};
use std::cell::Cell;
use twinedge::delegate_view;
use twinedge::validate::enumerate::for_each_corruption;
use twinedge::validate::{
    BoundaryPlace, Collect, Expectation, Link, Part, Rule, Start, Table, Unchecked, View, Violation,
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
            let asked = expectation.no_unused_vertices().simple().sides(3).closed().components(1).borders(0).genus(0);
            all.extend([asked, asked.open()]);
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
        self.answer.map(if position % 2 == 0 { Start::HalfEdge } else { Start::Vertex })
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

/// However many answers are consistent before they begin to change: only a few questions more are asked, and none about
/// slots that are not there.
#[test]
fn answers_may_change_from_call_to_call() {
    let table = loops();
    for expectation in expectations() {
        let questions = |consistent_answers, seed| {
            let view = Inconsistent::new(&table, consistent_answers, seed);
            validate(&view, &expectation, Collect::All);
            view.questions.get()
        };
        let consistent = questions(u64::MAX, 0);
        for consistent_answers in 0..=consistent {
            for seed in 0..8 {
                assert!(questions(consistent_answers, seed) < 3 * consistent + 300, "{expectation:?}");
            }
        }
    }
}

/// `next` is a permutation when R1 and L2 read it, and another one when T3 counts its cycles: the only way to a surface
/// that does not exist, because where L and V2 hold, the numbers of a component are those of a surface.
#[test]
fn a_surface_that_does_not_exist() {
    struct Changing(Cell<usize>, [usize; 2]);
    impl View for Changing {
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
            let [once, from] = self.1;
            Some(if self.0.get() == once || self.0.get() >= from { half_edge ^ 1 } else { half_edge })
        }
    }
    let expectation = Expectation::surface().without(Part::Faces).without(Part::Prev).without(Part::Leaving);
    // One change makes the fast path give up, and the other one comes when the cycles are counted.
    let changes = (1..10).flat_map(|once| (once..40).map(move |from| [once, from]));
    let reports = changes.map(|when| validate(&Changing(Cell::new(0), when), &expectation, Collect::All));
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

/// Twice and four times the records cost twice and four times the questions, whether the structure is valid or not.
#[test]
fn the_work_is_linear() {
    let expectation = Expectation::surface();
    assert_eq!(validate(&torus(10), &expectation, Collect::All).certificate().unwrap().genus, 1);
    let questions = |length, corrupt: &dyn Fn(&mut Table)| {
        let mut table = torus(length);
        corrupt(&mut table);
        let view = Inconsistent::new(&table, u64::MAX, 0);
        validate(&view, &expectation, Collect::All);
        view.questions.get()
    };
    let corruptions: [&dyn Fn(&mut Table); 6] = [
        &|_| (),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.next = Some(0)),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.origin = Some(0)),
        &|table| table.half_edges.iter_mut().flatten().for_each(|row| row.boundary = Some(0)),
        &|table| table.boundaries.iter_mut().flatten().for_each(|row| row.start = Some(Start::HalfEdge(0))),
        &|table| table.faces.iter_mut().flatten().for_each(|row| row.outer = Some(0)),
    ];
    for corrupt in corruptions {
        let [one, two, four] = [10, 20, 40].map(|length| questions(length, corrupt));
        // Questions asked once, before a violation is found, cancel out in the differences.
        assert!((four - two).abs_diff(2 * (two - one)) < 10, "{one} {two} {four}");
    }
}

#[test]
fn a_consistent_table_is_valid() {
    for expectation in [Expectation::plane(), Expectation::plane().without(Part::BoundaryComponents)] {
        assert_eq!(agree(&loops(), expectation), None);
    }
}

/// Links may lead one past the end, or anywhere else: no question is asked about what is there.
#[test]
fn no_question_about_a_slot_that_is_not_there() {
    let plane = Expectation::plane();
    for (mut table, base) in [(nested(), plane), (nested_textbook(), plane.without(Part::BoundaryComponents))] {
        for expectation in [base, base.open(), base.without(Part::Prev), base.without(Part::Places)] {
            let mut changes = 0;
            for_each_corruption(&mut table, &expectation, |changed, _, _| {
                changes += 1;
                // It panics where it is asked about something else.
                let report = validate(&Inconsistent::new(changed, u64::MAX, 0), &expectation, Collect::All);
                assert_eq!(report, validate(changed, &expectation, Collect::All));
            });
            assert!(changes > 500, "{changes}");
        }
    }
}

/// A table whose last slots of each kind are vacant, but still answer with the fields of a former record.
struct StaleSlots {
    live: Table,
    rows: Table,
}

impl StaleSlots {
    /// The last slots must be vacant, of boundary components the last two. They answer with the fields of the first ones,
    /// the last face with those of the second.
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

impl View for StaleSlots {
    delegate_view!(|this| &this.live; only vertex_slots, half_edge_slots, boundary_slots, face_slots);
    delegate_view!(|this| &this.live; only is_vertex, is_half_edge, is_boundary, is_face);
    delegate_view!(|this| &this.rows; only origin, twin, next, prev, boundary, face, leaving, isolated);
    delegate_view!(|this| &this.rows; only boundary_face, boundary_start, boundary_place, outer, inner_count, inner);
    delegate_view!(|this| &this.rows; only outer_half_edge, inner_start);
}

#[test]
fn answers_for_vacant_slots_do_not_matter() {
    let plane = Expectation::plane();
    for (mut table, base) in [(nested(), plane), (nested_textbook(), plane.without(Part::BoundaryComponents))] {
        table.vertices.push(None);
        table.half_edges.push(None);
        table.boundaries.extend([None, None]);
        table.faces.push(None);
        for expectation in [base, base.open(), base.without(Part::Prev), base.without(Part::Places)] {
            let judged = |table: &Table| validate(table, &expectation, Collect::All);
            assert!(judged(&table).is_valid());
            assert_eq!(validate(&StaleSlots::by(&table), &expectation, Collect::All), judged(&table));
            for_each_corruption(&mut table.clone(), &expectation, |changed, _, _| {
                assert_eq!(validate(&StaleSlots::by(changed), &expectation, Collect::All), judged(changed));
            });
        }
    }
}
