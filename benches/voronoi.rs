//! The Delaunay triangulation and the Voronoi diagram of 10^5 random points as maps, against only the triangulation of
//! `spade`.
//!
//! Target: at most 3 times the triangulation. Run with `cargo bench -p twinedge-benches --bench voronoi`.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use spade::{DelaunayTriangulation, Point2, Triangulation as _};
use std::hint::black_box;
use twinedge_algorithm::voronoi::{delaunay, voronoi};
use twinedge_geometry::Point;

fn points(count: usize) -> Vec<Point> {
    let mut state = 88_172_645_463_325_252_u64;
    let mut number = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    (0..count).map(|_| Point::new(number(), number())).collect()
}

fn diagrams(criterion: &mut Criterion) {
    let sites = points(100_000);
    let plain: Vec<Point2<f64>> = sites.iter().map(|p| Point2::new(p.x, p.y)).collect();
    let mut group = criterion.benchmark_group("100,000 sites");
    group.bench_function("spade alone", |b| {
        b.iter_batched(
            || plain.clone(),
            |plain| DelaunayTriangulation::<Point2<f64>>::bulk_load(plain).expect("they are in range"),
            BatchSize::LargeInput,
        );
    });
    group.bench_function("delaunay", |b| b.iter(|| delaunay(black_box(&sites)).expect("they are in range")));
    group.bench_function("voronoi", |b| b.iter(|| voronoi(black_box(&sites), None).expect("they are apart")));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = diagrams
}
criterion_main!(benches);
