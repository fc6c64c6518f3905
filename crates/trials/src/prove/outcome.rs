//! The work and the results of `prove`.

use super::genus;
use crate::outcome::{Results, faults};
use crate::published;
use crate::rows::{Row, add_findings, add_rows, rows};
use crate::run::Estimate;

/// The results of [`prove()`](crate::prove()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct ProveResults {
    /// The structure on which the work was done.
    pub on: String,
    /// Connected maps, by their number of edges.
    pub edges: Vec<EdgesRow>,
    /// Rooted maps by genus, from all rotation systems. This tests the validator, not the structure.
    pub genus: Vec<GenusRow>,
    /// All subdivisions, by their numbers of edges and vertices.
    pub nested: Vec<NestedRow>,
    /// The operators that the structure refused as [unsupported](twinedge::program::Refusal::Unsupported), by name.
    #[cfg_attr(feature = "serde", serde(default))]
    pub unsupported: Vec<String>,
    /// The first findings. All are counted in the rows.
    pub findings: Vec<Finding>,
}

/// A map with a fault.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Finding {
    /// The text of the program that leads to it: [`Program`](twinedge::program::Program) reads it.
    pub program: String,
    /// Its last operator, if that is at fault, and not the map itself.
    pub operator: Option<String>,
    /// The fault, in words.
    pub message: String,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { program, operator, message } = self;
        let operator = operator.as_ref().map(|operator| format!("{operator}: ")).unwrap_or_default();
        write!(f, "{operator}{message}, by\n{program}")
    }
}

rows! {
    /// Connected maps with one number of edges.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct EdgesRow {
        /// The number of edges.
        key n: usize = "edges" 5;
        /// Rooted maps.
        count rooted: u64 = "rooted" 12 is rooted_published;
        /// The published number (OEIS A000168).
        given rooted_published: u64;
        /// Maps without root, with mirror images told apart.
        count sensed: u64 = "without root" 14 is sensed_published;
        /// The published number (A006384).
        given sensed_published: u64;
        /// Maps with one face distinguished as the outside.
        count plane: u64 = "with an outside" 16 is plane_published;
        /// The published number (A103937).
        given plane_published: u64;
        /// Operators that were applied.
        count applications: u64 = "applied" 15;
        /// Operators that were refused.
        count refused: u64 = "refused" 15;
        /// The number of faults.
        zero violations: u64 = "violations" 10;
    }
}

/// Rooted maps with one number of edges, by genus.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GenusRow {
    /// The number of edges.
    pub n: usize,
    /// Rooted maps, from genus 0 on. Meaningless for a part of the work: see `labelled`.
    pub by_genus: Vec<u64>,
    /// The published numbers (Walsh and Lehman, *Counting rooted maps by genus*, 1972).
    pub published: Vec<u64>,
    /// Rotation systems that the validator rejected.
    pub refused: u64,
    /// Connected maps on labelled half-edges, from genus 0 on. These numbers can be added over parts.
    pub labelled: Vec<u64>,
}

rows! {
    /// Subdivisions with one number of edges and vertices.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct NestedRow {
        /// The number of edges.
        key edges: usize = "edges" 5;
        /// The number of vertices.
        key vertices: usize = "vertices" 8;
        /// Subdivisions that were grown.
        count maps: u64 = "maps" 12 is recounted;
        /// Their number by a count that makes no map.
        given recounted: u64;
        /// Operators that were applied.
        count applications: u64 = "applied" 15;
        /// Operators that were refused.
        count refused: u64 = "refused" 15;
        /// The number of faults.
        zero violations: u64 = "violations" 10;
    }
}

impl EdgesRow {
    /// Returns true if all counts equal the published ones.
    #[must_use]
    pub fn is_as_published(&self) -> bool {
        self.differences().next().is_none()
    }

    /// Returns the counts that differ from the published ones, in a sentence.
    fn difference(&self) -> Option<String> {
        let differ = self.differences();
        let differ: Vec<String> =
            differ.map(|(what, grown, published)| format!("{what}: grown {grown}, published {published}")).collect();
        (!differ.is_empty()).then(|| format!("connected maps of {} edges, {}", self.n, differ.join("; ")))
    }
}

impl ProveResults {
    /// Returns the unexpected counts, one sentence for each row.
    fn counts_that_differ(&self) -> Vec<String> {
        let mut differ: Vec<String> = self.edges.iter().filter_map(EdgesRow::difference).collect();
        let rows = self.genus.iter().filter(|row| row.by_genus != row.published);
        differ.extend(rows.map(|row| {
            format!("rooted maps of {} edges by genus: {:?} instead of {:?}", row.n, row.by_genus, row.published)
        }));
        let rows = self.nested.iter().filter(|row| row.maps != row.recounted);
        differ.extend(rows.map(|row| {
            let (edges, vertices) = (row.edges, row.vertices);
            format!("E {edges}, V {vertices}: {} subdivisions instead of {}", row.maps, row.recounted)
        }));
        differ
    }
}

impl Results for ProveResults {
    type Work = ProveWork;

    fn on(&self) -> Vec<&str> {
        vec![&self.on]
    }

    fn reasons(&self, _: &Self::Work, is_complete: bool) -> Vec<String> {
        let mut reasons = Vec::new();
        let nested = self.nested.iter().map(|row| row.violations);
        let violations: u64 = self.edges.iter().map(|row| row.violations).chain(nested).sum();
        reasons.extend(faults("violations", violations, &self.findings));
        let refused: u64 = self.genus.iter().map(|row| row.refused).sum();
        if refused > 0 {
            reasons.push(format!("rotation systems that the validator refused: {refused}"));
        }
        if is_complete {
            let counts = self.counts_that_differ();
            if !counts.is_empty() && !self.unsupported.is_empty() {
                reasons.push(format!(
                    "the structure refused as unsupported: {}; maps that need these operators are not grown, so the counts \
                     below fall short",
                    self.unsupported.join(", ")
                ));
            }
            reasons.extend(counts);
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.edges, &other.edges);
        add_rows(&mut self.nested, &other.nested);
        for (row, other) in self.genus.iter_mut().zip(&other.genus) {
            genus::add(&mut row.labelled, &other.labelled);
            row.refused += other.refused;
        }
        self.unsupported.extend_from_slice(&other.unsupported);
        self.unsupported.sort();
        self.unsupported.dedup();
        add_findings(&mut self.findings, &other.findings);
    }

    fn complete(&mut self) {
        for row in &mut self.genus {
            row.by_genus = genus::rooted(row.n, &row.labelled);
        }
    }
}

/// The work of `prove`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ProveWork {
    /// The largest number of edges of a connected map.
    pub edges: usize,
}

impl ProveWork {
    /// Returns the approximate number of operators that are tried; `u128::MAX` for more than it can hold.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        // Nine tenths of the maps have the largest number of edges. Each has 2n corners, so 4n² pairs of them, for `connect` on
        // both sides and for `split_vertex`, plus the same number of invalid ones.
        let mut maps = 0_u128;
        for n in 0..=self.edges {
            maps = maps.saturating_add(published::plane(n));
            if maps == u128::MAX {
                break;
            }
        }
        let edges = self.edges as u128;
        let amount = maps.saturating_mul(edges.saturating_mul(edges).saturating_mul(24));
        Estimate { amount, unit: "operators to try", per_second: 1_000_000 }
    }

    /// Returns the bounds of subdivisions, connected or not: there are many more of them for the same number of edges.
    pub(super) const fn nested(self) -> (usize, usize) {
        let edges = if self.edges > 4 { 4 } else { self.edges.saturating_sub(1) };
        (edges, edges + 2)
    }
}
