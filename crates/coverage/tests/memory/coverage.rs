//! Memory used by the check of a coverage in addition to the map, counted by the allocator.

use crate::counting::{LIVE_BYTES, PEAK_BYTES};
use twinedge_coverage::{Limits, check};
use twinedge_map::{Builder, Shape};

/// Islands in a sea are the worst case: near misses are searched between all of their edges.
#[test]
fn the_edges_of_coasts_are_held_by_the_index_alone() {
    // The whole check runs on this thread, whose memory is counted.
    rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().unwrap();
    let edges: u16 = 40_000;
    let coast = (0..edges).map(|i| f64::from(i) / f64::from(edges) * std::f64::consts::TAU);
    let mut builder = Builder::new();
    builder.shape(&Shape::polygon(coast.map(|angle| [angle.cos(), angle.sin()]))).unwrap();
    let map = builder.build().unwrap();
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    assert!(check(&map, &Limits::default()).unwrap().findings.is_empty());
    let peak = (PEAK_BYTES.get() - before).cast_unsigned() / usize::from(edges);
    assert!(peak < 130, "{peak} bytes an edge");
}
