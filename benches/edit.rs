//! Edits of a map, against building it anew.
//!
//! - `world-50m`: a point inserted and removed again, searched for and with a hint; a segment from a border to a point
//!   inside a country, likewise; a line across everything, rounded; and building the whole map, which an edit saves.
//! - `islands`: squares in an ocean, 10 of them and 4,000. Per edge, building costs the same, and so does cutting an
//!   island in two and joining it again. A drawing in the ocean costs more, since it is compared with all of its coast.
//! - `at random places`: topological operators on a grid that is larger than the caches.
//! - `pairs of triangles`: a triangulated grid of 400 × 400 vertices; edges between disjoint pairs of triangles are removed in random
//!   order, and the corners connected again in another order. `peers.cpp` does the same with CGAL.
//! - `a point in and out`, `a bridge in and out`: between 1,000 and 100,000 islands, at a hub with that many edges, in
//!   a ring of half as many; against a square in an otherwise empty map. The index exists.
//!
//! Targets: points and bridges, 5 µs wherever, growing with the logarithm; an isolated vertex, twice as long as splitting an edge. Run with `cargo bench -p twinedge-benches --bench edit`.

mod common;

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use std::collections::HashSet;
use std::hint::black_box;
use twinedge::dcel::{Dcel, HalfEdge, HalfEdgeKey, Split};
use twinedge::program::choose::{Choose, Random};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Snap, node};
use twinedge_map::edit::At;
use twinedge_map::{Builder, PlanarMap, Shape};

/// Points inside some faces whose outer boundary is a few dozen edges, each with a half-edge of that boundary whose
/// target the point sees.
fn inside_points(map: &mut PlanarMap) -> Vec<(Point, HalfEdgeKey)> {
    let mut candidates = Vec::new();
    for h in map.dcel().faces().filter_map(|face| face.outer_half_edge()) {
        let at = |h: HalfEdge<'_>| map.position(h.origin().key()).expect("it is of this map");
        let (p, q, r) = (at(h), at(h.next()), at(h.next().next()));
        if (20..60).contains(&h.boundary_cycle().count()) {
            candidates.push((Point::new((p.x + q.x + r.x) / 3.0, (p.y + q.y + r.y) / 3.0), h.key()));
        }
    }
    candidates.retain(|(p, h)| {
        let target = map.dcel().half_edge(*h).expect("it stays").target().key();
        let face = map.dcel().half_edge(*h).expect("it stays").face().key();
        let Ok(edited) = map.insert_segment(target, *p) else { return false };
        let inside = map.dcel().half_edge(edited.way[0]).expect("just made").face().key() == face;
        map.remove_vertex(edited.vertices[1]).expect("just made");
        inside
    });
    candidates
}

/// The map of world-50m with its points on a grid, and the grid.
fn noded_world() -> (PlanarMap, Snap) {
    let world = common::world_50m();
    let at = |v: twinedge::dcel::Vertex<'_>| world.position(v.key()).expect("it is of this map");
    let segments: Vec<[Point; 2]> = world.dcel().edges().map(|h| [at(h.origin()), at(h.target())]).collect();
    let noded = node(&segments, &[], Snap::Auto).expect("longitudes and latitudes are in reach");
    let mut builder = Builder::new();
    for ends in &noded.segments {
        let [a, b] = ends.map(|v| noded.points[v as usize]);
        builder.segment(a, b).expect("in range");
    }
    (builder.build().expect("the world fits"), Snap::Size(noded.summary.cell))
}

fn world(criterion: &mut Criterion) {
    let features = common::world_50m_features();
    let build = || {
        let mut builder = Builder::new();
        for feature in &features {
            builder.feature(feature).expect("longitudes and latitudes are in range");
        }
        builder.build().expect("the world fits")
    };
    let mut map = build();
    let points = inside_points(&mut map);
    assert!(points.len() > 50);

    let mut group = criterion.benchmark_group("edit world-50m");
    group.sample_size(10);
    group.bench_function("baseline: build it anew", |b| b.iter(|| black_box(build())));
    let mut which = points.iter().cycle();
    let mut point = |near: bool| {
        let (p, h) = which.next().expect("it goes round");
        let at = if near { At::from((*p, *h)) } else { At::from(*p) };
        let vertex = map.insert_point(black_box(at)).expect("in range").vertices[0];
        map.remove_vertex(vertex).expect("just made")
    };
    group.bench_function("a point in and out, near a half-edge", |b| b.iter(|| point(true)));
    group.bench_function("a point in and out, searched for", |b| b.iter(|| point(false)));

    let mut which = points.iter().cycle();
    let mut segment = |near: bool| {
        let (p, h) = which.next().expect("it goes round");
        let corner = map.dcel().half_edge(*h).expect("it stays").target().key();
        let from = map.position(corner).expect("it stays");
        let at = if near { At::from(corner) } else { At::from(from) };
        let edited = map.insert_segment(black_box(at), *p).expect("it crosses nothing");
        map.remove_vertex(edited.vertices[1]).expect("just made")
    };
    group.bench_function("a segment in and out, from a vertex", |b| b.iter(|| segment(true)));
    group.bench_function("a segment in and out, searched for", |b| b.iter(|| segment(false)));

    let (noded, grid) = noded_world();
    group.bench_function("a line across it, rounded", |b| {
        b.iter_batched_ref(
            || noded.clone(),
            |map| map.insert_segment_snapped([-170.0, -50.0], [170.0, 70.0], grid).expect("it is on the grid"),
            BatchSize::LargeInput,
        );
    });
    group.finish();
}

fn square(i: u32) -> [Point; 4] {
    let (x, y) = (f64::from(i % 64) * 3.0, f64::from(i / 64) * 3.0);
    [[x, y], [x + 2.0, y], [x + 2.0, y + 2.0], [x, y + 2.0]].map(Point::from)
}

/// All edges of all coasts.
const COAST: u32 = 16_000;

/// A round island with `edges` edges, on its own.
fn coast(island: u32, edges: u32) -> Vec<Point> {
    let (x, y) = (f64::from(island % 64) * 3.0, f64::from(island / 64) * 3.0);
    let turn = std::f64::consts::TAU / f64::from(edges);
    (0..edges).map(|i| f64::from(i) * turn).map(|a| Point::new(x + a.cos(), y + a.sin())).collect()
}

fn islands(criterion: &mut Criterion) {
    for count in [10, 4_000] {
        let build = || {
            let mut builder = Builder::new();
            for i in 0..count {
                builder.shape(&Shape::Polygon(vec![square(i).to_vec()])).expect("small integers are in range");
            }
            builder.build().expect("it fits")
        };
        let mut map = build();
        let corners: Vec<_> = (0..count)
            .map(|i| {
                let at = |p: Point| map.dcel().vertices().find(|v| map.position(v.key()) == Ok(p)).map(|v| v.key());
                let [a, _, c, _] = square(i * 7 % count);
                (at(a).expect("it is there"), at(c).expect("it is there"))
            })
            .take(1_000)
            .collect();

        let mut group = criterion.benchmark_group(format!("{count} islands"));
        group.sample_size(20);
        group.throughput(Throughput::Elements(4 * u64::from(count)));
        group.bench_function("build, per edge", |b| b.iter(|| black_box(build())));
        // An equal number of edges on few islands and on many.
        let coasts: Vec<_> = (0..count).map(|i| Shape::Polygon(vec![coast(i, COAST / count)])).collect();
        group.throughput(Throughput::Elements(u64::from(COAST)));
        group.bench_function("build 16,000 edges of coast", |b| {
            b.iter(|| {
                let mut builder = Builder::new();
                for shape in &coasts {
                    builder.shape(shape).expect("in range");
                }
                black_box(builder.build().expect("it fits"))
            });
        });
        group.throughput(Throughput::Elements(1));
        let mut which = corners.iter().cycle();
        group.bench_function("an edge across an island in and out", |b| {
            b.iter(|| {
                let (a, c) = which.next().expect("it goes round");
                let edge = map.insert_segment(*a, *c).expect("it crosses nothing").way[0];
                map.remove_edge(edge).expect("just made")
            });
        });
        let mut which = corners.iter().cycle();
        group.bench_function("an edge of the coast out and in", |b| {
            b.iter(|| {
                let (a, _) = which.next().expect("it goes round");
                let shore = map.dcel().vertex(*a).expect("it stays").leaving().expect("it is on the coast");
                let (edge, from, to) = (shore.key(), shore.origin().key(), shore.target().key());
                map.remove_edge(edge).expect("it is there");
                map.insert_segment(from, to).expect("it was there")
            });
        });
        group.finish();
    }
}

/// Half-edges of a grid of a million vertices, in an order with no near neighbours in a row.
fn random_half_edges(map: &PlanarMap) -> Vec<HalfEdgeKey> {
    let keys: Vec<HalfEdgeKey> = map.dcel().half_edges().map(HalfEdge::key).collect();
    let mut random = Random::seeded(1);
    (0..200_000).map(|_| keys[random.choose(keys.len())]).collect()
}

fn operators(criterion: &mut Criterion) {
    let map = common::triangulated_grid(1000);
    let chosen = random_half_edges(&map);
    let faces: Vec<_> = chosen.iter().map(|h| map.dcel().half_edge(*h).expect("of this map").face().key()).collect();
    let mut group = criterion.benchmark_group("at random places");
    group.sample_size(10);
    group.throughput(Throughput::Elements(chosen.len() as u64));
    // A clone has no room to grow: the first added record moves its columns, which is not timed.
    let copy = || {
        let mut dcel = map.dcel().clone();
        dcel.split_edge(chosen[0]).expect("of this map");
        dcel.add_isolated_vertex(faces[0]).expect("of this map");
        dcel
    };
    group.bench_function("split_edge", |b| {
        b.iter_batched_ref(
            copy,
            |dcel| {
                for h in &chosen {
                    let _ = black_box(dcel.split_edge(*h));
                }
            },
            BatchSize::LargeInput,
        );
    });
    group.bench_function("add_isolated_vertex", |b| {
        b.iter_batched_ref(
            copy,
            |dcel| {
                for f in &faces {
                    let _ = black_box(dcel.add_isolated_vertex(*f));
                }
            },
            BatchSize::LargeInput,
        );
    });
    group.finish();
}

fn shuffle<T>(all: &mut [T], random: &mut Random) {
    for i in (1..all.len()).rev() {
        all.swap(i, random.choose(i + 1));
    }
}

/// Edges between disjoint pairs of bounded faces, in random order.
fn disjoint_pairs(dcel: &Dcel, random: &mut Random) -> Vec<HalfEdgeKey> {
    let mut edges: Vec<HalfEdgeKey> = dcel.edges().map(HalfEdge::key).collect();
    shuffle(&mut edges, random);
    let mut used = HashSet::from([dcel.unbounded_face().key()]);
    edges.retain(|h| {
        let h = dcel.half_edge(*h).expect("of this map");
        let faces = [h.face().key(), h.twin().face().key()];
        let is_free = faces.iter().all(|face| !used.contains(face));
        if is_free {
            used.extend(faces);
        }
        is_free
    });
    edges
}

fn pairs_of_triangles(criterion: &mut Criterion) {
    let dcel = common::triangulated_grid(400).dcel().clone();
    let mut random = Random::seeded(1);
    let edges = disjoint_pairs(&dcel, &mut random);
    let corners = |h: &HalfEdgeKey| {
        let h = dcel.half_edge(*h).expect("of this map");
        [h.twin().next().key(), h.next().key()]
    };
    let mut corners: Vec<[HalfEdgeKey; 2]> = edges.iter().map(corners).collect();
    shuffle(&mut corners, &mut random);
    let remove = |dcel: &mut Dcel| {
        for h in &edges {
            let _ = black_box(dcel.remove_edge(*h));
        }
    };
    let mut group = criterion.benchmark_group("pairs of triangles");
    group.sample_size(10);
    group.throughput(Throughput::Elements(edges.len() as u64));
    group.bench_function("remove_edge", |b| b.iter_batched_ref(|| dcel.clone(), remove, BatchSize::LargeInput));
    let parted = || {
        let mut dcel = dcel.clone();
        remove(&mut dcel);
        dcel
    };
    let connect = |dcel: &mut Dcel| {
        for [from, to] in &corners {
            let _ = black_box(dcel.connect(*from, *to, Split::default()));
        }
    };
    group.bench_function("connect", |b| b.iter_batched_ref(parted, connect, BatchSize::LargeInput));
    group.finish();
}

/// Times points and bridges, drawn and erased again: ends of bridges, and points near half-edges.
fn in_and_out(criterion: &mut Criterion, name: &str, map: &mut PlanarMap, bridges: &[[At; 2]], points: &[At]) {
    let mut which = bridges.iter().cycle();
    let mut bridge = || {
        let [from, to] = *which.next().expect("it goes round");
        let edited = map.insert_segment(black_box(from), to).expect("it crosses nothing");
        match edited.vertices_made[..] {
            [end] => map.remove_vertex(end).expect("just made"),
            _ => map.remove_edge(edited.way[0]).expect("just made"),
        }
    };
    // The index is built before anything is timed.
    bridge();
    criterion.bench_function(&format!("a bridge in and out, {name}"), |b| b.iter(&mut bridge));
    let mut which = points.iter().cycle();
    criterion.bench_function(&format!("a point in and out, {name}"), |b| {
        b.iter(|| {
            let at = *which.next().expect("it goes round");
            let made = map.insert_point(black_box(at)).expect("in range").vertices[0];
            map.remove_vertex(made).expect("just made")
        });
    });
}

fn near(x: f64, y: f64) -> At {
    At::Point(Point::new(x, y))
}

fn crowds(criterion: &mut Criterion) {
    let ring = |points: Vec<Point>| Shape::Polygon(vec![points]);
    let vertex = |map: &PlanarMap, p: Point| {
        let Ok(twinedge_map::Located::Vertex(v)) = map.locate(p) else { panic!("there is a vertex") };
        At::Vertex(v)
    };
    for count in [1_000, 100_000_u32] {
        let mut builder = Builder::new();
        for i in 0..count {
            builder.shape(&ring(square(i).to_vec())).expect("in range");
        }
        let mut map = builder.build().expect("it fits");
        let chosen: Vec<u32> = (0..count / 64 - 1).map(|i| i * 7919 % (count / 64 - 1) * 64 + i % 63).collect();
        let bridges: Vec<[At; 2]> =
            chosen.iter().map(|i| [vertex(&map, square(*i)[2]), vertex(&map, square(*i + 1)[3])]).collect();
        let points: Vec<At> = chosen.iter().map(|i| near(square(*i)[2].x + 0.5, square(*i)[2].y + 0.25)).collect();
        in_and_out(criterion, &format!("{count} islands"), &mut map, &bridges, &points);

        let turn = std::f64::consts::TAU / f64::from(count);
        let around = |i: u32, radius: f64| {
            let angle = (f64::from(i) + if radius > 2.0 { 0.5 } else { 0.0 }) * turn;
            Point::new(radius * angle.cos(), radius * angle.sin())
        };
        let mut builder = Builder::new();
        for i in 0..count {
            builder.segment([0.0, 0.0], around(i, 1.0)).expect("in range");
        }
        let mut map = builder.build().expect("it fits");
        let hub = vertex(&map, Point::new(0.0, 0.0));
        let ends: Vec<Point> = (0..1000).map(|i| around(i * 7919 % count, 3.0)).collect();
        let bridges: Vec<[At; 2]> = ends.iter().map(|p| [hub, At::Point(*p)]).collect();
        let points: Vec<At> = ends.iter().map(|p| At::Point(*p)).collect();
        in_and_out(criterion, &format!("a hub of {count}"), &mut map, &bridges, &points);

        let mut builder = Builder::new();
        builder.shape(&ring((0..count / 2).map(|i| around(2 * i, 1.0)).collect())).expect("in range");
        let mut map = builder.build().expect("it fits");
        let shore = map.dcel().faces().find_map(|f| f.outer_half_edge()).expect("the ring has a face").key();
        let inside: Vec<Point> = (0..1000).map(|i| around(i * 7919 % count, 0.5)).collect();
        let points: Vec<At> = inside.iter().map(|p| At::from((*p, shore))).collect();
        let corner = map.dcel().half_edge(shore).expect("of this map").origin().key();
        let bridges: Vec<[At; 2]> = inside.iter().map(|p| [At::Vertex(corner), At::Point(*p)]).collect();
        in_and_out(criterion, &format!("a ring of {}", count / 2), &mut map, &bridges, &points);
    }
    let mut map = PlanarMap::new();
    let made = map.insert_ring(square(0)).expect("in range");
    let bridges = [[At::Vertex(made.vertices[0]), near(1.0, 0.5)]];
    let hint = At::from((Point::new(1.0, 1.5), made.way[0]));
    in_and_out(criterion, "a square alone", &mut map, &bridges, &[hint]);
}

criterion_group!(benches, world, islands, operators, pairs_of_triangles, crowds);
criterion_main!(benches);
