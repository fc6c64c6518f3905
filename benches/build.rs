//! Building `world-50m` from its segments, per distinct segment, against sorting these segments: the least that any
//! sweep must do. Gathering a grid of squares whose coordinates have few digits or many, and squares inside each other,
//! as polygons that cover each other and as lines. Noding the diameters of a circle, against noding their halves. Whole
//! structures at once, per half-edge: a triangulated grid from its faces, against sorting their sides and against
//! `from_view` of the same faces with their links; from its rotations; and removing edges by `retain`, against one by
//! one.
//!
//! Targets: 400 ns per segment, and 1,500 ns where they are noded first; noded exactly, 1.3 times as long as not noded,
//! since there is nothing to cut; gathering few digits, 1.5 times as long as all digits; and 60 ns per half-edge from
//! faces. Run with `cargo bench -p twinedge-benches --bench build`.

mod common;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use twinedge::dcel::{Corner, Dcel, Outside, Placement, Vertex};
use twinedge::validate::Expectation;
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};
use twinedge_map::{Builder, Feature, Noding, PlanarMap, Shape};

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
            sorted.sort_by(|a, b| a[0].x.total_cmp(&b[0].x).then(a[0].y.total_cmp(&b[0].y)));
            black_box(sorted)
        });
    });
    group.bench_function("twinedge", |b| b.iter(|| build(black_box(&features), Noding::None)));
    group.bench_function("twinedge, noded exactly", |b| b.iter(|| build(black_box(&features), Noding::Exact)));
    group.bench_function("twinedge, snapped", |b| b.iter(|| build(black_box(&features), Noding::Snap(Snap::Auto))));
    group.finish();
}

/// The squares of a grid, with a corner for each pair of numbers.
fn squares(side: u32, at: impl Fn(u32, u32) -> Point) -> Vec<Shape> {
    let square = |x, y| Shape::polygon(vec![at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
    (0..side * side).map(|i| square(i % side, i / side)).collect()
}

fn gathering(criterion: &mut Criterion) {
    const SIDE: u32 = 300;
    let scaled = |by: f64| squares(SIDE, |x, y| Point::new(f64::from(x) * by, f64::from(y) * by));
    let mut group = criterion.benchmark_group("gather a grid of squares");
    group.throughput(Throughput::Elements(u64::from(2 * SIDE * (SIDE + 1))));
    for (name, shapes) in [
        ("all digits set", squares(SIDE, |x, y| Point::new(0.1 + f64::from(x) / 7.0, 0.1 + f64::from(y) / 7.0))),
        ("small integers", scaled(1.0)),
        ("multiples of 2^20", scaled(f64::from(1 << 20))),
        ("multiples of 2^-20", scaled(1.0 / f64::from(1 << 20))),
    ] {
        group.bench_function(name, |b| {
            b.iter(|| {
                let mut builder = Builder::new();
                for shape in black_box(&shapes) {
                    builder.shape(shape).expect("in range");
                }
                builder
            });
        });
    }
    group.finish();
}

/// Squares inside each other, the largest first.
fn nested(squares: u32) -> impl Iterator<Item = [[f64; 2]; 5]> {
    (0..squares).map(move |i| {
        let (low, high) = (f64::from(i), f64::from(4 * squares - i));
        [[low, low], [high, low], [high, high], [low, high], [low, low]]
    })
}

fn nesting(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build nested squares");
    for squares in [1_000, 10_000] {
        group.throughput(Throughput::Elements(4 * u64::from(squares)));
        let mut build = |name: &str, shapes: Vec<Shape>| {
            group.bench_function(format!("{squares} {name}"), |b| {
                b.iter(|| {
                    let mut builder = Builder::new();
                    for shape in black_box(&shapes) {
                        builder.shape(shape).expect("in range");
                    }
                    builder.build().expect("it fits")
                });
            });
        };
        build("lines", nested(squares).map(Shape::line).collect());
        build("polygons", nested(squares).map(Shape::polygon).collect());
    }
    group.finish();
}

/// The diameters of a circle, which all meet in its middle, and their halves, which require no cut.
fn stars(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("node diameters");
    group.sample_size(10);
    for n in [1_000_u32, 10_000, 100_000] {
        let ends = (0..n).map(|i| (std::f64::consts::PI * f64::from(i) / f64::from(n)).sin_cos());
        let diameters: Vec<[Point; 2]> = ends.map(|(s, c)| [Point::new(-c, -s), Point::new(c, s)]).collect();
        let halves: Vec<[Point; 2]> =
            diameters.iter().flat_map(|[a, b]| [[*a, Point::new(0.0, 0.0)], [Point::new(0.0, 0.0), *b]]).collect();
        group.throughput(Throughput::Elements(n.into()));
        for (name, segments) in [("halves", halves), ("diameters", diameters)] {
            group.bench_function(format!("{n} {name}"), |b| {
                b.iter(|| node(black_box(&segments), &[], Snap::Auto).expect("they are finite"));
            });
        }
    }
    group.finish();
}

/// A grid of 1,000 × 1,000 vertices, by all ways in, and without half of its edges.
fn bulk(criterion: &mut Criterion) {
    let map = common::triangulated_grid(1_000);
    let dcel = map.dcel();
    let number = |v: Vertex<'_>| v.index() as u32 - 1;
    let faces: Vec<[u32; 3]> = dcel
        .faces()
        .filter_map(|f| {
            let mut corners = f.outer()?.half_edges().map(|h| number(h.origin()));
            Some([corners.next()?, corners.next()?, corners.next()?])
        })
        .collect();
    let rotations: Vec<Vec<u32>> =
        dcel.vertices().map(|v| v.rotation().map(|h| h.index() as u32 - 2).collect()).collect();
    let around = dcel.unbounded_face().inner().next().and_then(|b| b.start()).expect("the grid has an outside");
    let outside = Placement { outside: Corner::At(around.index() as u32 - 2), within: None };

    let mut group = criterion.benchmark_group("a grid at once");
    group.sample_size(10).throughput(Throughput::Elements(dcel.half_edge_count() as u64));
    group.bench_function("sort the sides", |b| {
        b.iter(|| {
            let side = |a: u32, b: u32, at: usize| (u64::from(a.min(b)) << 32 | u64::from(a.max(b)), at as u32);
            let mut sides: Vec<(u64, u32)> = Vec::with_capacity(3 * faces.len());
            for (f, [a, b, c]) in black_box(&faces).iter().enumerate() {
                sides.extend([side(*a, *b, 3 * f), side(*b, *c, 3 * f + 1), side(*c, *a, 3 * f + 2)]);
            }
            sides.sort_unstable();
            sides
        });
    });
    group.bench_function("from_view, linked", |b| {
        b.iter(|| Dcel::from_view(black_box(dcel), &Expectation::plane(), Outside::Given).expect("it is valid"));
    });
    group.bench_function("from_faces", |b| {
        b.iter(|| Dcel::from_faces(dcel.vertex_count(), black_box(&faces)).expect("they are a map"));
    });
    group.bench_function("from_rotations", |b| {
        b.iter(|| Dcel::from_rotations(black_box(&rotations), &[outside]).expect("they are a map"));
    });
    // Scattered by a multiplication.
    let goes = |h: usize| (h as u64 / 2).wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 63 == 0;
    group.bench_function("remove_edge, half of all", |b| {
        b.iter_batched_ref(
            || dcel.clone(),
            |dcel| {
                let edges: Vec<_> = dcel.edges().filter(|h| goes(h.index())).map(|h| h.key()).collect();
                for h in edges {
                    dcel.remove_edge(h).expect("it is there");
                }
            },
            BatchSize::PerIteration,
        );
    });
    group.bench_function("retain, without half of all", |b| {
        let retain = |dcel: &mut Dcel| dcel.retain(|_| true, |h| !goes(h.index())).expect("there is room");
        b.iter_batched_ref(|| dcel.clone(), retain, BatchSize::PerIteration);
    });
    group.bench_function("compact", |b| {
        b.iter_batched_ref(|| dcel.clone(), Dcel::compact, BatchSize::PerIteration);
    });
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30);
    targets = building, gathering, nesting, stars, bulk
}
criterion_main!(benches);
