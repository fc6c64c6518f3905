//! Sizes up to which scanning is faster than the index.

use twinedge::dcel::{Face, Vertex};

/// A limit, and the one in tests of this crate, which is so low that small maps go every way.
const fn limit(usual: usize, in_tests: usize) -> usize {
    if cfg!(test) { in_tests } else { usual }
}

/// A vertex from which more half-edges leave than this is a hub, until half as many are left.
pub(super) const HUB: usize = limit(64, 4);

/// Up to so many half-edges and boundary components, a face is scanned.
const SMALL: usize = limit(64, 6);

/// Returns true if so many half-edges leave a vertex that going around would take long. O(1).
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
