//! The findings of audits, in one form for all writers.
//!
//! ```text
//!   violations ───────────┐
//!   findings of meshes ───┤                    ┌──► JSON (`docs/report.md`)
//!   of topologies ────────┼──► Diagnosis ──────┼──► text
//!   of arcs, boundaries ──┤                    └──► layers of findings, pages
//!   of coverages ─────────┘
//! ```
//!
//! Each audit keeps typed findings, written as [`Diagnosis`]. [`RuleLine`] is the outcome of a rule, [`Document`] an audit as
//! JSON.

#[cfg(feature = "serde")]
mod document;
#[cfg(feature = "serde")]
mod json;
mod place;
mod rule;
mod topology_audit;

#[cfg(feature = "serde")]
pub use document::Document;
pub use place::middle;
pub use rule::{Reason, RuleLine};
pub use topology_audit::{TopologyAudit, TopologyCounts};

use std::fmt;
use twinedge::validate::{Record, Violation};

/// A point of the plane.
pub type Position = [f64; 2];

/// A finding of an audit. `Display` prints the rule, or else the kind, and the message.
///
/// ```
/// use twinedge::validate::Violation;
/// use twinedge_diagnosis::Diagnosis;
///
/// let found = Diagnosis::from(&Violation::TwinIsSelf { half_edge: 3 });
/// assert_eq!(found.to_string(), "L1: half-edge 3 is its own twin, so its edge has one side only");
/// assert_eq!(found.kind.name(), "twin_is_self");
/// ```
///
/// More fields may be added. To stay compatible, make your own from a [`Violation`] or by `..Diagnosis::default()`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// An id that is stable from run to run, if one was assigned.
    pub id: Option<String>,
    /// The line of the file, if each line is a separate structure.
    pub line: Option<u64>,
    /// The id of the rule, except for findings of meshes.
    pub rule: Option<&'static str>,
    /// The kind.
    pub kind: Kind,
    /// A sentence.
    pub message: String,
    /// The usual cause.
    pub cause: Option<&'static str>,
    /// The remedy.
    pub remedy: Option<&'static str>,
    /// The statements for the database that contains the records.
    pub sql: Option<Sql>,
    /// The records involved.
    pub records: Records,
    /// The features involved, if there are features.
    pub features: Option<Vec<FeatureName>>,
    /// The features of the other layer involved, for a finding between two layers.
    pub others: Option<Vec<FeatureName>>,
    /// The places involved, if there are places: vertices, ends of edges, bends.
    pub places: Option<Vec<Position>>,
    /// The place to look at.
    pub look: Option<Position>,
    /// The shape of the finding.
    pub trace: Trace,
    /// The size, for findings of a coverage.
    pub measures: Measures,
    /// The defects of a feature that is invalid by the rules of the OGC.
    pub defects: Vec<Flaw>,
    /// The missing vertices of a mismatch of borders.
    pub missing: Vec<MissingVertex>,
    /// `removed` or `made`, by snapping.
    pub snapping: Option<&'static str>,
    /// The number of the ISO 19157 measure that counts it.
    pub iso: Option<u32>,
    /// The id of the rule whose finding implies this one.
    pub follows_from: Option<&'static str>,
    /// The id of that finding, if it is known.
    pub follows_from_id: Option<String>,
    /// The message in terms of features, if there are features.
    pub sentence: Option<String>,
    /// The reason why it was accepted, if it was.
    pub accepted: Option<String>,
    /// True if it makes the input invalid.
    pub is_violation: bool,
}

/// The kind of a [`Diagnosis`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(untagged))]
pub enum Kind {
    /// A violation with its fields.
    Of(Violation),
    /// Another kind, by its name.
    Named {
        /// The name.
        kind: &'static str,
    },
    /// A violation by a component whose records have no numbers.
    Counted {
        /// The name.
        kind: &'static str,
        /// The counts of the component.
        fields: Figures,
    },
}

/// The counts of a component of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Figures {
    /// The number of vertices, V.
    pub vertices: u64,
    /// The number of edges, E.
    pub edges: u64,
    /// The number of cycles.
    pub cycles: u64,
    /// The genus.
    pub genus: u64,
}

impl Kind {
    /// Returns the name, which is stable between versions.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Of(violation) => violation.kind(),
            Self::Named { kind } | Self::Counted { kind, .. } => kind,
        }
    }
}

impl Default for Kind {
    fn default() -> Self {
        Self::Named { kind: "" }
    }
}

/// The records that a [`Diagnosis`] names, the faulty one first.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(untagged))]
pub enum Records {
    /// By their indices.
    Indices {
        /// At most two.
        records: Vec<Record>,
    },
    /// By their indices, as in JSON, and by the names in a textbook's tables.
    Both {
        /// At most two.
        records: Vec<Record>,
        /// The name of each.
        #[cfg_attr(feature = "serde", serde(skip))]
        names: Vec<String>,
    },
    /// By their names in a database or file, as in `edge +17`.
    Names {
        /// The names.
        records: Vec<String>,
    },
    /// Faces and vertices of a list of faces.
    OfMesh {
        /// The faces.
        faces: Vec<usize>,
        /// The vertices.
        vertices: Vec<usize>,
    },
    /// No records: a finding of a coverage has features instead.
    None {},
}

impl Default for Records {
    fn default() -> Self {
        Self::None {}
    }
}

impl Records {
    /// Returns the records in words.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        match self {
            Self::Indices { records } => records.iter().map(ToString::to_string).collect(),
            Self::Names { records: names } | Self::Both { names, .. } => names.clone(),
            Self::OfMesh { .. } | Self::None {} => Vec::new(),
        }
    }
}

/// Statements for the database of a finding.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sql {
    /// Queries for the rows involved.
    pub show: String,
    /// The statements that fix it; empty if fixing requires a choice.
    pub mend: Vec<String>,
}

/// The shape of a finding.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Trace {
    /// Points.
    pub points: Vec<Position>,
    /// Lines.
    pub lines: Vec<Vec<Position>>,
    /// The outer ring of each polygon, counter-clockwise, followed by its holes; all closed.
    pub polygons: Vec<Vec<Vec<Position>>>,
}

/// The size of a finding of a coverage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// The area.
    pub area: Option<f64>,
    /// The mean width: twice the area divided by the length.
    pub width: Option<f64>,
    /// The length of the borders.
    pub length: Option<f64>,
}

/// A vertex that the border of a feature lacks.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MissingVertex {
    /// The place.
    pub at: Position,
    /// The number of the feature, counted from 0.
    pub feature: usize,
}

/// The names of a feature.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FeatureName {
    /// Its number, counted from 0.
    pub number: usize,
    /// Its id in the file.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub id: Option<String>,
    /// Its name.
    pub name: Option<String>,
    /// Name and id, suitable for a terminal.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub label: String,
}

impl FeatureName {
    /// Returns the name, without control characters, or else `feature` and the number.
    #[must_use]
    pub fn title(&self) -> String {
        let plain =
            |name: &str| name.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect();
        self.name.as_deref().map_or_else(|| format!("feature {}", self.number), plain)
    }

    /// Returns the id, or else the name, or else the number after a `#`.
    #[must_use]
    pub fn key(&self) -> String {
        let key = self.id.clone().or_else(|| self.name.clone());
        key.unwrap_or_else(|| format!("#{}", self.number))
    }
}

/// A defect of a polygon, in the terms of the OGC.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Flaw {
    /// The defect.
    pub reason: String,
    /// The place.
    pub at: Position,
    /// The number of the shape in the feature.
    pub shape: usize,
    /// The number of the ring in the shape.
    pub ring: usize,
}

impl Diagnosis {
    /// Drops cause, remedy and statements.
    #[must_use]
    pub fn unexplained(self) -> Self {
        Self { cause: None, remedy: None, sql: None, ..self }
    }
}

/// Converts a violation, naming its records by their indices.
impl From<&Violation> for Diagnosis {
    fn from(violation: &Violation) -> Self {
        Self {
            rule: Some(violation.rule().id()),
            kind: Kind::Of(*violation),
            message: violation.message(),
            cause: Some(violation.cause()),
            remedy: Some(violation.remedy()),
            records: Records::Indices { records: violation.records().into_iter().flatten().collect() },
            is_violation: true,
            ..Self::default()
        }
    }
}

impl fmt::Display for Diagnosis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.rule.unwrap_or(self.kind.name()), self.message)
    }
}

/// Writes a line for each finding, and one for the number of omitted findings.
///
/// # Errors
/// If the formatter fails.
pub fn write_list<'a>(
    f: &mut fmt::Formatter<'_>,
    listed: impl IntoIterator<Item = &'a Diagnosis>,
    total: u64,
) -> fmt::Result {
    let mut more = total;
    for one in listed {
        writeln!(f, "{one}")?;
        more = more.saturating_sub(1);
    }
    if more > 0 { writeln!(f, "… and {more} more") } else { Ok(()) }
}
