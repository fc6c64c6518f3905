//! Location of points and zones of lines, on `world-50m` (75,863 edges).
//!
//! Points: the index against an R-tree of the polygons' bounding boxes, with the even-odd rule for the polygons around
//! the point, which is the usual way without a subdivision; and the walk from a neighbouring point, without an index.
//! Target: 250 ns for a random point.
//!
//! Lines: the index against an R-tree of the edges' bounding boxes, queried with the box of the segment, and against
//! every edge in turn; both sort their results by rounded distance. Target: 20 µs for a segment that meets 30 faces.
//!
//! The index: built on one thread and on all, against a constrained Delaunay triangulation with a hierarchy of hints.
//! Target: no slower.
//!
//! Run with `cargo bench -p twinedge-benches --bench location`.

mod common;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use rayon::ThreadPoolBuilder;
use rstar::primitives::{GeomWithData, Line, Rectangle};
use rstar::{AABB, RTree};
use spade::{ConstrainedDelaunayTriangulation, HierarchyHintGenerator, Point2};
use std::collections::HashMap;
use std::hint::black_box;
use twinedge::dcel::{HalfEdge, Vertex, VertexKey};
use twinedge_geometry::Point;
use twinedge_geometry::predicates::{Meeting, meeting};
use twinedge_map::{Feature, Located, Locator, PlanarMap, QueryLine, Shape, ZoneElement};

type Hierarchy = ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

/// Returns pseudorandom numbers from 0 to 1, always the same ones.
fn random() -> impl FnMut() -> f64 {
    let mut state = 50_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 33) as u32) / f64::from(1_u32 << 31)
    }
}

fn anywhere(random: &mut impl FnMut() -> f64) -> Point {
    Point::new(360.0 * random() - 180.0, 173.0 * random() - 90.0)
}

/// Polygons in an R-tree.
struct Polygons(RTree<GeomWithData<Rectangle<[f64; 2]>, Polygon>>);

struct Polygon {
    feature: u32,
    rings: Vec<Vec<Point>>,
}

impl Polygons {
    fn new(features: &[Feature]) -> Self {
        let mut all = Vec::new();
        for (feature, Feature { shapes, .. }) in (0..).zip(features) {
            for shape in shapes {
                let Shape::Polygon(rings) = shape else { continue };
                let corners: Vec<[f64; 2]> = rings[0].iter().map(|p| [p.x, p.y]).collect();
                let around = Rectangle::from_aabb(AABB::from_points(&corners));
                all.push(GeomWithData::new(around, Polygon { feature, rings: rings.clone() }));
            }
        }
        Self(RTree::bulk_load(all))
    }

    fn feature_at(&self, p: Point) -> Option<u32> {
        let odd = |rings: &[Vec<Point>]| {
            let edges = rings.iter().flat_map(|ring| ring.windows(2));
            let passed = edges.filter(|e| {
                (e[0].y > p.y) != (e[1].y > p.y)
                    && p.x < (e[1].x - e[0].x) * (p.y - e[0].y) / (e[1].y - e[0].y) + e[0].x
            });
            passed.count() % 2 == 1
        };
        self.0
            .locate_all_at_point([p.x, p.y])
            .map(|found| &found.data)
            .find(|polygon| odd(&polygon.rings))
            .map(|polygon| polygon.feature)
    }
}

fn points(criterion: &mut Criterion) {
    let map = common::world_50m();
    let locator = Locator::new(&map).expect("the world is plane");
    let polygons = Polygons::new(&common::world_50m_features());
    let mut random = random();
    let queries: Vec<Point> = (0..100_000).map(|_| anywhere(&mut random)).collect();
    let on_land = |p: &Point| match locator.locate(*p) {
        Ok(Located::Face(face)) => map.features_of(face).is_ok_and(|mut features| features.next().is_some()),
        _ => false,
    };
    let same = queries.iter().filter(|p| on_land(p) == polygons.feature_at(**p).is_some()).count();
    assert!(same > 99_990, "the countries that both find are the same, but for rounding: {same}");
    let vertices: Vec<_> = map.dcel().vertices().map(|v| map.position(v.key()).expect("of this map")).collect();
    let coast: Vec<Point> = (0..100_000)
        .map(|_| {
            #[expect(clippy::cast_sign_loss, reason = "it is from 0 to 1")]
            let v = vertices[(random() * 75_000.0) as usize];
            Point::new(v.x + 0.02 * random() - 0.01, v.y + 0.02 * random() - 0.01)
        })
        .collect();

    let mut group = criterion.benchmark_group("locate in world-50m");
    for (name, queries) in [("anywhere", &queries), ("near a vertex", &coast)] {
        let mut next = (0..queries.len()).cycle().map(|i| queries[i]);
        let mut ask = || next.next().expect("a cycle");
        group.bench_function(format!("R-tree of polygons, {name}"), |b| {
            b.iter_batched(&mut ask, |p| polygons.feature_at(p), BatchSize::SmallInput);
        });
        group.bench_function(format!("twinedge, {name}"), |b| {
            b.iter_batched(&mut ask, |p| locator.locate(p), BatchSize::SmallInput);
        });
    }
    group.finish();
}

/// Building the index, per half-edge, against a triangulation with a hierarchy of hints, which also locates in O(log
/// n).
fn index(criterion: &mut Criterion) {
    let one = ThreadPoolBuilder::new().num_threads(1).build().expect("a thread can be had");
    for (name, map) in [
        ("world-50m".to_string(), common::world_50m()),
        ("a grid of 20 × 20".to_string(), common::triangulated_grid(20)),
        ("a grid of 300 × 300".to_string(), common::triangulated_grid(300)),
    ] {
        let at = |v: Vertex<'_>| map.position(v.key()).expect("of this map");
        let places: HashMap<VertexKey, usize> = map.dcel().vertices().map(|v| v.key()).zip(0..).collect();
        let points: Vec<Point2<f64>> = map.dcel().vertices().map(at).map(|p| Point2::new(p.x, p.y)).collect();
        let ends = |h: HalfEdge<'_>| [places[&h.origin().key()], places[&h.target().key()]];
        let edges: Vec<[usize; 2]> = map.dcel().edges().map(ends).collect();

        let mut group = criterion.benchmark_group(format!("index of {name}"));
        group.sample_size(10);
        group.throughput(Throughput::Elements(2 * edges.len() as u64));
        group.bench_function("spade, constrained, with hierarchy", |b| {
            b.iter_batched(
                || (points.clone(), edges.clone()),
                |(points, edges)| Hierarchy::bulk_load_cdt(points, edges).expect("the map is plane"),
                BatchSize::LargeInput,
            );
        });
        let index = || Locator::new(black_box(&map));
        group.bench_function("twinedge", |b| b.iter(|| one.install(index)));
        group.bench_function("twinedge, all threads", |b| b.iter(index));
        group.finish();
    }
}

/// The edges that a segment meets, sorted by rounded distance.
fn sorted<'a>(edges: impl Iterator<Item = &'a [Point; 2]>, [from, to]: [Point; 2]) -> Vec<(f64, [Point; 2])> {
    let way = Point::new(to.x - from.x, to.y - from.y);
    let mut met: Vec<(f64, [Point; 2])> = edges
        .filter(|[a, b]| meeting(from, to, *a, *b) != Meeting::Disjoint)
        .map(|&[a, b]| {
            let edge = Point::new(b.x - a.x, b.y - a.y);
            let distance = (a.x - from.x) * edge.y - (a.y - from.y) * edge.x;
            (distance / (way.x * edge.y - way.y * edge.x), [a, b])
        })
        .collect();
    met.sort_by(|a, b| a.0.total_cmp(&b.0));
    met
}

fn faces(met: &[ZoneElement]) -> usize {
    met.iter().filter(|met| matches!(met, ZoneElement::Face(_))).count()
}

fn lines(criterion: &mut Criterion) {
    let map: PlanarMap = common::world_50m();
    let locator = Locator::new(&map).expect("the world is plane");
    let at = |v: Vertex<'_>| map.position(v.key()).expect("of this map");
    let edges: Vec<[Point; 2]> = map.dcel().edges().map(|h| [at(h.origin()), at(h.target())]).collect();
    let boxes = edges.iter().map(|e| GeomWithData::new(Line::new(e[0].into(), e[1].into()), *e));
    let tree: RTree<GeomWithData<Line<[f64; 2]>, [Point; 2]>> = RTree::bulk_load(boxes.collect());

    let mut random = random();
    let all: Vec<[Point; 2]> = (0..20_000).map(|_| [anywhere(&mut random), anywhere(&mut random)]).collect();
    let zone = |[from, to]: [Point; 2]| locator.zone(&QueryLine::Segment(from, to)).expect("in range");
    let thirty: Vec<[Point; 2]> = all.iter().copied().filter(|ends| (28..=32).contains(&faces(&zone(*ends)))).collect();
    let mean = all.iter().map(|ends| faces(&zone(*ends))).sum::<usize>() as f64 / all.len() as f64;
    println!("{} of {} random segments meet 28 to 32 faces; the mean is {mean}", thirty.len(), all.len());

    let mut group = criterion.benchmark_group("lines across world-50m");
    for (name, queries) in [("30 faces", &thirty), ("any", &all)] {
        let mut next = (0..queries.len()).cycle().map(|i| queries[i]);
        let mut ask = || next.next().expect("a cycle");
        group.bench_function(format!("every edge, {name}"), |b| {
            b.iter_batched(&mut ask, |ends| sorted(edges.iter(), ends), BatchSize::SmallInput);
        });
        group.bench_function(format!("R-tree asked for the box, {name}"), |b| {
            let ask_tree = |[from, to]: [Point; 2]| {
                let found = tree.locate_in_envelope_intersecting(AABB::from_corners(from.into(), to.into()));
                sorted(found.map(|edge| &edge.data), [from, to])
            };
            b.iter_batched(&mut ask, ask_tree, BatchSize::SmallInput);
        });
        group.bench_function(format!("twinedge, {name}"), |b| b.iter_batched(&mut ask, zone, BatchSize::SmallInput));
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(30);
    targets = points, lines, index
}
criterion_main!(benches);
