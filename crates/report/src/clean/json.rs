//! The report as JSON.

use super::Cleaning;
use serde_json::json;
use twinedge_diagnosis::{Diagnosis, FeatureName, Kind, Measures};
use twinedge_layers::clean::{AddedVertex, FeatureChange, LayerChange, Remaining};

impl Cleaning<'_> {
    /// Returns the report as JSON.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        let Self { name, decimals, report, written, elapsed_ms, .. } = self;
        let named = |number: &usize| self.named(*number);
        let remaining = |one: &Remaining| {
            let measures = Measures { area: Some(one.area), width: Some(one.width), length: None };
            Diagnosis {
                rule: Some(one.rule.id()),
                kind: Kind::Named { kind: one.rule.name() },
                message: self.remaining(one, *decimals),
                features: Some(one.features.iter().map(named).collect()),
                measures,
                look: Some(one.at.into()),
                ..Diagnosis::default()
            }
        };
        let all = |remaining_ones: &[Remaining]| remaining_ones.iter().map(remaining).collect::<Vec<_>>();
        let change = |change: &LayerChange| {
            json!({
                "kind": change.kind.name(),
                "from": change.from.iter().map(named).collect::<Vec<_>>(),
                "to": change.to.as_ref().map(named),
                "area": change.area,
                "width": change.width,
                "at": [change.at.x, change.at.y],
            })
        };
        let added = |vertex: &AddedVertex| json!({ "at": [vertex.at.x, vertex.at.y], "to": named(&vertex.to), "of": named(&vertex.of) });
        let changed = |feature: &FeatureChange| {
            let FeatureName { number, id, name, .. } = named(&feature.feature);
            without_null(json!({
                "number": number,
                "id": id,
                "name": name,
                "area_before": feature.area_before,
                "area_after": feature.area_after,
                "points_before": feature.points_before,
                "points_after": feature.points_after,
                "reasons": self.reasons(feature),
            }))
        };
        let left = report.left.map(|left| {
            json!({
                "plane": left.is_plane,
                "overlaps": left.overlaps,
                "gaps": left.gaps,
                "near_misses": left.near_misses,
                "slivers": left.slivers,
                "ogc_invalid": left.invalid,
                "findings": all(&report.remaining),
            })
        });
        without_null(json!({
            "input": name,
            "output": written.map(|written| &*written.name),
            "patch": self.patch,
            "clean": report.left.is_none(),
            "features": self.features,
            "with_polygons": report.polygons,
            "cell": report.noding.map(|noding| noding.cell).filter(|cell| *cell > 0.0),
            "sliver_area": report.sliver_area,
            "gap_width": report.gap_width,
            "chosen_width": report.chosen.map(|chosen| json!({ "width": chosen.width, "gaps": chosen.gaps, "next": chosen.next })),
            "made": report.made.as_ref().map(named),
            "changes": report.changes.iter().map(change).collect::<Vec<_>>(),
            "added_vertices": report.added.iter().map(added).collect::<Vec<_>>(),
            "changed": report.features.iter().map(changed).collect::<Vec<_>>(),
            "left": left,
            // Gaps wider than `--lake-width` or `--gap-width`.
            "wider_gaps": all(&report.wider_gaps),
            "accepted_gaps": all(&report.accepted_gaps),
            "tiles": self.tiles.as_ref().map(|tiles| &tiles.json),
            "warnings": self.warnings(),
            "elapsed_ms": elapsed_ms,
        }))
    }
}

fn without_null(mut object: serde_json::Value) -> serde_json::Value {
    object.as_object_mut().into_iter().for_each(|members| members.retain(|_, value| !value.is_null()));
    object
}
