//! Memory use of readers, counted by the allocator.
#![allow(clippy::incompatible_msrv, reason = "the tests need the Rust version of their own dependencies")]
#![allow(clippy::needless_pass_by_value, reason = "quickcheck hands its arguments over")]

mod claims;
#[path = "../../../../tests/memory/counting.rs"]
mod counting;
mod geojson;

use counting::{LIVE_BYTES, PEAK_BYTES};

/// Returns the peak memory during the work, beyond the memory in use before.
pub(crate) fn peak(work: impl FnOnce()) -> usize {
    let before = LIVE_BYTES.get();
    PEAK_BYTES.set(before);
    work();
    (PEAK_BYTES.get() - before).cast_unsigned()
}
