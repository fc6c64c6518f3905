//! Limits at which a search changes its method or stops.

use crate::noding::input::NodingError;
use core::sync::atomic::{AtomicUsize, Ordering};

/// Returns the limit; in tests of this crate a low one, so that small input takes every path.
pub(super) const fn limit(usual: usize, in_tests: usize) -> usize {
    if cfg!(test) { in_tests } else { usual }
}

/// The number of visits allowed for all parallel searches together.
pub(super) struct Budget<'a> {
    pub(super) most: usize,
    /// The visits counted so far.
    pub(super) visits: &'a AtomicUsize,
    pub(super) counted: usize,
}

impl Budget<'_> {
    /// Counts the visits of this search from time to time: threads contend for the counter.
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
