//! By several threads the report is the same, whatever is wrong and however many threads there are.

use crate::support::erased::validate;
use quickcheck::{Gen, QuickCheck};
use rayon::{ThreadPool, ThreadPoolBuilder};
use twinedge::dcel::Dcel;
use twinedge::program::{Program, Runner};
use twinedge::validate::{Collect, Expectation, Part, Parts, Table, View, validate_parallel};
use twinedge_trials::census::{Census, Scope};
use twinedge_trials::enumerate::for_each_corruption;
use twinedge_trials::forms::{forms, projections};

fn pools() -> [ThreadPool; 3] {
    [1, 2, 5].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap())
}

#[track_caller]
fn assert_same(pools: &[ThreadPool], view: &(impl View + Sync), expectation: &Expectation) {
    for collect in [Collect::All, Collect::First] {
        let report = validate(view, expectation, collect);
        for pool in pools {
            let parallel = pool.install(|| validate_parallel(view, expectation, collect));
            assert_eq!(parallel, report, "{expectation:?}\n{collect:?}\n{parallel}\n{report}");
        }
    }
}

#[test]
fn right_maps_in_every_form() {
    let pools = pools();
    for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }) {
        let table = Table::copy_of(map.runner.subject()).unwrap();
        for form in forms() {
            for projection in projections(&table, &form) {
                assert_same(&pools, &projection, &form.expectation);
            }
        }
    }
}

#[test]
fn every_corruption_of_small_maps() {
    let (pools, mut corruptions) = (pools(), 0);
    for parts in [Parts::ALL, Parts::ALL.without(Part::Prev)] {
        for map in Census::new(Scope::Subdivisions { edges: 2, vertices: 3 }) {
            let mut table = Table { parts, ..Table::copy_of(map.runner.subject()).unwrap() };
            for_each_corruption(&mut table, parts, |corrupt, _, _| {
                corruptions += 1;
                assert_same(&pools[2..], corrupt, &Expectation::plane());
            });
        }
    }
    assert!(corruptions > 10_000, "{corruptions}");
}

/// A list that ends too early leaves a boundary component that no face lists.
#[test]
fn a_boundary_component_that_is_not_listed() {
    let (pools, expectation, mut dropped) = (pools(), Expectation::plane(), 0);
    for map in Census::new(Scope::Subdivisions { edges: 1, vertices: 3 }) {
        let table = Table::copy_of(map.runner.subject()).unwrap();
        for f in 0..table.faces.len() {
            let mut table = table.clone();
            if table.faces[f].as_mut().and_then(|row| row.inner.pop()).is_some() {
                dropped += 1;
                assert!(!validate(&table, &expectation, Collect::First).is_valid());
                assert_same(&pools, &table, &expectation);
            }
        }
    }
    assert!(dropped > 5, "{dropped}");
}

/// Larger maps, whole and with a fault in one place.
#[test]
fn programs_and_a_wrong_link() {
    fn law(program: Program, at: usize, to: usize) {
        let pools = pools();
        let mut runner = Runner::new(Dcel::new());
        runner.run(&program);
        let map = runner.into_subject();
        assert_same(&pools, &map, &Expectation::plane());
        let mut table = Table::copy_of(&map).unwrap();
        if let Some(Some(row)) = at.checked_rem(table.half_edges.len()).map(|at| &mut table.half_edges[at]) {
            let link = [&mut row.origin, &mut row.twin, &mut row.next, &mut row.prev, &mut row.boundary];
            *link.into_iter().nth(to % 5).unwrap() = Some(to / 5 % 300);
        }
        assert_same(&pools, &table, &Expectation::plane());
    }
    QuickCheck::new().rng(Gen::from_size_and_seed(300, 2026)).tests(100).quickcheck(law as fn(Program, usize, usize));
}
