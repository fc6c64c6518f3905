//! Divided work: among the threads of the current pool with the feature `rayon`, otherwise on one. The result is bit-for-bit
//! equal.

use core::cmp::Ordering;
#[cfg(debug_assertions)]
use core::sync::atomic::AtomicBool;

/// Shorter slices are sorted on one thread.
#[cfg(feature = "rayon")]
const LONG: usize = 1 << 14;

/// Runs both and returns both results.
#[cfg(feature = "rayon")]
pub fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    rayon::join(a, b)
}

/// Runs both and returns both results.
#[cfg(not(feature = "rayon"))]
pub fn join<A, B>(a: impl FnOnce() -> A, b: impl FnOnce() -> B) -> (A, B) {
    (a(), b())
}

/// Set by a test: reverses items that tie, as another standard library may. Absent from optimised programs.
#[cfg(debug_assertions)]
#[doc(hidden)]
pub static REVERSE_TIES: AtomicBool = AtomicBool::new(false);

/// Sorts by an order in which only equal items tie, so that there is one result. O(n log n).
#[cfg(feature = "rayon")]
pub fn sort_unstable_by<T: Send>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering + Sync) {
    use rayon::slice::ParallelSliceMut;
    if items.len() < LONG {
        sort(items, order);
    } else {
        items.par_sort_unstable_by(order);
    }
}

/// Sorts by an order in which only equal items tie, so that there is one result. O(n log n).
#[cfg(not(feature = "rayon"))]
pub fn sort_unstable_by<T>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering) {
    sort(items, order);
}

#[allow(clippy::disallowed_methods, reason = "the one place where items are sorted so")]
fn sort<T>(items: &mut [T], order: impl Fn(&T, &T) -> Ordering) {
    #[cfg(debug_assertions)]
    if REVERSE_TIES.load(core::sync::atomic::Ordering::Relaxed) {
        items.reverse();
        return items.sort_by(order);
    }
    items.sort_unstable_by(order);
}

/// Applies a function to each item, and returns the results in order.
#[cfg(feature = "rayon")]
pub fn map<T: Sync, R: Send>(items: &[T], of: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
    items.par_iter().map(of).collect()
}

/// Applies a function to each item, and returns the results in order.
#[cfg(not(feature = "rayon"))]
pub fn map<T, R>(items: &[T], of: impl Fn(&T) -> R) -> Vec<R> {
    items.iter().map(of).collect()
}
