//! Validation after each operator: an edge split and joined again at random places of a triangulated grid of 10³ to 10⁶
//! edges, on a `Dcel`, on an `Audited` one, and with a full validation after each operator (on the smallest only). The places are the
//! same 1,000 again and again, which are then in the cache, or on the largest grid also 100,000 in turn ("cold").
//! Validation after each edit: an edge erased and drawn again on a `PlanarMap`, in the same ways.
//!
//! Run with `cargo bench -p twinedge-benches --bench near`.

mod common;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::collections::BTreeMap;
use std::hint::black_box;
use twinedge::dcel::{Audited, Dcel, HalfEdgeKey, VertexKey};
use twinedge_map::PlanarMap;

/// Half-edges at `count` places far apart.
fn places(dcel: &Dcel, count: usize) -> Vec<HalfEdgeKey> {
    let keys: Vec<HalfEdgeKey> = dcel.edges().map(|h| h.key()).collect();
    (0..count).map(|i: usize| keys[i.wrapping_mul(0x9E37_79B9_7F4A_7C15) % keys.len()]).collect()
}

fn near(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("split and join an edge");
    for side in [19, 58, 183, 578] {
        let mut dcel = common::triangulated_grid(side).dcel().clone();
        let (places, cold) = (places(&dcel, 1_000), places(&dcel, 100_000));
        let mut cold = cold.chunks(1_000).cycle();
        let edges = dcel.edge_count();
        group.throughput(Throughput::Elements(2 * places.len() as u64));
        group.bench_function(BenchmarkId::new("not validated", edges), |bench| {
            bench.iter(|| {
                for h in &places {
                    dcel.split_edge(*h).expect("it is an edge");
                    black_box(dcel.join_edges(*h).expect("the new vertex has two edges"));
                }
            });
        });
        if side == 19 {
            group.bench_function(BenchmarkId::new("validated in full", edges), |bench| {
                bench.iter(|| {
                    for h in &places {
                        dcel.split_edge(*h).expect("it is an edge");
                        assert!(dcel.validate().is_valid());
                        dcel.join_edges(*h).expect("the new vertex has two edges");
                        assert!(dcel.validate().is_valid());
                    }
                });
            });
        }
        let mut audited = Audited::new(dcel).expect("a grid is valid");
        let mut split_and_join = |places: &[HalfEdgeKey]| {
            for h in places {
                audited.change(|dcel| dcel.split_edge(*h)).expect("valid").expect("it is an edge");
                let joined = audited.change(|dcel| dcel.join_edges(*h)).expect("valid");
                black_box(joined.expect("the new vertex has two edges"));
            }
        };
        let name = |what| BenchmarkId::new(what, edges);
        group.bench_function(name("validated locally"), |bench| bench.iter(|| split_and_join(&places)));
        if side == 578 {
            let mut next = || cold.next().expect("it goes round");
            group.bench_function(name("validated locally, cold"), |bench| bench.iter(|| split_and_join(next())));
        }
    }
    group.finish();
}

/// Edges that are far apart, with their ends.
fn walls(map: &PlanarMap) -> Vec<(HalfEdgeKey, [VertexKey; 2])> {
    let wall = |h: HalfEdgeKey| {
        let h = map.dcel().half_edge(h).expect("it is one of the map");
        (h.key(), [h.origin().key(), h.target().key()])
    };
    places(map.dcel(), 1_000).into_iter().map(wall).collect::<BTreeMap<_, _>>().into_iter().collect()
}

/// Erases an edge and draws it again, by edits passed to `edit`.
fn redraw(
    walls: &mut [(HalfEdgeKey, [VertexKey; 2])],
    mut edit: impl FnMut(&mut dyn FnMut(&mut PlanarMap) -> HalfEdgeKey) -> HalfEdgeKey,
) {
    for (h, [from, to]) in walls {
        let gone = *h;
        edit(&mut |map| {
            map.remove_edge(gone).expect("it is an edge");
            gone
        });
        *h = edit(&mut |map| map.insert_segment(*from, *to).expect("it was there").way[0]);
    }
}

fn near_edits(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("erase and draw an edge");
    for side in [19, 58, 183, 578] {
        let mut map = common::triangulated_grid(side);
        let edges = map.dcel().edge_count();
        let mut drawn = walls(&map);
        group.throughput(Throughput::Elements(2 * drawn.len() as u64));
        group.bench_function(BenchmarkId::new("not validated", edges), |bench| {
            bench.iter(|| redraw(&mut drawn, |edit| edit(&mut map)));
        });
        if side == 19 {
            group.bench_function(BenchmarkId::new("validated in full", edges), |bench| {
                bench.iter(|| {
                    redraw(&mut drawn, |edit| {
                        let h = edit(&mut map);
                        assert!(map.validate().is_valid());
                        h
                    });
                });
            });
        }
        let mut audited = Audited::new(map).expect("a grid is valid");
        group.bench_function(BenchmarkId::new("validated locally", edges), |bench| {
            bench.iter(|| redraw(&mut drawn, |edit| audited.change(|map| edit(map)).expect("valid")));
        });
    }
    group.finish();
}

criterion_group!(benches, near, near_edits);
criterion_main!(benches);
