//! Hints for reports: a whole column of links is nil or dangling, half-edges have no twin, a list of a face has a nil, or no face
//! of a plane is unbounded. The cause is more often an incorrect answer of `View::parts`, or a missing method of the view, than
//! broken records.

use super::counts::Counts;
use super::record::{Field, Record};
use super::violation::Violation;
use super::{Report, Unchecked};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use core::fmt;

/// The columns that a structure may lack: the field, and its part.
const COLUMNS: [(Field, Part); 4] = [
    (Field::Prev, Part::Prev),
    (Field::Boundary, Part::BoundaryComponents),
    (Field::Face, Part::Faces),
    (Field::Leaving, Part::Leaving),
];

pub(super) fn write(f: &mut fmt::Formatter<'_>, report: &Report) -> fmt::Result {
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
