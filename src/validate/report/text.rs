//! Reports in words: a line for each rule, then hints, then a line for each kept violation.
//!
//! The cause of a hint is more often an incorrect answer of `View::parts`, or a missing method of the view, than broken records.

use super::names::{Field, Names, Number, Record};
use super::violation::{Sentence, Violation};
use super::{Counts, Report, Unchecked};
use crate::validate::rule::Rule;
use crate::validate::structure::Part;
use alloc::string::{String, ToString};
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

/// A report or a violation that prints names of records instead of indices: see [`Report::named`] and
/// [`Violation::named`].
pub struct Named<'a, T: ?Sized, F> {
    what: &'a T,
    names: F,
}

impl Report {
    /// Returns the report with the owner's names for records: `names` returns the name of a record, without its kind.
    ///
    /// A value that leads to no live record has no name, and stays the number that the view answered.
    ///
    /// ```
    /// use twinedge::validate::{Collect, Expectation, Record, Table, validate};
    /// // A loop that is its own twin.
    /// let table: Table = "V 1 0 - H 1 0 0 0 0 0 B 1 0 h0 i0 F 1 - 1 0".parse()?;
    /// let report = validate(&table, &Expectation::plane(), Collect::All);
    /// let named = report.named(|record| match record {
    ///     Record::HalfEdge(_) => "the loop",
    ///     _ => "the only one",
    /// });
    /// assert!(named.to_string().contains("L1: half-edge the loop is its own twin"));
    /// # Ok::<(), twinedge::validate::ParseTableError>(())
    /// ```
    pub const fn named<N: fmt::Display, F: Fn(Record) -> N>(&self, names: F) -> Named<'_, Self, F> {
        Named { what: self, names }
    }
}

impl Violation {
    /// Returns the violation with the owner's names for records, like [`Report::named`].
    ///
    /// ```
    /// use twinedge::validate::Violation;
    /// let violation = Violation::NextShared { first: 0, second: 1, next: 1 };
    /// let named = violation.named(|record| ["ab", "ba"][record.index()]);
    /// assert!(named.to_string().starts_with("L2: half-edges ab and ba both have next ba"));
    /// ```
    pub const fn named<N: fmt::Display, F: Fn(Record) -> N>(&self, names: F) -> Named<'_, Self, F> {
        Named { what: self, names }
    }
}

impl<N: fmt::Display, F: Fn(Record) -> N> fmt::Display for Named<'_, Report, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let write_name = |record, f: &mut fmt::Formatter<'_>| write!(f, "{}", (self.names)(record));
        write(self.what, Names(Some(&write_name)), f)
    }
}

impl<N: fmt::Display, F: Fn(Record) -> N> fmt::Display for Named<'_, Violation, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.what.rule(), self.message())
    }
}

impl<N: fmt::Display, F: Fn(Record) -> N> Named<'_, Violation, F> {
    /// Returns the sentence alone, without the id of the rule.
    #[must_use]
    pub fn message(&self) -> String {
        let write_name = |record, f: &mut fmt::Formatter<'_>| write!(f, "{}", (self.names)(record));
        Sentence(self.what, Names(Some(&write_name))).to_string()
    }
}

impl<T: ?Sized, F> fmt::Debug for Named<'_, T, F>
where
    Self: fmt::Display,
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
