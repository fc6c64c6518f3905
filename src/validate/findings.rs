//! The violations found so far, and an outcome per rule.

use super::report::{Collect, RuleOutcome, Unchecked};
use super::rule::Rule;
use super::violation::Violation;
use alloc::vec::Vec;

/// Whether the run goes on.
pub(crate) type Flow = Result<(), Halt>;

/// Why a run ends early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Halt {
    /// Only the first violation was wanted, and it is found.
    Found,
    /// No memory for a column.
    OutOfMemory,
}

/// Collects violations and outcomes while the rules are run.
#[derive(Debug)]
pub(crate) struct Findings {
    outcomes: [RuleOutcome; Rule::ALL.len()],
    violations: Vec<Violation>,
    collect: Collect,
    /// Where only the first violation is wanted: one that is reported at the end of the pass, unless the pass finds one of
    /// an earlier rule.
    held_back: Option<Violation>,
}

impl Findings {
    pub(crate) const fn new(collect: Collect) -> Self {
        Self {
            outcomes: [RuleOutcome { checked: 0, violations: 0, unchecked: None }; Rule::ALL.len()],
            violations: Vec::new(),
            collect,
            held_back: None,
        }
    }

    /// Notes a violation, and ends the run if the first one was asked for.
    #[cold]
    pub(crate) fn add(&mut self, violation: Violation) -> Flow {
        self.outcomes[violation.rule().index()].violations += 1;
        if self.violations.len() < self.collect.cap() && self.violations.try_reserve(1).is_ok() {
            self.violations.push(violation);
        }
        if self.collect == Collect::First { Err(Halt::Found) } else { Ok(()) }
    }

    /// Notes a violation found by a pass that several rules share, of which `first` is the first. If only one violation is
    /// wanted, it must be of the first broken rule, so the pass goes on until it ends or that rule is broken.
    #[cold]
    pub(crate) fn add_in_pass(&mut self, violation: Violation, first: Rule) -> Flow {
        if self.collect != Collect::First || violation.rule() == first {
            self.held_back = None;
            return self.add(violation);
        }
        if self.held_back.is_none_or(|held_back| violation.rule() < held_back.rule()) {
            self.held_back = Some(violation);
        }
        Ok(())
    }

    /// Ends a pass that several rules share.
    pub(crate) fn end_pass(&mut self) -> Flow {
        self.held_back.take().map_or(Ok(()), |violation| self.add(violation))
    }

    /// Whether the run ends with the first violation.
    pub(crate) fn wants_first_only(&self) -> bool {
        self.collect == Collect::First
    }

    pub(crate) const fn checked(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].checked += count;
    }

    pub(crate) const fn not_checked(&mut self, rule: Rule, why: Unchecked) {
        self.outcomes[rule.index()].unchecked = Some(why);
    }

    /// How many more violations will be kept.
    #[cfg(feature = "geometry")]
    pub(crate) fn room(&self) -> usize {
        self.collect.cap().saturating_sub(self.violations.len())
    }

    /// Counts violations that were found elsewhere and not kept.
    #[cfg(feature = "geometry")]
    pub(crate) const fn add_uncollected(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].violations += count;
    }

    /// The same, unless the rule was checked on some record or has a reason already.
    pub(crate) const fn not_checked_yet(&mut self, rule: Rule, why: Unchecked) {
        let outcome = &mut self.outcomes[rule.index()];
        if outcome.unchecked.is_none() && outcome.checked == 0 {
            outcome.unchecked = Some(why);
        }
    }

    /// Why the rule was not checked, or not on every record.
    pub(crate) const fn unchecked(&self, rule: Rule) -> Option<Unchecked> {
        self.outcomes[rule.index()].unchecked
    }

    /// Whether no violation of this rule was found.
    pub(crate) const fn holds(&self, rule: Rule) -> bool {
        self.outcomes[rule.index()].violations == 0
    }

    /// The first of these rules that is broken.
    pub(crate) fn broken(&self, rules: &[Rule]) -> Option<Rule> {
        rules.iter().copied().find(|rule| !self.holds(*rule))
    }

    /// The outcomes of these rules and the violations found.
    pub(crate) fn into_parts(self, rules: &[Rule]) -> (Vec<(Rule, RuleOutcome)>, Vec<Violation>) {
        let mut violations = self.violations;
        violations.sort_by_key(Violation::rule);
        (rules.iter().map(|rule| (*rule, self.outcomes[rule.index()])).collect(), violations)
    }
}
