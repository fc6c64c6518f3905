//! Estimating the number of cuts before any segment is cut.

use super::pixel::{Pixel, Pixels, Segment};
use rustc_hash::FxHashMap;

const PAIRS: u64 = 4096;

/// With fewer crossings, an estimate is unreliable.
const ENOUGH: u64 = 64;

/// Estimates the number of cuts where two segments cross; `None` if there are too few crossings. O(1).
///
/// The pairs are a fixed pseudo-random sequence. With s crossings found, the relative error is typically 1 / √s. A segment is cut
/// once in a pixel, by any number of others. So if many crossings share few pixels, as for lines through one point, each has at
/// most one cut per segment; the number of pixels is estimated from the numbers found once and found twice (A. Chao, 1984).
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
    // Among n² ordered pairs, each crossing counts twice.
    let alone = (u128::from(count) * u128::from(count) * u128::from(found)) / u128::from(PAIRS);
    let shared = u128::from(count) * u128::from(times.len() as u64 + unseen);
    Some(u64::try_from(alone.min(shared)).unwrap_or(u64::MAX))
}

#[cfg(test)]
mod tests;
