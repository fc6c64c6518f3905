//! Selects the violations to keep if there are too many.

use super::violation::Violation;
use crate::validate::rule::Rule;
use alloc::vec::Vec;

/// Keeps at most `cap` violations, which are in the order of the rules. Each broken rule keeps its first ones, with an equal share
/// for every rule; the unused share of rules with few goes to earlier rules. If there are more rules than `cap`, the first rules keep
/// one each.
pub(crate) fn keep_some_of_each(violations: &mut Vec<Violation>, cap: usize) {
    if violations.len() <= cap {
        return;
    }
    let mut found = [0_usize; Rule::ALL.len()];
    for violation in violations.iter() {
        found[violation.rule().index()] += 1;
    }
    let broken = found.iter().filter(|count| **count > 0).count();
    let share = (cap / broken).max(1);
    let mut rest = cap.saturating_sub(found.iter().map(|count| *count.min(&share)).sum());
    let mut left = cap;
    let mut kept = found.map(|count| {
        let more = count.saturating_sub(share).min(rest);
        rest -= more;
        let kept = (count.min(share) + more).min(left);
        left -= kept;
        kept
    });
    violations.retain(|violation| {
        let kept = &mut kept[violation.rule().index()];
        let is_kept = *kept > 0;
        *kept = kept.saturating_sub(1);
        is_kept
    });
}

#[cfg(test)]
mod tests;
