//! `twinedge query … contour`.

use super::which::{Source, Which};
use crate::output::{Failure, grouped, measure, print_answer, print_json};
use clap::ValueEnum;
use serde::Serialize;
use twinedge_algorithm::contour::{Contour as Outline, of_feature};
use twinedge_geometry::Point;
use twinedge_layers::io::{geojson, wkt};
use twinedge_map::Feature;
use twinedge_report::Condition;
use twinedge_report::names::label;

/// The outline of a feature: polygons with holes, without the borders inside it.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query contour Lesotho
  twinedge query world.geojson contour Lesotho --format wkt

Exit status: 0 there is an answer; 2 the input could not be read, or has no feature of that name.")]
pub(super) struct Contour {
    #[command(flatten)]
    which: Which,

    /// The output.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Format {
    /// Text: the parts of the outline.
    #[default]
    Text,
    /// One geometry as well-known text.
    Wkt,
    /// A feature collection with one feature.
    Geojson,
    /// One JSON object.
    Json,
}

#[derive(Debug, Serialize)]
struct ContourAnswer<'a> {
    input: &'a str,
    feature: String,
    id: usize,
    area: f64,
    polygons: Vec<Polygon>,
}

#[derive(Debug, Serialize)]
struct Polygon {
    outer: Vec<[f64; 2]>,
    holes: Vec<Vec<[f64; 2]>>,
}

impl Contour {
    pub(super) const fn condition(&self) -> Option<&Condition> {
        self.which.condition()
    }

    pub(super) fn answer(&self, asked: &Source) -> Result<(), Failure> {
        let Source { input, map, .. } = asked;
        let id = self.which.find(asked)?;
        let contour = of_feature(map, id).map_err(|error| Failure(format!("{input}: {error}")))?;
        let name = label(map, id);
        let written = |contour: Outline| {
            let mut feature = Feature::from(contour);
            feature.name = map.name(id).map(str::to_owned);
            feature.id = Some(id.index().to_string());
            [feature]
        };
        let mut text = Vec::new();
        match self.format {
            Format::Text => return print_answer(&summary(&name, input, &contour)),
            Format::Wkt => wkt::write(&mut text, &written(contour))?,
            Format::Geojson => geojson::write(&mut text, &written(contour))?,
            Format::Json => {
                let ring = |points: Vec<Point>| points.into_iter().map(Into::into).collect();
                let polygon = |p: twinedge_algorithm::contour::Polygon| Polygon {
                    outer: ring(p.outer),
                    holes: p.holes.into_iter().map(ring).collect(),
                };
                let area = contour.area();
                let polygons = contour.polygons.into_iter().map(polygon).collect();
                return print_json(&ContourAnswer { input, feature: name, id: id.index(), area, polygons });
            }
        }
        print_answer(&String::from_utf8_lossy(&text))
    }
}

fn summary(name: &str, input: &str, contour: &Outline) -> String {
    use crate::output::style::QUIET;
    let holes: usize = contour.polygons.iter().map(|p| p.holes.len()).sum();
    // The last point of a ring repeats its first.
    let vertices: usize = contour.polygons.iter().flat_map(|p| p.rings()).map(|ring| ring.len() - 1).sum();
    let (polygons, area) = (contour.polygons.len(), contour.area());
    format!(
        "{name}\n{QUIET}{input}{QUIET:#}\n\n  polygons {:>12}\n  holes    {:>12}\n  vertices {:>12}\n  area     {:>12}\n",
        grouped(polygons),
        grouped(holes),
        grouped(vertices),
        measure(area)
    )
}
