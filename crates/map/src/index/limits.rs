//! Sizes up to which scanning is faster than the index.

use twinedge::dcel::{Face, Vertex};

/// Returns the limit; in tests of this crate a low one, so that small maps take every path.
const fn limit(usual: usize, in_tests: usize) -> usize {
    if cfg!(test) { in_tests } else { usual }
}

/// A vertex with more half-edges becomes a hub, and remains one until only half of them are left.
pub(super) const HUB: usize = limit(64, 4);

/// The largest number of half-edges and boundary components of a face that is scanned.
const SMALL: usize = limit(64, 6);

/// Returns true if the degree of a vertex is so high that walking around it would take long. O(1).
pub(crate) fn is_hub(v: Vertex<'_>) -> bool {
    v.rotation().nth(HUB).is_some()
}

/// Returns true if a face is small enough to be scanned instead of using the index. O(1).
pub(crate) fn is_small(face: Face<'_>) -> bool {
    let mut left = SMALL;
    face.boundaries().all(|b| {
        let half_edges = b.half_edges().take(left).count();
        left = left.saturating_sub(half_edges.max(1));
        left > 0
    })
}
