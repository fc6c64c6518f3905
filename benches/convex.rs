//! Cutting every country of `world-50m` into convex pieces, against only the constrained Delaunay triangulation of
//! `spade`, of the same vertices and edges.
//!
//! Target: at most 1.5 times the triangulation. Run with `cargo bench -p twinedge-benches --bench convex`.

mod common;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use spade::{ConstrainedDelaunayTriangulation, Point2};
use std::collections::HashMap;
use std::hint::black_box;
use twinedge::dcel::FaceKey;
use twinedge_algorithm::claims::faces_by_feature;
use twinedge_algorithm::convex::decompose;

fn decomposition(criterion: &mut Criterion) {
    let map = common::world_50m();
    let faces: Vec<FaceKey> = faces_by_feature(&map).into_iter().flatten().collect();
    let mut numbers = HashMap::new();
    let mut points = Vec::new();
    for v in map.dcel().vertices() {
        numbers.insert(v.key(), points.len());
        let p = map.position(v.key()).expect("it is of this map");
        points.push(Point2::new(p.x, p.y));
    }
    let edges: Vec<[usize; 2]> =
        map.dcel().edges().map(|h| [numbers[&h.origin().key()], numbers[&h.target().key()]]).collect();
    let mut group = criterion.benchmark_group("decompose world-50m");
    group.bench_function("spade alone", |b| {
        b.iter_batched(
            || (points.clone(), edges.clone()),
            |(points, edges)| {
                ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, edges).expect("the map is plane")
            },
            BatchSize::LargeInput,
        );
    });
    group.bench_function("twinedge", |b| {
        b.iter_batched(
            || map.clone(),
            |mut map| {
                let found = decompose(&mut map, faces.iter().copied()).expect("the map is plane");
                (map, black_box(found))
            },
            BatchSize::LargeInput,
        );
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(20);
    targets = decomposition
}
criterion_main!(benches);
