//! Reports in words: a line for each rule, then hints, then a line for each kept violation.

use super::hints;
use super::names::Names;
use super::violation::Sentence;
use super::words::Number;
use super::{Report, Unchecked};
use core::fmt;

/// Writes a line for each rule (on surfaces without the rules of the plane), then hints, then a line for each kept violation. A hint
/// appears if a link is nil in all records, as when the structure does not store it.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write(self, Names::INDICES, f)
    }
}

/// Writes the text of `Display`, so a failed `unwrap` or `main` prints readable lines.
impl fmt::Debug for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

pub(super) fn write(report: &Report, names: Names<'_>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    for (rule, outcome) in report.outcomes.iter().filter(|(_, outcome)| outcome.unchecked != Some(Unchecked::PlaneOnly))
    {
        let checked = outcome.checked;
        write!(f, "{:2} {:9} ", rule.id(), rule.name())?;
        match (outcome.violations, outcome.unchecked) {
            (0, None) => write!(f, "ok, {checked} {}", rule.unit(checked))?,
            (0, Some(why)) => write!(f, "not checked: {why}")?,
            (n, why) => {
                let violations = Number(n, "violation", "violations");
                write!(f, "BROKEN, {violations} in {checked} {}", rule.unit(checked))?;
                if let Some(why) = why {
                    write!(f, "; the rest not checked: {why}")?;
                }
            }
        }
        writeln!(f)?;
    }
    hints::write(f, report)?;
    for violation in &report.violations {
        writeln!(f, "{}: {}", violation.rule(), Sentence(violation, names))?;
    }
    match report.violations_left_out() {
        0 => Ok(()),
        more => writeln!(f, "… and {more} more"),
    }
}
