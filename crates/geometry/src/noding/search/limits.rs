//! Limits at which a search changes its method, or ends.

use crate::noding::input::NodingError;
use core::sync::atomic::{AtomicUsize, Ordering};

/// A limit, and the one in tests of this crate, which is so low that small input goes every way.
pub(super) const fn limit(usual: usize, in_tests: usize) -> usize {
    if cfg!(test) { in_tests } else { usual }
}

/// The number of visits allowed, for all searches that run at once.
pub(super) struct Budget<'a> {
    pub(super) most: usize,
    /// Those that were counted.
    pub(super) visits: &'a AtomicUsize,
    /// The number of visits counted by this search.
    pub(super) counted: usize,
}

impl Budget<'_> {
    /// Counts the visits of this search from time to time: threads wait for each other where they count.
    pub(super) fn check(&mut self, found: usize) -> Result<(), NodingError> {
        const SOME: usize = limit(1024, 4);
        let fresh = found - self.counted;
        if fresh >= SOME {
            self.counted = found;
            if self.visits.fetch_add(fresh, Ordering::Relaxed) + fresh > self.most {
                return Err(NodingError::TooManyCuts { allowed: self.most });
            }
        }
        Ok(())
    }
}
