//! Accepted findings of a coverage, such as lakes and disputed areas.

use crate::words::plain;
use serde::{Deserialize, Serialize};
use std::collections::{HashMap, HashSet};
use twinedge_diagnosis::{Diagnosis, FeatureName, Position};

const SCHEMA: &str = "twinedge-accepted/1";

/// The relative amount by which a measure may grow, since measures are rounded.
const ROUNDING: f64 = 1e-9;

/// Accepted findings, known by their ids. A finding stays accepted as long as it does not grow. Invalid features and missing vertices have no size
/// and are accepted at their places.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Accepted {
    schema: String,
    accepted: Vec<AcceptedFinding>,
}

/// An accepted finding.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AcceptedFinding {
    /// The id.
    pub id: String,
    /// The reason, a sentence.
    #[serde(default)]
    pub reason: String,
    /// The day on which it was accepted.
    #[serde(default)]
    pub date: String,
    /// The rule.
    #[serde(default)]
    pub rule: String,
    /// The features, by id, or else by name.
    #[serde(default)]
    pub features: Vec<String>,
    /// The place to look at.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Position>,
    /// The accepted area; without one, any area is accepted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area: Option<f64>,
    /// The accepted length of the borders; without one, any length is accepted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// The accepted number of missing vertices; without one, any number is accepted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub missing: Option<usize>,
    /// The accepted number of defects of an invalid feature; without one, any number is accepted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub defects: Option<usize>,
}

#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct AcceptedSummary {
    /// The number of accepted findings that occur.
    pub(crate) count: usize,
    /// The ids of accepted findings that have grown, and so count as findings.
    pub(crate) grown: Vec<String>,
    /// The ids of accepted findings that no longer occur.
    pub(crate) gone: Vec<String>,
}

/// The error for a file that is not a list of accepted findings.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AcceptedError {
    /// The file is not JSON of this form.
    #[error("no list of accepted findings: {0}")]
    Json(#[from] serde_json::Error),
    /// The list has another version.
    #[error("no list of accepted findings: its schema is {0:?}, not {SCHEMA:?}")]
    Schema(String),
    /// An id occurs twice.
    #[error("the finding {0} is accepted twice")]
    Twice(String),
}

impl Accepted {
    /// Reads a file. O(its length).
    ///
    /// # Errors
    /// [`AcceptedError`].
    pub fn read(text: &str) -> Result<Self, AcceptedError> {
        let read: Self = serde_json::from_str(text)?;
        if read.schema != SCHEMA {
            return Err(AcceptedError::Schema(read.schema));
        }
        let mut ids = HashSet::new();
        match read.accepted.iter().find(|one| !ids.insert(&*one.id)) {
            Some(one) => Err(AcceptedError::Twice(one.id.clone())),
            None => Ok(read),
        }
    }

    /// Accepts all these findings. A finding in `before` keeps its reason and date unless it grew.
    pub(crate) fn all<'a>(
        findings: impl Iterator<Item = &'a Diagnosis>,
        before: Option<&Self>,
        reason: &str,
        date: &str,
    ) -> Self {
        let of = |one: &Diagnosis| {
            let id = one.id.clone().unwrap_or_default();
            let known = before.iter().flat_map(|before| &before.accepted).find(|known| known.id == id);
            let (reason, date) =
                known.filter(|known| known.covers(one)).map_or((reason, date), |known| (&known.reason, &known.date));
            AcceptedFinding {
                id,
                reason: reason.to_owned(),
                date: date.to_owned(),
                rule: one.rule.unwrap_or_default().to_owned(),
                features: one.features.iter().flatten().map(FeatureName::key).collect(),
                at: one.look,
                area: one.measures.area,
                length: one.measures.length,
                missing: Some(one.missing.len()).filter(|count| *count > 0),
                defects: Some(one.trace.points.len()).filter(|_| !one.defects.is_empty()),
            }
        };
        Self { schema: SCHEMA.to_owned(), accepted: findings.map(of).collect() }
    }

    /// Marks the accepted findings. Returns a summary and a sentence for each accepted finding that grew or no longer occurs.
    pub(crate) fn mark<'a>(&self, findings: impl Iterator<Item = &'a mut Diagnosis>) -> (AcceptedSummary, Vec<String>) {
        let known: HashMap<&str, &AcceptedFinding> = self.accepted.iter().map(|one| (&*one.id, one)).collect();
        let mut found = HashSet::new();
        let mut summary = AcceptedSummary::default();
        let mut lines = Vec::new();
        for one in findings {
            let Some(accepted) = one.id.as_deref().and_then(|id| known.get(id)) else { continue };
            found.insert(&*accepted.id);
            if accepted.covers(one) {
                summary.count += 1;
                one.accepted = Some(accepted.reason.clone());
                one.is_violation = false;
            } else {
                summary.grown.push(accepted.id.clone());
                lines.push(format!("{}: it was accepted on {}, and has grown", accepted.title(), accepted.date));
            }
        }
        for gone in self.accepted.iter().filter(|one| !found.contains(&*one.id)) {
            summary.gone.push(gone.id.clone());
            lines.push(format!("{}: it was accepted on {}, and no longer occurs", gone.title(), gone.date));
        }
        (summary, lines.iter().map(|line| plain(line)).collect())
    }
}

impl AcceptedFinding {
    /// Returns true if a finding is no greater, or, without a measure, at the same place.
    fn covers(&self, one: &Diagnosis) -> bool {
        let is_measured = one.measures.area.is_some();
        let is_near = |a: &Position, b: &Position| {
            [0, 1].iter().all(|axis| (a[*axis] - b[*axis]).abs() <= ROUNDING * a[*axis].abs().max(b[*axis].abs()))
        };
        let is_here = is_measured || self.at.zip(one.look).is_none_or(|(then, now)| is_near(&then, &now));
        let is_within = |now: Option<f64>, then: Option<f64>| match (now, then) {
            (Some(now), Some(then)) => now <= then * (1.0 + ROUNDING),
            _ => true,
        };
        let is_as_few = self.missing.is_none_or(|count| one.missing.len() <= count)
            && self.defects.is_none_or(|count| one.trace.points.len() <= count);
        is_within(one.measures.area, self.area) && is_within(one.measures.length, self.length) && is_as_few && is_here
    }

    fn title(&self) -> String {
        if self.features.is_empty() { self.id.clone() } else { format!("{} ({})", self.id, self.features.join(", ")) }
    }
}
