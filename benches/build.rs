//! Building `world-50m` from its segments, per distinct segment, beside sorting these segments: the least that any sweep
//! must do.
//!
//! Targets: 400 ns per segment, and 1,500 ns where they are noded first. Run with `cargo bench --bench build`.

mod common;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::geometry::Point;
use twinedge::geometry::noding::Snap;
use twinedge::map::{Builder, Feature, Noding, PlanarMap, Shape};

fn build(features: &[Feature], noding: Noding) -> PlanarMap {
    let mut builder = Builder::new();
    for feature in features {
        builder.feature(feature).expect("longitudes and latitudes are in range");
    }
    builder.build_with(noding).expect("the world fits")
}

fn segments(features: &[Feature]) -> Vec<[Point; 2]> {
    let mut segments = Vec::new();
    for shape in features.iter().flat_map(|feature| &feature.shapes) {
        if let Shape::Polygon(rings) = shape {
            for ring in rings {
                segments.extend(ring.windows(2).map(|pair| [pair[0], pair[1]]));
            }
        }
    }
    segments
}

fn building(criterion: &mut Criterion) {
    let features = common::world_50m_features();
    let map = build(&features, Noding::None);
    let segments = segments(&features);
    let mut group = criterion.benchmark_group("build world-50m");
    group.throughput(Throughput::Elements(map.dcel().edge_count() as u64));
    group.bench_function("sort the ring segments", |b| {
        b.iter(|| {
            let mut sorted = segments.clone();
            sorted.sort_unstable_by(|a, b| a[0].x.total_cmp(&b[0].x).then(a[0].y.total_cmp(&b[0].y)));
            black_box(sorted)
        });
    });
    group.bench_function("twinedge", |b| b.iter(|| build(black_box(&features), Noding::None)));
    group.bench_function("twinedge, snapped", |b| b.iter(|| build(black_box(&features), Noding::Snap(Snap::Auto))));
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30);
    targets = building
}
criterion_main!(benches);
