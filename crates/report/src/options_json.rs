//! The options of an audit as JSON.

use crate::coverage::CoverageOptions;
use crate::input_kind::InputKind;
use crate::options::{Edges, Options};
use serde_json::{Map, Value, json};
use twinedge_coverage::Limits;
use twinedge_geometry::noding::Snap;

/// Returns the options that determine the audit: the given ones, and the required properties of a mesh.
pub(crate) fn as_json(options: &Options, kind: InputKind) -> Map<String, Value> {
    let CoverageOptions { is_rule, limits } = &options.coverage;
    let Limits { gap_width, lake_width, accepted_gaps, sliver_area, .. } = limits;
    let snap = options.map.snap.map(|snap| match snap {
        Snap::Size(size) => json!(size),
        _ => json!("auto"),
    });
    let places: Vec<[f64; 2]> = accepted_gaps.iter().map(|place| (*place).into()).collect();
    let number = |number: &Option<f64>| number.map(Value::from);
    let parent = options.parent.as_ref().map(|parent| match &parent.key {
        Some(key) => json!(format!("{}={key}", parent.column)),
        None => json!(parent.column),
    });
    let of_map = [
        ("snap", snap),
        ("name_from", options.map.name_from.clone().map(Value::from)),
        ("allow_empty", options.map.allow_empty.then(|| json!(true))),
        ("coverage", is_rule.then(|| json!(true))),
        ("gap_width", number(gap_width)),
        ("lake_width", number(lake_width)),
        ("accept_gap", (!places.is_empty()).then(|| json!(places))),
        ("sliver", number(sliver_area)),
        ("parent_column", parent),
        (
            "edges",
            options.edges.map(|edges| match edges {
                Edges::Straight => json!("straight"),
                Edges::Geodesic => json!("geodesic"),
            }),
        ),
        ("geodesic", options.geodesic.then(|| json!(true))),
    ];
    match kind {
        InputKind::Map => of_map.into_iter().filter_map(|(key, value)| Some((key.to_owned(), value?))).collect(),
        InputKind::Mesh(_) => of_mesh(options),
        _ => Map::new(),
    }
}

pub(crate) fn of_mesh(options: &Options) -> Map<String, Value> {
    let space: Vec<&str> = options.space.iter().map(|rule| rule.id()).collect();
    let expected = [("expected", json!(options.mesh.to_string()))].into_iter();
    let all = expected.chain((!space.is_empty()).then(|| ("space", json!(space))));
    all.map(|(key, value)| (key.to_owned(), value)).collect()
}
