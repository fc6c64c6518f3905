//! Parts of a report on cleaning, computed together with it: the names of features, and the tiles.

use super::Names;
use crate::words::plain;
use serde_json::Value;
use twinedge_layers::Feature;
use twinedge_layers::clean::CleanReport;

#[derive(Clone, Debug, Default)]
pub(super) struct Called {
    pub(super) id: Option<String>,
    pub(super) name: Option<String>,
}

impl Called {
    pub(super) fn new(names: Names<'_>, feature: &Feature) -> Self {
        Self { id: feature.id.as_ref().map(ToString::to_string), name: names.of(feature) }
    }

    pub(super) fn label(&self, number: usize) -> String {
        plain(&match (&self.name, &self.id) {
            (Some(name), Some(id)) if name != id => format!("{name} ({id})"),
            (Some(name), _) => name.clone(),
            (None, Some(id)) => id.clone(),
            (None, None) => format!("feature {number}"),
        })
    }
}

/// Returns the features mentioned in a report, in order.
pub(super) fn mentioned(report: &CleanReport) -> Vec<usize> {
    let mut all = report.touched();
    all.extend(report.made);
    for one in [&report.remaining, &report.wider_gaps, &report.accepted_gaps].into_iter().flatten() {
        all.extend(&one.features);
    }
    all.sort_unstable();
    all.dedup();
    all
}

#[derive(Debug)]
pub(super) struct ToldTiles {
    pub(super) line: String,
    /// A line for each neighbourhood that was left unchanged.
    pub(super) too_large: Vec<String>,
    pub(super) json: Value,
}
