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
mod tests {
    use super::*;

    /// Returns the numbers of violations of L1, L2 and L3 that are kept.
    fn kept(found: [usize; 3], cap: usize) -> [usize; 3] {
        let of = [
            Violation::TwinIsSelf { half_edge: 0 },
            Violation::NextShared { first: 0, second: 0, next: 0 },
            Violation::Target { half_edge: 0, next: 0, target: 0, found: 0 },
        ];
        let mut violations: Vec<_> = of.iter().zip(found).flat_map(|(one, n)| core::iter::repeat_n(*one, n)).collect();
        keep_some_of_each(&mut violations, cap);
        assert!(violations.is_sorted_by_key(Violation::rule));
        of.map(|one| violations.iter().filter(|violation| violation.rule() == one.rule()).count())
    }

    #[test]
    fn each_broken_rule_keeps_some_of_its_violations() {
        assert_eq!(kept([1, 0, 1600], 1000), [1, 0, 999]);
        assert_eq!(kept([1600, 0, 1], 1000), [999, 0, 1]);
        assert_eq!(kept([9, 9, 9], 10), [4, 3, 3]);
        assert_eq!(kept([9, 1, 2], 10), [7, 1, 2]);
        assert_eq!(kept([9, 9, 9], 2), [1, 1, 0]);
        assert_eq!(kept([0, 5, 5], 1), [0, 1, 0]);
        assert_eq!(kept([3, 3, 3], 0), [0, 0, 0]);
        assert_eq!(kept([3, 3, 3], 9), [3, 3, 3]);
    }
}
