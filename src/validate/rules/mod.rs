//! The fast check of each rule, in a file under the name of the rule.

pub(super) mod borders;
pub(super) mod bounds;
pub(super) mod closed;
pub(super) mod connected;
pub(super) mod cycle;
pub(super) mod euler;
pub(super) mod genus;
pub(super) mod isolated;
pub(super) mod kept;
pub(super) mod leaving;
pub(super) mod listed;
pub(super) mod live;
pub(super) mod nesting;
pub(super) mod next_prev;
pub(super) mod outer;
pub(super) mod outside;
pub(super) mod rotation;
pub(super) mod sides;
pub(super) mod simple;
pub(super) mod target;
pub(super) mod twin;
pub(super) mod used;

use super::findings::Findings;
use super::report::Unchecked;
use super::rule::Rule;
use super::structure::Part;
use super::subject::Subject;

/// True if an optional rule is passed over: it was not asked for, or the rule that it needs is broken, which is then entered as
/// the reason.
fn passes_over(subject: Subject<'_>, rule: Rule, broken: Option<Rule>, findings: &mut Findings) -> bool {
    if !subject.extent.expect.asks_for(rule) {
        return true;
    }
    if let Some(broken) = broken {
        findings.not_checked(rule, Unchecked::Broken(broken));
    }
    broken.is_some()
}

/// The rule without which a cycle does not either have a face or bound nothing, if it is broken: at an open boundary,
/// border loops cannot be told from the others then.
pub(super) fn borders_broken(subject: Subject<'_>, findings: &Findings) -> Option<Rule> {
    if subject.is_open() { findings.broken(&[Rule::B1]) } else { None }
}

/// Returns the reason why T1 and T2 cannot be checked, if there is one.
fn containment_unchecked(subject: Subject<'_>, findings: &Findings) -> Option<Unchecked> {
    if !subject.has(Part::Holes) {
        return Some(Unchecked::Lacks(Part::Holes));
    }
    let below = [Rule::R1, Rule::V1, Rule::B1, Rule::B2, Rule::F1, Rule::F2];
    findings.broken(&below).map(Unchecked::Broken)
}
