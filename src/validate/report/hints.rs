//! Hints of a report where a whole column of links is nil or dangling, where half-edges have no twin, or where a list of a face
//! has a nil. The cause is more often a wrong answer of `View::parts`, or a method of the view that is not implemented, than
//! broken records.

use super::counts::Counts;
use super::record::{Field, Record};
use super::violation::Violation;
use crate::validate::structure::Part;
use core::fmt;

/// The columns that a structure may lack: the field, and the part that it belongs to.
const COLUMNS: [(Field, Part); 4] = [
    (Field::Prev, Part::Prev),
    (Field::Boundary, Part::BoundaryComponents),
    (Field::Face, Part::Faces),
    (Field::Leaving, Part::Leaving),
];

/// Writes a line for each column that is nil throughout, and one if half-edges name faces and there are none.
pub(super) fn write(
    f: &mut fmt::Formatter<'_>,
    violations: &[Violation],
    counts: &Counts,
    all_kept: bool,
) -> fmt::Result {
    for (field, part) in COLUMNS {
        let (records, kind) = match part {
            Part::Leaving => (counts.vertices.saturating_sub(counts.isolated_vertices), "vertices"),
            _ => (counts.half_edges, "half-edges"),
        };
        let (mut nil, mut last) = (0, 0);
        for index in violations.iter().filter_map(|violation| nil_at(*violation, field)) {
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
    // Half-edges may lack their twins where open boundaries are legal.
    if violations.iter().any(|violation| nil_at(*violation, Field::Twin).is_some()) {
        writeln!(f, "hint: a twin is nil; if the structure has a border, use `Expectation::open()`")?;
    }
    let lists_nothing =
        |violation: &Violation| matches!(violation, Violation::Nil { record: Record::Face(_), field: Field::Inner(_) });
    if violations.iter().any(lists_nothing) {
        writeln!(
            f,
            "hint: what a face lists is nil; if the structure stores no records for boundary components, leave \
             `Part::BoundaryComponents` out of `View::parts`"
        )?;
    }
    let names_face = |violation: &Violation| {
        matches!(violation, Violation::Dangling { record: Record::HalfEdge(_), field: Field::Face, .. })
    };
    if counts.faces == 0 && violations.iter().any(names_face) {
        writeln!(f, "hint: half-edges name faces, but there are none; does the view implement `face_slots`?")?;
    }
    Ok(())
}

/// The half-edge or vertex whose link is nil, if it is this link.
fn nil_at(violation: Violation, column: Field) -> Option<usize> {
    match violation {
        Violation::Nil { record: Record::HalfEdge(i) | Record::Vertex(i), field } if field == column => Some(i),
        _ => None,
    }
}
