//! `twinedge query … at`.

use super::record::Record;
use super::source::Source;
use crate::output::{Format, print_answer, print_json};
use crate::status::Failure;
use serde::Serialize;
use twinedge_geometry::Point;
use twinedge_map::Located;

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
