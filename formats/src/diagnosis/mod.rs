//! The findings of audits, in the one form that all writers take.
//!
//! ```text
//!   Violation ───────────┐
//!   mesh::Finding ───────┤                    ┌──► JSON (`docs/report.md`)
//!   postgis::Finding ────┼──► Diagnosis ──────┼──► text
//!   topojson's findings ─┤                    └──► layers and pages, in the program
//!   coverage::Finding ───┘
//! ```
//!
//! Each audit keeps its typed findings, and makes a [`Diagnosis`] of each to have it written. [`RuleLine`] is the outcome of a rule,
//! [`Document`] an audit as JSON.

#[cfg(feature = "serde")]
mod document;
#[cfg(feature = "serde")]
mod json;
mod place;
mod rule;

#[cfg(feature = "serde")]
pub use document::Document;
pub use place::middle;
pub use rule::{Reason, RuleLine};

use std::fmt;
use twinedge::validate::{Record, Violation};

/// A point of the plane.
pub type Position = [f64; 2];

/// One thing that an audit found. `Display` prints the rule, or else the kind, and the message.
///
/// ```
/// use twinedge::validate::Violation;
/// use twinedge_formats::diagnosis::Diagnosis;
///
/// let found = Diagnosis::from(&Violation::TwinIsSelf { half_edge: 3 });
/// assert_eq!(found.to_string(), "L1: half-edge 3 is its own twin, so its edge has one side only");
/// assert_eq!(found.kind.name(), "twin_is_self");
/// ```
///
/// More fields may come. One of your own is made from a [`Violation`] or by `..Diagnosis::default()`, so that it compiles then, too.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnosis {
    /// An id that is the same from run to run, if it was given one.
    pub id: Option<String>,
    /// The line of the file, where each line is a structure of its own.
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
    /// The statements for the database that has the records.
    pub sql: Option<Sql>,
    /// The records involved.
    pub records: Records,
    /// The features involved, where there are features.
    pub features: Option<Vec<FeatureName>>,
    /// The features of another layer that are involved, of a finding between two layers.
    pub others: Option<Vec<FeatureName>>,
    /// The places involved, where there are places: vertices, ends of edges, bends.
    pub places: Option<Vec<Position>>,
    /// The place to look at.
    pub look: Option<Position>,
    /// The shape of what is involved.
    pub trace: Trace,
    /// The size, of findings of a coverage.
    pub measures: Measures,
    /// The defects of a feature that is not valid by the rules of the OGC.
    pub defects: Vec<Flaw>,
    /// The vertices that a mismatch of borders is about.
    pub missing: Vec<MissingVertex>,
    /// `removed` by snapping, or `made` by it.
    pub snapping: Option<&'static str>,
    /// The number of the measure of ISO 19157 that counts it.
    pub iso: Option<u32>,
    /// The id of the rule of the finding from which this one follows.
    pub follows_from: Option<&'static str>,
    /// The id of that finding, if it is known.
    pub follows_from_id: Option<String>,
    /// The message in words about features, where there are features.
    pub sentence: Option<String>,
    /// The reason for which it was accepted, if it was.
    pub accepted: Option<String>,
    /// It makes the input invalid.
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
        /// The numbers of what the component has.
        fields: Figures,
    },
}

/// The counts of a component of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Figures {
    /// V.
    pub vertices: u64,
    /// E.
    pub edges: u64,
    /// The number of cycles.
    pub cycles: u64,
    /// The genus.
    pub genus: u64,
}

impl Kind {
    /// The name, which does not change between versions.
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

/// The records that a [`Diagnosis`] names, the one at fault first.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(untagged))]
pub enum Records {
    /// By their indices.
    Indices {
        /// At most two.
        records: Vec<Record>,
    },
    /// By their indices, which is how JSON has them, and by the names of a textbook's tables.
    Both {
        /// At most two.
        records: Vec<Record>,
        /// The name of each.
        #[cfg_attr(feature = "serde", serde(skip))]
        names: Vec<String>,
    },
    /// By the names that a database or file has for them, as in `edge +17`.
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
    /// A finding of a coverage: it has features instead.
    None {},
}

impl Default for Records {
    fn default() -> Self {
        Self::None {}
    }
}

impl Records {
    /// The records in words.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        match self {
            Self::Indices { records } => records.iter().map(ToString::to_string).collect(),
            Self::Names { records: names } | Self::Both { names, .. } => names.clone(),
            Self::OfMesh { .. } | Self::None {} => Vec::new(),
        }
    }
}

/// Statements for the database in which something was found.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Sql {
    /// Queries of the rows that are involved.
    pub show: String,
    /// The statements that mend it; none where that takes a choice.
    pub mend: Vec<String>,
}

/// The shape of what was found.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Trace {
    /// Points.
    pub points: Vec<Position>,
    /// Lines.
    pub lines: Vec<Vec<Position>>,
    /// The outer ring of each, counter-clockwise, and then its holes; all closed.
    pub polygons: Vec<Vec<Vec<Position>>>,
}

/// The size of a finding of a coverage.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measures {
    /// The area.
    pub area: Option<f64>,
    /// The mean width, twice the area by the length.
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

/// A feature as it is named.
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
    /// Name and id, fit for a terminal.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub label: String,
}

impl FeatureName {
    /// The name, without control characters, or else `feature` and the number.
    #[must_use]
    pub fn title(&self) -> String {
        let plain =
            |name: &str| name.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect();
        self.name.as_deref().map_or_else(|| format!("feature {}", self.number), plain)
    }

    /// The id, or else the name, or else the number after a `#`.
    #[must_use]
    pub fn key(&self) -> String {
        let key = self.id.clone().or_else(|| self.name.clone());
        key.unwrap_or_else(|| format!("#{}", self.number))
    }
}

/// A defect of a polygon, in the words of the OGC.
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

/// A violation, with its records named by their indices.
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

/// A line for each, and one that says how many more there are.
pub(crate) fn write_list<'a>(
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
