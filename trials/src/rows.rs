//! What the outcomes have in common.

/// The greatest number of findings that an outcome keeps; all are counted.
pub(crate) const MOST_FINDINGS: usize = 10;

/// Appends findings as far as they are kept.
pub(crate) fn add_findings<T: Clone>(findings: &mut Vec<T>, others: &[T]) {
    findings.extend_from_slice(others);
    findings.truncate(MOST_FINDINGS);
}

/// A count that is published, as far as outcomes can hold it.
pub(crate) fn narrow(count: u128) -> u64 {
    u64::try_from(count).unwrap_or(u64::MAX)
}

/// The reason that an interrupted run gives.
pub(crate) const INTERRUPTED: &str = "interrupted before the end";
