//! Validation, per half-edge: R1 … T4 of a triangulated grid of 1,000 × 1,000 vertices against one plain pass over the
//! same links; of the same links as a third-party structure with and without parts, border and fault, each against a
//! scan by index that reads the same parts; and R1 … G5 of `world-50m`.
//!
//! Targets: 15 ns per half-edge for R1 … T4; 150 ns with G1 … G5. Run with `cargo bench -p twinedge-benches --bench validation`.

mod common;

use common::{Mesh, PlainArrays, triangulated_grid};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::delegate_view;
use twinedge::validate::reference::rule_by_rule;
use twinedge::validate::{Collect, Expectation, Link, Only, Part, Parts, View, validate};

/// A structure with one invalid link: the twin, or the next, of one half-edge is the first half-edge. If that half-edge
/// does not exist, the structure is unchanged.
struct Wrong<'a, V> {
    right: &'a V,
    twin: bool,
    at: usize,
}

impl<V: View> View for Wrong<'_, V> {
    delegate_view!(|this| this.right; except twin, next);

    fn twin(&self, h: usize) -> Link {
        if self.twin && h == self.at { Some(1) } else { self.right.twin(h) }
    }
    fn next(&self, h: usize) -> Link {
        if !self.twin && h == self.at { Some(1) } else { self.right.next(h) }
    }
}

/// Structures with the same links that lack parts, or have a border.
fn foreign(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plain = PlainArrays::of(map.dcel());
    let (plane, surface) = (Expectation::plane(), Expectation::surface());
    let mut group = criterion.benchmark_group("validate a foreign grid");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    for (border, mesh) in [("closed", Mesh::of(&plain)), ("open", Mesh::of(&plain).open())] {
        for (name, parts, expectation) in [
            ("no faces, prev, leaving", Parts::NONE, plane),
            ("no faces", mesh.parts().without(Part::Faces), plane),
            ("faces, no prev, leaving", Parts::NONE.with(Part::Faces), surface),
            ("faces", mesh.parts(), surface),
        ] {
            let expectation = if border == "open" { expectation.open() } else { expectation };
            group.bench_function(format!("scan, {border}, {name}"), |b| b.iter(|| black_box(&mesh).scan(parts)));
            let view = Only::new(&mesh, parts);
            group.bench_function(format!("R1 … T4, {border}, {name}"), |b| {
                b.iter(|| assert!(validate(black_box(&view), &expectation, Collect::All).is_valid()));
            });
        }
    }
    group.finish();
}

/// One invalid link.
fn faulty(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plane = Expectation::plane();
    let mut group = criterion.benchmark_group("validate a grid with one fault");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    let middle = map.dcel().half_edges().map(|h| h.index()).max().unwrap_or_default() / 2;
    // A view without the fault: it also tests each link for being the invalid one.
    let right = Wrong { right: map.dcel(), twin: true, at: usize::MAX };
    group.bench_function("none", |b| {
        b.iter(|| assert!(validate(black_box(&right), &plane, Collect::All).is_valid()));
    });
    for (what, twin) in [("twin", true), ("next", false)] {
        let view = Wrong { right: map.dcel(), twin, at: middle };
        for (how_many, collect) in [("all", Collect::All), ("the first", Collect::First)] {
            group.bench_function(format!("{what}, {how_many}"), |b| {
                b.iter(|| assert!(!validate(black_box(&view), &plane, collect).is_valid()));
            });
        }
        group.bench_function(format!("{what}, rule by rule"), |b| {
            b.iter(|| assert!(!rule_by_rule(black_box(&view), &plane, Collect::All).is_valid()));
        });
    }
    group.finish();
}

fn validation(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plain = PlainArrays::of(map.dcel());
    let mut group = criterion.benchmark_group("validate a grid");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    group.bench_function("L3 alone on plain u32 arrays", |b| b.iter(|| black_box(&plain).one_pass()));
    group.bench_function("R1 … T4", |b| {
        b.iter(|| {
            let report = validate(black_box(map.dcel()), &Expectation::plane(), Collect::All);
            assert!(report.is_valid());
        });
    });
    group.finish();

    let map = common::world_50m();
    let mut group = criterion.benchmark_group("validate world-50m");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    group.bench_function("R1 … T4", |b| b.iter(|| assert!(black_box(map.dcel()).validate().is_valid())));
    group.bench_function("R1 … G5", |b| b.iter(|| assert!(black_box(&map).validate().is_valid())));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = validation, foreign, faulty
}
criterion_main!(benches);
