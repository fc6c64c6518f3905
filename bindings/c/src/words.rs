//! Reports in the words of the header. The library's own messages are for programs in Rust: they speak of expectations,
//! of views and their parts.

use crate::names::Link;
use crate::plan::Plan;
use serde_json::Value;
use std::borrow::Cow;
use std::fmt::Write;
use twinedge::validate::{Field, Part, Record, Report, Unchecked, Violation};

/// The library's words for a link that cannot be an index.
const NOWHERE: &str = "leads to no record at all";

/// The largest integer up to which a double represents all integers.
const EXACT: u64 = (1 << 53) - 1;

/// The facts that this report adds to the library's: the given links, and the numbers that they hold.
#[derive(Debug, Default)]
pub(crate) struct Words {
    given: [bool; Link::KINDS],
    pointers: bool,
    /// By the position of a violation in the list: the number in the column there, where the library has no index for
    /// it.
    numbers: Vec<(usize, i128)>,
}

/// Returns the usual cause of the violation.
pub(crate) const fn cause(violation: &Violation) -> &'static str {
    violation.cause()
}

/// Returns the remedy of the violation, in the words of the header.
pub(crate) fn remedy(violation: &Violation) -> &'static str {
    match violation.kind() {
        "nil" => {
            "set the link, or mark the record as vacant (`twinedge_live`); if the structure has no such links at all, do not give \
             them; if a half-edge lacks its twin or its face at a border, expect `TWINEDGE_EXPECTED_OPEN`"
        }
        "dangling" => {
            "find what links to a record before it is removed; if all such links dangle, give the number of records \
             (`twinedge_records`), or all of them in their list (`twinedge_pointers`)"
        }
        "twin_is_self" => {
            "create both half-edges of an edge together; at an open boundary let the twin be nil, and expect \
             `TWINEDGE_EXPECTED_OPEN`"
        }
        "not_leaving" => {
            "after each change at a vertex let it keep a half-edge that leaves it; if it keeps one that arrives, give the twin of \
             that one"
        }
        "no_unbounded_face" => {
            "do not expect `TWINEDGE_EXPECTED_PLANE` for a mesh; in the plane, let `TWINEDGE_LINK_OUTER` of the unbounded face be nil"
        }
        "second_unbounded_face" => "set `TWINEDGE_LINK_OUTER` of the face, or merge the unbounded faces",
        "no_outer" => {
            "set `TWINEDGE_LINK_FACE_HALF_EDGE` (or `TWINEDGE_LINK_OUTER`) of the face, also of one that is the outside, or mark \
             the face as vacant (`twinedge_live`)"
        }
        "wrong_place" => "update the place of the entry that is moved",
        "cycle_not_listed" => {
            "give each cycle a face of its own; if faces have holes or there are several components, give \
             `TWINEDGE_LINK_BOUNDARY` instead of `TWINEDGE_LINK_FACE`"
        }
        "no_outside" => {
            "list the outside of each component as an inner boundary component of the face in which it lies; do not expect \
             `TWINEDGE_EXPECTED_PLANE` for a mesh"
        }
        "genus" => {
            "node edges that cross, sort the half-edges around each vertex by angle, or do not expect `TWINEDGE_EXPECTED_PLANE`"
        }
        "unused_vertex" => "delete the vertex, or do not expect `TWINEDGE_EXPECTED_USED`",
        "on_border" => {
            "fill the hole, join the faces, or expect `TWINEDGE_EXPECTED_BORDERS` with their number instead of \
             `TWINEDGE_EXPECTED_CLOSED`"
        }
        "cross" => "split both edges where they cross",
        "touch" => "split the edge at the vertex",
        _ => violation.remedy(),
    }
}

/// Returns the sentence of the library, in the words of the header.
fn sentence(violation: &Violation) -> String {
    let before = "`outer` (or, without boundary component records, `outer_half_edge`) is nil";
    violation.message().replace(before, "`TWINEDGE_LINK_FACE_HALF_EDGE` (or `TWINEDGE_LINK_OUTER`) is nil")
}

/// Returns one link that stands for a part.
const fn link_of(part: Part) -> Option<Link> {
    match part {
        Part::Prev => Some(Link::Prev),
        Part::Leaving => Some(Link::Leaving),
        Part::Faces => Some(Link::Face),
        Part::BoundaryComponents | Part::Holes => Some(Link::Boundary),
        _ => None,
    }
}

/// Returns a hint of the library, in the words of the header.
fn hint(line: &str) -> String {
    let mut line = Cow::Borrowed(line);
    for (before, after) in [
        ("leave `Part::Prev` out of `View::parts`", "do not give `TWINEDGE_LINK_PREV`"),
        ("leave `Part::Leaving` out of `View::parts`", "do not give `TWINEDGE_LINK_LEAVING`"),
        ("leave `Part::Faces` out of `View::parts`", "do not give `TWINEDGE_LINK_FACE`"),
        (
            "leave `Part::BoundaryComponents` out of `View::parts`",
            "give `TWINEDGE_LINK_FACE` instead of `TWINEDGE_LINK_BOUNDARY`",
        ),
        ("use `Expectation::open()`", "expect `TWINEDGE_EXPECTED_OPEN`"),
        ("use `Expectation::surface()` for a mesh", "do not expect `TWINEDGE_EXPECTED_PLANE` for a mesh"),
        ("add `Part::UnboundedFace` to `View::parts`", "give `TWINEDGE_LINK_BOUNDARY` and `TWINEDGE_LINK_OUTER`"),
        ("does the view implement `face_slots`?", "give their number by `twinedge_records`"),
    ] {
        if line.contains(before) {
            line = Cow::Owned(line.replace(before, after));
        }
    }
    line.into_owned()
}

/// Replaces integers that a double does not hold by strings.
fn hold(value: &mut Value) {
    match value {
        Value::Number(number) => {
            let exact = number
                .as_u64()
                .map_or_else(|| number.as_i64().is_some_and(|n| n.unsigned_abs() <= EXACT), |n| n <= EXACT);
            if !exact {
                *value = Value::String(number.to_string());
            }
        }
        Value::Array(all) => all.iter_mut().for_each(hold),
        Value::Object(all) => all.values_mut().for_each(hold),
        _ => {}
    }
}

impl Words {
    /// `number` reads the integer in a column of the caller.
    pub(crate) fn new(plan: &Plan, report: &Report, number: impl Fn(Link, usize) -> Option<i128>) -> Self {
        let mut words =
            Self { given: Link::ALL.map(|link| plan.gives(link)), pointers: plan.width.is_none(), numbers: Vec::new() };
        for (position, violation) in report.violations().iter().enumerate() {
            let Violation::Dangling { record, field, value: usize::MAX } = *violation else { continue };
            let Some((link, at)) = words.place(record, field, &number) else { continue };
            // Another thread may have written to it meanwhile.
            if let Some(found) = number(link, at).filter(|found| usize::try_from(*found).is_err() && *found != -1) {
                words.numbers.push((position, found));
            }
        }
        words
    }

    fn gives(&self, link: Link) -> bool {
        self.given[link as usize]
    }

    /// Returns the column and the position of a link of a record.
    fn place(
        &self,
        record: Record,
        field: Field,
        number: &impl Fn(Link, usize) -> Option<i128>,
    ) -> Option<(Link, usize)> {
        let at = record.index();
        let index = |link, at| number(link, at).and_then(|found| usize::try_from(found).ok());
        Some(match (record, field) {
            (Record::HalfEdge(_), Field::Origin) if self.gives(Link::Target) => {
                (Link::Target, if self.gives(Link::Twin) { index(Link::Twin, at)? } else { at ^ 1 })
            }
            (Record::HalfEdge(_), Field::Origin) => (Link::Origin, at),
            (Record::HalfEdge(_), Field::Twin) => (Link::Twin, at),
            (Record::HalfEdge(_), Field::Next) => (Link::Next, at),
            (Record::HalfEdge(_), Field::Prev) => (Link::Prev, at),
            (Record::HalfEdge(_), Field::Boundary) => (Link::Boundary, at),
            (Record::HalfEdge(_), Field::Face) => (Link::Face, at),
            (Record::Vertex(_), Field::Leaving) => (Link::Leaving, at),
            (Record::Vertex(_), Field::Isolated) => (Link::Isolated, at),
            (Record::Boundary(_), Field::Face) => (Link::BoundaryFace, at),
            (Record::Boundary(_), Field::Start) if number(Link::BoundaryHalfEdge, at) != Some(-1) => {
                (Link::BoundaryHalfEdge, at)
            }
            (Record::Boundary(_), Field::Start) => (Link::BoundaryVertex, at),
            (Record::Face(_), Field::Outer) if self.gives(Link::Outer) => (Link::Outer, at),
            (Record::Face(_), Field::Inner(position)) if self.gives(Link::Inner) => {
                (Link::Inner, index(Link::InnerFirst, at)?.checked_add(position)?)
            }
            (Record::Face(_), Field::Outer | Field::Inner(_)) => (Link::FaceHalfEdge, at),
            _ => return None,
        })
    }

    /// Returns the number in the link of the violation at this position, where the library has no index for it.
    fn number(&self, position: usize) -> Option<i128> {
        let at = self.numbers.binary_search_by_key(&position, |(position, _)| *position).ok()?;
        Some(self.numbers[at].1)
    }

    /// Returns a sentence that describes the violation.
    pub(crate) fn message(&self, position: usize, violation: &Violation) -> String {
        let message = sentence(violation);
        match self.number(position) {
            Some(number) => message.replacen(NOWHERE, &format!("is {number}, which is no live record"), 1),
            None if self.pointers => message.replacen(NOWHERE, "leads to what is not in the list of its records", 1),
            None => message,
        }
    }

    /// Returns a line for each rule that applies, hints, and a line for each violation that is listed.
    pub(crate) fn text(&self, report: &Report) -> String {
        let library = report.to_string();
        let mut lines = library.lines().peekable();
        let mut text = String::with_capacity(library.len());
        // Writing to a string cannot fail.
        let applying = report.outcomes().filter(|(_, outcome)| outcome.unchecked != Some(Unchecked::PlaneOnly));
        for ((rule, outcome), line) in applying.zip(&mut lines) {
            let link = match outcome.unchecked {
                Some(Unchecked::Lacks(part)) => link_of(part).filter(|link| !self.gives(*link)),
                _ => None,
            };
            let _ = match outcome.unchecked.zip(link) {
                Some((why, link)) => {
                    let why_here = format!("{} was not given", link.constant());
                    write!(text, "{}", line.replacen(&why.to_string(), &why_here, 1))
                }
                None => write!(text, "{line}"),
            };
            if rule.id() == "L1" && !self.gives(Link::Twin) {
                let _ = write!(text, " (twin: h ^ 1, as {} was not given)", Link::Twin.constant());
            }
            text.push('\n');
        }
        while let Some(line) = lines.next_if(|line| line.starts_with("hint: ")) {
            let _ = writeln!(text, "{}", hint(line));
        }
        for ((position, violation), _) in report.violations().iter().enumerate().zip(&mut lines) {
            let _ = writeln!(text, "{}: {}", violation.rule(), self.message(position, violation));
        }
        for line in lines {
            let _ = writeln!(text, "{line}");
        }
        text
    }

    /// Returns the JSON of the library, with the numbers that links hold.
    pub(crate) fn json(&self, report: &Report) -> String {
        let Ok(mut document) = serde_json::to_value(report) else { return String::new() };
        if let Some(Value::Array(entries)) = document.get_mut("violations") {
            for ((position, violation), entry) in report.violations().iter().enumerate().zip(entries) {
                entry["message"] = self.message(position, violation).into();
                if let Violation::Dangling { value: usize::MAX, .. } = violation {
                    let number = self.number(position);
                    entry["fields"]["value"] = match number.map(i64::try_from) {
                        Some(Ok(number)) => number.into(),
                        Some(Err(_)) => number.unwrap_or_default().to_string().into(),
                        None => "none".into(),
                    };
                }
            }
        }
        hold(&mut document);
        document.to_string()
    }
}
