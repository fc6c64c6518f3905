//! The options of an audit.

use crate::accepted::Accepted;
use crate::coverage::CoverageOptions;
use crate::imported::MapOptions;
use crate::input_kind::InputKind;
use serde_json::{Map, Value, json};
use twinedge::algorithm::coverage::Limits;
use twinedge::geometry::noding::Snap;
use twinedge::validate::{Collect, Expectation};
use twinedge_formats::mesh::HalfEdgeMesh;

/// The options of an audit. Those that are for other kinds of inputs are not looked at.
#[derive(Clone, Debug)]
pub struct Options {
    /// Greatest number of violations to list, and of findings of each rule C1 … C7; all are counted. None: 1000, and in the text 3 findings
    /// of each of C1 … C7.
    pub list: Option<usize>,
    /// Causes and remedies are kept.
    pub explain: bool,
    /// The way to build a map.
    pub map: MapOptions,
    /// The limits by which a coverage is judged.
    pub coverage: CoverageOptions,
    /// The findings of the coverage that are accepted. Those that are not listed are not.
    pub accepted: Option<Accepted>,
    /// The map is cut into so many tiles across, and as many upwards, which are judged one by one.
    pub tiles: Option<u32>,
    /// Lengths in metres along geodesics.
    pub geodesic: bool,
    /// The properties that a mesh must have.
    pub mesh: Expectation,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            list: None,
            explain: false,
            map: MapOptions::default(),
            coverage: CoverageOptions::default(),
            accepted: None,
            tiles: None,
            geodesic: false,
            mesh: HalfEdgeMesh::expectation(),
        }
    }
}

impl Options {
    /// Those that say what is judged and how, as JSON: those that were given, and of a mesh what it must be.
    pub(crate) fn json(&self, kind: InputKind) -> Map<String, Value> {
        let CoverageOptions { is_rule, limits } = &self.coverage;
        let Limits { gap_width, lake_width, accepted_gaps, sliver_area, .. } = limits;
        let snap = self.map.snap.map(|snap| match snap {
            Snap::Size(size) => json!(size),
            _ => json!("auto"),
        });
        let places: Vec<[f64; 2]> = accepted_gaps.iter().map(|place| (*place).into()).collect();
        let number = |number: &Option<f64>| number.map(Value::from);
        let of_map = [
            ("snap", snap),
            ("name_from", self.map.name_from.clone().map(Value::from)),
            ("allow_empty", self.map.allow_empty.then(|| json!(true))),
            ("coverage", is_rule.then(|| json!(true))),
            ("gap_width", number(gap_width)),
            ("lake_width", number(lake_width)),
            ("accept_gap", (!places.is_empty()).then(|| json!(places))),
            ("sliver", number(sliver_area)),
            ("geodesic", self.geodesic.then(|| json!(true))),
        ];
        let of_mesh = [("expected", Some(json!(self.mesh.to_string())))];
        let given: Vec<_> = match kind {
            InputKind::Map => of_map.into(),
            InputKind::Mesh(_) => of_mesh.into(),
            _ => Vec::new(),
        };
        given.into_iter().filter_map(|(key, value)| Some((key.to_owned(), value?))).collect()
    }

    /// Greatest number of violations to list.
    pub(crate) fn most(&self) -> usize {
        self.list.unwrap_or(Collect::DEFAULT_CAP)
    }
}
