//! Maps built and queried by several threads, compared bit for bit with one thread.

use crate::location::maps::features;
use crate::noding::gather;
use rayon::{ThreadPool, ThreadPoolBuilder};
use twinedge::program::choose::{Choose, Random};
use twinedge_coverage::{Limits, check};
use twinedge_geometry::Point;
use twinedge_geometry::noding::{Noded, Snap, node, node_within};
use twinedge_map::{Feature, Noding, Shape};

fn threads(number: usize) -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(number).build().expect("threads can be had")
}

/// Computes a result by one thread and by three, and checks that both agree.
#[track_caller]
fn same<T: PartialEq + core::fmt::Debug + Send>(say: impl Fn() -> T + Sync) -> T {
    let (one, three) = (threads(1).install(&say), threads(3).install(&say));
    assert!(one == three, "one thread and three must agree");
    one
}

fn world() -> Vec<Feature> {
    features(include_bytes!("../../../../tests/data/world-50m.geojson"))
}

/// Many short segments, and some from one side to the other, which cross each other and the short ones.
fn tangle() -> Vec<[Point; 2]> {
    let mut source = Random::seeded(12);
    let mut random = || source.choose(1 << 31) as f64 / f64::from(1_u32 << 31);
    let mut segments: Vec<[Point; 2]> = (0..30_000)
        .map(|_| {
            let (x, y) = (random(), random());
            [Point::new(x, y), Point::new(x + 0.01 * (random() - 0.5), y + 0.01 * (random() - 0.5))]
        })
        .collect();
    segments.extend((0..50).map(|_| [Point::new(0.0, random()), Point::new(1.0, random())]));
    segments
}

fn told(noded: &Noded, segments: usize) -> String {
    let chains: Vec<Vec<u32>> = (0..segments).map(|s| noded.chain(s).into_iter().flatten().collect()).collect();
    format!("{:?} {:?} {:?} {chains:?}", noded.points, noded.segments, noded.summary)
}

#[test]
fn several_threads_build_the_map_that_one_builds() {
    let features = world();
    for noding in [Noding::None, Noding::Exact, Noding::Snap(Snap::Auto), Noding::Snap(Snap::Size(1.0 / 32.0))] {
        same(|| {
            let map = gather(&features).build_with(noding).expect("it fits");
            let mut saved = serde_json::to_value(&map).expect("a plane map can be saved");
            // Generations of two maps differ, so that their keys are not confused.
            assert!(saved["dcel"]["generations"].take().is_object());
            (saved.to_string(), format!("{:?}", map.noding()))
        });
    }
}

#[test]
fn several_threads_cut_as_one_does_and_stop_where_one_does() {
    let segments = tangle();
    let cuts = |noded: &Noded| noded.summary.crossings;
    for snap in [Snap::Auto, Snap::Size(1.0 / 1024.0)] {
        let (_, crossings) = same(|| {
            let noded = node(&segments, &[], snap).expect("they are finite");
            (told(&noded, segments.len()), cuts(&noded))
        });
        assert!(crossings > 1_000, "{crossings}");
    }
    let visits = |noded: &Noded| (0..segments.len()).map(|s| noded.chain(s).map_or(0, |c| c.len() - 2)).sum::<usize>();
    let all = visits(&node(&segments, &[], Snap::Auto).expect("they are finite"));
    for (allowed, is_enough) in [(all, true), (all - 1, false), (all / 2, false)] {
        let done = same(|| node_within(&segments, &[], Snap::Auto, allowed).map(|noded| cuts(&noded)));
        assert_eq!(done.is_ok(), is_enough, "{done:?}");
    }
}

#[test]
fn several_threads_find_in_a_coverage_what_one_finds() {
    // Parcels in rows, which overlap the next one, leave a gap, repeat one, or fit.
    let parcel = |i: u32| {
        let (x, y) = (f64::from(i % 20) * 10.0, f64::from(i / 20) * 10.0);
        let wide = [10.5, 9.5, 10.0][i as usize % 3];
        let ring = [[x, y], [x + wide, y], [x + wide, y + 10.0], [x, y + 10.0]];
        Feature { shapes: vec![Shape::polygon(ring)], ..Feature::default() }
    };
    let features: Vec<Feature> = (0..400).map(|i| parcel(i - u32::from(i % 50 == 49))).collect();
    let map = gather(&features).build_with(Noding::Snap(Snap::Auto)).expect("it fits");
    let found = same(|| check(&map, &Limits::default()).expect("it is plane").findings);
    assert!(found.len() > 100, "{}", found.len());
}
