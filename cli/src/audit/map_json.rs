//! The keys of JSON on the input of a map.

use crate::input::Imported;
use serde::Serialize;
use serde_json::{Map, Value, to_value};
use twinedge::geometry::noding::NodingSummary;
use twinedge::map::{Irregularity, IrregularityKind, Position};

/// The keys beside those of all audits.
pub(super) fn extra(imported: &Imported, warnings: &[String]) -> serde_json::Result<Map<String, Value>> {
    let mut extra = Map::new();
    extra.insert("import".to_owned(), to_value(JsonImport::new(imported))?);
    if let Some(noding) = imported.map.noding() {
        extra.insert("noding".to_owned(), to_value(JsonNoding::from(noding))?);
    }
    extra.insert("warnings".to_owned(), to_value(warnings)?);
    Ok(extra)
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
