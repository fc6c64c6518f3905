//! The work and the results of `meshes`.

use crate::outcome::{Results, faults};
use crate::rows::{Row, add_findings, add_rows, rows};
use crate::run::Estimate;
use std::fmt;
use twinedge::program::conformance::ConformanceSummary;

/// The work of `meshes`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MeshesWork {
    /// The largest number of vertices of a triangulation. The smallest has 3.
    pub vertices: usize,
}

/// A kind of triangulations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Shape {
    /// Of the sphere.
    Sphere {
        /// The number of vertices.
        vertices: usize,
    },
    /// Of a disc.
    Disc {
        /// The number of vertices on the border.
        outer: usize,
        /// The number of vertices inside.
        inner: usize,
    },
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sphere { vertices } => write!(f, "sphere {vertices}"),
            Self::Disc { outer, inner } => write!(f, "disc {outer}+{inner}"),
        }
    }
}

impl MeshesWork {
    /// Returns the approximate number of operators that are tried.
    #[must_use]
    pub fn estimate(&self) -> Estimate {
        // Measured on `Dcel`: up to 4, 5 and 6 vertices there are 1,652, 7,052 and 52,184, the last in 4 seconds without
        // optimization. Larger numbers were not measured; the estimate is an upper bound for the measured ones.
        let times = u32::try_from(self.vertices.saturating_sub(4)).unwrap_or(u32::MAX);
        Estimate {
            amount: 10_u128.saturating_pow(times).saturating_mul(1_700),
            unit: "operators to try",
            per_second: 10_000,
        }
    }

    pub(super) fn shapes(self) -> impl Iterator<Item = Shape> {
        let all = 3..=self.vertices;
        let spheres = all.clone().map(|vertices| Shape::Sphere { vertices });
        spheres.chain(all.flat_map(|vertices| {
            (0..=vertices - 3).rev().map(move |inner| Shape::Disc { outer: vertices - inner, inner })
        }))
    }
}

rows! {
    /// All triangulations of one kind.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct MeshesRow {
        /// The kind.
        key shape: Shape = "" 9;
        /// The number of triangulations, with mirror images told apart. Operators are tried on each of these.
        given maps: u64 = "maps" 8;
        /// The number of rooted ones: at any half-edge of a sphere, at a border half-edge of a disc.
        given rooted: u64 = "rooted" 8 is rooted_published;
        /// The published number of these, as far as it is known here (OEIS A000260; Brown 1964).
        given rooted_published: Option<u64>;
        /// The number of those without root, with mirror images taken together.
        given unrooted: u64 = "unrooted" 0 is unrooted_published;
        /// The published number of these, for spheres (OEIS A000109).
        given unrooted_published: Option<u64>;
        /// Operators that were applied, with the result of the definition by steps.
        count applied: u64 = "applied" 12;
        /// Operators that were refused, for the same reason.
        count refused: u64 = "refused" 12;
        /// Operators, or newly made structures, that differ.
        zero differences: u64 = "differences" 12;
    }
}

impl MeshesRow {
    /// Returns true if the numbers equal the published ones.
    #[must_use]
    pub fn is_as_published(&self) -> bool {
        Row::differences(self).next().is_none()
    }
}

rows! {
    /// The outcomes of one operator on all triangulations, counted.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub struct OperatorRow {
        /// Its name.
        label operator: String = "operator" 22;
        /// The number of times that it was applied.
        count applied: u64 = "applied" 12;
        /// The number of times that it was refused.
        count refused: u64 = "refused" 12;
        /// The number of times that the structure was not called, as there was nothing to choose from.
        count skipped: u64;
        /// The number of times that the structure lacked the operator, or room for it. After eight in a row it is skipped.
        count not_supported: u64 = "not supported" 13;
    }
}

/// A triangulation on which a fault occurred.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MeshFinding {
    /// Its triangles.
    pub triangles: Vec<[usize; 3]>,
    /// The faulty operator, or `None` for a fault of the triangulation itself.
    pub operator: Option<String>,
    /// The fault, in words.
    pub message: String,
}

impl fmt::Display for MeshFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let operator = self.operator.as_ref().map(|operator| format!("{operator}: ")).unwrap_or_default();
        write!(f, "{operator}{}, on {:?}", self.message, self.triangles)
    }
}

/// The results of [`meshes()`](crate::meshes()).
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct MeshesResults {
    /// The structure on which the work was done.
    pub on: String,
    /// The triangulations, by their kind. All parts count all of them.
    pub rows: Vec<MeshesRow>,
    /// The outcomes of the operators.
    pub operators: Vec<OperatorRow>,
    /// The first findings. All are counted in the rows.
    pub findings: Vec<MeshFinding>,
}

impl MeshesResults {
    pub(super) fn new(on: &str, rows: Vec<MeshesRow>) -> Self {
        let names = ConformanceSummary::default();
        let operators = names.by_operator().map(|(name, _)| OperatorRow {
            operator: name.to_owned(),
            applied: 0,
            refused: 0,
            skipped: 0,
            not_supported: 0,
        });
        let operators = operators.collect();
        Self { on: on.to_owned(), rows, operators, findings: Vec::new() }
    }

    pub(super) fn add(&mut self, rows: &[MeshesRow], summary: &ConformanceSummary, findings: &[MeshFinding]) {
        add_rows(&mut self.rows, rows);
        for (row, (_, counts)) in self.operators.iter_mut().zip(summary.by_operator()) {
            row.applied += counts.applied as u64;
            row.refused += counts.refused as u64;
            row.skipped += counts.skipped as u64;
            row.not_supported += (counts.unsupported + counts.no_room) as u64;
        }
        add_findings(&mut self.findings, findings);
    }
}

impl Results for MeshesResults {
    type Work = MeshesWork;

    fn on(&self) -> Vec<&str> {
        vec![&self.on]
    }

    fn reasons(&self, _: &Self::Work, is_complete: bool) -> Vec<String> {
        let mut reasons = Vec::new();
        let differ = self.rows.iter().filter(|row| !row.is_as_published());
        reasons.extend(differ.map(|row| format!("{}: there are not as many triangulations as published", row.shape)));
        let differences: u64 = self.rows.iter().map(|row| row.differences).sum();
        reasons.extend(faults("differences", differences, &self.findings));
        if is_complete && self.operators.iter().all(|row| row.applied == 0) {
            reasons.push("no operator was applied, so nothing was tried".to_owned());
        }
        reasons
    }

    fn absorb(&mut self, other: &Self) {
        add_rows(&mut self.rows, &other.rows);
        add_rows(&mut self.operators, &other.operators);
        add_findings(&mut self.findings, &other.findings);
    }
}
