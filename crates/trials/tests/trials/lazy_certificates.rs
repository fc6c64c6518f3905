//! All tables of a size, each with all labels: acceptance by the checker of certificates and by the reference.

use super::lazy::{MAP, RECORDS};
use std::cell::Cell;
use twinedge::validate::{Expectation, Part, Parts, View};
use twinedge_certificate::{Column, Columns, Numbers, passes, passes_surface};
use twinedge_trials::lazy::{Acceptor, LazyColumn, LazyError, LazyLabels, LazyResults, LazyWork};
use twinedge_trials::{Outcome, Run, Shard, Validator, lazy, sum};

const NAMES: Parts = MAP.with(Part::Holes).with(Part::UnboundedFace);

fn work(expectation: Expectation, parts: Parts, sizes: [usize; 4]) -> LazyWork {
    LazyWork { certificates: true, ..super::lazy::work(expectation, parts, sizes) }
}

fn judged(acceptor: &dyn Acceptor, work: LazyWork) -> Outcome<LazyResults> {
    lazy(work, acceptor, &Run::default()).unwrap()
}

/// Returns the number of valid tables, and the number of labels that pass, for these tables and for all alike.
fn accepted(work: LazyWork) -> (u64, u64) {
    let outcome = judged(&Validator, work);
    assert_eq!(outcome.reasons(), [""; 0], "{work:?}");
    let [reference, checker, both] = &outcome.judges[..] else { panic!("{outcome:?}") };
    assert_eq!((reference.accepted, checker.accepted), (outcome.accepted, both.accepted));
    (outcome.accepted, checker.accepted)
}

const fn genus(genus: usize) -> Expectation {
    Expectation::surface().genus(genus)
}

#[test]
fn labels_pass_if_and_only_if_the_plane_is_right() {
    let plane = Expectation::plane();
    assert_eq!(accepted(work(plane, Parts::ALL, [1, 0, 1, 1])), (1, 1));
    // An edge: the half-edge that leaves vertex 0, and the start of the cycle. The other rank is greater, out of 0, 1 and nil.
    assert_eq!(accepted(work(plane, Parts::ALL, [2, 2, 1, 1])), (2 * 2, 2 * 2 * 3));
    // A loop: the half-edge that it keeps, the inner cycle, and the numbers of both boundary components and faces.
    assert_eq!(accepted(work(plane, Parts::ALL, [1, 2, 2, 2])), (16, 16 * 3));
    assert_eq!(accepted(work(plane, Parts::ALL.without(Part::Places), [1, 2, 2, 2])), (16, 16 * 3));
    // The labels have the cycle, its start and its face.
    assert_eq!(accepted(work(plane, Parts::NONE, [2, 2, 1, 1])).1, 2 * 2 * 3);
    assert_eq!(accepted(work(plane, NAMES, [2, 2, 1, 1])), (2 * 2, 2 * 2 * 2 * 3));
    // An edge or nothing, on each live vertex.
    assert_eq!(accepted(LazyWork { vacant: true, ..work(plane, MAP, [2, 2, 1, 1]) }).0, 4 + 2 + 4 + 2 * 2);
}

#[test]
fn labels_pass_if_and_only_if_the_surface_has_the_genus() {
    // An edge. No turn and no step is compared, each in 1 + 3 + 9 ways; the rank grows; the component, one of two, occurs once or twice.
    assert_eq!(accepted(work(genus(0), RECORDS, [2, 2, 1, 1])), (4, 4 * (1 + 3 + 9) * (1 + 3 + 9) * 3 * 2 * 2));
    assert_eq!(accepted(work(genus(1), RECORDS, [2, 2, 1, 1])), (0, 0));
    assert_eq!(accepted(work(genus(0), MAP.with(Part::Faces), [1, 2, 0, 2])).0, 2 * 2);
    assert_eq!(accepted(work(genus(0), MAP, [1, 2, 2, 0])).0, 2);
}

/// Ranks or similar labels, each greater than the previously read one.
struct Growing<'a>(LazyLabels<'a>, Column, Cell<u32>);

#[derive(Clone, Copy)]
struct GrowingColumn<'a>(LazyColumn<'a>, Option<&'a Cell<u32>>);

impl Columns for Growing<'_> {
    type Numbers<'a>
        = GrowingColumn<'a>
    where
        Self: 'a;

    fn column(&self, column: Column) -> GrowingColumn<'_> {
        GrowingColumn(self.0.column(column), (column == self.1).then_some(&self.2))
    }
}

impl Numbers for GrowingColumn<'_> {
    fn count(self) -> usize {
        self.0.count()
    }

    fn at(self, entry: usize) -> Option<u32> {
        match self.1 {
            None => self.0.at(entry),
            Some(number) => (entry < self.count()).then(|| number.replace(number.get() + 1)),
        }
    }
}

/// A checker that accepts each rank as lower than the next one.
struct AnyRanks;

impl Acceptor for AnyRanks {
    fn accepts(&self, _: &dyn View, _: &Expectation) -> bool {
        false
    }

    fn passes(&self, view: &dyn View, labels: LazyLabels<'_>, _: &Expectation) -> bool {
        passes(view, &Growing(labels, Column::HalfEdgeRank, Cell::default()))
    }
}

#[test]
fn a_checker_that_compares_no_ranks_accepts_wrong_tables() {
    let outcome = judged(&AnyRanks, work(Expectation::plane(), Parts::ALL, [1, 2, 2, 2]));
    let [reference, checker, both] = &outcome.judges[..] else { panic!("{outcome:?}") };
    // The loop may lie in its own inside, or not: 3 ranks of each half-edge are equally valid.
    assert_eq!((reference.accepted, reference.differences, both.accepted), (16, 0, 16 * 9));
    assert_eq!((checker.accepted, checker.differences), (both.accepted + outcome.differences, outcome.differences));
    assert!(outcome.differences > 0);
    assert!(outcome.findings[0].starts_with("accepted by the checker alone: "), "{:?}", outcome.findings);
    assert!(outcome.findings[0].contains(" half_edge_rank "), "{:?}", outcome.findings);
}

struct NoLoops;

impl Acceptor for NoLoops {
    fn accepts(&self, _: &dyn View, _: &Expectation) -> bool {
        false
    }

    fn passes(&self, view: &dyn View, labels: LazyLabels<'_>, _: &Expectation) -> bool {
        passes(view, &labels)
            && (0..view.half_edge_slots()).all(|h| view.twin(h).and_then(|t| view.origin(t)) != view.origin(h))
    }
}

#[test]
fn a_checker_that_refuses_loops_leaves_right_tables_without_certificate() {
    let outcome = judged(&NoLoops, work(Expectation::plane(), Parts::ALL, [1, 2, 2, 2]));
    let [reference, checker, both] = &outcome.judges[..] else { panic!("{outcome:?}") };
    assert_eq!((reference.accepted, reference.differences), (16, 16));
    assert_eq!((checker.accepted, both.accepted, outcome.differences), (0, 0, 16));
    assert!(outcome.findings[0].starts_with("accepted by the reference alone: "), "{:?}", outcome.findings);
}

struct AnyGenus;

impl Acceptor for AnyGenus {
    fn accepts(&self, _: &dyn View, _: &Expectation) -> bool {
        false
    }

    fn passes(&self, view: &dyn View, labels: LazyLabels<'_>, _: &Expectation) -> bool {
        passes_surface(view, &labels, 0)
    }
}

#[test]
fn a_checker_that_does_not_count_the_genus_accepts_wrong_tables() {
    let outcome = judged(&AnyGenus, work(genus(1), MAP, [1, 2, 2, 0]));
    assert_eq!((outcome.accepted, outcome.judges[2].accepted), (0, 0));
    assert_eq!(outcome.judges[1].accepted, outcome.differences);
    assert!(outcome.differences > 0);
}

#[test]
fn the_parts_add_up_with_labels() {
    let work = work(Expectation::plane(), MAP, [2, 2, 1, 1]);
    let part = |index| lazy(work, &Validator, &Run::default().shard(Shard::new(index, 2).unwrap())).unwrap();
    let whole = lazy(work, &Validator, &Run::default().threads(3)).unwrap();
    assert_eq!(sum(&[part(1), part(0)]).unwrap(), whole);
    let runs: u64 = whole.judges.iter().map(|row| row.runs).sum();
    let estimated = work.estimate(&Validator).unwrap().amount;
    assert!(estimated < 2 * u128::from(runs) && u128::from(runs) < 2 * estimated, "{estimated} instead of {runs}");
}

#[test]
fn what_no_certificate_claims_is_an_error() {
    let (plane, surface) = (Expectation::plane(), Expectation::surface());
    let claims = [(surface, MAP), (plane.open(), MAP), (plane.simple(), MAP), (genus(0).open(), MAP), (plane, RECORDS)];
    for (expectation, parts) in claims {
        let work = work(expectation, parts, [1, 2, 1, 1]);
        assert_eq!(lazy(work, &Validator, &Run::default()).err(), Some(LazyError::NoCertificates), "{work:?}");
        assert_eq!(work.estimate(&Validator).err(), Some(LazyError::NoCertificates), "{work:?}");
    }
    let many = work(plane, MAP, [2, 4, 6, 6]);
    assert_eq!(lazy(many, &Validator, &Run::default()).err(), Some(LazyError::TooMany));
}
