//! `twinedge query … at`.

use super::which::Source;
use crate::output::{Failure, Format, print_answer, print_json};
use serde::Serialize;
use twinedge::dcel::{FaceKey, HalfEdgeKey, StaleKey, VertexKey};
use twinedge_geometry::Point;
use twinedge_map::{FeatureId, Located, PlanarMap};
use twinedge_report::names::label;

/// Tell what lies at a point: a face, an edge or a vertex. The answer is exact.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query at 28.25 -29.5
  twinedge query parcels.geojson at 120.5 48 --format json

Exit status: 0 there is an answer; 2 the input could not be read.")]
pub(super) struct At {
    /// First coordinate; the longitude in the built-in map.
    #[arg(allow_negative_numbers = true)]
    x: f64,

    /// Second coordinate; the latitude in the built-in map.
    #[arg(allow_negative_numbers = true)]
    y: f64,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct PlaceAnswer<'a> {
    input: &'a str,
    point: [f64; 2],
    found: Record,
}

impl At {
    pub(super) fn answer(&self, asked: &Source) -> Result<(), Failure> {
        let Source { input, map, .. } = asked;
        let found = match map.locate(Point::new(self.x, self.y))? {
            Located::Face(key) => Record::face(map, key),
            Located::Edge(key) => Record::edge(map, key),
            Located::Vertex(key) => Record::vertex(map, key),
        }?;
        match self.format {
            Format::Text => print_answer(&format!("{found}\n")),
            Format::Json => print_json(&PlaceAnswer { input, point: [self.x, self.y], found }),
        }
    }
}

/// A record of the map.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum Record {
    Face { id: usize, unbounded: bool, features: Vec<String>, overlap: bool },
    Edge { id: usize, from: [f64; 2], to: [f64; 2], features: Vec<String>, left: Vec<String>, right: Vec<String> },
    Vertex { id: usize, at: [f64; 2], features: Vec<String> },
}

impl Record {
    pub(super) fn face(map: &PlanarMap, key: FaceKey) -> Result<Self, StaleKey> {
        let face = map.dcel().face(key)?;
        let features = labels(map, map.features_of(key)?);
        Ok(Self::Face { id: face.index(), unbounded: face.is_unbounded(), overlap: features.len() > 1, features })
    }

    pub(super) fn edge(map: &PlanarMap, key: HalfEdgeKey) -> Result<Self, StaleKey> {
        let h = map.dcel().half_edge(key)?;
        Ok(Self::Edge {
            id: h.index(),
            from: map.position(h.origin().key())?.into(),
            to: map.position(h.target().key())?.into(),
            features: labels(map, map.features_along(key)?),
            left: labels(map, map.features_of(h.face().key())?),
            right: labels(map, map.features_of(h.twin().face().key())?),
        })
    }

    pub(super) fn vertex(map: &PlanarMap, key: VertexKey) -> Result<Self, StaleKey> {
        let v = map.dcel().vertex(key)?;
        let mut around = Vec::new();
        for h in v.rotation() {
            around.extend(map.features_of(h.face().key())?);
            around.extend(map.features_along(h.key())?);
        }
        around.sort_unstable();
        around.dedup();
        Ok(Self::Vertex { id: v.index(), at: map.position(key)?.into(), features: labels(map, around.into_iter()) })
    }
}

impl std::fmt::Display for Record {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let or = |names: &[String], none: &str| if names.is_empty() { none.to_owned() } else { names.join(", ") };
        match self {
            Self::Face { id, unbounded: true, .. } => write!(f, "face f{id}, the unbounded one"),
            Self::Face { id, features, overlap, .. } => {
                let overlap = if *overlap { ", an overlap" } else { "" };
                write!(f, "face f{id} of {}{overlap}", or(features, "no feature"))
            }
            Self::Edge { id, from: [x0, y0], to: [x1, y1], left, right, .. } => {
                let (left, right) = (or(left, "no feature"), or(right, "no feature"));
                write!(f, "edge h{id} from ({x0}, {y0}) to ({x1}, {y1}), {left} to its left and {right} to its right")
            }
            Self::Vertex { id, at: [x, y], features } => {
                write!(f, "vertex v{id} at ({x}, {y}), a corner of {}", or(features, "no feature"))
            }
        }
    }
}

fn labels(map: &PlanarMap, features: impl Iterator<Item = FeatureId>) -> Vec<String> {
    features.map(|feature| label(map, feature)).collect()
}
