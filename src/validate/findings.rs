//! A report under construction: violations, rule outcomes, and counts.

use super::report::{Bounds, Collect, Counts, Report, RuleOutcome, Unchecked, Violation, keep_some_of_each};
use super::rule::Rule;
use alloc::vec::Vec;

/// An error ends the run early.
pub type Flow = Result<(), Halt>;

/// A reason to end a run early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Halt {
    /// The first violation was found, and no more are wanted.
    Found,
    /// Memory ran out.
    OutOfMemory,
}

/// A report under construction: the outcome of each rule, and violations. For rules checked in addition to the rules of
/// [`validate`](super::validate), such as rules about coordinates.
///
/// ```
/// use twinedge::validate::{Collect, Findings, Rule, Violation};
///
/// let mut findings = Findings::new(Collect::All);
/// findings.checked(Rule::G1, 3);
/// findings.add(Violation::NotFinite { vertex: 2 }).unwrap();
/// let report = findings.into_report(&[Rule::G1]);
/// assert_eq!((report.violation_count(), report.outcome(Rule::G1).unwrap().checked), (1, 3));
/// ```
#[derive(Debug)]
pub struct Findings {
    outcomes: [RuleOutcome; Rule::ALL.len()],
    /// The first violations of each rule, up to the cap.
    violations: Vec<Violation>,
    collect: Collect,
    pub(crate) counts: Counts,
    pub(crate) bounds: Option<Bounds>,
}

impl Findings {
    /// Creates findings without any checks. O(1).
    #[must_use]
    pub const fn new(collect: Collect) -> Self {
        Self {
            outcomes: [RuleOutcome { checked: 0, violations: 0, unchecked: None }; Rule::ALL.len()],
            violations: Vec::new(),
            collect,
            counts: Counts::NOTHING,
            bounds: None,
        }
    }

    /// Records a violation. O(1), amortised.
    ///
    /// # Errors
    /// Ends the run if only the first violation is wanted.
    #[cold]
    pub fn add(&mut self, violation: Violation) -> Flow {
        let found = &mut self.outcomes[violation.rule().index()].violations;
        if *found < self.collect.cap() as u64 && self.violations.try_reserve(1).is_ok() {
            self.violations.push(violation);
        }
        *found += 1;
        if self.collect == Collect::First { Err(Halt::Found) } else { Ok(()) }
    }

    /// Begins a pass shared by several rules, `first` being the earliest.
    pub(crate) const fn pass(&mut self, first: Rule) -> Pass<'_> {
        Pass { findings: self, first, held_back: None }
    }

    /// Records that a rule was checked on `count` more records. O(1).
    pub const fn checked(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].checked += count;
    }

    /// Records the reason why a rule was not checked, or not on every record. O(1).
    pub const fn not_checked(&mut self, rule: Rule, why: Unchecked) {
        self.outcomes[rule.index()].unchecked = Some(why);
    }

    /// Returns the maximum number of violations kept per rule.
    #[must_use]
    pub const fn cap(&self) -> usize {
        self.collect.cap()
    }

    /// Counts violations found elsewhere and not kept.
    pub const fn add_uncollected(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].violations += count;
    }

    /// Records the reason, unless the rule was checked on some record or has a reason already.
    pub const fn not_checked_yet(&mut self, rule: Rule, why: Unchecked) {
        let outcome = &mut self.outcomes[rule.index()];
        if outcome.unchecked.is_none() && outcome.checked == 0 {
            outcome.unchecked = Some(why);
        }
    }

    pub(crate) const fn unchecked(&self, rule: Rule) -> Option<Unchecked> {
        self.outcomes[rule.index()].unchecked
    }

    pub(crate) const fn holds(&self, rule: Rule) -> bool {
        self.outcomes[rule.index()].violations == 0
    }

    /// Returns the first broken rule among `rules`.
    #[must_use]
    pub fn broken(&self, rules: &[Rule]) -> Option<Rule> {
        rules.iter().copied().find(|rule| !self.holds(*rule))
    }

    /// Returns the report on these rules.
    #[must_use]
    pub fn into_report(self, rules: &[Rule]) -> Report {
        let mut violations = self.violations;
        violations.sort_by_key(Violation::rule);
        keep_some_of_each(&mut violations, self.collect.cap());
        let outcomes = rules.iter().map(|rule| (*rule, self.outcomes[rule.index()])).collect();
        Report { outcomes, violations, counts: self.counts, bounds: self.bounds }
    }
}

/// The findings of a pass shared by several rules. If only the first violation is wanted, it must be of the first broken rule, so
/// violations of later rules are held back until the pass ends.
pub(crate) struct Pass<'f> {
    findings: &'f mut Findings,
    first: Rule,
    held_back: Option<Violation>,
}

impl Pass<'_> {
    /// Records a violation. Ends the run if only the first one is wanted and no earlier rule can be broken.
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

    pub(crate) fn end(self) -> Flow {
        self.held_back.map_or(Ok(()), |violation| self.findings.add(violation))
    }
}
