//! Reports in words: a line for each rule, then hints, then a line for each kept violation.
//!
//! The cause of a hint is more often an incorrect answer of `View::parts`, or a missing method of the view, than broken records.

use super::counts::Counts;
use super::names::{Field, Record};
use super::names::{Names, Number};
use super::violation::{Sentence, Violation};
use super::{Report, Unchecked};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
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
    write_hints(f, report)?;
    for violation in &report.violations {
        writeln!(f, "{}: {}", violation.rule(), Sentence(violation, names))?;
    }
    match report.violations_left_out() {
        0 => Ok(()),
        more => writeln!(f, "… and {more} more"),
    }
}

/// The columns that a structure may lack: the field, and its part.
const COLUMNS: [(Field, Part); 4] = [
    (Field::Prev, Part::Prev),
    (Field::Boundary, Part::BoundaryComponents),
    (Field::Face, Part::Faces),
    (Field::Leaving, Part::Leaving),
];

/// Writes the hints, one per line.
fn write_hints(f: &mut fmt::Formatter<'_>, report: &Report) -> fmt::Result {
    nil_columns(f, report)?;
    let any = |is_meant: fn(&Violation) -> bool| report.violations.iter().any(is_meant);
    // Half-edges may lack twins if open boundaries are legal.
    if any(|violation| nil_at(*violation, Field::Twin).is_some()) {
        writeln!(f, "hint: a twin is nil; if the structure has a border, use `Expectation::open()`")?;
    }
    if any(|violation| matches!(violation, Violation::Nil { record: Record::Face(_), field: Field::Inner(_) })) {
        writeln!(
            f,
            "hint: what a face lists is nil; if the structure stores no records for boundary components, leave \
             `Part::BoundaryComponents` out of `View::parts`"
        )?;
    }
    let names_face = any(|violation| {
        matches!(violation, Violation::Dangling { record: Record::HalfEdge(_), field: Field::Face, .. })
    });
    if report.counts.faces == 0 && names_face {
        writeln!(f, "hint: half-edges name faces, but there are none; does the view implement `face_slots`?")?;
    }
    let is_plane = report.outcome(Rule::T1).is_some_and(|outcome| outcome.unchecked != Some(Unchecked::PlaneOnly));
    if is_plane && any(|violation| matches!(violation, Violation::NoOuter { .. })) {
        writeln!(
            f,
            "hint: a face has no outer boundary component; if it is the unbounded face, add `Part::UnboundedFace` to `View::parts`"
        )?;
    }
    if is_plane && is_sphere(report) {
        writeln!(
            f,
            "hint: all faces are bounded, as those of a sphere are; use `Expectation::surface()` for a mesh, and in the plane add \
             `Part::UnboundedFace` to `View::parts`"
        )?;
    }
    Ok(())
}

/// True if the structure is valid, every face has an outer boundary component, and there is no border: it has no outside.
fn is_sphere(report: &Report) -> bool {
    let Counts { faces, outer_boundaries, borders, .. } = report.counts;
    faces > 0 && outer_boundaries == faces && borders == Some(0) && report.is_valid()
}

/// Writes a line for each column in which every link is nil.
fn nil_columns(f: &mut fmt::Formatter<'_>, report: &Report) -> fmt::Result {
    let all_kept = report.violations_left_out() == 0;
    for (field, part) in COLUMNS {
        let (records, kind) = match part {
            Part::Leaving => (report.counts.vertices.saturating_sub(report.counts.isolated_vertices), "vertices"),
            _ => (report.counts.half_edges, "half-edges"),
        };
        let (mut nil, mut last) = (0, 0);
        for index in report.violations.iter().filter_map(|violation| nil_at(*violation, field)) {
            (nil, last) = (nil + 1, index);
        }
        let which = match nil {
            0 | 1 => continue,
            n if n == records => "all",
            // The rest of the column was not kept.
            n if !all_kept && n - 1 == last => "the first",
            _ => continue,
        };
        writeln!(
            f,
            "hint: the {field} of {which} {nil} {kind} is nil; if the structure stores no {}, leave `Part::{part:?}` out of `View::parts`",
            part.name()
        )?;
    }
    Ok(())
}

/// The half-edge or vertex whose link is nil, if the link is in this column.
fn nil_at(violation: Violation, column: Field) -> Option<usize> {
    match violation {
        Violation::Nil { record: Record::HalfEdge(i) | Record::Vertex(i), field } if field == column => Some(i),
        _ => None,
    }
}
