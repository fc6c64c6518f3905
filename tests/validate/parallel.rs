//! By several threads the report is the same, whatever is wrong and however many threads there are.

use crate::support::erased::validate;
use crate::support::tables::{half_edge, vertex};
use quickcheck::{Gen, QuickCheck};
use rayon::{ThreadPool, ThreadPoolBuilder};
use twinedge::dcel::Dcel;
use twinedge::program::{Program, Runner};
use twinedge::validate::{
    BoundaryPlace, BoundaryRow, Collect, Expectation, FaceRow, HalfEdgeRow, Part, Parts, Start, Table, VertexRow, View,
    validate_parallel,
};
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

/// A ring of edges without vacant slots, so that each part has as many records of each kind. What only the scan reads, and what only the
/// walks around the vertices read, is wrong in each part by turns.
#[test]
fn a_wrong_link_in_each_part_of_a_ring() {
    let (pools, count) = (pools(), 8);
    let row = |h: usize| {
        let (ahead, back) = ((h + 2) % (2 * count), (h + 2 * count - 2) % (2 * count));
        let [next, prev] = if h % 2 == 0 { [ahead, back] } else { [back, ahead] };
        let [origin, twin, next, prev, boundary] = [h.div_ceil(2) % count, h ^ 1, next, prev, h % 2].map(Some);
        Some(HalfEdgeRow { origin, twin, next, prev, boundary, ..HalfEdgeRow::default() })
    };
    let boundary =
        |face, h, place| Some(BoundaryRow { face: Some(face), start: Some(Start::HalfEdge(h)), place: Some(place) });
    let ring = Table {
        vertices: (0..count).map(|v| Some(VertexRow { leaving: Some(2 * v), ..VertexRow::default() })).collect(),
        half_edges: (0..2 * count).map(row).collect(),
        boundaries: vec![boundary(1, 0, BoundaryPlace::Outer), boundary(0, 1, BoundaryPlace::Inner(0))],
        faces: vec![
            Some(FaceRow { inner: vec![Some(1)], ..FaceRow::default() }),
            Some(FaceRow { outer: Some(0), ..FaceRow::default() }),
        ],
        ..Table::default()
    };
    let judge = |table: &Table, is_valid| {
        assert_eq!(validate(table, &Expectation::plane(), Collect::First).is_valid(), is_valid);
        assert_same(&pools, table, &Expectation::plane());
    };
    judge(&ring, true);
    for i in 0..count {
        let mut table = ring.clone();
        vertex(&mut table, i).leaving = Some((2 * i + 2) % (2 * count));
        judge(&table, false);
        for h in [2 * i, 2 * i + 1] {
            let mut table = ring.clone();
            half_edge(&mut table, h).prev = None;
            judge(&table, false);
        }
    }
}
