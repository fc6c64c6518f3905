//! Report contents besides the expected violation: the numbers of checks, early ends, further faults.

use crate::support::erased::validate;
use crate::support::nested::{FACES, HALF_EDGES, PLANE, nested, nested_textbook};
use crate::support::opinions::agree;
use crate::support::tables::{Without, face, half_edge, map, textbook_mesh, torus, vertex};
use std::collections::BTreeSet;
use twinedge::validate::{
    Collect, Expectation, FaceRow, Field, Part, Record, Rule, Start, Table, Unchecked, Violation,
};
use twinedge_trials::enumerate::for_each_corruption;

#[test]
fn every_rule_says_how_much_it_checked_whatever_else_is_broken() {
    // By counting in the drawing. T1 and T2 rely on V1.
    let expected = |links| [links, 12, 12, 12, 6, 6, 12, 7, 3, 5, 3, 3, 3, 1];
    for (mut table, links) in [(nested(), 83), (nested_textbook(), 73)] {
        let checked = |table: &Table| {
            let report = validate(table, &PLANE, Collect::All);
            let topological = report.outcomes().filter(|(rule, _)| *rule <= Rule::T4);
            topological.map(|(_, outcome)| outcome.checked).collect::<Vec<_>>()
        };
        let counts = |table: &Table| *validate(table, &PLANE, Collect::All).counts();
        let mut expected = expected(links);
        let counted = counts(&table);
        assert_eq!(checked(&table), expected);
        vertex(&mut table, 3).leaving = Some(0);
        (expected[10], expected[11]) = (0, 0);
        assert_eq!(checked(&table), expected);
        assert_eq!(counts(&table), counted);
    }
}

#[test]
fn r1_a_list_is_said_to_be_too_long_exactly_if_some_of_it_was_not_read() {
    let found = |table: &Table| {
        let report = validate(table, &PLANE, Collect::All);
        let is_too_long = |v: &&Violation| matches!(v, Violation::ListTooLong { .. });
        let twice = report.violations().iter().filter(|v| matches!(v, Violation::ListedTwice { .. })).count();
        (twice, report.violations().iter().filter(is_too_long).count())
    };
    let mut cut_short = 0;
    for length in 2..100 {
        let at = |length: usize, table: &Table| {
            let mut table = table.clone();
            face(&mut table, 1).inner.resize(length, Some(3));
            face(&mut table, 1).inner_starts.resize(length, Some(Start::HalfEdge(7)));
            found(&table)
        };
        for table in [nested().without(Part::Places), nested_textbook()] {
            let ((before, _), (after, too_long)) = (at(length, &table), at(length + 1, &table));
            assert_eq!(too_long, usize::from(after == before), "{} entries, {table}", length + 1);
            cut_short += too_long;
        }
    }
    assert!(cut_short > 50);
}

#[test]
fn f2_what_is_not_listed_is_counted_as_checked_too() {
    let mut table = nested_textbook();
    face(&mut table, 0).inner_starts.clear();
    let report = validate(&table, &PLANE, Collect::All);
    assert_eq!(report.first().map(Violation::rule), Some(Rule::F2));
    assert_eq!(report.outcome(Rule::F2).map(|outcome| outcome.checked), Some(5));
}

/// The nested triangles with a loop at vertex 7 around face 3 in the inner one: half-edges 12 and 13. The last slot of each
/// kind is vacant.
fn with_a_loop() -> Table {
    let mut half_edges = HALF_EDGES.to_vec();
    half_edges.extend([(7, 12), (7, 13)]);
    let faces = [FACES[0], FACES[1], (Some(6), &[Start::HalfEdge(13)]), (Some(12), &[])];
    let mut table = map(8, &half_edges, &faces);
    table.vertices.push(None);
    table.half_edges.push(None);
    table.boundaries.push(None);
    table.faces.push(None);
    table
}

/// A change that breaks a table.
type Change = fn(&mut Table);

/// Returns the violations for a link of half-edge 12 that leads to no live record: the link, and the starts there.
fn broken_link(field: Field, value: Option<usize>) -> Vec<Violation> {
    let record = Record::HalfEdge(12);
    let leads_nowhere = match value {
        None => Violation::Nil { record, field },
        Some(value) => Violation::Dangling { record, field, value },
    };
    let starts =
        (field == Field::Boundary).then_some(Violation::StartElsewhere { boundary: 6, half_edge: 12, found: value });
    [leads_nowhere].into_iter().chain(starts).collect()
}

#[test]
fn r1_a_link_that_leads_nowhere_hides_nothing_beside_it_and_breaks_nothing_else() {
    let target = |half_edge, next, target, found| Violation::Target { half_edge, next, target, found };
    let not_mutual = |half_edge, twin, found| Violation::TwinNotMutual { half_edge, twin, found: Some(found) };
    let elsewhere: [(Change, &[Violation]); 8] = [
        (|_| (), &[]),
        (|t| half_edge(t, 0).twin = Some(2), &[not_mutual(0, 2, 3), not_mutual(1, 0, 2)]),
        (
            |t| half_edge(t, 0).twin = Some(0),
            &[Violation::TwinIsSelf { half_edge: 0 }, not_mutual(1, 0, 0), target(0, 2, 0, 1)],
        ),
        (
            |t| half_edge(t, 0).next = Some(4),
            &[
                Violation::PrevOfNext { half_edge: 0, next: 4, found: 2 },
                Violation::NextOfPrev { half_edge: 2, prev: 0, found: 4 },
                target(0, 4, 1, 2),
            ],
        ),
        (
            |t| half_edge(t, 0).prev = Some(2),
            &[
                Violation::NextOfPrev { half_edge: 0, prev: 2, found: 4 },
                Violation::PrevOfNext { half_edge: 4, next: 0, found: 2 },
            ],
        ),
        (
            |t| half_edge(t, 0).origin = Some(1),
            &[target(1, 5, 1, 0), target(4, 0, 0, 1), Violation::NotLeaving { vertex: 0, half_edge: 0, origin: 1 }],
        ),
        (|t| vertex(t, 0).leaving = Some(2), &[Violation::NotLeaving { vertex: 0, half_edge: 2, origin: 1 }]),
        (
            |t| vertex(t, 6).isolated = Some(2),
            &[Violation::IsolatedMismatch { vertex: 6, boundary: 3, found: Some(2) }],
        ),
    ];
    let (vertex, half_edge, boundary) = (8, 14, 7);
    let fields = [
        (Field::Origin, vertex),
        (Field::Twin, half_edge),
        (Field::Next, half_edge),
        (Field::Prev, half_edge),
        (Field::Boundary, boundary),
    ];
    for (change, violations) in elsewhere {
        for (field, vacant) in fields {
            for value in [None, Some(vacant), Some(99)] {
                let mut table = with_a_loop();
                assert_eq!(agree(&table, PLANE), None);
                change(&mut table);
                let row = table.half_edges[12].as_mut().unwrap();
                *match field {
                    Field::Origin => &mut row.origin,
                    Field::Twin => &mut row.twin,
                    Field::Next => &mut row.next,
                    Field::Prev => &mut row.prev,
                    _ => &mut row.boundary,
                } = value;
                let report = validate(&table, &PLANE, Collect::All);
                let expected = [broken_link(field, value), violations.to_vec()].concat();
                let as_expected = expected.iter().all(|violation| report.violations().contains(violation));
                assert!(as_expected && report.violations().len() == expected.len(), "{expected:?}\n{report}");
            }
        }
    }
}

#[test]
fn t4_applies_from_three_vertices_on() {
    let edge = map(2, &[(0, 1), (1, 0)], &[(None, &[Start::HalfEdge(0)])]);
    let triangle =
        map(3, &[(0, 2), (1, 5), (1, 4), (2, 1), (2, 0), (0, 3)], &[(None, &[Start::HalfEdge(1)]), (Some(0), &[])]);
    let t4 = |table: &Table| {
        let report = validate(table, &PLANE, Collect::All);
        let bounds = report.figures().unwrap().bounds.map(|bounds| (bounds.most_edges, bounds.most_faces));
        (bounds, report.outcome(Rule::T4).and_then(|outcome| outcome.unchecked))
    };
    assert_eq!(t4(&edge), (None, Some(Unchecked::NotSimple)));
    // It has the maximum numbers of both.
    assert_eq!(t4(&triangle), (Some((3, 2)), None));
    let mut one_face_more = triangle;
    one_face_more.faces.push(Some(FaceRow::default()));
    assert_eq!(agree(&one_face_more, PLANE), Some(Rule::F1));
    let report = validate(&one_face_more, &PLANE, Collect::All);
    assert!(report.violations().contains(&Violation::TooManyFaces { vertices: 3, faces: 3 }), "{report}");
}

#[test]
fn the_first_violation_stops_what_was_not_checked_yet() {
    let outcomes = |change: fn(&mut Table)| {
        let mut table = nested();
        change(&mut table);
        let report = validate(&table, &PLANE, Collect::First);
        assert_eq!(report.violation_count(), 1);
        report
            .outcomes()
            .map(|(rule, outcome)| (rule, outcome.unchecked == Some(Unchecked::Stopped)))
            .collect::<Vec<_>>()
    };
    for (rule, stopped) in outcomes(|t| half_edge(t, 0).next = None) {
        assert!(stopped, "{rule}");
    }
    for (rule, stopped) in outcomes(|t| vertex(t, 0).leaving = Some(2)) {
        assert_eq!(stopped, rule >= Rule::V1, "{rule}");
    }
}

#[test]
fn rules_of_coordinates_are_those_of_g() {
    assert!(Rule::ALL.iter().all(|rule| rule.is_geometric() == rule.id().starts_with('G')));
}

/// More wrong origins than the cap come before the one half-edge that is its own twin. Some violations of each broken rule are
/// kept, and the first belongs to L1.
#[test]
fn a_thousand_violations_of_l3_hide_none_of_l1() {
    let mut table = textbook_mesh(40 * 40, &torus([40, 40]));
    let last = table.half_edges.len() - 1;
    for h in (0..last).step_by(3) {
        let origin = &mut half_edge(&mut table, h).origin;
        *origin = origin.map(|v| (v + 1) % (40 * 40));
    }
    half_edge(&mut table, last).twin = Some(last);
    let judge = |collect| validate(&table, &Expectation::surface(), collect);
    let all = judge(Collect::All);
    let broken: Vec<Rule> = all.broken_rules().collect();
    assert_eq!(broken, [Rule::L1, Rule::L3, Rule::V1]);
    assert!(all.outcome(Rule::L3).unwrap().violations > Collect::DEFAULT_CAP as u64);
    assert_eq!(all.first(), Some(&Violation::TwinNotMutual { half_edge: last - 1, twin: last, found: Some(last) }));
    for (collect, kept) in [
        (Collect::First, 1),
        (Collect::All, Collect::DEFAULT_CAP),
        (Collect::AtMost(1), 1),
        (Collect::AtMost(2), 2),
        (Collect::AtMost(3), 3),
        (Collect::AtMost(10), 10),
        (Collect::AtMost(usize::MAX), usize::try_from(all.violation_count()).unwrap()),
    ] {
        let report = judge(collect);
        assert_eq!(report.first(), all.first(), "{collect:?}");
        assert!(report.violations().is_sorted_by_key(Violation::rule), "{collect:?}");
        assert_eq!(report.violations().len(), kept, "{collect:?}");
        let rules: BTreeSet<Rule> = report.violations().iter().map(Violation::rule).collect();
        assert!(rules.into_iter().eq(broken.iter().copied().take(kept)), "{collect:?}: some of each");
    }
    assert_eq!(
        (judge(Collect::AtMost(0)).first(), judge(Collect::AtMost(0)).violation_count()),
        (None, all.violation_count())
    );
}

/// L1, L2 and L3 are checked in one pass, so a record that breaks L3 may come before one that breaks L1.
#[test]
fn the_first_violation_is_the_first_of_the_first_broken_rule() {
    let mut cases = 0;
    let mut compare = |table: &Table, expectation: &Expectation| {
        let [first, all] = [Collect::First, Collect::All].map(|collect| validate(table, expectation, collect));
        assert_eq!(first.first(), all.first(), "{table}\n{first}\n{all}");
        assert_eq!(first.violation_count(), u64::from(!all.is_valid()), "{table}\n{first}");
        cases += 1;
    };
    for (table, expectation) in
        [(nested(), PLANE), (nested().without(Part::Prev), PLANE), (nested(), PLANE.open()), (nested_textbook(), PLANE)]
    {
        // Exchange two equal cells as far apart as possible: half-edge 0 and the last.
        let mut twice = table.clone();
        half_edge(&mut twice, 0).next = Some(7);
        half_edge(&mut twice, 11).twin = Some(11);
        compare(&twice, &expectation);
        let mut corrupt = table.clone();
        for_each_corruption(&mut corrupt, table.parts, |corrupt, _, _| compare(corrupt, &expectation));
        // One fault in a low slot, another in a high slot.
        half_edge(&mut corrupt, 0).next = Some(4);
        for_each_corruption(&mut corrupt, table.parts, |corrupt, _, _| compare(corrupt, &expectation));
    }
    assert!(cases > 1000, "{cases}");
}
