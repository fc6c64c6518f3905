//! Tests of `estimate`.

use super::{Pixels, Segment, crossing_cuts};

#[test]
fn the_estimate_is_near_the_number() {
    let segment = |a: [i64; 2], b: [i64; 2]| Segment { a, b, ends: [0, 1] };
    // A grid of n lines across n lines: each of 2n lines is cut n times.
    for n in [10, 300] {
        let level = (0..n).map(|i| segment([-1, i], [n, i]));
        let lines: Vec<Segment> = level.chain((0..n).map(|i| segment([i, -1], [i, n]))).collect();
        let cuts = u64::try_from(2 * n * n).unwrap();
        let estimate = crossing_cuts(Pixels::ONE_STEP, &lines).unwrap();
        assert!(estimate.abs_diff(cuts) < cuts / 8, "{estimate} for {cuts}");
    }
    // Two hundred lines through one point, and two hundred through another: each is cut once.
    let star = |x: i64| (0..200).map(move |i| segment([x - 1000, 2 * i - 199], [x + 1000, 199 - 2 * i]));
    let stars: Vec<Segment> = star(0).chain(star(10_000)).collect();
    let estimate = crossing_cuts(Pixels::ONE_STEP, &stars).unwrap();
    assert!((400..=4 * 400).contains(&estimate), "{estimate}");
    let apart: Vec<Segment> = (0..100).map(|i| segment([0, i], [9, i])).collect();
    assert_eq!(crossing_cuts(Pixels::ONE_STEP, &apart), None);
    assert_eq!(crossing_cuts(Pixels::ONE_STEP, &[]), None);
}
