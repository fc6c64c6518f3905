//! The checkers in parts, one for each thread: the tests share nothing.

use super::answers::Answers;
use super::check::{check, scan};
use super::storage::Columns;
use super::sums::Sums;
use super::surface::{Surface, check_surface};
use super::test::{Failure, Failures, Noted as _, Test};
use crate::validate::structure::View;
use alloc::vec::Vec;
use rayon::prelude::*;

/// The same as [`check`], by all threads of the current pool of `rayon`: each looks at a part of the records.
///
/// # Errors
/// The tests that fail.
///
/// ```
/// use twinedge::validate::Table;
/// use twinedge::validate::certificate::{Labels, check, check_parallel};
/// let edge: Table = "V 2 0 - 1 - H 2 0 1 1 1 0 1 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
/// let labels = Labels::default();
/// assert_eq!(check_parallel(&edge, &labels), check(&edge, &labels));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_parallel<V, C>(view: &V, labels: &C) -> Result<(), Vec<Failure>>
where
    V: View + Sync + ?Sized,
    C: Columns + Sync,
{
    let whole = Answers::new(view, labels);
    if !whole.readable() {
        return check(view, labels);
    }
    let (sums, mut failures) = in_parts(&whole, |part, failures| scan(&part, failures).unwrap_or_default());
    sums.note(&mut failures);
    failures.into_result()
}

/// The same as [`check_surface`], by all threads of the current pool of `rayon`: each looks at a part of the records.
///
/// # Errors
/// The tests that fail.
pub fn check_surface_parallel<V, C>(view: &V, labels: &C, genus: usize) -> Result<(), Vec<Failure>>
where
    V: View + Sync + ?Sized,
    C: Columns + Sync,
{
    let whole = Answers::new(view, labels);
    if !whole.readable() {
        return check_surface(view, labels, genus);
    }
    let (sums, mut failures) =
        in_parts(&whole, |part, failures| Surface(part).scan(false, failures).unwrap_or_default());
    failures.note(Test::GenusOk, 0, sums.fit(genus));
    failures.into_result()
}

/// Scans each part, and adds up what they found.
fn in_parts<'a, V, C>(
    whole: &Answers<'a, V, C>,
    scan: impl Fn(Answers<'a, V, C>, &mut Failures) -> Sums + Sync,
) -> (Sums, Failures)
where
    V: View + Sync + ?Sized,
    C: Columns + Sync,
{
    let parts = rayon::current_num_threads();
    let found = (0..parts).into_par_iter().map(|part| {
        let mut failures = Failures::new();
        (scan(whole.part(part, parts), &mut failures), failures)
    });
    found.reduce(
        || (Sums::default(), Failures::new()),
        |(sums, failures), (more, others)| (sums.join(more), failures.join(&others)),
    )
}
