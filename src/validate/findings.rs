//! The report under construction: violations, an outcome for each rule, counts.

use super::report::{Bounds, Collect, Counts, Report, RuleOutcome, Unchecked, Violation, keep_some_of_each};
use super::rule::Rule;
use alloc::vec::Vec;

/// An error if the run ends early.
pub(crate) type Flow = Result<(), Halt>;

/// A reason to end a run early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Halt {
    /// Only the first violation was wanted, and it is found.
    Found,
    /// No memory for a column.
    OutOfMemory,
}

/// The report under construction.
#[derive(Debug)]
pub(crate) struct Findings {
    outcomes: [RuleOutcome; Rule::ALL.len()],
    /// Of each rule the first ones, up to the cap.
    violations: Vec<Violation>,
    collect: Collect,
    /// The counts so far.
    pub(crate) counts: Counts,
    pub(crate) bounds: Option<Bounds>,
}

impl Findings {
    pub(crate) const fn new(collect: Collect) -> Self {
        Self {
            outcomes: [RuleOutcome { checked: 0, violations: 0, unchecked: None }; Rule::ALL.len()],
            violations: Vec::new(),
            collect,
            counts: Counts::NOTHING,
            bounds: None,
        }
    }

    /// Notes a violation, and ends the run if the first one was asked for.
    #[cold]
    pub(crate) fn add(&mut self, violation: Violation) -> Flow {
        let found = &mut self.outcomes[violation.rule().index()].violations;
        if *found < self.collect.cap() as u64 && self.violations.try_reserve(1).is_ok() {
            self.violations.push(violation);
        }
        *found += 1;
        if self.collect == Collect::First { Err(Halt::Found) } else { Ok(()) }
    }

    /// Begins a pass that several rules share, of which this is the first.
    pub(crate) const fn pass(&mut self, first: Rule) -> Pass<'_> {
        Pass { findings: self, first, held_back: None }
    }

    pub(crate) const fn checked(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].checked += count;
    }

    pub(crate) const fn not_checked(&mut self, rule: Rule, why: Unchecked) {
        self.outcomes[rule.index()].unchecked = Some(why);
    }

    /// Returns the greatest number of violations of a rule that are kept.
    #[cfg(feature = "geometry")]
    pub(crate) const fn cap(&self) -> usize {
        self.collect.cap()
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

    /// Returns the reason why the rule was not checked, or not on every record.
    pub(crate) const fn unchecked(&self, rule: Rule) -> Option<Unchecked> {
        self.outcomes[rule.index()].unchecked
    }

    /// True if no violation of this rule was found.
    pub(crate) const fn holds(&self, rule: Rule) -> bool {
        self.outcomes[rule.index()].violations == 0
    }

    /// The first of these rules that is broken.
    pub(crate) fn broken(&self, rules: &[Rule]) -> Option<Rule> {
        rules.iter().copied().find(|rule| !self.holds(*rule))
    }

    /// The outcomes of these rules and the violations found.
    pub(crate) fn into_report(self, rules: &[Rule]) -> Report {
        let mut violations = self.violations;
        violations.sort_by_key(Violation::rule);
        keep_some_of_each(&mut violations, self.collect.cap());
        let outcomes = rules.iter().map(|rule| (*rule, self.outcomes[rule.index()])).collect();
        Report { outcomes, violations, counts: self.counts, bounds: self.bounds }
    }
}

/// The findings of a pass that several rules share. Where only the first violation is wanted, it must be of the first broken rule: one
/// of a later rule is held back until the pass ends.
pub(crate) struct Pass<'f> {
    findings: &'f mut Findings,
    first: Rule,
    held_back: Option<Violation>,
}

impl Pass<'_> {
    /// Notes a violation. The run ends here if only the first one is wanted and no earlier rule can be broken.
    #[cold]
    pub(crate) fn add(&mut self, violation: Violation) -> Flow {
        if self.findings.collect != Collect::First || violation.rule() == self.first {
            return self.findings.add(violation);
        }
        if self.held_back.is_none_or(|held_back| violation.rule() < held_back.rule()) {
            self.held_back = Some(violation);
        }
        Ok(())
    }

    /// Ends the pass.
    pub(crate) fn end(self) -> Flow {
        self.held_back.map_or(Ok(()), |violation| self.findings.add(violation))
    }
}
