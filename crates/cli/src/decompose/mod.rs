//! `twinedge decompose`: cuts the faces of a map into convex pieces.

mod steps;

use crate::input::MapFile;
use crate::output::style::QUIET;
use crate::output::{Failure, Verdict, grouped, plain, print_answer};
use crate::output_file::{format_of, write_file};
use crate::query::{Source, find};
use anstream::adapter::strip_str;
use clap::ValueEnum;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use twinedge::dcel::FaceKey;
use twinedge_algorithm::claims::faces_by_feature;
use twinedge_algorithm::convex::{Decomposition, decompose};
use twinedge_map::{FeatureId, PlanarMap};
use twinedge_report::Imported;
use twinedge_report::names::label;

/// Cut the features of a map into convex pieces, by edges between their vertices.
///
/// Each face is triangulated, holes included; then each diagonal is looked at once, and removed unless a corner would be larger
/// than a straight angle without it (Hertel and Mehlhorn). A simple polygon with r reflex corners falls into at most 2r + 1
/// pieces, at most four times the least possible number.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  twinedge decompose                                        every country of the built-in map
  twinedge decompose --feature Switzerland --steps steps.svg
  twinedge decompose parcels.geojson --format geojson -o pieces.geojson

Exit status: 0 the features are decomposed; 1 the pieces break a rule; 2 the input could not be read, has no feature of that \
name, or is not plane.")]
pub(crate) struct Decompose {
    #[command(flatten)]
    map: MapFile,

    /// Decompose only the feature of this name, or with this number: '#12'.
    #[arg(long, value_name = "NAME")]
    feature: Option<String>,

    /// Output format. Default: by the extension of the output (.txt, .json, .geojson), else text.
    #[arg(long, value_enum)]
    format: Option<Format>,

    /// File to write; `-` is standard output, and the default.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Also write an animated picture of the triangulation, and of each diagonal as it is looked at.
    #[arg(long, value_name = "FILE.svg")]
    steps: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    /// Text: a line for each feature.
    Text,
    /// One JSON object.
    Json,
    /// A feature collection with a polygon for each piece.
    Geojson,
}

#[derive(Debug, Serialize)]
struct DecompositionAnswer {
    input: String,
    features: Vec<Row>,
    ok: bool,
}

/// The pieces of the faces of a feature.
#[derive(Debug, Serialize)]
struct Row {
    feature: usize,
    name: Option<String>,
    triangles: usize,
    diagonals: usize,
    removed: usize,
    pieces: usize,
    reflex: usize,
}

impl Decompose {
    pub(crate) fn run(&self) -> Result<Verdict, Failure> {
        let file = self.output.as_deref().filter(|path| *path != Path::new("-"));
        let extensions = [("txt", Format::Text), ("json", Format::Json), ("geojson", Format::Geojson)];
        let format = match self.format {
            Some(format) => format,
            None => format_of(file, &extensions)?.unwrap_or(Format::Text),
        };
        format_of(self.steps.as_deref(), &[("svg", ())])?;
        let Imported { name: input, map, noted, .. } = self.map.build()?;
        if !map.is_plane() {
            let why = "edges cross, touch or overlap, so faces are not well defined";
            return Err(Failure(format!("{input}: {why}; --snap auto cuts them, audit says where they are")));
        }
        let asked = Source { input, map, noted };
        let features = match &self.feature {
            Some(name) => vec![find(&asked, name)?],
            None => asked.map.features().collect(),
        };
        let Source { input, mut map, .. } = asked;
        let by_feature = faces_by_feature(&map);
        let faces: Vec<FaceKey> = features.iter().flat_map(|f| by_feature[f.index()].iter().copied()).collect();
        if let Some(file) = &self.steps {
            let picture = steps::picture(&map, &faces).map_err(|error| Failure(format!("{input}: {error}")))?;
            write_file(file, self.map.path(), picture.as_bytes())?;
        }
        let found = decompose(&mut map, faces).map_err(|error| Failure(format!("{input}: {error}")))?;
        let found: BTreeMap<FaceKey, Decomposition> = found.into_iter().map(|one| (one.face, one)).collect();
        let of = |feature: &FeatureId| by_feature[feature.index()].iter().filter_map(|face| found.get(face));
        let rows = features.iter().map(|feature| {
            let sum = |count: fn(&Decomposition) -> usize| of(feature).map(count).sum();
            Row {
                feature: feature.index(),
                name: map.name(*feature).map(str::to_owned),
                triangles: sum(|one| one.triangles),
                diagonals: sum(|one| one.diagonals),
                removed: sum(Decomposition::removed),
                pieces: sum(|one| one.pieces.len()),
                reflex: sum(|one| one.reflex),
            }
        });
        let rows = rows.collect();
        let answer = DecompositionAnswer { input, features: rows, ok: map.validate().is_valid() };
        let text = match format {
            Format::Text => text(&map, &answer)?,
            Format::Json => serde_json::to_string_pretty(&answer)? + "\n",
            Format::Geojson => {
                let pieces = features.iter().flat_map(|f| of(f).flat_map(|one| &one.pieces).map(|piece| (*f, *piece)));
                geojson(&map, pieces)?
            }
        };
        match file {
            None => print_answer(&text)?,
            Some(path) => write_file(path, self.map.path(), strip_str(&text).to_string().as_bytes())?,
        }
        Ok(if answer.ok { Verdict::Sound } else { Verdict::Wrong })
    }
}

fn text(map: &PlanarMap, answer: &DecompositionAnswer) -> Result<String, std::fmt::Error> {
    let mut out = String::new();
    writeln!(out, "{QUIET}{}{QUIET:#}\n", plain(&answer.input))?;
    let names: Vec<String> = { map.features() }.map(|feature| label(map, feature)).collect();
    let width = answer.features.iter().map(|row| names[row.feature].chars().count()).max().unwrap_or(0).max(7);
    writeln!(
        out,
        "  {:width$}  {:>9}  {:>9}  {:>9}  {:>9}  {:>9}",
        "feature", "reflex", "triangles", "diagonals", "removed", "pieces"
    )?;
    for row in &answer.features {
        let [reflex, triangles, diagonals, removed, pieces] =
            [row.reflex, row.triangles, row.diagonals, row.removed, row.pieces].map(grouped);
        let name = &names[row.feature];
        writeln!(out, "  {name:width$}  {reflex:>9}  {triangles:>9}  {diagonals:>9}  {removed:>9}  {pieces:>9}")?;
    }
    Ok(out)
}

#[derive(Serialize)]
struct Collection {
    r#type: &'static str,
    features: Vec<Piece>,
}

#[derive(Serialize)]
struct Piece {
    r#type: &'static str,
    properties: Properties,
    geometry: Geometry,
}

#[derive(Serialize)]
struct Properties {
    feature: usize,
    name: Option<String>,
}

#[derive(Serialize)]
struct Geometry {
    r#type: &'static str,
    coordinates: [Vec<[f64; 2]>; 1],
}

fn geojson(map: &PlanarMap, pieces: impl Iterator<Item = (FeatureId, FaceKey)>) -> Result<String, Failure> {
    let mut features = Vec::new();
    for (feature, piece) in pieces {
        features.push(Piece {
            r#type: "Feature",
            properties: Properties { feature: feature.index(), name: map.name(feature).map(str::to_owned) },
            geometry: Geometry { r#type: "Polygon", coordinates: [twinedge_report::outline::ring(map, piece)?] },
        });
    }
    Ok(serde_json::to_string(&Collection { r#type: "FeatureCollection", features })? + "\n")
}
