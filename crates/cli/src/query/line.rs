//! `twinedge query … line`.

use super::at::Record;
use super::which::Source;
use crate::output::{Failure, Format, print_answer, print_json};
use clap::ValueEnum;
use serde::Serialize;
use twinedge_geometry::Point;
use twinedge_map::{QueryLine, ZoneElement};

/// The faces, edges and vertices that a line meets, in order.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query line -10 52 30 52
  twinedge query line -10 52 30 52 --extent ray --format json

Exit status: 0 there is an answer; 2 the input could not be read.")]
pub(super) struct Line {
    /// First coordinate of the start.
    #[arg(allow_negative_numbers = true)]
    x1: f64,

    /// Second coordinate of the start.
    #[arg(allow_negative_numbers = true)]
    y1: f64,

    /// First coordinate of the end.
    #[arg(allow_negative_numbers = true)]
    x2: f64,

    /// Second coordinate of the end.
    #[arg(allow_negative_numbers = true)]
    y2: f64,

    /// The extent of the line.
    #[arg(long, value_enum, default_value_t)]
    extent: Extent,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// The extent of the line.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Extent {
    /// From the first point to the second.
    #[default]
    Segment,
    /// From the first point through the second, without end.
    Ray,
    /// Through both points, without end in both directions.
    Line,
}

#[derive(Debug, Serialize)]
struct LineAnswer<'a> {
    input: &'a str,
    from: [f64; 2],
    to: [f64; 2],
    met: Vec<Step>,
}

/// The next part of the map that the line meets.
#[derive(Debug, Serialize)]
struct Step {
    #[serde(flatten)]
    record: Record,
    /// True if the line runs along the part instead of across it; only edges can be run along.
    along: bool,
}

impl Line {
    pub(super) fn answer(&self, asked: &Source) -> Result<(), Failure> {
        let Source { input, map, .. } = asked;
        let (from, to) = (Point::new(self.x1, self.y1), Point::new(self.x2, self.y2));
        let stretch = match self.extent {
            Extent::Segment => QueryLine::Segment(from, to),
            Extent::Ray => QueryLine::Ray(from, to),
            Extent::Line => QueryLine::Line(from, to),
        };
        let zone = map.zone(&stretch)?;
        let steps = zone.into_iter().map(|met| {
            let record = match met {
                ZoneElement::Face(key) => Record::face(map, key),
                ZoneElement::Edge(key) | ZoneElement::Along(key) => Record::edge(map, key),
                ZoneElement::Vertex(key) => Record::vertex(map, key),
            };
            record.map(|record| Step { record, along: matches!(met, ZoneElement::Along(_)) })
        });
        let met = steps.collect::<Result<Vec<_>, _>>()?;
        match self.format {
            Format::Text => {
                let line = |Step { record, along }: &Step| format!("{}{record}\n", if *along { "along " } else { "" });
                print_answer(&met.iter().map(line).collect::<String>())
            }
            Format::Json => print_json(&LineAnswer { input, from: from.into(), to: to.into(), met }),
        }
    }
}
