//! Every face loop, and every rotation, of a triangulated grid of 1,000 × 1,000 vertices: the structure against plain
//! `u32` arrays with the same numbering.
//!
//! Target: at most 1.15 times the arrays. Run with `cargo bench -p twinedge-benches --bench traversal`.

mod common;

use common::{PlainArrays, triangulated_grid};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::dcel::Dcel;

fn face_loops(dcel: &Dcel) -> usize {
    let mut sum = 0;
    for face in dcel.faces() {
        let Some(start) = face.outer_half_edge() else { continue };
        for h in start.boundary_cycle() {
            sum += h.origin().index();
        }
    }
    sum
}

fn face_half_edges(dcel: &Dcel) -> usize {
    let mut sum = 0;
    for face in dcel.faces().filter(|face| !face.is_unbounded()) {
        for h in face.half_edges() {
            sum += h.origin().index();
        }
    }
    sum
}

fn face_loops_plain(plain: &PlainArrays) -> usize {
    let mut sum = 0;
    for &start in &plain.outer {
        if start == u32::MAX {
            continue;
        }
        let mut h = start;
        loop {
            sum += plain.origin[h as usize] as usize;
            h = plain.next[h as usize];
            if h == start {
                break;
            }
        }
    }
    sum
}

fn rotations(dcel: &Dcel) -> usize {
    let mut sum = 0;
    for vertex in dcel.vertices() {
        for h in vertex.rotation().rev() {
            sum += h.index();
        }
    }
    sum
}

fn rotations_plain(plain: &PlainArrays) -> usize {
    let mut sum = 0;
    for &start in &plain.leaving {
        if start == u32::MAX {
            continue;
        }
        let mut h = start;
        loop {
            sum += h as usize;
            h = plain.next[plain.twin[h as usize] as usize];
            if h == start {
                break;
            }
        }
    }
    sum
}

fn traversal(criterion: &mut Criterion) {
    let map = triangulated_grid(1000);
    let dcel = map.dcel();
    let plain = PlainArrays::of(dcel);
    assert_eq!(face_loops(dcel), face_loops_plain(&plain));
    assert_eq!(face_half_edges(dcel), face_loops_plain(&plain));
    assert_eq!(rotations(dcel), rotations_plain(&plain));

    let mut group = criterion.benchmark_group("face loops");
    group.throughput(Throughput::Elements(dcel.half_edge_count() as u64));
    group.bench_function("plain u32 arrays", |b| b.iter(|| face_loops_plain(black_box(&plain))));
    group.bench_function("twinedge", |b| b.iter(|| face_loops(black_box(dcel))));
    group.bench_function("Face::half_edges", |b| b.iter(|| face_half_edges(black_box(dcel))));
    group.finish();

    let mut group = criterion.benchmark_group("rotations");
    group.throughput(Throughput::Elements(dcel.half_edge_count() as u64));
    group.bench_function("plain u32 arrays", |b| b.iter(|| rotations_plain(black_box(&plain))));
    group.bench_function("twinedge", |b| b.iter(|| rotations(black_box(dcel))));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = traversal
}
criterion_main!(benches);
