//! The report of `twinedge clean` as JSON.

use serde::Serialize;
use twinedge_formats::diagnosis::{Diagnosis, FeatureName};

/// The report.
#[derive(Debug, Serialize)]
pub(super) struct Json<'a> {
    pub(super) input: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) output: Option<&'a str>,
    pub(super) clean: bool,
    pub(super) features: usize,
    pub(super) with_polygons: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) cell: Option<f64>,
    pub(super) sliver_area: f64,
    pub(super) changes: Vec<JsonChange>,
    pub(super) changed: Vec<JsonFeature>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) left: Option<JsonLeft>,
    /// Gaps that are wider than `--gap-width`.
    pub(super) wider_gaps: Vec<Diagnosis>,
    pub(super) warnings: Vec<String>,
    pub(super) elapsed_ms: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct JsonChange {
    pub(super) kind: &'static str,
    pub(super) from: Vec<FeatureName>,
    pub(super) to: Option<FeatureName>,
    pub(super) area: f64,
    pub(super) width: f64,
    pub(super) at: [f64; 2],
}

#[derive(Debug, Serialize)]
pub(super) struct JsonFeature {
    #[serde(flatten)]
    pub(super) feature: FeatureName,
    pub(super) area_before: f64,
    pub(super) area_after: f64,
    pub(super) points_before: usize,
    pub(super) points_after: usize,
    pub(super) reasons: Vec<String>,
}

#[derive(Debug, Serialize)]
pub(super) struct JsonLeft {
    pub(super) plane: bool,
    pub(super) overlaps: usize,
    pub(super) gaps: usize,
    pub(super) near_misses: usize,
    pub(super) slivers: usize,
    pub(super) ogc_invalid: usize,
    pub(super) findings: Vec<Diagnosis>,
}
