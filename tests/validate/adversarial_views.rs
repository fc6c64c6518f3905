//! Views with arbitrary answers: the validator terminates and refuses them. No answer makes it panic, ask about a missing
//! slot, or loop.

use crate::support::erased::validate;
use crate::support::inconsistent::Inconsistent;
use crate::support::nested::{PLANE, nested, nested_textbook};
use crate::support::opinions::{agree, broken};
use crate::support::tables::{Without, map, mesh, textbook_map, torus};
use std::cell::Cell;
use twinedge::validate::near::{Baseline, WriteSet, validate_near};
use twinedge::validate::{
    BoundaryPlace, Collect, Expectation, HalfEdgeColumns, Link, Only, Part, Parts, Rule, Start, Table, Unchecked, View,
    Violation,
};
use twinedge::{delegate_view, view_answers};
use twinedge_trials::enumerate::for_each_corruption;
use twinedge_trials::forms::Form;

const SURFACE: Expectation = Expectation::surface();

/// The forms that exercise different code.
fn forms() -> Vec<Form> {
    let mut all = vec![];
    for claims in [PLANE, SURFACE] {
        for lacks in
            [None, Some(Part::BoundaryComponents), Some(Part::Faces), Some(Part::Holes), Some(Part::UnboundedFace)]
        {
            let parts = lacks.map_or(Parts::ALL, |part| Parts::ALL.without(part));
            let asked = claims.no_unused_vertices().simple().sides(3).closed().components(1).borders(0).genus(0);
            for (claims, parts) in [(claims, parts), (claims, parts.without(Part::Prev)), (asked, parts)] {
                all.extend([claims, claims.open()].map(|claims| Form::new(claims, parts)));
            }
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
    view_answers! { |claims|
        parts => Parts::ALL,
        vertex_slots => claims.slots[0],
        half_edge_slots => claims.slots[1],
        boundary_slots => claims.slots[2],
        face_slots => claims.slots[3],
        origin(_h) => claims.answer,
        twin(_h) => claims.answer,
        next(_h) => claims.answer,
        prev(_h) => claims.answer,
        boundary(_h) => claims.answer,
        face(_h) => claims.answer,
        leaving(_h) => claims.answer,
        isolated(_h) => claims.answer,
        boundary_face(_h) => claims.answer,
        boundary_start(_h) => claims.answer.map(Start::HalfEdge),
        boundary_place(_h) => claims.answer.map(BoundaryPlace::Inner),
        outer(_h) => claims.answer,
        inner_count(_h) => claims.listed,
        inner(_h, _i) => claims.answer,
        outer_half_edge(_h) => claims.answer,
        inner_start(_h, position) => claims.answer.map(if position % 2 == 0 { Start::HalfEdge } else { Start::Vertex }),
    }
}

#[test]
fn a_claim_of_too_many_records_is_refused_unread() {
    for kind in 0..4 {
        for claimed in [usize::MAX, u32::MAX as usize] {
            let mut slots = [1; 4];
            slots[kind] = claimed;
            let view = Claims { slots, answer: None, listed: 0 };
            let report = validate(&view, &PLANE, Collect::All);
            assert!(!report.is_valid());
            assert_eq!((report.violation_count(), report.figures()), (0, None));
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
    for form in forms() {
        for answer in [None, Some(0), Some(1), Some(999), Some(1000), Some(usize::MAX)] {
            for listed in [0, 3, usize::MAX] {
                let view = Claims { slots: [1000; 4], answer, listed };
                // No slot is vacant unless the view says so.
                for (slot, is_live) in [(0, true), (999, true), (1000, false), (usize::MAX, false)] {
                    let live =
                        [view.is_vertex(slot), view.is_half_edge(slot), view.is_boundary(slot), view.is_face(slot)];
                    assert_eq!(live, [is_live; 4]);
                }
                let report = validate(&Only::new(view, form.parts), &form.expectation, Collect::AtMost(0));
                assert!(!report.is_valid());
                assert!(report.violation_count() > 0);
            }
        }
    }
}

/// Two nested loops and a vertex, in either form: every question has an answer.
fn loops() -> Table {
    let (outside, between) = ([Start::HalfEdge(1), Start::Vertex(2)], [Start::HalfEdge(3)]);
    let half_edges = [(0, 0), (0, 1), (1, 2), (1, 3)];
    let faces: [(Option<usize>, &[Start]); 3] = [(None, &outside), (Some(0), &between), (Some(2), &[])];
    let (mut table, textbook) = (map(3, &half_edges, &faces), textbook_map(3, &half_edges, &faces));
    for (row, other) in table.half_edges.iter_mut().flatten().zip(textbook.half_edges.iter().flatten()) {
        row.face = other.face;
    }
    for (row, other) in table.faces.iter_mut().flatten().zip(textbook.faces.iter().flatten()) {
        (row.outer_half_edge, row.inner_starts) = (other.outer_half_edge, other.inner_starts.clone());
    }
    table
}

/// Answers that change after any number of consistent ones only cause a few more questions, none about missing slots.
#[test]
fn answers_may_change_from_call_to_call() {
    let table = loops();
    for form in forms() {
        let questions = |consistent_answers, seed| {
            let view = Inconsistent::new(&table, consistent_answers, seed);
            validate(&Only::new(&view, form.parts), &form.expectation, Collect::All);
            view.questions.get()
        };
        let consistent = questions(u64::MAX, 0);
        for consistent_answers in 0..=consistent {
            for seed in 0..8 {
                let asked = questions(consistent_answers, seed);
                assert!(asked < 3 * consistent + 300, "{asked}, {consistent}, {form:?}");
            }
        }
    }
}

/// Answers may also change during checks near a change, of every record and of a few.
#[test]
fn answers_may_change_while_a_change_is_checked() {
    let table = loops();
    let written = WriteSet { vertices: vec![0], half_edges: vec![0, 1], ..WriteSet::default() };
    for form in forms().into_iter().filter(|form| !form.expectation.is_open()) {
        let Ok(baseline) = Baseline::new(&Only::new(&table, form.parts), &form.expectation) else { continue };
        let questions = |consistent_answers, seed| {
            let view = Inconsistent::new(&table, consistent_answers, seed);
            let _ = Baseline::new(&Only::new(&view, form.parts), &form.expectation);
            let asked = view.questions.get();
            let view = Inconsistent::new(&table, consistent_answers, seed);
            let _ = validate_near(&mut baseline.clone(), &Only::new(&view, form.parts), &written);
            asked + view.questions.get()
        };
        let consistent = questions(u64::MAX, 0);
        for consistent_answers in 0..=consistent {
            for seed in 0..32 {
                assert!(questions(consistent_answers, seed) < 6 * consistent + 600, "{form:?}");
            }
        }
    }
}

/// `next` is a permutation when R1 and L2 read it, and a different one when T3 counts its cycles. Otherwise no invalid
/// surface is possible, since where L and V2 hold, the counts of a component belong to a surface.
#[test]
fn a_surface_that_does_not_exist() {
    struct Changing(Cell<usize>, [usize; 2]);
    impl View for Changing {
        view_answers! { |view|
            parts => Parts::NONE,
            vertex_slots => 1,
            half_edge_slots => 2,
            origin(_h) => Some(0),
            twin(h) => Some(h ^ 1),
            next(h) => {
                view.0.set(view.0.get() + 1);
                let [once, from] = view.1;
                Some(if view.0.get() == once || view.0.get() >= from { h ^ 1 } else { h })
            },
        }
    }
    // One change makes the fast path fail, and the other one comes while cycles are counted.
    let changes = (1..10).flat_map(|once| (once..40).map(move |from| [once, from]));
    let reports = changes.map(|when| validate(&Changing(Cell::new(0), when), &SURFACE, Collect::All));
    let odd: Vec<_> = reports.filter(|report| broken(report) == [Rule::T3]).collect();
    let violation = Violation::NoSuchSurface { vertex: 0, vertices: 1, edges: 1, cycles: 1 };
    assert!(!odd.is_empty());
    assert!(odd.iter().all(|report| report.violations() == [violation]));
}

/// Twice and four times the records take twice and four times the questions, for valid and invalid structures.
#[test]
fn the_work_is_linear() {
    assert_eq!(validate(&mesh(30, &torus([3, 10])), &SURFACE, Collect::All).figures().unwrap().genus, 1);
    let questions = |length, corrupt: &dyn Fn(&mut Table)| {
        let mut table = mesh(3 * length, &torus([3, length]));
        corrupt(&mut table);
        let view = Inconsistent::new(&table, u64::MAX, 0);
        validate(&view, &SURFACE, Collect::All);
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
        // Questions asked only once, before a violation is found, cancel in the differences.
        assert!((four - two).abs_diff(2 * (two - one)) < 10, "{one} {two} {four}");
    }
}

#[test]
fn a_consistent_table_is_valid() {
    assert_eq!(agree(&loops(), PLANE), None);
    assert_eq!(agree(&loops().without(Part::BoundaryComponents), PLANE), None);
}

/// The whole table, open, and without one part.
fn forms_of(whole: Table) -> [(Table, Expectation); 4] {
    let [without_prev, without_places] = [Part::Prev, Part::Places].map(|part| whole.without(part));
    [(whole.clone(), PLANE.open()), (whole, PLANE), (without_prev, PLANE), (without_places, PLANE)]
}

/// A table whose last slots of each kind are vacant, but still answer with the fields of a former record.
struct StaleSlots {
    live: Table,
    rows: Table,
}

impl StaleSlots {
    /// The last slots must be vacant, for boundary components the last two. They answer with the fields of the first ones,
    /// and the last face with the fields of the second.
    fn by(live: &Table) -> Self {
        let live = live.clone();
        let mut rows = live.clone();
        *rows.vertices.last_mut().unwrap() = rows.vertices[0];
        *rows.half_edges.last_mut().unwrap() = rows.half_edges[0];
        let n = rows.boundaries.len();
        // A cycle and an isolated vertex, if boundary components are stored.
        (rows.boundaries[n - 1], rows.boundaries[n - 2]) = (rows.boundaries[0], rows.boundaries[3 % n]);
        rows.faces.pop();
        rows.faces.push(rows.faces[1].clone());
        Self { live, rows }
    }
}

impl View for StaleSlots {
    delegate_view!(|this| &this.live; only parts, vertex_slots, half_edge_slots, boundary_slots, face_slots);
    delegate_view!(|this| &this.live; only is_vertex, is_half_edge, is_boundary, is_face);
    delegate_view!(|this| &this.rows; only origin, twin, next, prev, boundary, face, leaving, isolated);
    delegate_view!(|this| &this.rows; only boundary_face, boundary_start, boundary_place, outer, inner_count, inner);
    delegate_view!(|this| &this.rows; only outer_half_edge, inner_start);
}

#[test]
fn answers_for_vacant_slots_do_not_matter() {
    for mut table in [nested(), nested_textbook()] {
        table.vertices.push(None);
        table.half_edges.push(None);
        table.boundaries.extend([None, None]);
        table.faces.push(None);
        for (table, expectation) in forms_of(table) {
            let judged = |table: &Table| validate(table, &expectation, Collect::All);
            assert!(judged(&table).is_valid());
            assert_eq!(validate(&StaleSlots::by(&table), &expectation, Collect::All), judged(&table));
            for_each_corruption(&mut table.clone(), table.parts, |changed, _, _| {
                assert_eq!(validate(&StaleSlots::by(changed), &expectation, Collect::All), judged(changed));
            });
        }
    }
}

/// A table that lends links different from its answers: origin, next, prev and boundary.
struct Lying<'a> {
    table: &'a Table,
    columns: [Vec<u32>; 4],
}

impl View for Lying<'_> {
    delegate_view!(|this| this.table);

    fn half_edge_columns(&self) -> Option<HalfEdgeColumns<'_>> {
        let [origin, next, prev, boundary] = &self.columns;
        Some(HalfEdgeColumns { origin, next, prev, boundary, face: &[], live_edges: None })
    }
}

#[test]
fn lent_links_may_be_other_links_than_the_view_answers() {
    let table = nested();
    let n = table.half_edges.len();
    let links: [fn(&Table, usize) -> Link; 4] = [View::origin, View::next, View::prev, View::boundary];
    let column = |link: fn(&Table, usize) -> Link| {
        (0..n).map(|h| link(&table, h).map_or(u32::MAX, |link| link as u32)).collect::<Vec<_>>()
    };
    let mut lying = Lying { table: &table, columns: links.map(column) };
    assert!(validate(&lying, &PLANE, Collect::All).is_valid());
    for value in [0, 1, 3, n as u32 - 1, n as u32, u32::MAX - 1, u32::MAX] {
        for (column, h) in (0..4).flat_map(|column| (0..n).map(move |h| (column, h))) {
            let right = std::mem::replace(&mut lying.columns[column][h], value);
            for expectation in [PLANE, PLANE.open()] {
                let _ = validate(&lying, &expectation, Collect::All);
            }
            lying.columns[column][h] = right;
        }
    }
}
