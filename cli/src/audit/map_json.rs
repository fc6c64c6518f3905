//! The report of a map as JSON.

use super::audited::{Audited, labels};
use super::remedies::remedy;
use crate::coverage::Coverage;
use crate::input::Imported;
use serde::Serialize;
use twinedge::geometry::noding::NodingSummary;
use twinedge::map::{Irregularity, IrregularityKind, Position};
use twinedge::validate::{Bounds, Counts, Described, REPORT_SCHEMA, Rule, RuleOutcome, places};

#[derive(Debug, Serialize)]
pub(super) struct Json<'a> {
    input: &'a str,
    import: JsonImport,
    #[serde(skip_serializing_if = "Option::is_none")]
    noding: Option<JsonNoding>,
    schema: &'static str,
    valid: bool,
    counts: Counts,
    bounds: Option<Bounds>,
    rules: Vec<JsonRule>,
    violation_count: u64,
    violations: Vec<JsonViolation<'a>>,
    coverage: Coverage,
    warnings: Vec<String>,
    elapsed_ms: f64,
}

#[derive(Debug, Serialize)]
struct JsonImport {
    features: usize,
    segments: usize,
    repeated_segments: usize,
    repeated_points: usize,
    open_rings: usize,
    degenerate_rings: usize,
    rings_wound_wrongly: usize,
    self_touching_rings: usize,
    spikes: usize,
    with_extra_dimensions: usize,
    dropped_properties: usize,
    dropped_empty: usize,
    irregularities: Vec<JsonIrregularity>,
}

#[derive(Debug, Serialize)]
struct JsonIrregularity {
    kind: String,
    at: [f64; 2],
    feature: usize,
    name: Option<String>,
    shape: usize,
    ring: usize,
    point: usize,
}

impl JsonImport {
    fn new(imported: &Imported) -> Self {
        let Imported { map, read, orients_rings, .. } = imported;
        let summary = map.summary();
        let irregularity = |one: &Irregularity| {
            let Position { feature, shape, ring, point } = one.position;
            let name = map.features().nth(feature).and_then(|f| map.name(f)).map(str::to_owned);
            JsonIrregularity { kind: one.kind.to_string(), at: one.at.into(), feature, name, shape, ring, point }
        };
        let is_one = |one: &&Irregularity| *orients_rings || one.kind != IrregularityKind::WoundWrongly;
        Self {
            features: summary.features,
            segments: summary.segments,
            repeated_segments: summary.duplicate_segments,
            repeated_points: summary.zero_length_segments,
            open_rings: summary.open_rings,
            degenerate_rings: summary.degenerate_rings,
            rings_wound_wrongly: if *orients_rings { summary.rings_wound_wrongly } else { 0 },
            self_touching_rings: summary.self_touching_rings,
            spikes: summary.spikes,
            with_extra_dimensions: read.with_extra_dimensions,
            dropped_properties: read.dropped_properties,
            dropped_empty: read.dropped_empty,
            irregularities: summary.irregularities.iter().filter(is_one).map(irregularity).collect(),
        }
    }
}

#[derive(Debug, Serialize)]
struct JsonNoding {
    cell: f64,
    segments_cut: usize,
    crossings: usize,
    points_merged: usize,
    segments_collapsed: usize,
    segments_repeated: usize,
    largest_move: [f64; 2],
}

impl From<&NodingSummary> for JsonNoding {
    fn from(summary: &NodingSummary) -> Self {
        Self {
            cell: summary.cell,
            segments_cut: summary.split,
            crossings: summary.crossings,
            points_merged: summary.merged,
            segments_collapsed: summary.collapsed,
            segments_repeated: summary.duplicates,
            largest_move: summary.largest_move,
        }
    }
}

#[derive(Debug, Serialize)]
struct JsonRule {
    id: Rule,
    #[serde(flatten)]
    outcome: RuleOutcome,
}

#[derive(Debug, Serialize)]
struct JsonViolation<'a> {
    #[serde(flatten)]
    described: Described<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cause: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    remedy: Option<&'static str>,
    at: Vec<[f64; 2]>,
    features: Vec<String>,
}

impl<'a> Json<'a> {
    pub(super) fn new(audited: Audited<'a>, explain: bool) -> Self {
        let Audited { imported, report, coverage, is_valid, elapsed, .. } = audited;
        let Imported { name, read, map, noted, .. } = imported;
        Self {
            input: name,
            import: JsonImport::new(imported),
            noding: map.noding().map(JsonNoding::from),
            schema: REPORT_SCHEMA,
            valid: is_valid,
            counts: *report.counts(),
            bounds: report.figures().and_then(|figures| figures.bounds),
            rules: report.outcomes().map(|(id, outcome)| JsonRule { id, outcome }).collect(),
            violation_count: report.violation_count(),
            violations: report
                .violations()
                .iter()
                .map(|violation| JsonViolation {
                    described: Described(violation),
                    cause: explain.then(|| violation.cause()),
                    remedy: explain.then(|| remedy(violation)),
                    at: places(map, violation).into_iter().map(Into::into).collect(),
                    features: labels(map, violation),
                })
                .collect(),
            coverage,
            warnings: noted.without_geometry().into_iter().chain(noted.warnings(read)).collect(),
            elapsed_ms: elapsed,
        }
    }
}
