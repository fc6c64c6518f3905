//! The part of Kani's library that the harnesses use, with its signatures, to run them where there is no Kani.
//!
//! A model checker takes all values at once. Here [`check`] runs a harness over one value after the other: [`any`]
//! counts up from 0, and the first value that [`assume`] rejects is one too many. This covers every value if an
//! assumption bounds it from above right after the call. A [`cover!`] that no run fulfils fails, where Kani would
//! report it as unsatisfiable.
//!
//! Under `cargo kani` the real library takes this one's place; see `proofs/README.md`.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};

pub use kani_macros::{proof, unwind};

/// The choices of a run, and the conditions that some run has met.
#[derive(Debug, Default)]
struct Runs {
    values: Vec<usize>,
    taken: usize,
    covers: Vec<(&'static str, bool)>,
}

thread_local! {
    static RUNS: RefCell<Runs> = RefCell::default();
}

/// The payload of the panic that ends a run whose last value is one too many.
struct TooLarge;

/// Types whose values Kani can make up.
pub trait Arbitrary: Sized {
    /// Returns any value.
    fn any() -> Self;
}

impl Arbitrary for usize {
    fn any() -> Self {
        RUNS.with_borrow_mut(|runs| {
            if runs.taken == runs.values.len() {
                runs.values.push(0);
            }
            runs.taken += 1;
            runs.values[runs.taken - 1]
        })
    }
}

/// Returns any value.
#[must_use]
pub fn any<T: Arbitrary>() -> T {
    T::any()
}

/// Rejects values that do not fulfil the condition: the last value made up, and all larger ones.
pub fn assume(condition: bool) {
    if !condition {
        resume_unwind(Box::new(TooLarge));
    }
}

/// Records whether the condition can be fulfilled.
pub fn cover(condition: bool, message: &'static str) {
    RUNS.with_borrow_mut(|runs| match runs.covers.iter_mut().find(|(known, _)| *known == message) {
        Some((_, met)) => *met |= condition,
        None => runs.covers.push((message, condition)),
    });
}

/// Requires a run that fulfils the condition.
#[macro_export]
macro_rules! cover {
    ($condition:expr, $message:literal) => {
        $crate::cover($condition, $message)
    };
}

/// Runs a harness over all values.
///
/// # Panics
/// If the harness does, or if a condition to cover is never met.
pub fn check(name: &str, harness: fn()) {
    RUNS.take();
    loop {
        let too_large = match catch_unwind(AssertUnwindSafe(harness)) {
            Ok(()) => false,
            Err(panic) if panic.is::<TooLarge>() => true,
            Err(panic) => resume_unwind(panic),
        };
        let is_last = RUNS.with_borrow_mut(|runs| {
            runs.values.truncate(std::mem::take(&mut runs.taken));
            if too_large {
                runs.values.pop();
            }
            runs.values.last_mut().map(|last| *last += 1).is_none()
        });
        if is_last {
            break;
        }
    }
    for (message, met) in RUNS.take().covers {
        assert!(met, "{name}: never in any run: {message}");
    }
}

#[cfg(test)]
mod tests {
    use super::{any, assume, check};

    fn below(n: usize) -> usize {
        let k = any();
        assume(k < n);
        k
    }

    #[test]
    fn every_value_is_run() {
        thread_local!(static SEEN: std::cell::RefCell<Vec<(usize, usize)>> = const { std::cell::RefCell::new(Vec::new()) });
        check("pairs", || {
            let first = below(3);
            let second = below(first + 1);
            SEEN.with_borrow_mut(|seen| seen.push((first, second)));
            crate::cover!(first == 2 && second == 1, "a pair");
        });
        assert_eq!(SEEN.take(), [(0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)]);
    }

    #[test]
    #[should_panic(expected = "vacuous: never in any run: four")]
    fn what_is_never_covered_fails() {
        check("vacuous", || crate::cover!(below(4) == 4, "four"));
    }

    #[test]
    #[should_panic(expected = "wrong at 2")]
    fn a_harness_that_fails_fails() {
        check("wrong", || assert!(below(3) < 2, "wrong at 2"));
    }
}
