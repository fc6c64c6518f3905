//! Validation, per half-edge: R1 … T4 of a triangulated grid of 1,000 × 1,000 vertices beside one plain pass over the same
//! links, and R1 … G5 of `world-50m`.
//!
//! Targets: 15 ns per half-edge for R1 … T4; 150 ns with G1 … G5. Run with `cargo bench --bench validation`.

mod common;

use common::{PlainArrays, triangulated_grid};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::validate::{Collect, Expectation, validate};

/// The least that any check must do: follow each link once.
fn one_pass(plain: &PlainArrays) -> usize {
    let links = plain.origin.iter().zip(&plain.twin).zip(&plain.next);
    links
        .filter(|((_, twin), next)| {
            **twin != u32::MAX && plain.origin[**twin as usize] == plain.origin[**next as usize]
        })
        .count()
}

fn validation(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let plain = PlainArrays::of(map.dcel());
    let mut group = criterion.benchmark_group("validate a grid");
    group.throughput(Throughput::Elements(map.dcel().half_edge_count() as u64));
    group.bench_function("L3 alone on plain u32 arrays", |b| b.iter(|| one_pass(black_box(&plain))));
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
    targets = validation
}
criterion_main!(benches);
