//! `twinedge query … faces`.

use super::list::{Limit, greatest_first};
use super::which::Source;
use crate::output::style::BAD;
use crate::output::{Failure, Format, grouped, measure, print_answer, print_json};
use clap::ValueEnum;
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use twinedge::dcel::Face;
use twinedge_algorithm::area::face_area;
use twinedge_report::names::label;

/// All faces: the features that cover them, their areas, their boundaries and their neighbours.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge query faces
  twinedge query - faces --format json < parcels.geojson

Exit status: 0 there is an answer; 2 the input could not be read.")]
pub(super) struct Faces {
    /// The column to sort by.
    #[arg(long, value_enum, default_value_t)]
    sort: SortBy,

    #[command(flatten)]
    limit: Limit,

    /// Output format.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// The order of faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum SortBy {
    /// Their numbers.
    #[default]
    Number,
    /// The area, the largest first; the unbounded face comes last.
    Area,
    /// The number of edges, the most first.
    Edges,
}

#[derive(Debug, Serialize)]
struct FacesAnswer<'a> {
    input: &'a str,
    faces: Vec<Row>,
}

/// A face. An edge with the face on both sides counts once.
#[derive(Debug, Serialize)]
struct Row {
    id: usize,
    features: Vec<String>,
    overlap: bool,
    unbounded: bool,
    /// `None` for the unbounded face.
    area: Option<f64>,
    edges: usize,
    holes: usize,
    neighbours: Vec<usize>,
}

impl Faces {
    pub(super) fn answer(&self, asked: &Source) -> Result<(), Failure> {
        let Source { input, map, .. } = asked;
        let mut faces = Vec::with_capacity(map.dcel().face_count());
        for face in map.dcel().faces() {
            let features: Vec<String> = map.features_of(face.key())?.map(|f| label(map, f)).collect();
            let mut neighbours: BTreeSet<usize> = face.neighbours().map(Face::index).collect();
            neighbours.remove(&face.index());
            let both_sides = |h: twinedge::dcel::HalfEdge<'_>| h.twin().face() == face && h.twin().index() < h.index();
            faces.push(Row {
                id: face.index(),
                overlap: features.len() > 1,
                features,
                unbounded: face.is_unbounded(),
                area: Some(face_area(map, face.key())?).filter(|area| area.is_finite()),
                edges: face.half_edges().filter(|h| !both_sides(*h)).count(),
                holes: face.inner_count(),
                neighbours: neighbours.into_iter().collect(),
            });
        }
        match self.sort {
            SortBy::Number => {}
            SortBy::Area => greatest_first(&mut faces, |row| row.area.unwrap_or(f64::NEG_INFINITY)),
            SortBy::Edges => greatest_first(&mut faces, |row| row.edges as f64),
        }
        self.limit.cut(&mut faces);
        match self.format {
            Format::Text => print_answer(&text(&faces)?),
            Format::Json => print_json(&FacesAnswer { input, faces }),
        }
    }
}

fn text(faces: &[Row]) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    writeln!(out, "{:>8} {:>14} {:>8} {:>6} {:>10}  features", "face", "area", "edges", "holes", "neighbours")?;
    for row in faces {
        let area = row.area.map_or_else(|| "unbounded".to_owned(), measure);
        let [edges, holes, neighbours] = [row.edges, row.holes, row.neighbours.len()].map(grouped);
        write!(out, "{:>8} {area:>14} {edges:>8} {holes:>6} {neighbours:>10}  ", format!("f{}", row.id))?;
        if row.overlap {
            write!(out, "{BAD}overlap{BAD:#}: ")?;
        }
        writeln!(out, "{}", if row.features.is_empty() { "-".to_owned() } else { row.features.join(", ") })?;
    }
    Ok(out)
}
