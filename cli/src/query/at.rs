//! `twinedge query … at`.

use super::Asked;
use super::met::Record;
use crate::Failure;
use crate::output::{Format, print, print_json};
use serde::Serialize;
use twinedge::geometry::Point;
use twinedge::map::{Located, Locator};

/// What lies at a point: a face, an edge or a vertex, exactly.
#[derive(Debug, clap::Args)]
pub(super) struct At {
    /// The first coordinate: for the built-in map the longitude.
    #[arg(allow_negative_numbers = true)]
    x: f64,

    /// The second coordinate: for the built-in map the latitude.
    #[arg(allow_negative_numbers = true)]
    y: f64,

    /// For whom to print.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Debug, Serialize)]
struct Answer<'a> {
    input: &'a str,
    point: [f64; 2],
    found: Record,
}

impl At {
    pub(super) fn answer(&self, asked: &Asked) -> Result<(), Failure> {
        let Asked { input, map } = asked;
        let found = match Locator::new(map)?.locate(Point::new(self.x, self.y))? {
            Located::Face(key) => Record::face(map, key),
            Located::Edge(key) => Record::edge(map, key),
            Located::Vertex(key) => Record::vertex(map, key),
        }?;
        match self.format {
            Format::Text => print(&format!("{found}\n")),
            Format::Json => print_json(&Answer { input, point: [self.x, self.y], found }),
        }
    }
}
