//! Differences between a subject and the reference, with their messages, and the coverage of a comparison.

use crate::dcel::Corner;
use crate::program::operators::{Op, Program};
use crate::program::panics::catch;
use crate::program::pointer_model::StartError;
use crate::program::runner::Runner;
use crate::program::subject::{Refusal, StepOutcome, Subject};
use crate::validate::{Part, Record, Report};
use alloc::boxed::Box;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;
use thiserror::Error;

/// A question about a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Question {
    /// The twin of its half-edge.
    Twin,
    /// The half-edge that follows its half-edge.
    Next,
    /// The first half-edge with the same origin.
    Origin,
    /// The first corner in the same face.
    Face,
}

/// An answer of a subject, in terms that do not depend on its handles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Answer {
    /// The corner with this place in [`Runner::corners`](crate::program::Runner::corners).
    Corner(usize),
    /// The unbounded face.
    Unbounded,
    /// An error, or a handle that it never gave out.
    Nothing,
}

/// A difference between the structure under test and the reference.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Difference {
    /// The structure is empty, and lacks a part without which nothing can be added to it.
    #[error("the structure is empty, and stores no {}; begin with one that is not", .0.name())]
    Lacks(Part),
    /// Programs cannot begin with this structure.
    #[error(transparent)]
    Start(StartError),
    /// [`Subject::half_edge_at`](crate::program::Subject::half_edge_at) returns no handle for this half-edge.
    #[error("half_edge_at gives no handle for half-edge {half_edge} of the view")]
    NoHandle {
        /// The index of the half-edge in the view.
        half_edge: usize,
    },
    /// [`Subject::vertex_at`](crate::program::Subject::vertex_at) returns no handle for this vertex.
    #[error("vertex_at gives no handle for isolated vertex {vertex} of the view")]
    NoVertexHandle {
        /// The index of the vertex in the view.
        vertex: usize,
    },
    /// The view has an unexpected half-edge, or one with the handle of another half-edge.
    #[error(
        "half-edge {half_edge} of the view should not be there, or its handle is that of another one{}",
        if *is_named { "" } else { NAMES }
    )]
    Unknown {
        /// Its index in the view.
        half_edge: usize,
        /// True for the handles of [`mesh::Named`](crate::program::mesh::Named).
        is_named: bool,
    },
    /// The view lacks a half-edge or an isolated vertex.
    #[error("corner {corner} is not in the view")]
    Missing {
        /// The place of its corner in [`Runner::corners`](crate::program::Runner::corners).
        corner: usize,
    },
    /// The view keeps every expected rule, but a link of a half-edge differs.
    #[error("in the view, {question:?} of half-edge {half_edge}, corner {corner}, is another than it should be")]
    View {
        /// The index of the half-edge in the view.
        half_edge: usize,
        /// The place of its corner in [`Runner::corners`](crate::program::Runner::corners).
        corner: usize,
        /// The question.
        question: Question,
    },
    /// No operator was applied, so nothing was tried.
    #[error("no operator was applied, so nothing was tried: does the subject have any of them?")]
    NothingApplied,
    /// The subject has operators that were never applied.
    #[error("never applied, and so not tried: {}", .0.join(", "))]
    NeverApplied(Vec<&'static str>),
    /// The operator had a different outcome.
    #[error("the outcome should be `{reference}` and is `{subject}`")]
    StepOutcome {
        /// The outcome in the reference.
        reference: StepOutcome,
        /// The outcome in the subject.
        subject: StepOutcome,
    },
    /// The subject breaks a rule.
    #[error("{}", FirstViolation(.0))]
    Invalid(Box<Report>),
    /// The view keeps every expected rule, but an isolated vertex lies in a different face, is unexpected, or has the handle of another
    /// vertex.
    #[error("isolated vertex {vertex} of the view should not be there, or lies in another face than it should")]
    Isolated {
        /// The index of the vertex in the view.
        vertex: usize,
    },
    /// The map is the expected one, but a surviving vertex has a different handle, so data stored under its old handle is lost. Of
    /// two merged vertices either may survive, unless [`collapse_keeps`](super::Conformance::collapse_keeps) chooses one.
    #[error("a vertex that was there before should be {} and is {found}, so what is kept by its handle is lost", .expected.join(" or "))]
    Vertex {
        /// The expected handles.
        expected: Vec<String>,
        /// The handle found.
        found: String,
    },
    /// The subject panicked. Panics are caught only with the feature `std`.
    #[error("panicked: {0}")]
    Panicked(String),
    /// The map is the expected one, but a handle's answer differs.
    #[error("of corner {corner}, {question:?} should be {reference:?} and is {subject:?}")]
    Answers {
        /// The place of the corner in [`Runner::corners`](crate::program::Runner::corners).
        corner: usize,
        /// The question.
        question: Question,
        /// The answer of the reference.
        reference: Answer,
        /// The answer of the subject.
        subject: Answer,
    },
}

const NAMES: &str = ". If operators move half-edges to other indices, the mesh needs program::mesh::Named";

/// The first violation of a report, in words, and the hints of the report.
struct FirstViolation<'a>(&'a Report);

impl fmt::Display for FirstViolation<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.violations().first() {
            Some(violation) => write!(f, "{} is broken: {}", violation.rule(), violation.message())?,
            None => f.write_str("a rule could not be checked")?,
        }
        self.0.to_string().lines().filter(|line| line.starts_with("hint: ")).try_for_each(|line| write!(f, "\n{line}"))
    }
}

/// The first difference between a subject and the reference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// The number of operators run before.
    pub before: usize,
    /// The failing operator; `None` at the start, or if too little was tried.
    pub op: Option<Op>,
    /// The difference.
    pub difference: Difference,
}

impl Failure {
    pub(super) const fn is_coverage(&self) -> bool {
        matches!(self.difference, Difference::NothingApplied | Difference::NeverApplied(_))
    }
}

impl core::error::Error for Failure {}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.op {
            Some(op) => {
                let when = if matches!(self.difference, Difference::Panicked(_)) { "in" } else { "after" };
                write!(f, "{when} operator {}, `{op}`: {}", self.before + 1, self.difference)
            }
            None if self.is_coverage() => write!(f, "after {} operators: {}", self.before, self.difference),
            None => write!(f, "at the start: {}", self.difference),
        }
    }
}

/// The smallest program found on which a subject differs from the reference.
#[derive(Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// The program. Empty if the start is at fault, or if too little was tried.
    pub program: Program,
    /// The difference.
    pub failure: Box<Failure>,
    pub(super) words: Box<Words>,
}

/// The half-edges of a counterexample, each with the vertices that it joins.
#[derive(Clone, Default, PartialEq, Eq)]
pub(super) struct Words {
    /// The half-edges that the difference names.
    pub(super) places: Vec<String>,
    /// The half-edges that each operator chose, with their other handles.
    pub(super) calls: Vec<String>,
}

impl Counterexample {
    pub(super) fn of(program: Program, failure: Failure) -> Self {
        Self { program, failure: Box::new(failure), words: Box::default() }
    }
}

impl core::error::Error for Counterexample {}

impl fmt::Display for Counterexample {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.failure)?;
        self.words.places.iter().try_for_each(|place| write!(f, "\n{place}"))?;
        if self.program.0.is_empty() {
            return Ok(());
        }
        f.write_str("\nwith this program, and the handles that its operators choose:\n")?;
        let text = self.program.to_string();
        let calls = self.words.calls.iter().map(Some).chain(core::iter::repeat(None));
        for (line, call) in text.lines().zip(core::iter::once(None).chain(calls)) {
            match call {
                Some(call) => writeln!(f, "{line} # {call}")?,
                None => writeln!(f, "{line}")?,
            }
        }
        Ok(())
    }
}

/// Writes the text of `Display`: `unwrap` shows it.
impl fmt::Debug for Counterexample {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

pub(super) fn call_in_words<K: Subject>(runner: &Runner<K>, op: Op) -> String {
    let half_edge = |h: K::HalfEdge| match ends(runner.subject(), h) {
        Ok([origin, target]) => format!("{h:?} ({origin:?} to {target:?})"),
        Err(refusal) => format!("{h:?} ({refusal})"),
    };
    let chosen = || match runner.resolve(op) {
        Ok(call) => call.map(|v| format!("{v:?}"), half_edge, |f| format!("{f:?}")).to_string(),
        Err(outcome) => outcome.to_string(),
    };
    catch(chosen).unwrap_or_else(|panic| format!("panicked: {panic}"))
}

fn ends<K: Subject>(subject: &K, h: K::HalfEdge) -> Result<[K::Vertex; 2], Refusal> {
    Ok([subject.origin_of(h)?, subject.origin_of(subject.twin_of(h)?)?])
}

/// The half-edges that a difference names, with the vertices that they join.
pub(super) fn places_in_words<K: Subject>(runner: &Runner<K>, difference: &Difference) -> Vec<String> {
    let subject = runner.subject();
    let of_view = |h: usize| {
        let target = subject.twin(h).filter(|twin| *twin < subject.half_edge_slots()).and_then(|t| subject.origin(t));
        let [origin, target] = [subject.origin(h)?, target?];
        Some(format!("half-edge {h} joins vertex {origin} and vertex {target}"))
    };
    let of_corner = |corner: usize| {
        let Corner::At(h) = runner.corners().nth(corner)? else { return None };
        let [origin, target] = ends(subject, h).ok()?;
        Some(format!("corner {corner} is that of half-edge {h:?}, which joins {origin:?} and {target:?}"))
    };
    let found = || match difference {
        Difference::View { half_edge, .. } | Difference::Unknown { half_edge, .. } => {
            Vec::from_iter(of_view(*half_edge))
        }
        Difference::Answers { corner, .. } | Difference::Missing { corner } => Vec::from_iter(of_corner(*corner)),
        Difference::Invalid(report) => {
            let records = report.first().into_iter().flat_map(|violation| violation.records()).flatten();
            let half_edges = records.filter_map(|record| match record {
                Record::HalfEdge(h) if h < subject.half_edge_slots() && subject.is_half_edge(h) => Some(h),
                _ => None,
            });
            half_edges.filter_map(of_view).collect()
        }
        _ => Vec::new(),
    };
    catch(found).unwrap_or_default()
}

/// The outcomes of one operator, counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct OperatorCounts {
    /// Applied by both.
    pub applied: usize,
    /// Refused by both, for the same reason.
    pub refused: usize,
    /// The subject was not called: there was nothing to choose from, or it refused a question that the choice depends on.
    pub skipped: usize,
    /// Refused by the subject for want of room.
    pub no_room: usize,
    /// The subject does not have this operator.
    pub unsupported: usize,
}

impl OperatorCounts {
    /// The number of runs.
    #[must_use]
    pub const fn all(&self) -> usize {
        self.applied + self.refused + self.skipped + self.no_room + self.unsupported
    }

    /// Tells whether the subject has the operator, as far as is known.
    #[must_use]
    pub const fn is_supported(&self) -> bool {
        self.applied + self.refused + self.no_room > 0
    }

    const fn add(&mut self, other: &Self) {
        self.applied += other.applied;
        self.refused += other.refused;
        self.skipped += other.skipped;
        self.no_room += other.no_room;
        self.unsupported += other.unsupported;
    }
}

/// A part that a structure lacks, so that it was not compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum NotCompared {
    /// Faces.
    Faces,
    /// Inner boundary components, isolated vertices among them: the structure does not list them.
    Holes,
    /// The outside: the structure has no unbounded face.
    Outside,
    /// `next` of half-edges on the border: the structure keeps none.
    BorderNext,
    /// The refusal of stale handles: see [`without_stale_handles`](super::Conformance::without_stale_handles).
    StaleHandles,
    /// The handles of vertices before and after an operator: see
    /// [`without_vertex_handles`](super::Conformance::without_vertex_handles).
    VertexHandles,
}

impl NotCompared {
    const ALL: [Self; 6] =
        [Self::Faces, Self::Holes, Self::Outside, Self::BorderNext, Self::StaleHandles, Self::VertexHandles];

    /// The noun for this part, without an article.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Faces => "faces",
            Self::Holes => "inner boundary components and isolated vertices",
            Self::Outside => "the unbounded face",
            Self::BorderNext => "next on the border",
            Self::StaleHandles => "stale handles",
            Self::VertexHandles => "the handles of vertices before and after",
        }
    }
}

/// Counts of the outcomes of one program or several, and the parts that were not compared.
///
/// [`Display`](fmt::Display) writes a table with a row per operator run, and lists the unsupported operators.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConformanceSummary {
    counts: [OperatorCounts; Op::NAMES.len()],
    not_compared: [bool; NotCompared::ALL.len()],
}

impl ConformanceSummary {
    /// The counts of each operator, with its name.
    pub fn by_operator(&self) -> impl Iterator<Item = (&'static str, OperatorCounts)> + '_ {
        Op::NAMES.iter().copied().zip(self.counts)
    }

    /// The counts of the operator of this name; `None` if no operator has it.
    #[must_use]
    pub fn of(&self, name: &str) -> Option<OperatorCounts> {
        self.by_operator().find_map(|(other, counts)| (other == name).then_some(counts))
    }

    /// The sum over all operators.
    #[must_use]
    pub fn total(&self) -> OperatorCounts {
        let mut sum = OperatorCounts::default();
        self.counts.iter().for_each(|counts| sum.add(counts));
        sum
    }

    /// The parts that the structure lacks, so that they were not compared.
    pub fn not_compared(&self) -> impl Iterator<Item = NotCompared> + '_ {
        NotCompared::ALL.into_iter().filter(|part| self.not_compared[*part as usize])
    }

    /// Adds the coverage of another run.
    pub fn add(&mut self, other: &Self) {
        self.counts.iter_mut().zip(&other.counts).for_each(|(sum, counts)| sum.add(counts));
        self.not_compared.iter_mut().zip(other.not_compared).for_each(|(sum, part)| *sum |= part);
    }

    pub(super) const fn note(&mut self, part: NotCompared) {
        self.not_compared[part as usize] = true;
    }

    pub(super) const fn count(&mut self, op: Op, outcome: StepOutcome) {
        let counts = &mut self.counts[op.kind() as usize];
        *match outcome {
            StepOutcome::Applied => &mut counts.applied,
            StepOutcome::Refused(Refusal::Full) => &mut counts.no_room,
            StepOutcome::Refused(Refusal::Unsupported) => &mut counts.unsupported,
            StepOutcome::Refused(_) => &mut counts.refused,
            StepOutcome::Skipped => &mut counts.skipped,
        } += 1;
    }
}

impl fmt::Display for ConformanceSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{:<22} {:>9} {:>9} {:>9} {:>9} {:>12}",
            "operator", "applied", "refused", "skipped", "no room", "unsupported"
        )?;
        let mut lacks = Vec::new();
        for (name, counts) in self.by_operator().filter(|(_, counts)| counts.all() > 0) {
            let OperatorCounts { applied, refused, skipped, no_room, unsupported } = counts;
            if applied == 0 && refused == 0 && no_room == 0 && unsupported > 0 {
                lacks.push(name);
            } else {
                writeln!(f, "{name:<22} {applied:>9} {refused:>9} {skipped:>9} {no_room:>9} {unsupported:>12}")?;
            }
        }
        if !lacks.is_empty() {
            writeln!(f, "not supported: {}", lacks.join(", "))?;
        }
        for part in self.not_compared() {
            writeln!(f, "not compared: {}", part.name())?;
        }
        Ok(())
    }
}
