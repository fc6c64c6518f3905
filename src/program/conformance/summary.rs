//! The coverage of a comparison: the outcomes of each operator, and the parts that were not compared.

use crate::program::operators::Op;
use crate::program::subject::{Refusal, StepOutcome};
use alloc::vec::Vec;
use core::fmt;

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
