//! What a validation found: an outcome per rule, the violations, the counts, and on success a certificate.

use super::{Part, Rule, Violation};
use alloc::vec::Vec;
use core::fmt;

/// How many violations to collect. The true count per rule is kept in any case, except with `First`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Collect {
    /// Stop at the first violation of the first broken rule.
    First,
    /// Keep up to [`Collect::DEFAULT_CAP`] violations.
    #[default]
    All,
    /// Keep up to this many violations; none of them is fewer than the count says.
    AtMost(usize),
}

impl Collect {
    /// How many violations `All` keeps.
    pub const DEFAULT_CAP: usize = 1000;

    pub(crate) const fn cap(self) -> usize {
        match self {
            Self::First => 1,
            Self::All => Self::DEFAULT_CAP,
            Self::AtMost(n) => n,
        }
    }
}

/// Why a rule was not checked, or not on every record.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Unchecked {
    /// It makes sense only where this rule holds, and that one is broken.
    Broken(Rule),
    /// The structure lacks this part.
    Lacks(Part),
    /// It is a rule of the plane.
    PlaneOnly,
    /// It is a rule of simple maps with at least three vertices: there are loops, parallel edges or fewer vertices.
    NotSimple,
    /// The run ended with the first violation, as asked.
    Stopped,
    /// The structure claims more than `u32::MAX - 1` records of one kind.
    TooLarge,
    /// There was no memory for the columns that the check needs.
    OutOfMemory,
    /// The faces list more than twice as many inner boundary components as there are, and 16: the rest of the lists was
    /// not read.
    ListTooLong,
}

impl Unchecked {
    /// Whether a structure that is otherwise right can be certified although the rule was not checked: what it does not
    /// have, or what does not apply to it, is no fault.
    #[must_use]
    pub const fn is_by_design(self) -> bool {
        matches!(self, Self::Lacks(_) | Self::PlaneOnly | Self::NotSimple)
    }
}

impl fmt::Display for Unchecked {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Broken(rule) => write!(f, "needs {rule}, which is broken"),
            Self::Lacks(part) => {
                write!(f, "the structure has no {}", part.name().trim_start_matches("a ").trim_start_matches("an "))
            }
            Self::PlaneOnly => f.write_str("a rule of the plane only"),
            Self::NotSimple => f.write_str("applies to simple maps with at least 3 vertices"),
            Self::Stopped => f.write_str("stopped at the first violation"),
            Self::TooLarge => f.write_str("more than 4,294,967,294 records of one kind"),
            Self::OutOfMemory => f.write_str("not enough memory"),
            Self::ListTooLong => f.write_str("the lists of the faces are too long to be read to the end"),
        }
    }
}

/// What became of one rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct RuleOutcome {
    /// How many were checked; what is counted is [`Rule::unit`].
    pub checked: u64,
    /// How many violations were found, kept or not.
    pub violations: u64,
    /// Why some or all were not checked.
    pub unchecked: Option<Unchecked>,
}

/// How many of everything. What could not be counted because a rule that counting relies on is broken is `None`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Counts {
    /// V.
    pub vertices: usize,
    /// Half-edges.
    pub half_edges: usize,
    /// E: pairs of twins, and half-edges without twin where the boundary is open.
    pub edges: usize,
    /// F: face records, the unbounded one included.
    pub faces: usize,
    /// Boundary components listed as outer.
    pub outer_boundaries: usize,
    /// Boundary components listed as inner, isolated vertices included.
    pub inner_boundaries: usize,
    /// Vertices that no half-edge leaves.
    pub isolated_vertices: usize,
    /// C: connected components.
    pub components: Option<usize>,
    /// Cycles of `next`.
    pub cycles: Option<usize>,
    /// Open boundaries of half-edges without twin: the cycles that their missing twins would make. T3 counts them with the
    /// cycles.
    pub borders: Option<usize>,
    /// The sum of the genera of the components.
    pub genus: Option<usize>,
}

/// The bounds of T4, for a simple map: how far its counts are from the most that is possible.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Bounds {
    /// `3V − 6`, the most edges possible.
    pub most_edges: usize,
    /// `2V − 4`, the most faces possible.
    pub most_faces: usize,
}

/// What is known of a structure in which no violation was found and every rule that applies to it was checked.
///
/// Added over the components, with one cycle for each isolated vertex, T3 says that
/// `vertices − edges + cycles + borders + isolated_vertices = 2 · components − 2 · genus`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// V.
    pub vertices: usize,
    /// E.
    pub edges: usize,
    /// F, the unbounded face included.
    pub faces: usize,
    /// C.
    pub components: usize,
    /// Cycles of `next`.
    pub cycles: usize,
    /// Open boundaries of half-edges without twin.
    pub borders: usize,
    /// Vertices that no half-edge leaves.
    pub isolated_vertices: usize,
    /// The sum of the genera of the components: 0 in the plane.
    pub genus: usize,
    /// The bounds of T4, if the map is simple and has three vertices.
    pub bounds: Option<Bounds>,
    /// The rules that do not apply to this structure, with the reason.
    pub not_checked: Vec<(Rule, Unchecked)>,
}

/// What a validation found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Report {
    pub(crate) outcomes: Vec<(Rule, RuleOutcome)>,
    pub(crate) violations: Vec<Violation>,
    pub(crate) counts: Counts,
    pub(crate) bounds: Option<Bounds>,
}

impl Report {
    /// The rules that were to be checked, in order, each with what became of it.
    #[must_use]
    pub fn outcomes(&self) -> impl ExactSizeIterator<Item = (Rule, RuleOutcome)> + '_ {
        self.outcomes.iter().copied()
    }

    /// What became of this rule; `None` for a rule that is not of this validation (G without coordinates).
    #[must_use]
    pub fn outcome(&self, rule: Rule) -> Option<RuleOutcome> {
        self.outcomes.iter().find(|(r, _)| *r == rule).map(|(_, o)| *o)
    }

    /// The violations that were kept, in the order of the rules.
    #[must_use]
    pub fn violations(&self) -> &[Violation] {
        &self.violations
    }

    /// Adds what was found by rules that are checked after these.
    #[cfg(feature = "geometry")]
    pub(crate) fn append(&mut self, outcomes: Vec<(Rule, RuleOutcome)>, violations: Vec<Violation>) {
        self.outcomes.extend(outcomes);
        self.violations.extend(violations);
    }

    /// What is left to collect after these violations.
    #[cfg(feature = "geometry")]
    pub(crate) const fn collect_left(&self, collect: Collect) -> Collect {
        match collect {
            Collect::First => Collect::First,
            _ => Collect::AtMost(collect.cap().saturating_sub(self.violations.len())),
        }
    }

    /// How many violations were found, kept or not.
    #[must_use]
    pub fn violation_count(&self) -> u64 {
        self.outcomes.iter().map(|(_, o)| o.violations).sum()
    }

    /// How many there are of everything.
    #[must_use]
    pub const fn counts(&self) -> &Counts {
        &self.counts
    }

    /// Whether no violation was found and every rule that applies was checked.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        self.outcomes.iter().all(|(_, o)| o.violations == 0 && o.unchecked.is_none_or(Unchecked::is_by_design))
    }

    /// The certificate, if the structure is valid.
    #[must_use]
    pub fn certificate(&self) -> Option<Certificate> {
        let Counts { vertices, edges, faces, isolated_vertices, .. } = self.counts;
        if !self.is_valid() {
            return None;
        }
        Some(Certificate {
            vertices,
            edges,
            faces,
            components: self.counts.components?,
            cycles: self.counts.cycles?,
            borders: self.counts.borders?,
            isolated_vertices,
            genus: self.counts.genus?,
            bounds: self.bounds,
            not_checked: self.outcomes.iter().filter_map(|(r, o)| Some((*r, o.unchecked?))).collect(),
        })
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (rule, outcome) in &self.outcomes {
            write!(f, "{:2} {:9} ", rule.id(), rule.name())?;
            match (outcome.violations, outcome.unchecked) {
                (0, None) => write!(f, "ok, {} {}", outcome.checked, rule.unit())?,
                (0, Some(why)) => write!(f, "not checked: {why}")?,
                (n, why) => {
                    write!(f, "BROKEN, {n} violation(s) in {} {}", outcome.checked, rule.unit())?;
                    if let Some(why) = why {
                        write!(f, "; the rest not checked: {why}")?;
                    }
                }
            }
            writeln!(f)?;
        }
        for violation in &self.violations {
            writeln!(f, "{}: {violation}", violation.rule())?;
        }
        let more = self.violation_count().saturating_sub(self.violations.len() as u64);
        if more > 0 {
            writeln!(f, "… and {more} more")?;
        }
        Ok(())
    }
}

/// The run may go on, or the first violation was asked for and found.
pub(crate) type Flow = Result<(), Halt>;

/// Why a run ends early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Halt {
    /// The first violation was asked for and found.
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

    pub(crate) const fn checked(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].checked += count;
    }

    pub(crate) const fn not_checked(&mut self, rule: Rule, why: Unchecked) {
        self.outcomes[rule.index()].unchecked = Some(why);
    }

    /// How many more violations will be kept.
    #[cfg(feature = "geometry")]
    pub(crate) const fn room(&self) -> usize {
        self.collect.cap().saturating_sub(self.violations.len())
    }

    /// Counts violations that were found elsewhere and not kept.
    #[cfg(feature = "geometry")]
    pub(crate) const fn add_uncollected(&mut self, rule: Rule, count: u64) {
        self.outcomes[rule.index()].violations += count;
    }

    /// The same, for a rule of which nothing was checked so far.
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
