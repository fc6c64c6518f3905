//! JSON keys for the input of a map.

use crate::imported::Imported;
use crate::trace::position;
use serde_json::{Map, Value, json};
use twinedge_map::{Irregularity, IrregularityKind, Position};

/// Returns the keys that only the audit of a map has.
pub(crate) fn extra(imported: &Imported, warnings: &[String]) -> Map<String, Value> {
    let Imported { map, read, summary, orients_rings, .. } = imported;
    let irregularity = |one: &Irregularity| {
        let Position { feature, shape, ring, point } = one.position;
        let name = map.features().nth(feature).and_then(|f| map.name(f));
        json!({
            "kind": one.kind.to_string(), "at": position(one.at), "feature": feature, "name": name, "shape": shape,
            "ring": ring, "point": point,
        })
    };
    let is_one = |one: &&Irregularity| *orients_rings || one.kind != IrregularityKind::WoundWrongly;
    let irregularities: Vec<Value> = summary.irregularities.iter().filter(is_one).map(irregularity).collect();
    let mut import = json!({
        "features": summary.features,
        "segments": summary.segments,
        "repeated_segments": summary.duplicate_segments,
        "repeated_points": summary.zero_length_segments,
        "open_rings": summary.open_rings,
        "degenerate_rings": summary.degenerate_rings,
        "rings_wound_wrongly": if *orients_rings { summary.rings_wound_wrongly } else { 0 },
        "self_touching_rings": summary.self_touching_rings,
        "spikes": summary.spikes,
        "with_extra_dimensions": read.with_extra_dimensions,
        "dropped_properties": read.dropped_properties,
        "dropped_empty": read.dropped_empty,
        "irregularities": irregularities,
    });
    let columns: Vec<&str> = imported.noted.name_columns().collect();
    if !columns.is_empty() {
        import["name_columns"] = json!(columns);
    }
    let noding = map.noding().map(|noding| {
        json!({
            "cell": noding.cell,
            "segments_cut": noding.split,
            "crossings": noding.crossings,
            "points_merged": noding.merged,
            "segments_collapsed": noding.collapsed,
            "segments_repeated": noding.duplicates,
            "largest_move": noding.largest_move,
        })
    });
    let without = Some(&imported.noted.without_geometry).filter(|without| !without.is_empty());
    let keys = [
        ("import", Some(import)),
        ("noding", noding),
        ("warnings", Some(json!(warnings))),
        ("without_geometry", without.map(|without| json!(without))),
    ];
    keys.into_iter().filter_map(|(key, value)| Some((key.to_owned(), value?))).collect()
}
