//! An estimate of the number of cuts, made before any segment is cut.

use super::pixel::{Pixel, Pixels, Segment};
use rustc_hash::FxHashMap;

/// The number of pairs that are tried.
const PAIRS: u64 = 4096;

/// Estimates from fewer crossings than this are worth nothing.
const ENOUGH: u64 = 64;

/// About how many times segments are cut where two of them cross; none if there are too few crossings to tell. O(1).
///
/// The pairs are those of a fixed pseudo-random sequence. Of s crossings found, the estimate is off by a part of 1 / √s, as a
/// rule. A segment is cut once in a pixel, by however many others. So where many crossings share few pixels, as those of lines
/// through one point, there are no more cuts than segments for each of those pixels, and their number is estimated from how many were
/// found once and how many twice (A. Chao, 1984).
pub(super) fn crossing_cuts(pixels: Pixels, segments: &[Segment]) -> Option<u64> {
    let count = segments.len() as u64;
    let mut state = 0_u64;
    // SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
    let mut some = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut random = state;
        random = (random ^ (random >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        random = (random ^ (random >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        random ^= random >> 31;
        &segments[((u128::from(random) * u128::from(count)) >> 64) as usize]
    };
    if segments.is_empty() {
        return None;
    }
    let mut times: FxHashMap<Pixel, u64> = FxHashMap::default();
    for pixel in (0..PAIRS).filter_map(|_| pixels.crossing(some(), some())) {
        *times.entry(pixel).or_default() += 1;
    }
    let found: u64 = times.values().sum();
    if found < ENOUGH {
        return None;
    }
    let exactly = |n: u64| times.values().filter(|times| **times == n).count() as u64;
    let unseen = exactly(1).pow(2).checked_div(2 * exactly(2)).unwrap_or(exactly(1).pow(2));
    // Of n² pairs in order, each crossing is two.
    let alone = (u128::from(count) * u128::from(count) * u128::from(found)) / u128::from(PAIRS);
    let shared = u128::from(count) * u128::from(times.len() as u64 + unseen);
    Some(u64::try_from(alone.min(shared)).unwrap_or(u64::MAX))
}

#[cfg(test)]
mod tests {
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
        // Two hundred lines through one point, and as many through another: each is cut once.
        let star = |x: i64| (0..200).map(move |i| segment([x - 1000, 2 * i - 199], [x + 1000, 199 - 2 * i]));
        let stars: Vec<Segment> = star(0).chain(star(10_000)).collect();
        let estimate = crossing_cuts(Pixels::ONE_STEP, &stars).unwrap();
        assert!((400..=4 * 400).contains(&estimate), "{estimate}");
        let apart: Vec<Segment> = (0..100).map(|i| segment([0, i], [9, i])).collect();
        assert_eq!(crossing_cuts(Pixels::ONE_STEP, &apart), None);
        assert_eq!(crossing_cuts(Pixels::ONE_STEP, &[]), None);
    }
}
