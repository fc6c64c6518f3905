//! Time per half-edge as the map grows, from 10³ half-edges on, each workload against a peer or a floor in the same
//! run.
//!
//! - `validate`: R1 … T4 of a triangulated grid, on one thread and on all, against one plain pass over the same links.
//! - `walk the faces`: all face loops of the same grid, against plain arrays.
//! - `from faces`: the same grid from its triangles, against sorting their sides.
//! - `build`: a triangulation of random points from its segments, on one thread and on all, against sorting these.
//! - `node`: random segments that each cross about two others, on one thread and on all, against `i_overlay`'s union of
//!   an equal number of triangles around them, which also cuts.
//! - `edit`: an edge of the grid split and joined again, with validation after each (`Audited`), against none; per
//!   operator.
//!
//! Workloads that take long at 10⁷ half-edges end at 10⁶. `benches/README.md` has the results; `benches/growth.py`
//! makes them from the files in `target/criterion`. Run with `cargo bench -p twinedge-benches --bench growth`.

mod common;

use common::{PlainArrays, triangulated_grid};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::float::simplify::SimplifyShape;
use rayon::{ThreadPool, ThreadPoolBuilder};
use spade::{ConstrainedDelaunayTriangulation, HierarchyHintGenerator, Point2, Triangulation};
use std::hint::black_box;
use std::time::Duration;
use twinedge::dcel::{Audited, Dcel, Face, HalfEdge, HalfEdgeKey, Vertex};
use twinedge::validate::{Collect, Expectation, validate};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};
use twinedge_map::{Builder, PlanarMap};

type Hierarchy = ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

/// Sides of triangulated grids with about 10³ … 10⁷ half-edges.
const SIDES: [u32; 5] = [13, 41, 129, 408, 1_291];

/// Returns pseudorandom numbers from 0 to 1, always the same ones.
fn random() -> impl FnMut() -> f64 {
    let mut state = 2_026_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 33) as u32) / f64::from(1_u32 << 31)
    }
}

fn random_points(n: usize) -> Vec<Point> {
    let mut random = random();
    (0..n).map(|_| Point::new(random(), random())).collect()
}

fn triangulated(points: &[Point]) -> Hierarchy {
    let points = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
    Hierarchy::bulk_load(points).expect("they are from 0 to 1")
}

fn segments(triangulation: &Hierarchy) -> Vec<[Point; 2]> {
    let ends = |edge: spade::handles::UndirectedEdgeHandle<'_, _, _, _, _>| {
        edge.positions().map(|p: Point2<f64>| Point::new(p.x, p.y))
    };
    triangulation.undirected_edges().map(ends).collect()
}

fn build(segments: &[[Point; 2]]) -> PlanarMap {
    let mut builder = Builder::new();
    for [a, b] in segments {
        builder.segment(*a, *b).expect("in range");
    }
    builder.build().expect("it fits")
}

fn one_thread() -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(1).build().expect("a thread can be had")
}

/// Few samples, as there are many sizes.
fn group<'c>(criterion: &'c mut Criterion, name: &str, items: usize) -> BenchmarkGroup<'c, WallTime> {
    let mut group = criterion.benchmark_group(format!("growth: {name}"));
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_millis(1_500));
    group.throughput(Throughput::Elements(items as u64));
    group
}

/// The least that any check must do: follow each link once.
fn one_pass(plain: &PlainArrays) -> usize {
    let links = plain.origin.iter().zip(&plain.twin).zip(&plain.next);
    links
        .filter(|((_, twin), next)| {
            **twin != u32::MAX && plain.origin[**twin as usize] == plain.origin[**next as usize]
        })
        .count()
}

/// Half-edges counted face by face, on plain arrays.
fn walk_arrays(plain: &PlainArrays) -> usize {
    let mut counted = 0;
    for start in plain.outer.iter().filter(|start| **start != u32::MAX) {
        let mut h = *start;
        loop {
            counted += 1;
            h = plain.next[h as usize];
            if h == *start {
                break;
            }
        }
    }
    counted
}

fn of_grids(criterion: &mut Criterion) {
    let plane = Expectation::plane();
    for side in SIDES {
        let map = triangulated_grid(side);
        let (dcel, plain) = (map.dcel(), PlainArrays::of(map.dcel()));
        let size = dcel.half_edge_count();

        let mut group = group(criterion, "validate", size);
        group.bench_function(BenchmarkId::new("one pass over plain arrays", size), |b| {
            b.iter(|| one_pass(black_box(&plain)));
        });
        group.bench_function(BenchmarkId::new("twinedge", size), |b| {
            b.iter(|| assert!(validate(black_box(dcel), &plane, Collect::All).is_valid()));
        });
        group.finish();

        let mut group = self::group(criterion, "walk the faces", size);
        group.bench_function(BenchmarkId::new("plain arrays", size), |b| b.iter(|| walk_arrays(black_box(&plain))));
        group.bench_function(BenchmarkId::new("twinedge", size), |b| {
            let walk = |f: Face<'_>| f.outer().map_or(0, |boundary| boundary.half_edges().count());
            b.iter(|| black_box(dcel).faces().map(walk).sum::<usize>());
        });
        group.finish();

        let number = |v: Vertex<'_>| v.index() as u32 - 1;
        let corners = |f: Face<'_>| {
            let mut corners = f.outer()?.half_edges().map(|h| number(h.origin()));
            Some([corners.next()?, corners.next()?, corners.next()?])
        };
        let faces: Vec<[u32; 3]> = dcel.faces().filter_map(corners).collect();
        let mut group = self::group(criterion, "from faces", size);
        group.bench_function(BenchmarkId::new("sort the sides", size), |b| {
            b.iter(|| {
                let side = |a: u32, b: u32| u64::from(a.min(b)) << 32 | u64::from(a.max(b));
                let of = |[a, b, c]: &[u32; 3]| [side(*a, *b), side(*b, *c), side(*c, *a)];
                let mut sides: Vec<u64> = black_box(&faces).iter().flat_map(of).collect();
                sides.sort_unstable();
                sides
            });
        });
        group.bench_function(BenchmarkId::new("twinedge", size), |b| {
            b.iter(|| Dcel::from_faces(dcel.vertex_count(), black_box(&faces)).expect("they are a map"));
        });
        group.finish();

        let keys: Vec<HalfEdgeKey> = dcel.edges().map(HalfEdge::key).collect();
        let places: Vec<HalfEdgeKey> =
            (0..1_000).map(|i: usize| keys[i.wrapping_mul(0x9E37_79B9_7F4A_7C15) % keys.len()]).collect();
        let mut group = self::group(criterion, "edit", 2 * places.len());
        let mut edited = dcel.clone();
        group.bench_function(BenchmarkId::new("not validated", size), |b| {
            b.iter(|| {
                for h in &places {
                    edited.split_edge(*h).expect("it is an edge");
                    black_box(edited.join_edges(*h).expect("the new vertex has two edges"));
                }
            });
        });
        let mut audited = Audited::new(edited).expect("a grid is valid");
        group.bench_function(BenchmarkId::new("twinedge", size), |b| {
            b.iter(|| {
                for h in &places {
                    audited.change(|dcel| dcel.split_edge(*h)).expect("valid").expect("it is an edge");
                    let joined = audited.change(|dcel| dcel.join_edges(*h)).expect("valid");
                    black_box(joined.expect("the new vertex has two edges"));
                }
            });
        });
        group.finish();
    }
}

fn of_triangulations(criterion: &mut Criterion) {
    let one = one_thread();
    for n in [170, 1_700, 17_000, 170_000] {
        let points = random_points(n);
        let triangulation = triangulated(&points);
        let segments = segments(&triangulation);
        let map = build(&segments);
        let size = map.dcel().half_edge_count();

        let mut group = group(criterion, "build", size);
        group.bench_function(BenchmarkId::new("sort the segments", size), |b| {
            b.iter(|| {
                let mut sorted = segments.clone();
                sorted.sort_by(|a, b| a[0].x.total_cmp(&b[0].x).then(a[0].y.total_cmp(&b[0].y)));
                black_box(sorted)
            });
        });
        group.bench_function(BenchmarkId::new("twinedge", size), |b| b.iter(|| one.install(|| build(&segments))));
        group.bench_function(BenchmarkId::new("twinedge, all threads", size), |b| b.iter(|| build(&segments)));
        group.finish();
    }
}

fn noding(criterion: &mut Criterion) {
    let one = one_thread();
    for n in [500, 5_000, 50_000, 500_000_usize] {
        let mut random = random();
        let length = 2.0 / (n as f64).sqrt();
        let segments: Vec<[Point; 2]> = (0..n)
            .map(|_| {
                let (a, turn) = (Point::new(random(), random()), core::f64::consts::TAU * random());
                [a, Point::new(a.x + length * turn.cos(), a.y + length * turn.sin())]
            })
            .collect();
        let triangles: Vec<Vec<[f64; 2]>> = segments
            .iter()
            .map(|[a, b]| vec![[a.x, a.y], [b.x, b.y], [a.x - 0.1 * (b.y - a.y), a.y + 0.1 * (b.x - a.x)]])
            .collect();
        let mut group = group(criterion, "node", n);
        group.bench_function(BenchmarkId::new("i_overlay, union of triangles", n), |b| {
            b.iter(|| black_box(&triangles).simplify_shape(FillRule::NonZero));
        });
        let cut = || node(black_box(&segments), &[], Snap::Auto).expect("they are finite");
        group.bench_function(BenchmarkId::new("twinedge", n), |b| b.iter(|| one.install(cut)));
        group.bench_function(BenchmarkId::new("twinedge, all threads", n), |b| b.iter(cut));
        group.finish();
    }
}

criterion_group!(benches, of_grids, of_triangulations, noding);
criterion_main!(benches);
