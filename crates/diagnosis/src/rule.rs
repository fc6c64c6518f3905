//! The outcome of a rule, of the validator or of a format.

use std::fmt;
use twinedge::validate::{Report, Rule, RuleOutcome, Unchecked};

/// The outcome of a rule. `Display` prints it in one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RuleLine {
    /// The id: `R1` and so on; `P0` … `P4` of PostGIS, `A0` … `A3` of TopoJSON, `O1` … `O5` of `OpenStreetMap`, `X1` … `X6`
    /// between layers, `M9` … `M11` of meshes.
    pub id: &'static str,
    /// The name.
    pub name: &'static str,
    /// The rule in one sentence.
    pub statement: &'static str,
    /// The number of checked units.
    pub checked: u64,
    /// The unit: links, vertices and so on.
    pub unit: &'static str,
    /// The number of violations, kept or not.
    pub violations: u64,
    /// The reason why it was not checked, or not everywhere.
    pub unchecked: Option<Reason>,
    /// The number of unchecked units, if known.
    pub left_out: Option<u64>,
}

/// The reason why a rule was not checked, or not everywhere, as printed by `Display`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Reason {
    /// The reason of the validator.
    Validator(Unchecked),
    /// It relies on a broken rule of the format.
    Broken(&'static str),
    /// The boxes of some faces cannot be judged: the lines that name these faces do not close.
    NotClosed,
    /// The faces of some isolated nodes are unknown.
    NotLocated,
    /// Some faces of a mesh have more than three sides and are not convex.
    NotConvex,
}

impl Reason {
    /// Returns true if the input can be valid although the rule was not checked.
    #[must_use]
    pub const fn is_by_design(self) -> bool {
        matches!(self, Self::Validator(why) if why.is_by_design())
    }

    /// Returns the broken rule of the validator on which it relies, if that is the reason.
    #[must_use]
    pub const fn broken(self) -> Option<Rule> {
        match self {
            Self::Validator(Unchecked::Broken(rule)) => Some(rule),
            _ => None,
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Validator(why) => why.fmt(f),
            Self::Broken(rule) => write!(f, "needs {rule}, which is broken"),
            Self::NotConvex => f.write_str("they have more than three sides and are not convex; triangulate them"),
            Self::NotClosed => f.write_str("for mbr: the lines around these faces do not close"),
            Self::NotLocated => {
                f.write_str("in which face isolated nodes lie: needs G5, or G4 and lines around the faces that close")
            }
        }
    }
}

impl RuleLine {
    /// Converts a rule of the validator.
    #[must_use]
    pub fn new(rule: Rule, outcome: RuleOutcome) -> Self {
        Self {
            id: rule.id(),
            name: rule.name(),
            statement: rule.statement(),
            checked: outcome.checked,
            unit: rule.unit(outcome.checked),
            violations: outcome.violations,
            unchecked: outcome.unchecked.map(Reason::Validator),
            left_out: None,
        }
    }

    /// Converts the rules of a report.
    #[must_use]
    pub fn of(report: &Report) -> Vec<Self> {
        report.outcomes().map(|(rule, outcome)| Self::new(rule, outcome)).collect()
    }

    /// Returns false for a rule of the plane if the structure is a surface: text leaves it out.
    #[must_use]
    pub fn applies(&self) -> bool {
        self.unchecked != Some(Reason::Validator(Unchecked::PlaneOnly))
    }

    /// Returns true if it was checked on some records, and the number of unchecked ones is known.
    #[must_use]
    pub fn is_in_part(&self) -> bool {
        self.checked > 0 && self.left_out.is_some()
    }

    /// Returns a clause with the number of unchecked records and the reason.
    #[must_use]
    pub fn not_checked(&self) -> Option<String> {
        let why = self.unchecked?;
        Some(match self.left_out {
            Some(count) => format!("not checked on {count} of {} {}: {why}", self.checked + count, self.unit),
            None if self.violations > 0 => format!("the rest not checked: {why}"),
            None => format!("not checked: {why}"),
        })
    }

    /// Returns true if it applies and was not checked, or not everywhere.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.unchecked.is_some_and(|why| !why.is_by_design())
    }
}

impl fmt::Display for RuleLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { id, name, checked, unit, violations, .. } = self;
        write!(f, "{id} {name:10} ")?;
        match (violations, self.not_checked()) {
            (0, None) => write!(f, "ok, {checked} {unit}"),
            (0, Some(why)) if self.is_in_part() => write!(f, "ok, {checked} {unit}; {why}"),
            (0, Some(why)) => f.write_str(&why),
            (n, why) => {
                write!(f, "BROKEN, {n} violation{} in {checked} {unit}", if *n == 1 { "" } else { "s" })?;
                why.map_or(Ok(()), |why| write!(f, "; {why}"))
            }
        }
    }
}
