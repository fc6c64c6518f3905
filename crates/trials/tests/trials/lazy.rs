//! All tables of a size, every cell free: the tables that the validator and the reference accept.

use twinedge::validate::{Expectation, Only, Part, Parts, View, accepts};
use twinedge_trials::lazy::{Acceptor, LazyError, LazyResults, LazyWork};
use twinedge_trials::{Outcome, Run, Shard, Validator, lazy, sum};

struct BlindToPrev;

impl Acceptor for BlindToPrev {
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool {
        accepts(&Only::new(view, view.parts().without(Part::Prev)), expectation)
    }
}

struct NoLoops;

impl Acceptor for NoLoops {
    fn accepts(&self, view: &dyn View, expectation: &Expectation) -> bool {
        accepts(view, &expectation.simple())
    }
}

pub(crate) const MAP: Parts = Parts::NONE.with(Part::Prev).with(Part::Leaving);
pub(crate) const RECORDS: Parts = MAP.with(Part::Places);

pub(crate) fn work(
    expectation: Expectation,
    parts: Parts,
    [vertices, half_edges, boundaries, faces]: [usize; 4],
) -> LazyWork {
    LazyWork { expectation, parts, vertices, half_edges, boundaries, faces, vacant: false, certificates: false }
}

fn accepted(work: LazyWork) -> u64 {
    let outcome = lazy(work, &Validator, &Run::default()).unwrap();
    assert_eq!(outcome.reasons(), [""; 0], "{work:?}");
    outcome.accepted
}

#[test]
fn as_many_tables_are_accepted_as_there_are_maps() {
    let (plane, surface) = (Expectation::plane(), Expectation::surface());
    // A loop at one of two vertices that keeps either half-edge, or an edge between both.
    assert_eq!(accepted(work(surface, MAP, [2, 2, 0, 0])), 2 * 2 + 2);
    assert_eq!(accepted(work(plane, MAP, [2, 4, 0, 0])), 312);
    // In addition, the component and face of a cycle.
    assert_eq!(accepted(work(surface, RECORDS, [2, 2, 2, 2])), 2 * 2 * 2 * 2);
    // Either half-edge begins the face.
    assert_eq!(accepted(work(surface, MAP.with(Part::Faces), [2, 2, 0, 1])), 2 * 2);
    // The isolated vertex is the only inner boundary component.
    assert_eq!(accepted(work(plane, Parts::ALL, [1, 0, 1, 1])), 1);
}

#[test]
fn vacant_slots_open_borders_and_claims_are_judged_alike() {
    let surface = Expectation::surface();
    // The empty map, with or without each vertex; and the maps of two half-edges, with one vertex possibly vacant.
    assert_eq!(accepted(LazyWork { vacant: true, ..work(surface, MAP, [2, 2, 0, 0]) }), 4 + 6 + 2 * 2);
    // In addition to those without border.
    assert!(accepted(work(surface.open(), MAP, [2, 2, 0, 0])) > 6);
    assert_eq!(accepted(work(surface.simple().no_unused_vertices(), MAP, [2, 2, 0, 0])), 2);
}

struct AnySides;

impl Acceptor for AnySides {
    fn accepts(&self, view: &dyn View, _: &Expectation) -> bool {
        accepts(view, &Expectation::surface().simple())
    }
}

#[test]
fn what_is_asked_for_is_judged_and_counted() {
    let surface = Expectation::surface();
    // With two edges, a torus with one face of four sides: one rooted map, 3! numberings of the other half-edges.
    assert_eq!(accepted(work(surface.sides(4).genus(1), MAP, [1, 4, 0, 0])), 6 * 4);
    // An edge between two vertices is simple, a loop is not, and two loops are not connected.
    assert_eq!(accepted(work(surface.simple().components(1), MAP, [2, 2, 0, 0])), 2);
    assert_eq!(accepted(work(surface.components(2), MAP, [2, 4, 0, 0])), 3 * 2 * 4);
    assert_eq!(accepted(work(surface.borders(0).border_kept(), MAP, [2, 2, 0, 0])), 6);
    assert_eq!(accepted(work(surface.borders(1), MAP, [2, 2, 0, 0])), 0);
}

#[test]
fn a_validator_that_counts_no_sides_differs() {
    let outcome = differences(&AnySides, work(Expectation::surface().simple().triangles(), MAP, [2, 2, 0, 0]));
    assert_eq!((outcome.accepted, outcome.differences), (2, 2));
    assert!(outcome.reasons().contains(&"validator: accepted 2 instead of 0".to_owned()), "{:?}", outcome.reasons());
}

fn differences(acceptor: &dyn Acceptor, work: LazyWork) -> Outcome<LazyResults> {
    lazy(work, acceptor, &Run::default()).unwrap()
}

#[test]
fn a_validator_that_accepts_too_much_differs() {
    let outcome = differences(&BlindToPrev, work(Expectation::surface(), MAP, [2, 2, 0, 0]));
    // Two values of `prev` that are nil, dangling or live, for each valid table; one of these is valid.
    assert_eq!((outcome.accepted, outcome.differences), (6 * 16, 6 * 15));
    assert!(outcome.findings[0].starts_with("accepted by the validator alone: "), "{:?}", outcome.findings);
    assert!(!outcome.is_ok());
}

#[test]
fn a_validator_that_accepts_too_little_differs() {
    let outcome = differences(&NoLoops, work(Expectation::surface(), MAP, [2, 2, 0, 0]));
    assert_eq!((outcome.accepted, outcome.differences), (2, 4));
    assert!(outcome.findings[0].starts_with("accepted by the reference alone: "), "{:?}", outcome.findings);
}

#[test]
fn the_parts_add_up() {
    let work = work(Expectation::plane(), MAP, [2, 4, 0, 0]);
    let part = |index| lazy(work, &Validator, &Run::default().shard(Shard::new(index, 3).unwrap())).unwrap();
    let parts = [part(0), part(1), part(2)];
    let text = serde_json::to_string(&parts).unwrap();
    assert_eq!(serde_json::from_str::<Vec<Outcome<LazyResults>>>(&text).unwrap(), parts);
    assert_eq!(sum(&parts).unwrap(), lazy(work, &Validator, &Run::default().threads(3)).unwrap());
}

#[test]
fn tables_that_cannot_be_counted_are_an_error() {
    let sizes = [([6, 10, 6, 6], Parts::ALL), ([16, 1, 0, 0], Parts::NONE), ([usize::MAX, 0, 0, 0], Parts::NONE)];
    for (size, parts) in sizes {
        let outcome = lazy(work(Expectation::plane(), parts, size), &Validator, &Run::default());
        assert_eq!(outcome.err(), Some(LazyError::TooMany), "{size:?}");
        let estimate = work(Expectation::plane(), parts, size).estimate(&Validator);
        assert_eq!(estimate.err(), Some(LazyError::TooMany), "{size:?}");
    }
}

fn estimated(work: LazyWork) -> u128 {
    work.estimate(&Validator).unwrap().amount
}

#[test]
fn where_all_branches_are_followed_the_estimate_is_the_number_of_runs() {
    let (plane, surface) = (Expectation::plane(), Expectation::surface());
    for work in
        [work(surface, MAP, [2, 2, 0, 0]), work(plane, Parts::ALL, [1, 0, 1, 1]), work(plane, MAP, [1, 2, 0, 0])]
    {
        let outcome = lazy(work, &Validator, &Run::default()).unwrap();
        let runs: u64 = outcome.judges.iter().map(|row| row.runs).sum();
        assert_eq!(estimated(work), u128::from(runs), "{work:?}");
    }
}

#[test]
fn the_estimate_is_less_than_a_factor_of_two_from_the_runs_that_were_done() {
    let (plane, surface) = (Expectation::plane(), Expectation::surface());
    // Runs of the validator and of the reference, on 2026-11-28.
    let done = [
        (work(surface, MAP, [2, 4, 0, 0]), 22_767 + 9_335),
        (work(surface, RECORDS, [2, 4, 2, 2]), 1_718_619 + 407_153),
        (work(plane, Parts::ALL, [2, 4, 2, 2]), 18_439_098 + 1_884_450),
        (work(surface.open(), MAP, [3, 4, 0, 0]), 4_250_944 + 76_980),
        (work(surface, MAP, [2, 6, 0, 0]), 7_680_885 + 707_702),
        (work(surface, MAP, [3, 6, 0, 0]), 41_875_510 + 1_721_009),
    ];
    for (work, runs) in done {
        let found = estimated(work);
        assert!(found < 2 * runs && runs < 2 * found, "{work:?}: {found} instead of {runs}");
    }
    let (smallest, _) = done[0];
    assert_eq!(estimated(smallest), estimated(smallest));
}
