//! The fast path changes nothing in a report, and settles what is right.

use crate::support::only_live::OnlyLive;
use crate::support::watched::Watched;
use twinedge::program::census::{Census, Scope};
use twinedge::validate::enumerate::for_each_corruption;
use twinedge::validate::forms::{expectations, projections};
use twinedge::validate::reference::rule_by_rule;
use twinedge::validate::{Collect, Expectation, HalfEdgeRow, Table, VertexRow, View, validate};

/// The report is that of the rules one by one, however many violations are collected, and neither asks for what a
/// vacant slot holds.
#[track_caller]
fn assert_same(view: &impl View, expectation: &Expectation, what: impl std::fmt::Display) {
    for collect in [Collect::All, Collect::First, Collect::AtMost(1)] {
        let report = validate(view, expectation, collect);
        let by_the_rules = rule_by_rule(view, expectation, collect);
        assert_eq!(report, by_the_rules, "{what}\n{expectation:?}\n{collect:?}\n{report}\n{by_the_rules}");
    }
    let _ = validate(&OnlyLive(view), expectation, Collect::All);
    let _ = rule_by_rule(&OnlyLive(view), expectation, Collect::All);
}

#[test]
fn right_maps_in_every_form() {
    for map in Census::new(Scope::Subdivisions { edges: 3, vertices: 3 }) {
        let table = Table::copy_of(map.runner.subject()).unwrap();
        for expectation in expectations() {
            for projection in projections(&table, &expectation) {
                assert_same(&projection, &expectation, &projection);
            }
        }
    }
}

#[test]
fn every_corruption_of_small_maps_in_every_form() {
    let mut corruptions = 0;
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }) {
        let table = Table::copy_of(map.runner.subject()).unwrap();
        for expectation in expectations() {
            for mut projection in projections(&table, &expectation) {
                for_each_corruption(&mut projection, &expectation, |corrupt, _, _| {
                    corruptions += 1;
                    assert_same(corrupt, &expectation, corrupt);
                });
            }
        }
    }
    assert!(corruptions > 100_000, "{corruptions}");
}

/// So many loops, each at a vertex of its own.
fn loops(count: usize) -> Table {
    let half_edge = |h: usize| HalfEdgeRow {
        origin: Some(h / 2),
        twin: Some(h ^ 1),
        next: Some(h),
        prev: Some(h),
        ..HalfEdgeRow::default()
    };
    Table {
        vertices: (0..count).map(|v| Some(VertexRow { leaving: Some(2 * v), ..VertexRow::default() })).collect(),
        half_edges: (0..2 * count).map(|h| Some(half_edge(h))).collect(),
        ..Table::default()
    }
}

/// Whether few half-edges are wrong, or too many to look at one by one.
#[test]
fn any_number_of_wrong_half_edges() {
    let expectation = Expectation::plane().without(twinedge::validate::Part::Faces);
    for wrong in [0, 1, 2, 500, 1023, 1024, 1025, 3000] {
        let mut twins = loops(3000);
        let mut prevs = loops(3000);
        for v in 0..wrong {
            twins.half_edges[2 * v].as_mut().unwrap().twin = Some(2 * v);
            prevs.half_edges[2 * v].as_mut().unwrap().prev = Some(2 * v + 1);
        }
        for table in [twins, prevs] {
            assert_same(&table, &expectation, wrong);
        }
    }
}

/// One wrong link is not searched for from the start: the links of right half-edges are read as often as in a right structure, and
/// once or twice more.
#[test]
fn one_wrong_link_is_not_searched_for_from_the_start() {
    let expectation = Expectation::plane().without(twinedge::validate::Part::Faces);
    let count = 1000;
    let asked = |table: &Table| {
        let view = Watched::new(table);
        let _ = validate(&view, &expectation, Collect::All);
        [view.twin.get(), view.next.get(), view.prev.get()]
    };
    let right = asked(&loops(count));
    // By index, around the vertex, and three steps from each half-edge to find out that its cycle is short.
    assert_eq!(right, [3 * 2 * count, 5 * 2 * count, 2 * count]);
    let mut table = loops(count);
    table.half_edges[count].as_mut().unwrap().twin = None;
    let [twin, next, prev] = asked(&table);
    assert!(twin < right[0] && next < right[1] && prev < right[2] + 20, "{twin} {next} {prev}");
    let mut table = loops(count);
    table.half_edges[count].as_mut().unwrap().prev = None;
    let [twin, next, prev] = asked(&table);
    assert!(twin < right[0] && next < right[1] && prev <= 2 * right[2] + 20, "{twin} {next} {prev}");
}
